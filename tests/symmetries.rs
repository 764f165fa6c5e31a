//! Different descriptions of one mechanism have the same motion: translated and rotated, with a body made of
//! two halves, written from the other end.

mod support;

use mstmm::{Chain, ChainState, Dopri5, Point, StateVector};
use mstmm_reference::Random;
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use support::matter::Lump;
use support::mechanism::{Mechanism, both};
use support::{difference, worst};

const STATES: u64 = 20;

/// Condition numbers of some thousands times a hundred roundings.
const AT_ONCE: f64 = 1e-11;

/// After half a second at a tolerance of 1e-12 a step: some hundred steps, and neighbouring motions
/// part by less than a hundred times.
const LATER: f64 = 1e-8;

/// Returns all results at a point after a rotation of the world by `turn`.
fn entries(point: &Point<f64>, turn: &Rotation3<f64>, shift: &Vector3<f64>) -> Vec<f64> {
    let mut entries: Vec<f64> = Vec::new();
    entries.extend((turn * point.position() + shift).iter());
    entries.extend((turn * point.orientation()).matrix().iter());
    for vector in [
        point.velocity(),
        point.angular_velocity(),
        point.acceleration(),
        point.angular_acceleration(),
        point.force(),
        point.moment(),
    ] {
        entries.extend((turn * vector).iter());
    }
    entries
}

fn as_it_is(points: &[Point<f64>]) -> Vec<f64> {
    let (turn, shift) = (Rotation3::identity(), Vector3::zeros());
    points.iter().flat_map(|point| entries(point, &turn, &shift)).collect()
}

fn points<C: Mechanism>(chain: &C, state: &C::State) -> Vec<Point<f64>>
where
    C::Inputs: Default,
{
    chain.answer(state, &C::Inputs::default()).expect("a regular chain").points
}

fn half_a_second<C: Mechanism>(chain: &C, state: &mut C::State)
where
    C::Inputs: Default,
{
    let mut dopri5 = Dopri5::new(1e-12, 1e-12);
    dopri5.advance_to(chain, state, 0.5, |_, _| C::Inputs::default()).expect("steps");
}

/// Two chains in states that `same` makes the same: compared at once and half a second later.
fn move_alike<A: Mechanism, B: Mechanism>(
    name: &str,
    same: impl Fn(&A::State, &mut B::State),
    seen: impl Fn(&[Point<f64>], &[Point<f64>]) -> f64,
) where
    A::Inputs: Default,
    B::Inputs: Default,
{
    let (a, b) = (A::default(), B::default());
    let (mut at_once, mut later) = (0.0, 0.0);
    for seed in 0..STATES {
        let mut state_a = a.random_state(&mut Random::new(seed));
        let mut state_b = b.start();
        same(&state_a, &mut state_b);
        let off = seen(&points(&a, &state_a), &points(&b, &state_b));
        assert!(off < AT_ONCE, "{name}, seed {seed}: {off:e} at once");
        at_once = worst(at_once, off);
        if seed < 5 {
            half_a_second(&a, &mut state_a);
            half_a_second(&b, &mut state_b);
            let off = seen(&points(&a, &state_a), &points(&b, &state_b));
            assert!(off < LATER, "{name}, seed {seed}: {off:e} later");
            later = worst(later, off);
        }
    }
    println!("{name}: {at_once:.1e} at once, {later:.1e} later");
}

/// The bodies of all chains here, in front of their routes.
macro_rules! arm {
    ($riccati:ident $transfer:ident $gravity:tt { $($route:tt)* }) => {
        both! { $riccati $transfer [Ball, Pin] {
            gravity = $gravity m/s^2;
            body Upper {
                mass = 2 kg;
                com = [0.5, 0.1, 0] m;
                output = [1, 0, 0.2] m turned rpy(90, 0, 0) deg;
                inertia = tensor(0.3, 0.5, 0.6, 0.1, -0.04, 0.02) kg*m^2 about com;
            }
            body Lower {
                mass = 1 kg;
                com = [0.4, 0, -0.1] m;
                output = [0.8, 0.3, 0] m;
                inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com;
            }
            $($route)*
        } }
    };
}

