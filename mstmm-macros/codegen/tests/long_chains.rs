//! Tests that the accuracy does not decrease with the length of a chain: accelerations and transmitted wrenches of long
//! chains against the same equations in twice the precision.

mod common;

use common::double_double::DoubleDouble;
use common::{Computed, Point, compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::{Scalar, Structured, Vec3};
use mstmm_codegen::model::{Chain, SolutionMethod};
use mstmm_reference::Random;

const LENGTHS: [usize; 3] = [3, 30, 300];

const CUBE: &str = "body Cube { mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input; }";

/// Returns a chain of `count` cubes; `kind` gives the hinge of each.
fn chain(count: usize, kind: impl Fn(usize) -> &'static str) -> Chain {
    let route: String = (0..count).map(|k| format!(" -> {} j{k} -> Cube b{k}", kind(k))).collect();
    read(&format!("chain Long {{ gravity = [0, -9.8, 0] m/s^2; {CUBE} ground{route}; }}"))
}

/// Returns the largest errors of the hinges' accelerations and of forces and moments at points, each relative to the largest
/// value of its kind.
fn errors<S: Scalar>(
    chain: &Chain,
    way: (SolutionMethod, Axes),
    seed: u64,
    number: fn(S) -> f64,
) -> [f64; 2] {
    let mut random = Random::new(seed);
    // Angles and rates that `f32` holds exactly, so that all precisions solve the same problem.
    // Quaternions cannot be of unit length in every precision: theirs is a rounding error of input.
    let mut short = |limit: f64| f64::from(random.between(-limit, limit) as f32);
    let (mut q, mut v) = (Vec::new(), Vec::new());
    for hinge in &chain.hinges {
        q.extend((0..hinge.kind.coordinates()).map(|_| short(1.0)));
        v.extend((0..hinge.kind.dof_count()).map(|_| short(2.0)));
        if hinge.kind.coordinates() == 4 {
            let quaternion = q.split_off(q.len() - 4);
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            q.extend(quaternion.iter().map(|x| x / length));
        }
    }
    let efforts = vec![0.0; v.len()];
    let truth = compute::<DoubleDouble>(chain, (SolutionMethod::Riccati, way.1), &q, &v, &efforts);
    let computed = compute::<S>(chain, way, &q, &v, &efforts);
    let (truth, computed) = (quantities(&truth, |x| x.high), quantities(&computed, number));
    let [accelerations, forces, moments] =
        [0, 1, 2].map(|kind| common::difference(&computed[kind], &truth[kind]));
    // NaN must not get lost in a maximum.
    [accelerations, if moments > forces || moments.is_nan() { moments } else { forces }]
}

/// Returns accelerations, forces and moments.
fn quantities<S: Scalar>(computed: &Computed<S>, number: fn(S) -> f64) -> [Vec<f64>; 3] {
    let points = &computed.report.points;
    let list = |vector: fn(&Point<Structured<S>>) -> Vec3<Structured<S>>| {
        points.iter().flat_map(|point| vector(point).0).map(|x| number(x.value())).collect()
    };
    let accelerations = computed.accelerations.iter().map(|&x| number(x)).collect();
    [accelerations, list(|point| point.force), list(|point| point.moment)]
}

/// Checks both methods, in the axes that they are used in, with `f64` and `f32`.
fn check(name: &str, axes: &[Axes], kind: impl Fn(usize) -> &'static str + Copy) {
    for count in LENGTHS {
        let chain = chain(count, kind);
        for method in [SolutionMethod::Riccati, SolutionMethod::Transfer] {
            for &axes in axes {
                for seed in 0..3 {
                    let double = errors::<f64>(&chain, (method, axes), seed, |x| x);
                    let single = errors::<f32>(&chain, (method, axes), seed, f64::from);
                    let [a, loads] = [0, 1].map(|kind| (double[kind], single[kind]));
                    let what = format!("{name} {count} {method:?} {axes:?} seed {seed}");
                    println!("{what}: {:.1e} {:.1e}, {:.1e} {:.1e}", a.0, a.1, loads.0, loads.1);
                    // A plain product of 30 elements has no correct digit in either precision.
                    assert!(a.0 < 1e-12 && a.1 < 1e-4, "{what}: accelerations");
                    // With `transfer` accelerations of points are sums of those of all hinges before,
                    // whose errors nothing takes back, and wrenches are sums over up to eight bodies.
                    let summed = if method == SolutionMethod::Transfer { 50.0 } else { 1.0 };
                    let bounds = (summed * 1e-12, summed * 1e-4);
                    assert!(loads.0 < bounds.0 && loads.1 < bounds.1, "{what}: loads");
                }
            }
        }
    }
}

#[test]
fn balls() {
    check("balls", &[Axes::Body, Axes::Inertial], |_| "ball");
}

#[test]
fn pins_in_a_plane() {
    check("planar pins", &[Axes::Body], |_| "pin(z)");
}

#[test]
fn pins_about_perpendicular_axes() {
    check("perpendicular pins", &[Axes::Body], |k| ["pin(z)", "pin(y)"][k % 2]);
}

#[test]
fn pins_about_oblique_axes() {
    check("oblique pins", &[Axes::Body, Axes::Inertial], |k| {
        ["pin([1, 2, 3])", "pin([0, 1, -1])", "pin(x)"][k % 3]
    });
}

#[test]
fn balls_and_pins() {
    check("balls and pins", &[Axes::Body, Axes::Inertial], |k| ["ball", "pin(y)"][k % 2]);
}
