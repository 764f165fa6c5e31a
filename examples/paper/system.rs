//! The systems of sections 4.1 and 4.2: their names, the compared angles, and the records of a motion.

use serde::Serialize;

/// The end of every motion in s.
pub const DURATION: u32 = 5;
/// The records per second of the motion by generated code.
pub const RECORDS_PER_SECOND: u32 = 100;
/// The records per second of the motion by Newton–Euler. It divides [`RECORDS_PER_SECOND`].
pub const MARKS_PER_SECOND: u32 = 10;
/// The acceleration of gravity in m/s², along −y. The paper does not give it; this value reproduces the
/// errors in the paper's table 1.
pub const GRAVITY: f64 = 9.8;

/// A mechanical system of the paper.
#[derive(Serialize)]
pub struct System {
    /// The section, with a letter if the section has several systems.
    pub label: &'static str,
    pub title: &'static str,
    /// The beginning of file names.
    pub file_stem: &'static str,
    /// The compared angles, in the order of [`Record::angles_rad`].
    pub angles: Vec<Angle>,
    /// The accelerations at time zero in closed form.
    pub start: Vec<KnownAcceleration>,
}

/// An angle that a figure of the paper shows.
#[derive(Serialize)]
pub struct Angle {
    pub symbol: &'static str,
    /// The element of the angle, such as "body 2". Angles of one group share a table.
    pub group: &'static str,
    /// The name of the column in a CSV file.
    pub column: String,
}

/// The second derivative of an angle at time zero.
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
