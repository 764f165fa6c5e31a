//! The elastic hinge of [P, Appendix A.1] against closed forms: momenta and energy of a free pair,
//! frequencies of small motions, any number of turns about ζ, motion in the plane.

mod support;

use mstmm::Dual;
use mstmm::prelude::*;
use mstmm_reference::Random;
use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3, Vector6};
use support::matter::{Lump, momenta};
use support::mechanism::random_quaternion;
use support::moving::energy_rate;
use support::{difference, worst};

mstmm_chain! {
    /// Two free bodies on springs of six stiffnesses.
    chain Pair {
        param drag = 0;
        body One {
            mass = 2 kg;
            com = [0.1, 0.2, -0.1] m;
            output = [0.4, 0.1, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.5, 0.6, 0.7, 0.05, -0.02, 0.1) kg*m^2 about com;
        }
        body Two {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.1] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        One one -> elastic joint -> Two two;
        hinge joint {
            stiffness = [300, 200, 100] N/m;
            turning_stiffness = [25, 40, 10] N*m/rad;
            damping = [1 * drag, 2 * drag, 3 * drag] N*s/m;
            turning_damping = [0.3 * drag, 0.2 * drag, 0.1 * drag] N*m*s/rad;
        }
    }
}

const PAIR: [Lump; 2] = [
    Lump { mass: 2.0, com: [0.1, 0.2, -0.1], inertia: [0.5, 0.6, 0.7, 0.05, -0.02, 0.1] },
    Lump { mass: 1.5, com: [0.2, -0.1, 0.1], inertia: [0.1, 0.12, 0.09, 0.01, 0.02, -0.01] },
];
const DAMPING: [f64; 6] = [1.0, 2.0, 3.0, 0.3, 0.2, 0.1];

fn random_pair(random: &mut Random) -> PairState<f64> {
    let mut state = Pair::new().initial_state();
    let mut q: Vec<f64> = (0..3).map(|_| random.between(-1.0, 1.0)).collect();
    q.extend(random_quaternion(random));
    q.extend((0..6).map(|_| random.between(-0.2, 0.2)));
    state.coordinates_mut().copy_from_slice(&q);
    state.rates_mut().fill_with(|| random.between(-1.0, 1.0));
    state
}

/// Both momenta, and the energy.
fn conserved(chain: &Pair<f64>, state: &PairState<f64>) -> [Vec<f64>; 2] {
    let mut at = chain.workspace();
    chain.solve_into(state, &chain.no_inputs(), &mut at).expect("a regular chain");
    let momenta = momenta(&PAIR, &at.points(), 0).map(<[f64; 3]>::from).concat();
    [momenta, vec![chain.energy(state).total()]]
}

/// The fastest oscillation has ω of some 20 rad/s, of which the fourth-order method loses (hω)⁶/72
/// of the energy a step, 3·10⁻¹⁰ in ten seconds at h = 0.5 ms. Halving the step leaves a sixteenth
/// or less: what drifts is the method.
#[test]
fn a_free_pair_keeps_its_momenta_and_its_energy() {
    let chain = Pair::<f64>::new();
    for seed in 0..3 {
        let start = random_pair(&mut Random::new(seed));
        let before = conserved(&chain, &start);
        let drift = [5e-4, 2.5e-4].map(|step| {
            let mut state = start.clone();
            Rk4::new(step).advance_to(&chain, &mut state, 10.0, |_, _| chain.no_inputs()).unwrap();
            let after = conserved(&chain, &state);
            [0, 1].map(|k| difference(&after[k], &before[k]))
        });
        println!("seed {seed}: momenta, energy drift by {drift:?}");
        assert!(drift[0][0] < 1e-9 && drift[0][1] < 1e-9, "seed {seed}: {drift:?}");
        for k in 0..2 {
            let rounding = 1e-12; // of 40 000 steps
            assert!(drift[1][k] < drift[0][k] / 12.0 + rounding, "seed {seed}: {drift:?}");
        }
    }
}

/// dE/dt = −Σ c ṡ², exactly, by dual numbers; so the energy only falls.
#[test]
fn dampers_dissipate_the_expected_energy() {
    let (mut chain, mut dual) = (Pair::<f64>::new(), Pair::<Dual<f64>>::new());
    for (drag, tolerance) in [(0.0, 1e-12), (1.0, 1e-12), (5.0, 1e-12)] {
        chain.set_drag(drag).unwrap();
        dual.set_drag(Dual::from(drag)).unwrap();
        let mut largest = 0.0;
        for seed in 0..50 {
            let state = random_pair(&mut Random::new(seed));
            let rate = energy_rate(&chain, &dual, &state, &chain.no_inputs());
            let mut moving = chain.initial_state();
            chain.configuration_rate_into(&state, &mut moving);
            let strains = &moving.coordinates()[7..];
            let taken: f64 = strains.iter().zip(DAMPING).map(|(s, c)| drag * c * s * s).sum();
            // The terms that cancel are of the size of stiffness times strain times rate.
            let off = (rate + taken).abs() / 300.0;
            assert!(off < tolerance, "seed {seed}, drag {drag}: {rate} and {taken}");
            largest = worst(largest, off);
        }
        println!("drag {drag}: off by {largest:.1e}");
    }
    let mut state = random_pair(&mut Random::new(7));
    let (mut rk4, mut before) = (Rk4::new(1e-3), chain.energy(&state).total());
    for _ in 0..3000 {
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).unwrap();
        let now = chain.energy(&state).total();
        assert!(now <= before + 1e-14, "{now} after {before}");
        before = now;
    }
}

