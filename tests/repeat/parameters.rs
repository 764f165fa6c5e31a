//! Parameters of repeated parts: one number for all repetitions, and one for each.

use super::twins::Pair;
use mstmm::{Error, mstmm_chain};
use mstmm_reference::Random;

macro_rules! chains {
    ($(
        $name:ident $method:ident [$($rod:ident $knot:ident $bend:ident $([$size:literal])?),*]
        { $($rest:tt)* }
    )*) => { $(
        mstmm_chain! { chain $name {
            method = $method;
            param fall = 9.8 m/s^2;
            param extra = 0.5 kg;
            param length = 0.6 m;
            param hard = 30 N*m/rad;
            $(
                param $knot $([$size])? = 0.2 kg;
                param $bend $([$size])? = 0.1;
            )*
            gravity = [1 m/s^2, -1 * fall, 2 m/s^2];
            body Base {
                mass = 1 kg + extra;
                com = [0.1, 0.2, 0] m;
                output = [0.2, 0.3, 0] m;
                inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
            }
            $( body $rod {
                mass = 1 kg + extra + $knot;
                com = [0.5 * length, (0.1 m) * $bend, 0 m];
                output = [length, 0 m, 0.1 m] turned rpy(0.3, $bend, 0.1);
                inertia = diag((0.1 m^2) * (1 kg + $knot), 0.2 kg*m^2, 0.2 kg*m^2) about com;
            } )*
            $($rest)*
        } }
    )* };
}

chains! {
    Knots riccati [Rod knot bend [3]] {
        ground -> ball first -> Base base -> repeat 3 { pin a -> Rod b } -> pin k -> Base last;
        hinge a { stiffness = hard; damping = 2 * bend; }
        spring s { on = b; at = output; to = [0, 1, 2] m; stiffness = 3 * bend; length = length; }
    }
    KnotsByTransfer transfer [Rod knot bend [3]] {
        ground -> ball first -> Base base -> repeat 3 { pin a -> Rod b } -> pin k -> Base last;
        hinge a { stiffness = hard; damping = 2 * bend; }
        spring s { on = b; at = output; to = [0, 1, 2] m; stiffness = 3 * bend; length = length; }
    }
    KnotsOut riccati [Rod1 knot1 bend1, Rod2 knot2 bend2, Rod3 knot3 bend3] {
        ground -> ball first -> Base base -> pin a1 -> Rod1 b1 -> pin a2 -> Rod2 b2
            -> pin a3 -> Rod3 b3 -> pin k -> Base last;
        hinge a1 { stiffness = hard; damping = 2 * bend1; }
        hinge a2 { stiffness = hard; damping = 2 * bend2; }
        hinge a3 { stiffness = hard; damping = 2 * bend3; }
        spring s1 { on = b1; at = output; to = [0, 1, 2] m; stiffness = 3 * bend1; length = length; }
        spring s2 { on = b2; at = output; to = [0, 1, 2] m; stiffness = 3 * bend2; length = length; }
        spring s3 { on = b3; at = output; to = [0, 1, 2] m; stiffness = 3 * bend3; length = length; }
    }
}

macro_rules! compare {
    ($chain:ident) => {
        for seed in 0..5 {
            let mut random = Random::new(seed);
            let [fall, extra, length, hard] =
                [9.0, 0.4, 0.5, 20.0].map(|least| random.between(least, 1.5 * least));
            let knots = [(); 3].map(|()| random.between(0.1, 0.5));
            let bends = [(); 3].map(|()| random.between(0.1, 0.5));
            let (mut repeated, mut unrolled) = ($chain::<f64>::new(), KnotsOut::<f64>::new());
            let mut set = || -> Result<(), Error> {
                repeated.set_fall(fall)?;
                repeated.set_extra(extra)?;
                repeated.set_length(length)?;
                repeated.set_hard(hard)?;
                repeated.set_knot(|index| knots[index])?;
                repeated.set_bend(|index| bends[index])?;
                unrolled.set_fall(fall)?;
                unrolled.set_extra(extra)?;
                unrolled.set_length(length)?;
                unrolled.set_hard(hard)?;
                unrolled.set_knot1(knots[0])?;
                unrolled.set_knot2(knots[1])?;
                unrolled.set_knot3(knots[2])?;
                unrolled.set_bend1(bends[0])?;
                unrolled.set_bend2(bends[1])?;
                unrolled.set_bend3(bends[2])
            };
            set().expect("numbers that make sense");
            assert_eq!(repeated.parameters().knot(), &knots);
            assert_eq!(repeated.parameters().extra(), extra);
            Pair { name: stringify!($chain), repeated, unrolled }.check(|_, _| {}, |_, _| {});
        }
        let (repeated, unrolled) = ($chain::<f64>::new(), KnotsOut::<f64>::new());
        Pair { name: "defaults", repeated, unrolled }.check(|_, _| {}, |_, _| {});
    };
}

#[test]
fn parameters_that_are_set() {
    compare!(Knots);
    compare!(KnotsByTransfer);
}

/// A value that is invalid for one repetition is rejected for all, and nothing changes.
#[test]
fn parameters_that_are_refused() {
    let mut chain = Knots::<f64>::new();
    chain.set_knot(|index| index as f64).expect("masses that are positive");
    let before = chain.clone();
    let reason = |result| match result {
        Err(Error::InvalidParameter { name, reason }) => (name, reason),
        other => panic!("{other:?}"),
    };
    for wrong in 0..3 {
        let set = |value: f64| move |index| if index == wrong { value } else { 0.1 };
        let (name, why) = reason(chain.set_knot(set(-2.0)));
        assert!(name == "knot" && why.contains("mass"), "{name} {why}");
        assert_eq!(reason(chain.set_knot(set(f64::NAN))).0, "knot");
        let (name, why) = reason(chain.set_bend(set(-1.0)));
        assert!(name == "bend" && !why.is_empty(), "{name} {why}");
        assert_eq!(reason(chain.set_extra(-1.5)).0, "extra");
        assert_eq!(format!("{chain:?}"), format!("{before:?}"));
    }
}
