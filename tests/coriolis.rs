//! The Coriolis matrix: textbook examples, and the derivative of the mass matrix along the motion by dual numbers.

use mstmm::nalgebra::{Matrix2, SMatrix, Vector2};
use mstmm::{Described, Dual, Error, mstmm_chain};
use mstmm_reference::Random;

mstmm_chain! {
    plane chain TwoLinks {
        gravity = [0, -9.81] m/s^2;
        answers = coriolis_matrix;
        body Upper { mass = 1.5 kg; com = [0.3, 0] m; output = [0.7, 0] m; inertia = 0.2 kg*m^2 about com; }
        body Lower { mass = 0.8 kg; com = [0.4, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin shoulder -> Upper upper -> pin elbow -> Lower lower;
        hinge shoulder, elbow { torque = input; armature = 0.3; damping = 0.4; }
    }

    plane chain Bead {
        answers = coriolis_matrix;
        body Wire { mass = 1 kg; com = [0, 0] m; output = [0, 0] m; inertia = 0.4 kg*m^2 about com; }
        body Ring { mass = 0.5 kg; com = [0, 0] m; inertia = 0.01 kg*m^2 about com; }
        ground -> pin turn -> Wire wire -> slider(x) along -> Ring ring;
    }

    line chain Train {
        answers = coriolis_matrix;
        body Car { mass = 2 kg; output = 1 m; }
        ground -> slider a -> Car one -> slider b -> Car two;
    }

    chain Crane {
        answers = [coriolis_matrix, mass_matrix];
        body Block {
            mass = 1.2 kg; com = [0.2, 0.1, -0.1] m; output = [0.5, 0.1, 0.3] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.3, 0.4, 0.5, 0.02, -0.03, 0.01) kg*m^2 about com;
        }
        ground -> ball base -> Block mast -> cylindrical(y) boom -> Block jib
            -> universal(x, [0, 1, 1]) swivel -> Block hook -> planar(z) table -> Block load;
    }
}

/// Entries below 10 of some dozen roundings.
const ROUNDING: f64 = 1e-14;

/// The manipulator with two links of M. W. Spong, S. Hutchinson, M. Vidyasagar, *Robot Modeling and Control*, section 7.4:
/// `C = [[h q̇₂, h (q̇₁ + q̇₂)], [−h q̇₁, 0]]` with `h = −m₂ l₁ l_c2 sin q₂`.
#[test]
fn arm_with_two_links() -> Result<(), Error> {
    let arm = TwoLinks::<f64>::new();
    let mut state = arm.initial_state();
    state.q = Vector2::new(0.3, -0.9);
    state.v = Vector2::new(1.7, -0.6);
    let h = -0.8 * 0.7 * 0.4 * state.q[1].sin();
    let (one, two) = (state.v[0], state.v[1]);
    let expected = Matrix2::new(h * two, h * (one + two), -h * one, 0.0);
    let found = arm.coriolis_matrix(&state, &arm.no_inputs())?;
    assert!((found - expected).amax() < ROUNDING, "{found} is not {expected}");
    let x = Vector2::new(0.4, -1.1);
    let product = arm.coriolis_matrix_times(&state, &arm.no_inputs(), &x)?;
    assert!((product - expected * x).amax() < ROUNDING, "{product}");
    Ok(())
}

/// A bead on a rotating wire, in polar coordinates: the force `−m r φ̇²` along the wire and the torque `2 m r ṙ φ̇`.
#[test]
fn bead_on_a_wire() -> Result<(), Error> {
    let wire = Bead::<f64>::new();
    let mut state = wire.initial_state();
    state.q = Vector2::new(0.2, 0.6);
    state.v = Vector2::new(1.3, -0.7);
    let (m, r) = (0.5, state.q[1]);
    let expected = Matrix2::new(r * state.v[1], r * state.v[0], -r * state.v[0], 0.0) * m;
    let found = wire.coriolis_matrix(&state, &wire.no_inputs())?;
    assert!((found - expected).amax() < ROUNDING, "{found} is not {expected}");
    Ok(())
}

/// Nothing rotates on a line.
#[test]
fn zero_on_a_line() -> Result<(), Error> {
    let train = Train::<f64>::new();
    let mut state = train.initial_state();
    state.v = Vector2::new(1.0, 2.0);
    assert_eq!(train.coriolis_matrix(&state, &train.no_inputs())?, Matrix2::zeros());
    Ok(())
}

/// `Ṁ = C + Cᵀ`, with the derivative of the mass matrix by dual numbers along the motion.
#[test]
fn the_mass_matrix_changes_by_its_symmetric_part() -> Result<(), Error> {
    for seed in 0..20 {
        println!("seed {seed}");
        let mut random = Random::new(seed);
        let crane = Crane::<f64>::new();
        let mut state = crane.initial_state();
        state.q.iter_mut().for_each(|q| *q += random.between(-0.7, 0.7));
        state.v.iter_mut().for_each(|v| *v = random.between(-1.0, 1.0));
        mstmm::Chain::normalize(&crane, &mut state);
        let along = Crane::<Dual<f64>>::new();
        let mut moving = along.initial_state();
        moving.q = state.q.map(|q| Dual::new(q, [0.0]));
        // A displacement of zero whose derivatives are the rates.
        let displacement = state.v.map(|v| Dual::new(0.0, [v]));
        Crane::displace(&mut moving, displacement.as_slice()).expect("an entry for each rate");
        let matrix = along.mass_matrix(&moving, &along.no_inputs())?;
        let expected = SMatrix::<f64, 10, 10>::from_fn(|i, j| matrix[(i, j)].derivative());
        let found = crane.coriolis_matrix(&state, &crane.no_inputs())?;
        let off = (found + found.transpose() - expected).amax();
        // Entries up to 10, sums of some hundred terms.
        assert!(off < 1e-12, "seed {seed}: {off:e}");
    }
    Ok(())
}
