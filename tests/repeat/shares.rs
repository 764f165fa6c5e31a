//! Forces and moments of hinges that leave the previous or the last repetition.

use super::twins::{copied, random_state};
use mstmm::nalgebra::Vector3;
use mstmm::{Point, mstmm_chain};
use mstmm_reference::Random;

macro_rules! ladder {
    ($name:ident { $($rest:tt)* }) => {
        mstmm_chain! {
            chain $name {
                gravity = [1, -9.8, 2] m/s^2;
                body Link {
                    mass = 1 kg;
                    com = [0.3, 0.1, 0] m;
                    output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
                    inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
                    point side = [0.2, 0.5, -0.1] m turned rpy(0, 40, 10) deg;
                }
                $($rest)*
            }
        }
    };
}

ladder! { Repeated {
    ground -> universal base -> Link beam -> repeat 3 from right.side = beam.side {
        pin(x) a -> Link left;
        last.right.side -> ball b -> Link right;
        left.side -> pin(y) c -> Link rung;
    } -> pin d -> Link weight;
    rung.side -> slider(x) e -> Link bead;
    left.output -> cylindrical f -> Link beside;
    hinge b { stiffness = 20; damping = 0.5; }
} }

ladder! { Written {
    ground -> universal base -> Link beam -> pin(x) a1 -> Link left1;
    beam.side -> ball b1 -> Link right1;
    left1.side -> pin(y) c1 -> Link rung1;
    left1.output -> pin(x) a2 -> Link left2;
    right1.side -> ball b2 -> Link right2;
    left2.side -> pin(y) c2 -> Link rung2;
    left2.output -> pin(x) a3 -> Link left3;
    right2.side -> ball b3 -> Link right3;
    left3.side -> pin(y) c3 -> Link rung3;
    left3.output -> pin d -> Link weight;
    rung3.side -> slider(x) e -> Link bead;
    left3.output -> cylindrical f -> Link beside;
    hinge b1, b2, b3 { stiffness = 20; damping = 0.5; }
} }

/// Some hundred operations between a state and a force, in a tree with a condition of some ten.
const TOLERANCE: f64 = 1e-12;

fn numbers(point: &Point<f64>) -> [Vector3<f64>; 4] {
    [point.position(), point.acceleration(), point.moment(), point.force()]
}

#[test]
fn hinges_have_the_shares_of_the_written_tree() {
    let (repeated, written) = (Repeated::<f64>::new(), Written::<f64>::new());
    let (mut at, mut twin_at) = (repeated.workspace(), written.workspace());
    for seed in 0..20 {
        let state = random_state::<Repeated<f64>>(&mut Random::new(seed));
        let twin: WrittenState<f64> = copied(&state);
        repeated.solve_into(&state, &repeated.no_inputs(), &mut at).expect("a regular tree");
        written.solve_into(&twin, &written.no_inputs(), &mut twin_at).expect("a regular tree");
        let mut points = Vec::new();
        macro_rules! pairs {
            ($($hinge:ident($index:literal) = $other:ident;)*) => { $(
                let (hinge, other) = (at.$hinge($index).expect("of three"), twin_at.$other());
                let name = stringify!($other);
                points.push((name, hinge.input(), other.input()));
                points.push((name, hinge.output(), other.output()));
            )* };
        }
        pairs! {
            a(0) = a1; a(1) = a2; a(2) = a3;
            b(0) = b1; b(1) = b2; b(2) = b3;
            c(0) = c1; c(1) = c2; c(2) = c3;
        }
        macro_rules! outside {
            ($($hinge:ident)*) => { $(
                let name = stringify!($hinge);
                points.push((name, at.$hinge().input(), twin_at.$hinge().input()));
                points.push((name, at.$hinge().output(), twin_at.$hinge().output()));
            )* };
        }
        outside!(base d e f);
        let sizes = points.iter().flat_map(|(_, _, other)| numbers(other));
        let largest = sizes.map(|vector| vector.norm()).fold(1.0, f64::max);
        for (name, point, other) in points {
            for (found, expected) in numbers(&point).into_iter().zip(numbers(&other)) {
                let off = (found - expected).norm() / largest;
                assert!(off < TOLERANCE, "seed {seed}, {name}: off by {off:e}");
            }
        }
    }
}
