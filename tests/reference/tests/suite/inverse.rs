//! Inverse dynamics, compared with forward dynamics, energies and the power of all efforts and loads.

use crate::samples::{Case, assert_close, plain_cases, rich_cases};
use crate::trees::trees;
use mstmm_reference::{Drives, Element, End, Gravity, Group, Hinge, Source, State};

/// The tolerance relative to the largest effort: the rounding error of a dense system of up to 66
/// unknowns, at most 7e-13 in the chains tried.
const TOLERANCE: f64 = 1e-11;

fn cases() -> impl Iterator<Item = Case> {
    plain_cases().into_iter().chain(rich_cases()).chain(trees())
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn times(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

/// Returns the efforts of all free rates in forward dynamics: of motors, and zero at a floating base.
fn forward_efforts(case: &Case, efforts: &[Vec<f64>]) -> Vec<f64> {
    let own = case.chain.hinges().zip(efforts).filter(|(hinge, _)| !hinge.prescribed);
    let base = vec![0.0; case.chain.base_dof_count()];
    base.into_iter().chain(own.flat_map(|(_, efforts)| efforts.iter().copied())).collect()
}

/// Returns whether the motion of a hinge or of an end of the chain is prescribed.
fn is_prescribed(case: &Case) -> bool {
    let moving = |end: &End| matches!(end, End::Moving { .. });
    let starts = case.chain.later_routes.iter().map(|route| &route.start);
    starts.chain([&case.chain.start, &case.chain.finish]).any(moving)
        || case.chain.hinges().any(|hinge| hinge.prescribed)
}

/// `M v̇ + bias` are the efforts of the motors in an open chain. In a closed chain the reactions of
/// the loop constraint are missing, which do no work on rates that fulfil it.
#[test]
fn inverse_dynamics_undo_forward_dynamics() {
    let (mut open, mut closed) = (0, 0);
    for case in cases() {
        let Case { chain, state, drives } = &case;
        let solution = case.solve();
        let applied = forward_efforts(&case, &solution.efforts);
        let mass = chain.mass_matrix(state, drives);
        let bias = chain.bias_efforts(state, drives);
        let inertial = times(&mass, &solution.accelerations);
        let scale =
            inertial.iter().chain(&bias).fold(1.0_f64, |most, effort| most.max(effort.abs()));
        let missing: Vec<f64> =
            inertial.iter().zip(&bias).zip(&applied).map(|((m, b), t)| m + b - t).collect();
        if !chain.closed() {
            open += 1;
            for missing in missing {
                assert_close(missing, 0.0, TOLERANCE * scale, &chain.name);
            }
        } else if !is_prescribed(&case) {
            closed += 1;
            let size: f64 = state.v.iter().map(|v| v.abs()).sum();
            assert_close(
                dot(&missing, &state.v),
                0.0,
                TOLERANCE * scale * (1.0 + size),
                &chain.name,
            );
        }
    }
    assert!(open > 100 && closed > 10, "{open} open chains, {closed} closed ones");
}

/// The kinetic energy is `½ vᵀ M v` if no rates are prescribed, and `M` is symmetric.
#[test]
fn mass_matrices_give_kinetic_energies() {
    for case in cases() {
        let Case { chain, state, drives } = &case;
        let mass = chain.mass_matrix(state, drives);
        let scale = mass.iter().flatten().fold(1.0_f64, |most, entry| most.max(entry.abs()));
        for (row, entries) in mass.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                assert_close(*entry, mass[column][row], TOLERANCE * scale, &chain.name);
            }
        }
        let energy = 0.5 * dot(&times(&mass, &state.v), &state.v);
        if !is_prescribed(&case) {
            assert_close(energy, case.solve().kinetic_energy, TOLERANCE * scale, &chain.name);
        }
    }
}

/// The time in s between two energies.
const STEP: f64 = 2e-5;

/// The power of the drives that keep all rates constant is the derivative of the energy, if only
/// gravity, springs, limits and rotors act.
#[test]
fn bias_efforts_balance_the_power() {
    let mut tried = 0;
    for mut case in cases().filter(|case| !case.chain.closed() && !is_prescribed(case)) {
        conserve(&mut case);
        tried += 1;
        let Case { chain, state, drives } = &case;
        let power = dot(&chain.bias_efforts(state, drives), &state.v);
        let still = vec![0.0; state.v.len()];
        let energy = |t: f64| {
            let state = State { v: state.v.clone(), ..chain.moved(state, &still, t) };
            let solution = chain.solve_driven(&state, drives);
            solution.kinetic_energy + solution.potential_energy
        };
        let slope = (8.0 * (energy(STEP) - energy(-STEP))
            - (energy(2.0 * STEP) - energy(-2.0 * STEP)))
            / (12.0 * STEP);
        // The rounding error of energies over the step, and the third-order error of `moved`.
        let tolerance = 2e-7 * (1.0 + case.solve().kinetic_energy);
        assert_close(power, slope, tolerance, &case.chain.name);
    }
    assert!(tried > 60, "{tried} chains");
}

/// Removes everything that changes the energy of a chain except its drives.
fn conserve(case: &mut Case) {
    let chain = &mut case.chain;
    chain.loads.clear();
    for spring in &mut chain.springs {
        spring.damping = 0.0;
        spring.force = Source::None;
    }
    if chain.gravity == Gravity::Input {
        chain.gravity = Gravity::Constant(case.drives.gravity);
    }
    for element in chain.all_elements_mut() {
        let Element::Hinge(Hinge { linear, turning, .. }) = element else { continue };
        for group in [linear, turning] {
            let lasting = Group { damping: Vec::new(), friction: Vec::new(), ..group.clone() };
            *group = lasting;
            group.limits.iter_mut().for_each(|limits| limits.damping = 0.0);
        }
    }
    case.drives = Drives { loads: Vec::new(), ..case.drives.clone() };
}