mstmm_chain! {
    /// A block whose centre of mass sits in the hinge.
    chain Block {
        body Cube {
            mass = 2 kg; com = [0, 0, 0] m; inertia = diag(0.3, 0.4, 0.5) kg*m^2 about com;
        }
        ground -> elastic joint -> Cube cube;
        hinge joint {
            stiffness = [300, 200, 100] N/m;
            turning_stiffness = [25, 40, 10] N*m/rad;
            torque = input;
            force = input;
        }
    }
}

const STIFFNESS: [f64; 6] = [300.0, 200.0, 100.0, 25.0, 40.0, 10.0];
const BLOCK: [f64; 6] = [2.0, 2.0, 2.0, 0.3, 0.4, 0.5];

/// Along one coordinate alone the block is a harmonic oscillator of ω² = k/m or k/J, at any
/// amplitude; after a whole period it is back.
#[test]
fn one_component_oscillates_at_its_own_frequency() {
    let chain = Block::<f64>::new();
    for k in 0..6 {
        let frequency = (STIFFNESS[k] / BLOCK[k]).sqrt();
        let mut state = chain.initial_state();
        state.coordinates_mut()[k] = 0.3;
        let found = chain.accelerations(&state, &chain.no_inputs()).unwrap();
        let mut expected = [0.0; 6];
        expected[k] = -frequency * frequency * 0.3;
        let off = difference(found.as_slice(), &expected);
        assert!(off < 1e-15, "component {k}: {off:e}");
        let (start, period) = (state.clone(), std::f64::consts::TAU / frequency);
        Dopri5::new(1e-12, 1e-12)
            .advance_to(&chain, &mut state, period, |_, _| chain.no_inputs())
            .unwrap();
        let back = difference(state.coordinates(), start.coordinates());
        println!("component {k}: ω {frequency:.3} rad/s, off by {back:.1e} after a period");
        // A few hundred steps, each within the tolerance.
        assert!(back < 1e-10, "component {k}: {back:e}");
    }
}

mstmm_chain! {
    /// A body beside the hinge, so that all six components depend on each other.
    chain Bracket {
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.3] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground at [1, 2, 3] m turned rpy(10, 20, 30) deg -> elastic joint -> Arm arm;
        hinge joint { stiffness = [300, 200, 100] N/m; turning_stiffness = [25, 40, 10] N*m/rad; }
    }
}

/// Small motions: M v̇ = −K q with the mass matrix about the hinge.
///
/// Central differences leave the third derivative, ε² = 10⁻⁸ of the value with ε = 10⁻⁴.
#[test]
fn small_motions_have_the_frequencies_of_mass_and_stiffness_matrix() {
    let [xx, yy, zz, xy, xz, yz] = PAIR[1].inertia;
    let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let (mass, arm) = (1.5, Vector3::new(0.2, -0.1, 0.3).cross_matrix());
    let mut matrix = Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * mass));
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-arm * mass));
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(arm * mass));
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&(inertia - arm * arm * mass));
    let stiffness = Matrix6::from_diagonal(&Vector6::from(STIFFNESS));
    let expected = matrix.try_inverse().expect("a body has mass") * -stiffness;

    let chain = Bracket::<f64>::new();
    let column = |k: usize| {
        let at = |strain: f64| {
            let mut state = chain.initial_state();
            state.coordinates_mut()[k] = strain;
            Vector6::from_column_slice(
                chain.accelerations(&state, &chain.no_inputs()).unwrap().as_slice(),
            )
        };
        (at(1e-4) - at(-1e-4)) / 2e-4
    };
    let found = Matrix6::from_columns(&[0, 1, 2, 3, 4, 5].map(column));
    let off = (found - expected).norm() / expected.norm();
    println!("off by {off:.1e}");
    assert!(off < 1e-7, "{found} instead of {expected}");
    // The frequencies themselves: the eigenvalues of the matrix are those of M⁻¹ K.
    let squares = |matrix: Matrix6<f64>| {
        let mut squares: Vec<f64> =
            (-matrix).complex_eigenvalues().iter().map(|value| value.re).collect();
        squares.sort_by(f64::total_cmp);
        squares
    };
    assert!(difference(&squares(found), &squares(expected)) < 1e-6);
}

