//! Prints what `answers.c` prints, computed without the functions for C. The chains are those of the file, included here
//! again.

use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::prelude::*;
use std::error::Error;

include!("chains.rs");

fn line(name: &str, numbers: impl IntoIterator<Item = f64>) {
    let words = numbers.into_iter().map(|number| format!(" {:016x}", number.to_bits()));
    println!("{name}{}", words.collect::<String>());
}

/// Prints numbers after the status.
fn ok(name: &str, numbers: impl IntoIterator<Item = f64>) {
    println!("MSTMM_OK");
    line(name, numbers);
}

/// The rows of a matrix, or a vector.
macro_rules! rows {
    ($matrix:expr) => {
        $matrix.transpose().iter().copied().collect::<Vec<f64>>()
    };
}

/// The motion of a point in space.
macro_rules! motion {
    ($point:expr) => {{
        let point = $point;
        let mut numbers: Vec<f64> = point.position().iter().copied().collect();
        numbers.extend(point.orientation().matrix().transpose().iter());
        numbers.extend(&point.velocity());
        numbers.extend(&point.angular_velocity());
        numbers.extend(&point.bias_acceleration());
        numbers.extend(&point.angular_bias_acceleration());
        numbers
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    in_space()?;
    in_a_plane()?;
    on_a_line()
}

fn in_space() -> Result<(), Box<dyn Error>> {
    let mut whip = Whip::<f64>::new();
    whip.set_load(1.5)?;
    let mut at = whip.initial_state();
    let inputs = WhipInputs { shoulder: 0.0, wrist: 0.5 };
    println!("{}", ["MSTMM_OK"; 4].join("\n"));
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..20 {
        rk4.step(&whip, &mut at, |_, _| inputs)?;
    }
    let x = SVector::from_fn(|index, _| 0.25 * index as f64 - 1.0);
    let kinematics = whip.kinematics(&at, &inputs)?;
    ok("finger", motion!(kinematics.hand().finger()));
    ok("eye", motion!(kinematics.bead(1).ok_or("a bead")?.eye()));
    ok("jacobian", rows!(kinematics.bead(2).ok_or("a bead")?.output().jacobian()));
    println!("MSTMM_INDEX\nMSTMM_INDEX\nMSTMM_NULL_POINTER");
    let momentum = whip.momentum(&at, &inputs)?;
    let vectors = [momentum.center_of_mass, momentum.linear, momentum.angular];
    let vectors = vectors.iter().flat_map(|vector| vector.iter().copied().collect::<Vec<_>>());
    ok("momentum", std::iter::once(momentum.mass).chain(vectors));
    ok("momentum matrix", rows!(whip.momentum_matrix(&at, &inputs)?));
    ok("regressor", rows!(whip.regressor(&at, &x, &inputs)?));
    let dynamic = whip.dynamic_parameters();
    ok("dynamic", dynamic.iter().copied());
    line("mass", [1.5]);
    line("mass", [0.3]);
    line("damping", [0.01]);
    let mut efforts = SVector::zeros();
    whip.regressor_times_into(&at, &x, &inputs, &dynamic, &mut efforts)?;
    ok("efforts", efforts.iter().copied());
    let mut solved = whip.workspace();
    whip.inverse_solve_into(&at, &x, &inputs, &mut solved)?;
    let mut numbers: Vec<f64> = solved.accelerations().iter().copied().collect();
    numbers.extend([solved.kinetic_energy(), solved.potential_energy()]);
    for point in solved.points() {
        numbers.extend(&point.position());
        numbers.extend(point.orientation().matrix().transpose().iter());
        for vector in [point.velocity(), point.angular_velocity(), point.acceleration()] {
            numbers.extend(&vector);
        }
        for vector in [point.angular_acceleration(), point.moment(), point.force()] {
            numbers.extend(&vector);
        }
    }
    ok("solved", numbers);
    // A chain with repetitions has matrices only in the caller's storage.
    let mut matrix = SMatrix::zeros();
    whip.mass_matrix_into(&at, &inputs, &mut matrix)?;
    ok("matrix", rows!(matrix));
    whip.inverse_mass_matrix_into(&at, &inputs, &mut matrix)?;
    ok("inverse", rows!(matrix));
    let mut derivatives = Default::default();
    whip.inverse_dynamics_derivatives_into(&at, &x, &inputs, &mut derivatives)?;
    ok("by coordinates", rows!(derivatives.by_coordinates));
    line("by rates", rows!(derivatives.by_rates));
    line("by accelerations", rows!(derivatives.by_accelerations));
    let mut linear = Default::default();
    whip.linearize_into(&at, &inputs, &mut linear)?;
    ok("a", rows!(linear.a()));
    line("b", rows!(linear.b()));
    let mut direction = WhipVariation::default();
    direction.coordinates[0] = 0.5;
    // A pin, then three balls.
    direction.rates[1 + 2 * 3 + 1] = -0.25;
    direction.inputs[1] = 2.0;
    direction.parameters[0] = 1.0;
    let (mut accelerations, mut change) = (SVector::zeros(), SVector::zeros());
    whip.push_into(&at, &inputs, &direction, &mut accelerations, &mut change)?;
    ok("push", accelerations.iter().copied());
    line("change", change.iter().copied());
    let mut gradient = WhipVariation::default();
    whip.pull_into(&at, &inputs, &x, &mut accelerations, &mut gradient)?;
    ok("pull", accelerations.iter().copied());
    let parts = gradient.coordinates.iter().chain(&gradient.rates);
    line("gradient", parts.chain(&gradient.inputs).chain(&gradient.parameters).copied());
    println!("MSTMM_QUATERNION");
    Ok(())
}

fn in_a_plane() -> Result<(), Box<dyn Error>> {
    let flat = Flat::<f64>::new();
    let (at, none) = (flat.initial_state(), flat.no_inputs());
    println!("MSTMM_OK\nMSTMM_OK");
    let kinematics = flat.kinematics(&at, &none)?;
    let mark = kinematics.b().mark();
    let mut numbers: Vec<f64> = mark.position().iter().copied().collect();
    numbers.extend(<[f64; 2]>::from(mark.cos_sin()));
    numbers.extend(&mark.velocity());
    numbers.push(mark.angular_velocity());
    numbers.extend(&mark.bias_acceleration());
    numbers.push(mark.angular_bias_acceleration());
    ok("mark", numbers);
    ok("jacobian", rows!(kinematics.b().com().jacobian()));
    ok("jacobian of b", rows!(flat.b_jacobian(&at, &none, &[0.1, -0.2].into())?));
    println!("MSTMM_NULL_POINTER");
    let momentum = flat.momentum(&at, &none)?;
    let vectors = momentum.center_of_mass.iter().chain(&momentum.linear).copied();
    ok("momentum", std::iter::once(momentum.mass).chain(vectors).chain([momentum.angular]));
    let mut direction = FlatVariation::default();
    direction.rates[1] = 1.0;
    let (mut accelerations, mut change) = (SVector::zeros(), SVector::zeros());
    flat.push_into(&at, &none, &direction, &mut accelerations, &mut change)?;
    ok("change", change.iter().copied());
    let mut solved = flat.workspace();
    flat.inverse_solve_into(&at, &change, &none, &mut solved)?;
    let mut numbers: Vec<f64> = solved.accelerations().iter().copied().collect();
    for point in solved.points() {
        numbers.extend(&point.acceleration());
        numbers.extend([point.angular_acceleration(), point.moment()]);
        numbers.extend(&point.force());
    }
    ok("solved", numbers);
    Ok(())
}

fn on_a_line() -> Result<(), Box<dyn Error>> {
    let train = Train::<f64>::new();
    let (at, none) = (train.initial_state(), train.no_inputs());
    println!("MSTMM_OK\nMSTMM_OK");
    let kinematics = train.kinematics(&at, &none)?;
    let end = kinematics.second().output();
    ok("end", [end.position(), end.velocity(), end.bias_acceleration()]);
    ok("jacobian", rows!(end.jacobian()));
    ok("jacobian of second", rows!(train.second_jacobian(&at, &none, &[2.0].into())?));
    let momentum = train.momentum(&at, &none)?;
    ok("momentum", [momentum.mass, momentum.center_of_mass, momentum.linear]);
    ok("a", rows!(train.linearize(&at, &none)?.a()));
    let (mut accelerations, mut gradient) = (SVector::zeros(), TrainVariation::default());
    train.pull_into(&at, &none, &[1.0, 2.0].into(), &mut accelerations, &mut gradient)?;
    ok("coordinates", gradient.coordinates.iter().copied());
    Ok(())
}
