//! Trees of a thousand bodies: as accurate as chains, and as costly for each repetition as short trees.

use super::counted::{Counted, operations};
use crate::double_double::DoubleDouble;
use crate::{DOUBLE, Pose, SINGLE, error, exact_energy, with_room};
use mstmm::{GeneratedChain, mstmm_chain};

macro_rules! trees {
    ($($name:ident { $($route:tt)* })*) => { $(
        mstmm_chain! { chain $name {
            gravity = [0, -9.8, 0] m/s^2;
            body Cube {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                point left = [1, 0.5, 0] m turned rpy(0, 0, 90) deg;
                point right = [1, -0.5, 0] m turned rpy(0, 0, -90) deg;
            }
            body Rung {
                mass = 0.25 kg;
                com = [0.25, 0, 0] m;
                output = [0.5, 0, 0] m;
                inertia = diag(1/96, 1/48, 1/48) kg*m^2 about com;
            }
            $($route)*
        } }
    )* };
}

/// Two rungs on every link, with as many links as given.
macro_rules! ladders {
    ($($name:ident of $links:literal;)*) => {
        trees! { $( $name {
            ground -> repeat $links {
                ball knot -> Cube link;
                link.left -> pin(z) a -> Rung left;
                link.right -> pin(y) b -> Rung right;
            };
        } )* }
    };
}

/// A floating head and segments with two legs each: parts in a repeated part of a part.
macro_rules! centipedes {
    ($($name:ident of $segments:literal;)*) => {
        trees! { $( $name {
            part Leg(side) {
                pin(y) hip -> Rung thigh -> pin([0, side, 0]) knee -> Rung shank;
            }
            part Segment(side) {
                pin(z) joint -> Cube cube;
                cube.left -> Leg(side) left;
                cube.right -> Leg(-side) right;
            }
            Cube head -> repeat $segments { Segment(1) segment };
        } )* }
    };
}

/// Two rails: the second one leaves the previous repetition.
macro_rules! rails {
    ($($name:ident of $rungs:literal;)*) => {
        trees! { $( $name {
            ground -> universal(y, z) base -> Cube beam
                -> repeat $rungs from right.output = beam.left {
                    pin(y) a -> Cube left;
                    last.right.output -> pin(z) b -> Rung right;
                };
        } )* }
    };
}

ladders! { Ladder of 334; Ladder34 of 34; Ladder4 of 4; }
centipedes! { Centipede of 200; Centipede20 of 20; Centipede2 of 2; }
rails! { Rails of 500; Rails50 of 50; Rails5 of 5; }

#[test]
fn a_ladder_of_a_thousand_bodies() {
    compare!(Ladder true);
}

#[test]
fn a_centipede_of_a_thousand_bodies() {
    compare!(Centipede true);
}

#[test]
fn two_rails_of_five_hundred_bodies() {
    compare!(Rails true);
}

/// Returns the operations of accelerations, of all results and of an energy.
fn cost<C: GeneratedChain<Scalar = Counted>>(chain: &C) -> [u64; 3] {
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let (mut rate, mut at) = (state.clone(), Box::new(chain.workspace()));
    [
        operations(|| chain.derivative_into(&state, &inputs, &mut rate).expect("a regular tree")),
        operations(|| chain.solve_into(&state, &inputs, &mut at).expect("a regular tree")),
        operations(|| _ = chain.energy(&state)),
    ]
}

/// The cost is the same for each repetition, to the operation. The lengths are such that the ratio of
/// their differences is ten.
macro_rules! linear {
    ($($long:ident $middle:ident $short:ident)*) => { $(
        with_room(|| {
            let name = stringify!($long);
            let long = cost(&$long::<Counted>::new());
            let middle = cost(&$middle::<Counted>::new());
            let short = cost(&$short::<Counted>::new());
            println!("{name}: {short:?}, {middle:?}, {long:?} operations");
            for (k, short) in short.into_iter().enumerate() {
                assert!(short > 0 && middle[k] > short, "{name}: nothing is counted");
                assert_eq!(long[k] - middle[k], 10 * (middle[k] - short), "{name}, answer {k}");
            }
        });
    )* };
}

#[test]
fn each_repetition_costs_the_same() {
    linear! {
        Ladder Ladder34 Ladder4
        Centipede Centipede20 Centipede2
        Rails Rails50 Rails5
    }
}