arm! { Here HereByTransfer [0, -9.8, 0] {
    ground -> ball shoulder -> Upper upper -> pin(z) elbow -> Lower lower;
} }

// A_z(30°) A_x(20°) turns the gravity above into this one.
arm! { There ThereByTransfer
    [9.8 * cos(20 deg) * sin(30 deg), -9.8 * cos(20 deg) * cos(30 deg), -9.8 * sin(20 deg)]
{
    ground at [1, -2, 3] m turned rpy(20, 0, 30) deg
        -> ball shoulder -> Upper upper -> pin(z) elbow -> Lower lower;
} }

#[test]
fn a_turned_and_shifted_world_moves_alike() {
    let turn = Rotation3::from_euler_angles(20f64.to_radians(), 0.0, 30f64.to_radians());
    let shift = Vector3::new(1.0, -2.0, 3.0);
    let seen = |here: &[Point<f64>], there: &[Point<f64>]| {
        // The ground's own frame is turned too, so every point is.
        let expected: Vec<f64> =
            here.iter().flat_map(|point| entries(point, &turn, &shift)).collect();
        difference(&as_it_is(there), &expected)
    };
    fn same(here: &impl ChainState<Scalar = f64>, there: &mut impl ChainState<Scalar = f64>) {
        there.coordinates_mut().copy_from_slice(here.coordinates());
        there.rates_mut().copy_from_slice(here.rates());
    }
    move_alike::<Here<f64>, There<f64>>("riccati", same, seen);
    move_alike::<HereByTransfer<f64>, ThereByTransfer<f64>>("transfer", same, seen);
}

// The same bodies with the origins at their other ends, whose frames have the axes of the old
// outputs: x, y, z of `Upper` are x, −z, y there.
both! { Backwards BackwardsByTransfer [Pin, Ball] {
    gravity = [0, -9.8, 0] m/s^2;
    body Lower {
        mass = 1 kg;
        com = [-0.4, -0.3, -0.1] m;
        output = [-0.8, -0.3, 0] m;
        inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com;
    }
    body Upper {
        mass = 2 kg;
        com = [-0.5, -0.2, -0.1] m;
        output = [-1, -0.2, 0] m turned rpy(-90, 0, 0) deg;
        inertia = tensor(0.3, 0.6, 0.5, -0.04, -0.1, -0.02) kg*m^2 about com;
    }
    Lower lower -> pin(z) elbow -> Upper upper -> ball shoulder -> ground;
} }

/// Implements the change of a state when all is written from the other end.
macro_rules! backwards {
    ($($forwards:ident $backwards:ident $reverse:ident;)*) => { $(
        fn $reverse(
            from: &<$forwards<f64> as Chain>::State,
            to: &mut <$backwards<f64> as Chain>::State,
        ) {
            to.elbow_mut().set_angle(-from.elbow().angle()).set_rate(-from.elbow().rate());
            let turn: UnitQuaternion<f64> = from.shoulder().orientation();
            to.shoulder_mut()
                .set_orientation(turn.inverse())
                .set_rate(-(turn * from.shoulder().rate()));
        }
    )* };
}

backwards! {
    Here Backwards reversed;
    HereByTransfer BackwardsByTransfer reversed_by_transfer;
}

/// The same point with the force and moment on the other neighbour.
fn from_the_other_side(point: &Point<f64>) -> Point<f64> {
    let z = StateVector::new(
        point.acceleration().into(),
        point.angular_acceleration().into(),
        (-point.moment()).into(),
        (-point.force()).into(),
    );
    // nalgebra keeps columns, a point rows.
    let rows = point.orientation().matrix().transpose().data.0;
    let [position, velocity, spin] =
        [point.position(), point.velocity(), point.angular_velocity()].map(<[f64; 3]>::from);
    Point::new(position, rows, velocity, spin, z)
}

#[test]
fn a_chain_written_from_the_other_end_moves_the_same() {
    // What was an input is an output, where force and moment count the other way.
    let seen = |forwards: &[Point<f64>], backwards: &[Point<f64>]| {
        let reversed: Vec<Point<f64>> = backwards.iter().rev().map(from_the_other_side).collect();
        difference(&as_it_is(&reversed), &as_it_is(forwards))
    };
    move_alike::<Here<f64>, Backwards<f64>>("riccati", reversed, seen);
    move_alike::<HereByTransfer<f64>, BackwardsByTransfer<f64>>(
        "transfer",
        reversed_by_transfer,
        seen,
    );
}