/// θ₃ counts on, its torque grows with it; the springs of the displacement turn along.
///
/// With θ₁ = θ₂ = 0: m d̈ = −A_z K Δ, and J ω̇ = −k θ₃ + (k_y − k_x) Δ_x Δ_y about ζ, since the
/// displacement's axes turn with θ₃. The torques about ξ and η have no arm.
#[test]
fn turns_about_zeta_are_counted() {
    let chain = Block::<f64>::new();
    let [kx, ky, kz, .., turning] = STIFFNESS;
    let mut largest = 0.0;
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let shift = Vector3::from_fn(|_, _| random.between(-0.5, 0.5));
        let angle = random.between(-60.0, 60.0);
        let mut state = chain.initial_state();
        state.joint_mut().set_displacement(shift).set_angles(Vector3::new(0.0, 0.0, angle));
        let found = chain.accelerations(&state, &chain.no_inputs()).unwrap();
        let pull = Vector3::new(-kx * shift.x, -ky * shift.y, -kz * shift.z);
        let linear = Rotation3::from_axis_angle(&Vector3::z_axis(), angle) * pull / 2.0;
        let torque = -turning * angle + (ky - kx) * shift.x * shift.y;
        let expected = [linear.x, linear.y, linear.z, 0.0, 0.0, torque / 0.5];
        let off = difference(found.as_slice(), &expected);
        assert!(off < 1e-14, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");

    // Wound up by five turns and let go: A cos(ωt), through zero to five turns the other way.
    let amplitude = 5.0 * std::f64::consts::TAU;
    let frequency = (STIFFNESS[5] / BLOCK[5]).sqrt();
    let mut state = chain.initial_state();
    state.joint_mut().set_angles(Vector3::new(0.0, 0.0, amplitude));
    let mut dopri5 = Dopri5::new(1e-12, 1e-12);
    for tenth in 1..=10 {
        let time = 0.2 * f64::from(tenth);
        dopri5.advance_to(&chain, &mut state, time, |_, _| chain.no_inputs()).unwrap();
        let off = state.joint().angles().z - amplitude * (frequency * time).cos();
        assert!(off.abs() < 1e-9 * amplitude, "at {time} s: {off:e}");
    }
}

mstmm_chain! {
    chain InSpace {
        gravity = [1, -9.8, 0] m/s^2;
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0] m;
            output = [0.5, 0.1, 0] m turned rpy(0, 0, 20) deg;
            inertia = diag(0.1, 0.12, 0.09) kg*m^2 about com;
        }
        ground -> elastic near -> Arm first -> elastic far -> Arm second;
        hinge near, far {
            stiffness = [300, 200, 100] N/m;
            turning_stiffness = [25, 40, 10] N*m/rad;
            damping = [1, 2, 3] N*s/m;
            turning_damping = [3, 2, 1] N*m*s/rad;
            armature = [0.1, 0.2, 0.3] kg;
            turning_armature = [0.1, 0.2, 0.3] kg*m^2;
        }
    }
    plane chain InPlane {
        gravity = [1, -9.8] m/s^2;
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1] m;
            output = [0.5, 0.1] m turned 20 deg;
            inertia = 0.09 kg*m^2 about com;
        }
        ground -> elastic near -> Arm first -> elastic far -> Arm second;
        hinge near, far {
            stiffness = [300, 200] N/m;
            turning_stiffness = 10 N*m/rad;
            damping = [1, 2] N*s/m;
            turning_damping = 1 N*m*s/rad;
            armature = [0.1, 0.2] kg;
            turning_armature = 0.3 kg*m^2;
        }
    }
}

/// What lies in the plane: Δ_x, Δ_y, θ₃ of both hinges.
const IN_PLANE: [usize; 6] = [0, 1, 5, 6, 7, 11];

#[test]
fn in_the_plane_it_is_the_elastic_hinge_of_the_plane() {
    let (space, plane) = (InSpace::<f64>::new(), InPlane::<f64>::new());
    let mut largest = 0.0;
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let (mut spatial, mut flat) = (space.initial_state(), plane.initial_state());
        for (own, of_space) in IN_PLANE.into_iter().enumerate() {
            let q =
                if own % 3 == 2 { random.between(-9.0, 9.0) } else { random.between(-0.3, 0.3) };
            let v = random.between(-2.0, 2.0);
            (flat.coordinates_mut()[own], flat.rates_mut()[own]) = (q, v);
            (spatial.coordinates_mut()[of_space], spatial.rates_mut()[of_space]) = (q, v);
        }
        let found = plane.accelerations(&flat, &plane.no_inputs()).unwrap();
        let truth = space.accelerations(&spatial, &space.no_inputs()).unwrap();
        let mut expected = [0.0; 12];
        for (own, of_space) in IN_PLANE.into_iter().enumerate() {
            expected[of_space] = found[own];
        }
        let energies = [plane.energy(&flat), space.energy(&spatial)].map(|energy| energy.total());
        let off = difference(truth.as_slice(), &expected);
        let off = worst(off, difference(&energies[..1], &energies[1..]));
        assert!(off < 1e-13, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}
