//! Motions as CSV files.

use std::error::Error;
use std::path::{Path, PathBuf};

use crate::compare::Comparison;
use crate::system::{Record, System};

/// Writes both motions of a comparison to `folder` and returns the files.
pub fn write(folder: &Path, comparison: &Comparison) -> Result<[PathBuf; 2], Box<dyn Error>> {
    let system = &comparison.system;
    let path = |method: &str| folder.join(format!("{}_{method}.csv", system.file_stem));
    let [method, newton_euler] = [path("method"), path("newton_euler")];
    write_motion(&method, system, &comparison.method)?;
    write_motion(&newton_euler, system, &comparison.newton_euler)?;
    Ok([method, newton_euler])
}

fn write_motion(path: &Path, system: &System, motion: &[Record]) -> Result<(), Box<dyn Error>> {
    let mut file = csv::Writer::from_path(path)?;
    let angles = system.angles.iter().map(|angle| angle.column.as_str());
    let energies = ["kinetic_energy_j", "potential_energy_j"];
    file.write_record(["time_s"].into_iter().chain(angles).chain(energies))?;
    for record in motion {
        // An array is written as one field per entry; values are written with all their digits.
        file.serialize((
            record.time_s,
            &record.angles_rad,
            record.kinetic_energy_j,
            record.potential_energy_j,
        ))?;
    }
    file.flush()?;
    Ok(())
}
