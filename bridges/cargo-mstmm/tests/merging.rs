//! Merging links keeps mass, centre of mass and inertia of the whole robot.

use cargo_mstmm::import::{Options, import};
use mstmm_codegen::model::{Attachment, BodyId, Chain, Frame, Value};
use nalgebra::{Matrix3, Vector3};
use proc_macro2::{TokenStream, TokenTree};

/// Mass, centre of mass, and inertia about the centre of mass, all at the zero position.
struct Whole {
    mass: f64,
    com: Vector3<f64>,
    tensor: Matrix3<f64>,
}

fn read(text: &str) -> Chain {
    let tokens: TokenStream = text.parse().expect("tokens");
    let groups = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(group.stream()),
        _ => None,
    });
    mstmm_codegen::read(groups.collect()).expect("a chain").remove(0).0
}

fn known(value: &Value) -> f64 {
    value.known().expect("a number")
}

fn vector(values: &[Value; 3]) -> Vector3<f64> {
    Vector3::from_fn(|i, _| known(&values[i]))
}

fn place(frame: &Frame) -> (Vector3<f64>, Matrix3<f64>) {
    (vector(&frame.position), Matrix3::from_fn(|i, j| known(&frame.rotation[i][j])))
}

/// Returns the position and the rotation of each body at the zero position, where the frames of a hinge coincide.
fn places(chain: &Chain) -> Vec<(Vector3<f64>, Matrix3<f64>)> {
    let mut places = vec![(Vector3::zeros(), Matrix3::identity()); chain.bodies.iter().count()];
    for hinge in chain.hinges.iter() {
        let Attachment::Input(body) = hinge.outboard else { panic!("a hinge ends at an input") };
        let at = |body: BodyId| places[body.index()];
        let ((r, rotation), (d, inner)) = match &hinge.inboard {
            Attachment::Ground(frame) => ((Vector3::zeros(), Matrix3::identity()), place(frame)),
            Attachment::Input(body) => (at(*body), (Vector3::zeros(), Matrix3::identity())),
            Attachment::Output(body) => (at(*body), place(&chain.bodies[*body].output)),
            Attachment::Point(body, index) => {
                (at(*body), place(&chain.bodies[*body].points[*index].frame))
            }
        };
        places[body.index()] = (r + rotation * d, rotation * inner);
    }
    places
}

fn whole(text: &str) -> Whole {
    let chain = read(text);
    let mut parts = Vec::new();
    for (body, (r, rotation)) in chain.bodies.iter().zip(places(&chain)) {
        let [xx, yy, zz, xy, xz, yz] = body.inertia.tensor.each_ref().map(known);
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        parts.push((
            known(&body.mass),
            r + rotation * vector(&body.com),
            rotation * tensor * rotation.transpose(),
        ));
    }
    let mass: f64 = parts.iter().map(|(mass, ..)| mass).sum();
    let com = parts.iter().map(|(mass, com, _)| com * *mass).sum::<Vector3<f64>>() / mass;
    let tensor = parts.iter().map(|(mass, at, tensor)| {
        let cross = (at - com).cross_matrix();
        tensor - cross * cross * *mass
    });
    Whole { mass, com, tensor: tensor.sum() }
}

#[test]
fn mass_centre_and_invariants_of_the_tensor_stay() {
    for file in ["arm", "dog", "merged"] {
        let path = format!("{}/tests/urdf/{file}.urdf", env!("CARGO_MANIFEST_DIR"));
        let moving = std::fs::read_to_string(path).unwrap();
        let mut rigid = moving.clone();
        for kind in ["revolute", "continuous", "prismatic"] {
            rigid = rigid.replace(&format!("type=\"{kind}\""), "type=\"fixed\"");
        }
        let floating = Options { floating: true, ..Options::default() };
        // The base of the arm has no mass: it cannot float.
        let options = if file == "arm" { Options::default() } else { floating.clone() };
        let [moving, rigid] = [(moving, options), (rigid, floating)]
            .map(|(text, options)| whole(&import(&text, &options).unwrap().text));
        // Sums of at most 20 terms, each with a few roundings.
        let tolerance = 100.0 * f64::EPSILON;
        assert!((moving.mass - rigid.mass).abs() <= tolerance * rigid.mass, "{file}");
        assert!(
            (moving.com - rigid.com).norm() <= tolerance,
            "{file}: {} {}",
            moving.com,
            rigid.com
        );
        let invariants = |j: &Matrix3<f64>| {
            let trace = j.trace();
            [trace, (trace * trace - (j * j).trace()).abs().sqrt(), j.determinant().cbrt()]
        };
        for (a, b) in invariants(&moving.tensor).into_iter().zip(invariants(&rigid.tensor)) {
            assert!((a - b).abs() <= tolerance * rigid.tensor.trace(), "{file}: {a} {b}");
        }
    }
}
