//! The README's picture: its crane at the end of its program, with the forces in the hinges and the weights. It is a still
//! picture by `mstmm-look`.

use mstmm::description::{Geometry, Shape};
use mstmm::prelude::*;
use mstmm_look::Recording;
use std::fmt::Write;

/// Declares the chain and keeps its text.
macro_rules! chain {
    ($($text:tt)*) => {
        mstmm_chain! { $($text)* }
        const TEXT: &str = stringify!($($text)*);
    };
}

chain! {
    pub plane chain Crane {
        gravity = [0, -9.81] m/s^2;
        param payload = 500 kg;

        body Boom { mass = 400 kg; com = [2, 0] m; output = [4, 0] m; inertia = 550 kg*m^2 about com; }
        body Jib { mass = 200 kg; com = [1.5, 0] m; output = [3, 0] m; inertia = 150 kg*m^2 about com; }
        body Load { mass = payload; com = [0, -2] m; inertia = 60 kg*m^2 about com; }

        ground -> pin foot -> Boom boom -> pin knuckle -> Jib jib -> pin hook -> Load load;

        hinge foot { start = 60 deg; rest = 62 deg; }
        hinge knuckle { start = -40 deg; rest = -40 deg; }
        hinge foot, knuckle { stiffness = 1 MN*m/rad; damping = 20 kN*m*s/rad; }
        hinge hook { start = -60 deg; }
    }
}

const STEPS: usize = 1000;
const FILE: &str = "src/crane.svg";
/// The same as the target of a link, for the documentation.
const LINK: &str = "src/crane.uri";

/// Returns the shapes of a body: bars, and a rope with a box. They are for the picture only.
fn shapes(body: &str) -> Vec<Shape> {
    let at = |geometry, x, y| {
        let orientation = [1.0, 0.0, 0.0, 0.0];
        Shape { geometry, position: [x, y, 0.0], orientation }
    };
    match body {
        "boom" => vec![at(Geometry::Box([4.0, 0.26, 0.26]), 2.0, 0.0)],
        "jib" => vec![at(Geometry::Box([3.0, 0.18, 0.18]), 1.5, 0.0)],
        _ => vec![
            at(Geometry::Box([0.03, 1.7, 0.03]), 0.0, -0.85),
            at(Geometry::Box([0.8, 0.6, 0.6]), 0.0, -2.0),
        ],
    }
}

fn picture() -> String {
    let crane = Crane::<f64>::new();
    let mut state = crane.initial_state();
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..STEPS {
        rk4.step(&crane, &mut state, |_time, _state| crane.no_inputs()).expect("a step");
    }
    let mut recording = Recording::new(&crane);
    recording.record(&state, &crane.no_inputs()).expect("a solution");
    let mut motion = recording.into_motion();
    for body in &mut motion.mechanism_mut().bodies {
        body.shapes = shapes(&body.name);
    }
    motion.svg(0).expect("a picture")
}

/// The picture as a URI.
fn uri(svg: &str) -> String {
    let mut uri = "data:image/svg+xml,".to_owned();
    for byte in svg.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'/' | b':' | b'=' | b',' => {
                uri.push(byte.into());
            }
            _ => write!(uri, "%{byte:02X}").expect("text can be written"),
        }
    }
    uri + "\n\n"
}

#[test]
fn the_picture_shows_the_results_of_the_program() {
    let picture = picture();
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(super::path(FILE), &picture).expect("a writable folder");
        std::fs::write(super::path(LINK), uri(&picture)).expect("a writable folder");
    }
    assert!(super::read(FILE) == picture, "MSTMM_BLESS=1 draws {FILE} anew");
    assert!(super::read(LINK) == uri(&picture), "MSTMM_BLESS=1 writes {LINK} anew");

    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let readme = super::read("README.md");
    assert!(readme.contains(FILE));
    assert!(squeezed(&readme).contains(&squeezed(TEXT)), "the README has another chain");
    assert!(readme.contains("Rk4::new(1e-3)") && readme.contains(&format!("0..{STEPS}")));
}
