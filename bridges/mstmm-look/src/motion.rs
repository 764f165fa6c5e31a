//! Motions: frames of numbers with names and units.

use crate::layout::Layout;
use crate::rotation::{Quaternion, Vector};
use crate::{Block, Column, Mechanism, Options, PageOptions, csv, npz, page, picture};
use mstmm_runtime::Described;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// A recorded motion: a table with a row for each frame, and the mechanism that moved.
///
/// It does not depend on the type of the chain, so it can also be filled with numbers from elsewhere, see
/// [`of`](Self::of) and [`push`](Self::push).
#[derive(Clone, Debug)]
pub struct Motion {
    mechanism: Mechanism,
    layout: Layout,
    /// All frames, row by row.
    values: Vec<f64>,
}

impl Motion {
    pub(crate) fn new(mechanism: Mechanism, layout: Layout) -> Self {
        Motion { mechanism, layout, values: Vec::new() }
    }

    /// Makes an empty motion of a chain, for rows from elsewhere.
    #[must_use]
    pub fn of<C>(chain: &C, options: Options) -> Self
    where
        C: Described<Scalar: Into<f64>>,
    {
        crate::Recording::with(chain, options).into_motion()
    }

    /// Adds a frame, with a value for each of [`columns`](Self::columns) in their order. Values need not be finite.
    ///
    /// # Errors
    /// [`io::ErrorKind::InvalidInput`] if the number of values is another.
    pub fn push(&mut self, row: &[f64]) -> io::Result<()> {
        let width = self.columns().len();
        if row.len() != width {
            let message = format!("a frame has {width} values, not {}", row.len());
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        self.values.extend_from_slice(row);
        Ok(())
    }

    pub(crate) fn push_row(&mut self, row: Vec<f64>) {
        debug_assert_eq!(row.len(), self.layout.columns.len());
        self.values.extend(row);
    }

    /// Returns the mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Returns the mechanism, to give its bodies other shapes.
    pub fn mechanism_mut(&mut self) -> &mut Mechanism {
        &mut self.mechanism
    }

    /// Returns the recorded quantities; the first is the time.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.layout.columns
    }

    /// Returns the index of a column by its name, such as `rod.input.force.x`.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.layout.columns.iter().position(|column| column.name == name)
    }

    /// Returns the blocks of columns, such as the forces at all connection points.
    #[must_use]
    pub fn blocks(&self) -> &[Block] {
        &self.layout.blocks
    }

    /// Returns a block by its name: `time`, `coordinates`, `rates`, `accelerations`, `efforts`, `inputs`,
    /// `kinetic_energy`, `potential_energy`, `spring_length`, `spring_length_rate`, `spring_tension`, `spring_force`,
    /// `position`, `orientation`, `velocity`, `angular_velocity`, `force` or `moment`.
    #[must_use]
    pub fn block(&self, name: &str) -> Option<&Block> {
        self.layout.find(name)
    }

    /// Returns the number of frames.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len() / self.layout.columns.len().max(1)
    }

    /// Returns whether no frame is recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Returns the frames, each with a value for each column.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.values.chunks_exact(self.layout.columns.len().max(1))
    }

    /// Returns a frame.
    #[must_use]
    pub fn row(&self, frame: usize) -> Option<&[f64]> {
        self.rows().nth(frame)
    }

    /// Returns the last frame.
    #[must_use]
    pub fn last(&self) -> Option<&[f64]> {
        self.row(self.len().checked_sub(1)?)
    }

    /// Returns the values of a column in all frames.
    pub fn values(&self, column: usize) -> impl Iterator<Item = f64> + '_ {
        self.rows().filter_map(move |row| row.get(column).copied())
    }

    /// Returns a vector of a block at a connection point in a frame.
    pub(crate) fn vector(&self, block: &str, point: usize, row: &[f64]) -> Option<Vector> {
        let first = self.block(block)?.first + 3 * point;
        row.get(first..)?.first_chunk().copied()
    }

    /// Returns the orientation of a connection point in a frame.
    pub(crate) fn orientation(&self, point: usize, row: &[f64]) -> Option<Quaternion> {
        let first = self.block("orientation")?.first + 4 * point;
        row.get(first..)?.first_chunk().copied()
    }

    /// Writes a page that shows the motion: one HTML file that needs no network.
    ///
    /// # Errors
    /// If the file cannot be written, if nothing or no poses are recorded, or if a value is not finite.
    pub fn write_html(&self, path: impl AsRef<Path>) -> io::Result<()> {
        self.write_html_with(path, &PageOptions::default())
    }

    /// Writes a page with options.
    ///
    /// # Errors
    /// As [`write_html`](Self::write_html). A mesh that cannot be read is no error; the page notes it.
    pub fn write_html_with(&self, path: impl AsRef<Path>, options: &PageOptions) -> io::Result<()> {
        std::fs::write(path, page::html(self, options)?)
    }

    /// Returns the page as text.
    ///
    /// # Errors
    /// As [`write_html`](Self::write_html).
    pub fn html(&self, options: &PageOptions) -> io::Result<String> {
        page::html(self, options)
    }

    /// Writes a CSV file: a head with names and units, such as `elbow.angle [rad]`, then a row for each frame. Numbers
    /// have the digits that read back to the same bits.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_csv(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        csv::write(self, &mut file)?;
        file.flush()
    }

    /// Writes an NPZ file with an array for each block, `time` of shape `(frames,)`, `coordinates` of shape
    /// `(frames, coordinates)`, `force` of shape `(frames, points, 3)`, and arrays of names and units.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_npz(&self, path: impl AsRef<Path>) -> io::Result<()> {
        npz::write(self, BufWriter::new(File::create(path)?))
    }

    /// Writes a still picture of a frame as SVG: the bodies, and the force and moment that act on each of them at its
    /// input.
    ///
    /// # Errors
    /// If the file cannot be written, or if there is no such frame or no poses are recorded.
    pub fn write_svg(&self, path: impl AsRef<Path>, frame: usize) -> io::Result<()> {
        self.write_svg_with(path, frame, &PageOptions::default())
    }

    /// Writes a still picture with options, of which it uses the folder of meshes.
    ///
    /// # Errors
    /// As [`write_svg`](Self::write_svg). A body whose mesh cannot be read is drawn as one without shapes.
    pub fn write_svg_with(
        &self,
        path: impl AsRef<Path>,
        frame: usize,
        options: &PageOptions,
    ) -> io::Result<()> {
        std::fs::write(path, picture::svg(self, frame, options)?)
    }

    /// Returns the still picture of a frame as text.
    ///
    /// # Errors
    /// As [`write_svg`](Self::write_svg).
    pub fn svg(&self, frame: usize) -> io::Result<String> {
        self.svg_with(frame, &PageOptions::default())
    }

    /// Returns the still picture of a frame as text, with options.
    ///
    /// # Errors
    /// As [`write_svg`](Self::write_svg).
    pub fn svg_with(&self, frame: usize, options: &PageOptions) -> io::Result<String> {
        picture::svg(self, frame, options)
    }
}
