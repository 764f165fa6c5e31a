//! What a system is called, which of its angles are compared, and how a motion is recorded.

use serde::Serialize;

/// The end of every motion in s.
pub const DURATION: u32 = 5;
/// How many times a second the motion by generated code is recorded.
pub const RECORDS_PER_SECOND: u32 = 100;
/// How many times a second the motion by Newton–Euler is recorded; it divides the other number.
pub const MARKS_PER_SECOND: u32 = 10;
/// The acceleration of free fall in m/s², along −y. The paper does not give it; with this value the
/// errors in its table 1 come out.
pub const GRAVITY: f64 = 9.8;

/// A mechanical system of the paper.
#[derive(Serialize)]
pub struct System {
    /// The section, with a letter where it has several systems.
    pub label: &'static str,
    pub title: &'static str,
    /// How names of files begin.
    pub file_stem: &'static str,
    /// The angles that are compared, in the order of [`Record::angles_rad`].
    pub angles: Vec<Angle>,
    /// Accelerations at time zero that are known beforehand.
    pub start: Vec<KnownAcceleration>,
}

/// An angle that a figure of the paper shows.
#[derive(Serialize)]
pub struct Angle {
    pub symbol: &'static str,
    /// What the angle belongs to, such as "body 2". Angles of one group share a table.
    pub group: &'static str,
    /// The column of a CSV file.
    pub column: String,
}

/// A second derivative of an angle at time zero.
#[derive(Serialize)]
pub struct KnownAcceleration {
    pub name: &'static str,
    /// In rad/s².
    pub value: f64,
}

/// A motion at one time.
#[derive(Serialize)]
pub struct Record {
    pub time_s: f64,
    pub angles_rad: Vec<f64>,
    pub kinetic_energy_j: f64,
    pub potential_energy_j: f64,
}

impl Angle {
    /// The angle's full name, such as "θ₁ of body 2".
    pub fn name(&self) -> String {
        format!("{} of {}", self.symbol, self.group)
    }
}

impl Record {
    pub fn energy(&self) -> f64 {
        self.kinetic_energy_j + self.potential_energy_j
    }
}
