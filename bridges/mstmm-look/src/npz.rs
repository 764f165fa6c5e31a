//! NPZ files: zip archives of arrays in numpy's format, version 1.0.

use crate::Motion;
use std::collections::BTreeSet;
use std::io::{self, Seek, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Writes a motion.
pub fn write(motion: &Motion, to: impl Write + Seek) -> io::Result<()> {
    let mut archive = Archive(ZipWriter::new(to));
    let mut named = BTreeSet::new();
    for block in motion.blocks() {
        let (first, width) = (block.first, block.width());
        let mut shape = vec![motion.len()];
        shape.extend(&block.shape);
        let values = motion.rows().filter_map(|row| row.get(first..first + width)).flatten();
        archive.array(block.name, "<f8", &shape, values.flat_map(|value| value.to_le_bytes()))?;
        if let Some((array, names)) = block.names.as_ref().filter(|(array, _)| named.insert(*array))
        {
            archive.texts(array, names)?;
        }
        if block.names.is_some() && block.shape.len() == 1 {
            let columns = motion.columns().iter().skip(first).take(width);
            let units: Vec<String> = columns.map(|column| column.unit.to_owned()).collect();
            archive.texts(&format!("{}_units", block.name), &units)?;
        }
    }
    let bodies: Vec<String> = motion.mechanism().bodies.iter().map(|it| it.name.clone()).collect();
    archive.texts("body_names", &bodies)?;
    archive.0.finish()?.flush()
}

/// An archive that grows.
struct Archive<W: Write + Seek>(ZipWriter<W>);

impl<W: Write + Seek> Archive<W> {
    /// Adds an array from the bytes of its elements in C order.
    fn array(
        &mut self,
        name: &str,
        element: &str,
        shape: &[usize],
        bytes: impl Iterator<Item = u8>,
    ) -> io::Result<()> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .large_file(true);
        self.0.start_file(format!("{name}.npy"), options)?;
        self.0.write_all(&head(element, shape))?;
        let mut chunk = Vec::with_capacity(1 << 16);
        for byte in bytes {
            chunk.push(byte);
            if chunk.len() == chunk.capacity() {
                self.0.write_all(&chunk)?;
                chunk.clear();
            }
        }
        self.0.write_all(&chunk)
    }

    /// Adds an array of texts.
    fn texts(&mut self, name: &str, texts: &[String]) -> io::Result<()> {
        let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
        let padded = texts.iter().flat_map(|text| {
            text.chars().chain(std::iter::repeat('\0')).take(longest).map(u32::from)
        });
        let bytes = padded.flat_map(u32::to_le_bytes);
        self.array(name, &format!("<U{longest}"), &[texts.len()], bytes)
    }
}

/// Returns the head of an array: magic, version, length, and a Python dictionary that is padded to 64 bytes.
fn head(element: &str, shape: &[usize]) -> Vec<u8> {
    let lengths: String = shape.iter().map(|length| format!("{length}, ")).collect();
    let shape = lengths.trim_end();
    let mut text =
        format!("{{'descr': '{element}', 'fortran_order': False, 'shape': ({shape}), }}");
    let unpadded = 10 + text.len() + 1;
    text.extend(std::iter::repeat_n(' ', unpadded.next_multiple_of(64) - unpadded));
    text.push('\n');
    let mut head = b"\x93NUMPY\x01\x00".to_vec();
    // Shapes have a few lengths, so the text is shorter than 2¹⁶.
    head.extend((text.len() as u16).to_le_bytes());
    head.extend(text.bytes());
    head
}
