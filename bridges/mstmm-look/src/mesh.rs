//! Meshes from STL and OBJ files: triangles as corners in m.

use crate::rotation::Vector;
use std::fs;
use std::path::Path;

/// The largest number of triangles of a page's mesh. Larger meshes make pages that no mail takes.
const MOST: usize = 200_000;

/// The corners of triangles, three each.
pub type Corners = Vec<Vector>;

/// Reads a mesh by the path that a description has: an address such as `package://robot/meshes/link.stl` is searched by
/// its last parts, from the longest.
///
/// # Errors
/// The reason why a mesh is not shown, as a note for the page.
pub fn read(folder: Option<&Path>, written: &str) -> Result<Corners, String> {
    let Some(folder) = folder else {
        return Err("no folder of meshes is given".to_owned());
    };
    let path = written.split_once("://").map_or(written, |(_, path)| path);
    let parts: Vec<&str> = path.split(['/', '\\']).filter(|part| !part.is_empty()).collect();
    let is_inside = parts.iter().all(|part| *part != "..");
    let candidates = (0..parts.len()).map(|skipped| parts[skipped..].iter().collect());
    let found =
        candidates.map(|rest: std::path::PathBuf| folder.join(rest)).find(|it| it.is_file());
    let Some(file) = found.filter(|_| is_inside) else {
        return Err("the file is not in the folder of meshes".to_owned());
    };
    let bytes = fs::read(&file).map_err(|error| error.to_string())?;
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let corners = match ending.to_ascii_lowercase().as_str() {
        "stl" => stl(&bytes),
        "obj" => obj(&bytes),
        _ => return Err("only STL and OBJ files can be read".to_owned()),
    };
    let corners = corners.ok_or("the file is damaged")?;
    match corners.len() / 3 {
        0 => Err("the file has no triangles".to_owned()),
        count if count > MOST => Err(format!("the file has {count} triangles, more than {MOST}")),
        _ => Ok(corners),
    }
}

fn stl(bytes: &[u8]) -> Option<Corners> {
    // The size decides, because binary files may begin with `solid`, too.
    let count = bytes.get(80..84).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    match count.and_then(|count| usize::try_from(count).ok()) {
        Some(count) if bytes.len() >= 84 && (bytes.len() - 84) / 50 == count && count > 0 => {
            binary_stl(&bytes[84..])
        }
        _ => ascii_stl(bytes),
    }
}

fn binary_stl(bytes: &[u8]) -> Option<Corners> {
    let mut corners = Vec::new();
    for triangle in bytes.chunks_exact(50) {
        for corner in triangle[12..48].chunks_exact(12) {
            let mut vector = [0.0; 3];
            for (entry, bytes) in vector.iter_mut().zip(corner.chunks_exact(4)) {
                *entry = f64::from(f32::from_le_bytes(bytes.try_into().ok()?));
            }
            corners.push(vector);
        }
    }
    finite(corners)
}

fn ascii_stl(bytes: &[u8]) -> Option<Corners> {
    let text = std::str::from_utf8(bytes).ok()?;
    let mut corners = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        if words.next() == Some("vertex") {
            corners.push(vector(words)?);
        }
    }
    (corners.len() % 3 == 0).then_some(corners).and_then(finite)
}

fn obj(bytes: &[u8]) -> Option<Corners> {
    let text = String::from_utf8_lossy(bytes);
    let (mut vertices, mut corners): (Vec<Vector>, Corners) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => vertices.push(vector(words)?),
            Some("f") => {
                let of = |word: &str| -> Option<Vector> {
                    let index: isize = word.split('/').next()?.parse().ok()?;
                    let count = isize::try_from(vertices.len()).ok()?;
                    // Negative indices count from the last vertex.
                    let from_zero = if index < 0 { count + index } else { index - 1 };
                    vertices.get(usize::try_from(from_zero).ok()?).copied()
                };
                let face: Option<Vec<Vector>> = words.map(of).collect();
                let face = face?;
                let (first, rest) = face.split_first()?;
                corners.extend(rest.windows(2).flat_map(|pair| [*first, pair[0], pair[1]]));
            }
            _ => {}
        }
    }
    finite(corners)
}

fn vector<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<Vector> {
    let mut next = || words.next()?.parse().ok();
    Some([next()?, next()?, next()?])
}

fn finite(corners: Corners) -> Option<Corners> {
    corners.iter().flatten().all(|entry| entry.is_finite()).then_some(corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Vector; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.5, 0.25]];

    fn binary(triangles: u32) -> Vec<u8> {
        let mut bytes = b"solid binary".to_vec();
        bytes.resize(80, b' ');
        bytes.extend(triangles.to_le_bytes());
        for _ in 0..triangles {
            bytes.extend([0; 12]);
            bytes.extend(TRIANGLE.iter().flatten().flat_map(|it| (*it as f32).to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    #[test]
    fn all_formats_give_the_same_triangle() {
        let ascii = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
                     vertex 0 5e-1 0.25\nendloop\nendfacet\nendsolid a\n";
        assert_eq!(stl(ascii.as_bytes()), Some(TRIANGLE.to_vec()));
        assert_eq!(stl(&binary(1)), Some(TRIANGLE.to_vec()));
        assert_eq!(stl(&binary(2)).map(|corners| corners.len()), Some(6));
        let text = "v 0 0 0\nv 1 0 0\nv 0 .5 .25\nvn 0 0 1\nf 1//1 2//1 -1//1\n";
        assert_eq!(obj(text.as_bytes()), Some(TRIANGLE.to_vec()));
        let quad = obj(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4").expect("a quad");
        assert_eq!(quad.len(), 6);
    }

    #[test]
    fn damaged_files_are_notes() {
        assert_eq!(obj(b"v 0 0 0\nf 1 2 3"), None);
        assert_eq!(obj(b"v 0 0"), None);
        assert_eq!(ascii_stl(b"vertex 0 0 nan\nvertex 0 0 0\nvertex 0 0 0"), None);
        assert_eq!(ascii_stl(b"vertex 0 0 0"), None);
        assert!(read(None, "a.stl").is_err());
    }

    #[test]
    fn addresses_are_searched_by_their_last_parts() {
        let folder = std::env::temp_dir().join(format!("mstmm-look-mesh-{}", std::process::id()));
        fs::create_dir_all(folder.join("visual")).expect("a folder");
        fs::write(folder.join("visual/link.STL"), binary(1)).expect("a file");
        for path in ["package://robot/meshes/visual/link.STL", "visual/link.STL"] {
            assert_eq!(read(Some(&folder), path), Ok(TRIANGLE.to_vec()), "{path}");
        }
        assert!(read(Some(&folder), "visual/other.stl").is_err());
        assert!(read(Some(&folder), "visual/../visual/link.STL").is_err());
        fs::remove_dir_all(folder).expect("the folder");
    }
}
