//! Writes a page, a CSV file and a picture of several motions.
//!
//! `cargo run --release -p mstmm-look --example gallery -- target/look`

mod chains;
mod meshes;
mod motions;

use mstmm_look::PageOptions;
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder: PathBuf = std::env::args().nth(1).unwrap_or_else(|| "target/look".into()).into();
    std::fs::create_dir_all(&folder)?;
    meshes::write(&folder)?;
    let options = PageOptions::default().meshes(&folder);
    for (name, motion) in [
        ("crane", motions::crane()?),
        ("dog", motions::dog()?),
        ("four_bar", motions::four_bar()?),
        ("train", motions::train()?),
        ("meshes", meshes::train()?),
        ("tree", motions::tree(10_000)?),
    ] {
        let path = |ending: &str| folder.join(format!("{name}.{ending}"));
        motion.write_html_with(path("html"), &options)?;
        motion.write_npz(path("npz"))?;
        motion.write_svg_with(path("svg"), motion.len() / 3, &options)?;
        if motion.len() < 1000 {
            motion.write_csv(path("csv"))?;
        }
        let size = std::fs::metadata(path("html"))?.len();
        println!("{name}: {} frames, {:.2} MB", motion.len(), size as f64 * 1e-6);
    }
    Ok(())
}
