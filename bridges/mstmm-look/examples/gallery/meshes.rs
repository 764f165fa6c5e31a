//! Bodies with meshes from files.

use crate::chains::{Train, TrainInputs};
use crate::motions::record;
use mstmm::Error;
use mstmm::description::{Geometry, Shape};
use mstmm_look::Motion;
use std::path::Path;

/// The train whose cars have meshes: a binary STL file, an OBJ file, and a file that does not exist.
pub fn train() -> Result<Motion, Error> {
    let chain = Train::new();
    let mut motion = record(&chain, (51, 20, 5e-3), |_, _| TrainInputs { engine_force: 4e4 })?;
    let files = ["package://look/meshes/block.stl", "wedge.obj", "absent.stl"];
    let mut files = files.into_iter().cycle();
    for body in &mut motion.mechanism_mut().bodies {
        let geometry = Geometry::Mesh(files.next().unwrap_or_default());
        body.shapes =
            vec![Shape { geometry, position: [7.5, 0.0, 0.0], orientation: [1.0, 0.0, 0.0, 0.0] }];
    }
    Ok(motion)
}

/// The corners of a block around the middle of a car, in m.
const CORNERS: [[f32; 3]; 8] = [
    [-6.0, -4.0, -4.0],
    [6.0, -4.0, -4.0],
    [6.0, 4.0, -4.0],
    [-6.0, 4.0, -4.0],
    [-6.0, -4.0, 4.0],
    [6.0, -4.0, 4.0],
    [6.0, 4.0, 4.0],
    [-6.0, 4.0, 4.0],
];
/// The corners of its faces, counter-clockwise from outside.
const FACES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// Writes the block as a binary STL file and, a third as high, as an OBJ file.
pub fn write(folder: &Path) -> std::io::Result<()> {
    let mut stl = vec![0; 80];
    stl.extend(12u32.to_le_bytes());
    for [a, b, c, d] in FACES {
        for triangle in [[a, b, c], [a, c, d]] {
            stl.extend([0; 12]);
            stl.extend(
                triangle.iter().flat_map(|corner| CORNERS[*corner]).flat_map(f32::to_le_bytes),
            );
            stl.extend([0; 2]);
        }
    }
    std::fs::create_dir_all(folder.join("meshes"))?;
    std::fs::write(folder.join("meshes/block.stl"), stl)?;
    let vertices = CORNERS.map(|[x, y, z]| format!("v {x} {y} {}\n", z / 3.0)).concat();
    let faces = FACES.map(|[a, b, c, d]| format!("f {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1));
    std::fs::write(folder.join("wedge.obj"), vertices + &faces.concat())
}