both! { Whole WholeByTransfer [Ball, Pin] {
    gravity = [0, -9.8, 0] m/s^2;
    body Beam {
        mass = 2 kg;
        com = [0.5, 0.1, 0] m;
        output = [1, 0, 0] m;
        // Twice the half's, and 2 · 1 kg · (0.25 m)² across x.
        inertia = tensor(0.16, 0.325, 0.365, 0.02, -0.04, 0.06) kg*m^2 about com;
    }
    body Tip {
        mass = 1 kg;
        com = [0.3, 0, 0.1] m;
        inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
    }
    ground -> ball shoulder -> Beam beam -> pin([1, 0, 2]) elbow -> Tip tip;
} }

// The second half's frame is turned by 90° about z: its x is the beam's y, its y the beam's −x.
both! { Halves HalvesByTransfer [Ball, Pin] {
    gravity = [0, -9.8, 0] m/s^2;
    body First {
        mass = 1 kg;
        com = [0.25, 0.1, 0] m;
        output = [0.5, 0, 0] m turned rpy(0, 0, 90) deg;
        inertia = tensor(0.08, 0.1, 0.12, 0.01, -0.02, 0.03) kg*m^2 about com;
    }
    body Second {
        mass = 1 kg;
        com = [0.1, -0.25, 0] m;
        output = [0, -0.5, 0] m turned rpy(0, 0, -90) deg;
        inertia = tensor(0.1, 0.08, 0.12, -0.01, 0.03, 0.02) kg*m^2 about com;
    }
    body Tip {
        mass = 1 kg;
        com = [0.3, 0, 0.1] m;
        inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
    }
    ground -> ball shoulder -> First first -> weld seam -> Second second
        -> pin([1, 0, 2]) elbow -> Tip tip;
} }

/// The halves as above.
const FIRST: Lump =
    Lump { mass: 1.0, com: [0.25, 0.1, 0.0], inertia: [0.08, 0.1, 0.12, 0.01, -0.02, 0.03] };
const SECOND: Lump =
    Lump { mass: 1.0, com: [0.1, -0.25, 0.0], inertia: [0.1, 0.08, 0.12, -0.01, 0.03, 0.02] };

#[test]
fn two_halves_welded_move_like_the_whole() {
    let seen = |whole: &[Point<f64>], halves: &[Point<f64>]| {
        let [ground, shoulder, _first, _seam, second @ ..] = halves else { panic!("six elements") };
        let outside = [&[*ground, *shoulder], second].concat();
        difference(&as_it_is(&outside), &as_it_is(whole))
    };
    fn same(whole: &impl ChainState<Scalar = f64>, halves: &mut impl ChainState<Scalar = f64>) {
        halves.coordinates_mut().copy_from_slice(whole.coordinates());
        halves.rates_mut().copy_from_slice(whole.rates());
    }
    move_alike::<Whole<f64>, Halves<f64>>("riccati", same, seen);
    move_alike::<WholeByTransfer<f64>, HalvesByTransfer<f64>>("transfer", same, seen);
}

/// The weld between the halves transmits the wrench that each half needs for its motion.
#[test]
fn the_points_of_a_weld_report_the_load_inside() {
    fn check<C: Mechanism>()
    where
        C::Inputs: Default,
    {
        let chain = C::default();
        for seed in 0..STATES {
            let state = chain.random_state(&mut Random::new(seed));
            let points = points(&chain, &state);
            let [_, input, cut, seam, output, ..] = &points[..] else { panic!("six elements") };
            assert_eq!((cut.force(), cut.moment()), (seam.force(), seam.moment()));
            assert!(cut.force().norm() > 1.0, "seed {seed}: nothing to see");
            let gravity = [0.0, -9.8, 0.0];
            let off = FIRST
                .imbalance([input, cut], gravity)
                .max(SECOND.imbalance([seam, output], gravity));
            assert!(off < AT_ONCE, "seed {seed}: {off:e}");
        }
    }
    check::<Halves<f64>>();
    check::<HalvesByTransfer<f64>>();
}
