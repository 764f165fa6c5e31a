//! CSV files.

use crate::Motion;
use std::io::{self, Write};

/// Writes a motion. Names consist of identifiers, brackets and dots, and units have no commas, so nothing is quoted.
pub fn write(motion: &Motion, to: &mut impl Write) -> io::Result<()> {
    for (index, column) in motion.columns().iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(to, "{comma}{} [{}]", column.name, column.unit)?;
    }
    writeln!(to)?;
    for row in motion.rows() {
        for (index, value) in row.iter().enumerate() {
            let comma = if index == 0 { "" } else { "," };
            // The fewest digits that read back to the same bits, with an exponent where it is shorter.
            write!(to, "{comma}{value:?}")?;
        }
        writeln!(to)?;
    }
    Ok(())
}
