//! Parts of results: a file for each chunk.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::{Arguments, Results};
use mstmm_payloads::RESULTS;

/// The folder with the parts. A part that exists is complete, since it is written under another name and renamed.
pub struct Parts {
    folder: PathBuf,
    samples: u64,
    chunk: u64,
}

impl Parts {
    /// Opens the folder of a study.
    ///
    /// # Errors
    /// If it has parts of another study, or cannot be written.
    pub fn open(folder: &Path, study: &Arguments) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        let (note, own) = (folder.join("study.txt"), note(study));
        match fs::read_to_string(&note) {
            Ok(known) if known == own => {}
            Ok(known) => {
                let text = format!(
                    "has parts of another study ({}), this is {}",
                    known.trim(),
                    own.trim()
                );
                return Err(io::Error::other(format!(
                    "{} {text}; use another folder",
                    folder.display()
                )));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => fs::write(&note, own)?,
            Err(error) => return Err(error),
        }
        Ok(Parts { folder: folder.to_owned(), samples: study.samples, chunk: study.chunk })
    }

    fn path(&self, chunk: u64) -> PathBuf {
        self.folder.join(format!("part-{chunk:06}.f64"))
    }

    /// Returns whether a chunk has a part.
    pub fn has(&self, chunk: u64) -> bool {
        self.path(chunk).exists()
    }

    /// Writes the part of a chunk: the results of each sample, little-endian.
    pub fn write(&self, chunk: u64, results: &[f64]) -> io::Result<()> {
        let path = self.path(chunk);
        let other = path.with_extension("unfinished");
        let mut file = fs::File::create(&other)?;
        file.write_all(&results.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>())?;
        file.sync_all()?;
        fs::rename(other, path)
    }

    /// Reads the part of a chunk.
    pub fn read(&self, chunk: u64) -> io::Result<Vec<Results>> {
        let path = self.path(chunk);
        let bytes = fs::read(&path)?;
        let (values, rest) = bytes.as_chunks::<8>();
        let (rows, left) = values.as_chunks::<{ RESULTS.len() }>();
        let expected = self.chunk.min(self.samples - chunk * self.chunk);
        if !rest.is_empty() || !left.is_empty() || rows.len() as u64 != expected {
            return Err(io::Error::other(format!(
                "{} is not a part of this study",
                path.display()
            )));
        }
        Ok(rows.iter().map(|row| row.map(f64::from_le_bytes)).collect())
    }
}

fn note(study: &Arguments) -> String {
    format!("samples {}, chunk {}, seed {}\n", study.samples, study.chunk, study.seed)
}
