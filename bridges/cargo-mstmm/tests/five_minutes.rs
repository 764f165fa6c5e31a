//! The chapter "your robot in five minutes": its listing is what the tool writes for its file. Its program is a test of
//! the documentation.

use cargo_mstmm::import::{Options, import};

#[test]
fn the_chapter_shows_the_imported_text() {
    let urdf = include_str!("../../../src/tutorial/arm.urdf");
    let chapter = include_str!("../../../src/tutorial/five_minutes.md");
    let (name, file) = (Some("Arm".to_owned()), "arm.urdf".to_owned());
    let imported = import(urdf, &Options { name, file, ..Options::default() });
    let imported = imported.expect("a robot");
    assert_eq!(imported.warnings, Vec::<String>::new());
    assert!(chapter.contains(imported.text.trim_end()), "{}", imported.text);
}
