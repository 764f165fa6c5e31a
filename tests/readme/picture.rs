//! The README's picture: its crane at the end of its program, with the forces in the hinges and the weights.

use mstmm::prelude::*;
use nalgebra::Vector2;
use std::fmt::{Display, Write};

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

const BODY: &str = "#3a87c8";
const HINGE: &str = "#2f9e62";
const FORCE: &str = "#d0761a";
/// Readable on white and on black.
const GREY: &str = "#77808a";

/// Pixels for a metre, and for a kilonewton.
const METRE: f64 = 70.0;
const KILONEWTON: f64 = 12.0;

type Pixel = Vector2<f64>;

fn pixel(position: Vector2<f64>) -> Pixel {
    Pixel::new(position.x, -position.y) * METRE
}

/// An SVG that grows.
#[derive(Default)]
struct Svg(String);

impl Svg {
    fn line(&mut self, line: impl Display) {
        writeln!(self.0, "{line}").expect("text can be written");
    }

    fn circle(&mut self, centre: Pixel, radius: f64, colour: &str) {
        let [x, y] = centre.into();
        self.line(format_args!(
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="{radius}" fill="{colour}"/>"#
        ));
    }

    fn bar(&mut self, from: Pixel, to: Pixel, width: f64, opacity: f64) {
        let ends = format!("M{:.1} {:.1}L{:.1} {:.1}", from.x, from.y, to.x, to.y);
        self.line(format_args!(
            r#"<path d="{ends}" stroke="{BODY}" stroke-opacity="{opacity}" stroke-width="{width}"/>"#
        ));
    }

    fn text(&mut self, at: Pixel, anchor: &str, colour: &str, text: impl Display) {
        let [x, y] = at.into();
        self.line(format_args!(
            r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{text}</text>"#
        ));
    }

    /// A force that acts at a point; its label stands beside the tip.
    fn force(&mut self, at: Pixel, newton: Vector2<f64>, colour: &str) {
        let along = Pixel::new(newton.x, -newton.y) * (KILONEWTON / 1000.0);
        let (tip, unit) = (at + along, along.normalize());
        let (shaft, aside) = (tip - unit * 8.0, Pixel::new(-unit.y, unit.x) * 5.0);
        let [left, right] = [tip - unit * 11.0 + aside, tip - unit * 11.0 - aside];
        self.line(format_args!(
            r#"<path d="M{:.1} {:.1}L{:.1} {:.1}" stroke="{colour}" stroke-width="3"/>"#,
            at.x, at.y, shaft.x, shaft.y
        ));
        self.line(format_args!(
            r#"<path d="M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z" fill="{colour}"/>"#,
            tip.x, tip.y, left.x, left.y, right.x, right.y
        ));
        let label = format!("{:.1} kN", newton.norm() / 1000.0);
        let (anchor, beside) = if along.x < -1.0 { ("end", -8.0) } else { ("start", 8.0) };
        self.text(tip + Pixel::new(beside, 4.0), anchor, colour, label);
    }
}

fn picture() -> String {
    let crane = Crane::<f64>::new();
    let mut state = crane.initial_state();
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..STEPS {
        rk4.step(&crane, &mut state, |_time, _state| crane.no_inputs()).expect("a step");
    }
    let mut at = crane.workspace();
    crane.solve_into(&state, &crane.no_inputs(), &mut at).expect("a solution");

    let hinges = [at.foot().output(), at.knuckle().output(), at.hook().output()];
    let [foot, knuckle, hook] = hinges.map(|point| pixel(point.position()));
    let load = pixel(at.load().com().position());

    let mut svg = Svg::default();
    svg.line(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-110 -400 550 430" width="550""#);
    svg.line(r#" font-family="sans-serif" font-size="15" stroke-linecap="round" stroke-linejoin="round" role="img""#);
    svg.line(r#" aria-label="A crane with a swinging load, the forces in its three pins and the weights of its bodies">"#);
    // The ground, the boom, the jib, the rope and the load.
    svg.line(format_args!(r#"<path d="M0 0L-26 22L26 22Z" fill="{GREY}" fill-opacity="0.4"/>"#));
    svg.line(format_args!(r#"<path d="M-50 22L50 22" stroke="{GREY}" stroke-width="2"/>"#));
    svg.bar(foot, knuckle, 16.0, 0.35);
    svg.bar(knuckle, hook, 12.0, 0.35);
    svg.bar(hook, load, 2.0, 0.8);
    let turn = -at.load().com().orientation().angle().to_degrees();
    svg.line(format_args!(
        r#"<rect x="-24" y="-16" width="48" height="32" transform="translate({:.1} {:.1}) rotate({turn:.1})" fill="{BODY}" fill-opacity="0.35"/>"#,
        load.x, load.y
    ));
    for (com, mass) in [(at.boom().com(), 400.0), (at.jib().com(), 200.0), (at.load().com(), 500.0)]
    {
        svg.force(pixel(com.position()), Vector2::new(0.0, -9.81 * mass), GREY);
    }
    for (name, point) in ["foot", "knuckle", "hook"].into_iter().zip(&hinges) {
        let centre = pixel(point.position());
        svg.force(centre, point.force(), FORCE);
        svg.circle(centre, 5.0, HINGE);
        match name {
            "hook" => svg.text(centre + Pixel::new(14.0, 0.0), "start", HINGE, name),
            _ => svg.text(centre + Pixel::new(-14.0, 4.0), "end", HINGE, name),
        }
    }
    svg.line("</svg>");
    svg.0
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
