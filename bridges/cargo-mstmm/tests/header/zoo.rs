//! Prints what `zoo.c` prints, computed without the functions for C. The chains are those of the file, included here again.

use mstmm::prelude::*;
use mstmm::{Described, Error, HingeMotion, PinState};

include!("chains.rs");

fn line(name: &str, numbers: impl IntoIterator<Item = f32>) {
    let words = numbers.into_iter().map(|number| format!(" {:08x}", number.to_bits()));
    println!("{name}{}", words.collect::<String>());
}

fn ok(count: usize) {
    for _ in 0..count {
        println!("MSTMM_OK ");
    }
}

fn state(of: &ZooState<f32>) -> Vec<f32> {
    of.q.iter().chain(&of.v).copied().chain([of.t]).collect()
}

fn main() -> Result<(), Error> {
    let zoo = Zoo::<f32>::DESCRIPTION;
    let index = |found: Option<usize>| found.expect("a name");
    println!(
        "indices {} {} {} {}",
        index(zoo.coordinate("d.angle")),
        index(zoo.coordinate("link[2].orientation.x")),
        index(zoo.rate("link[1].rate.z")),
        index(zoo.input("int.state.rate")),
    );
    let [bead, wheel, d] =
        ["bead[1].output", "wheel.input", "d.output"].map(|name| index(zoo.point(name)));
    println!("points {bead} {wheel} {d}");
    println!(
        "counts {} {} {} {} {}",
        zoo.coordinates().len(),
        zoo.rates().len(),
        zoo.inputs().len(),
        zoo.parameters().len(),
        zoo.points().len(),
    );
    let swing = Swing::<f32>::DESCRIPTION;
    println!(
        "swing {} {}",
        index(swing.coordinate("A_B.angle")),
        index(swing.coordinate("a__b.angle"))
    );
    motion()?;
    others()
}

fn motion() -> Result<(), Error> {
    let mut zoo = Zoo::<f32>::new();
    zoo.set_load(1.5)?;
    zoo.set_knot(|index| if index == 1 { 0.2 } else { 0.1 })?;
    ok(2);
    println!("MSTMM_PARAMETER ");
    ok(1);
    println!("MSTMM_INDEX \nMSTMM_INDEX ");
    ok(1);
    line("knot", [0.2]);
    let inputs = ZooInputs {
        gravity: [0.0, 0.0, -9.81].into(),
        a: 0.3,
        int: HingeMotion { state: PinState::new(0.1, 0.2), acceleration: 0.4 },
        push_force: [1.0, 0.0, 0.0].into(),
    };
    let mut at = zoo.initial_state();
    ok(2);
    at.q[1] += 0.01;
    zoo.assemble(&mut at, &inputs)?;
    ok(1);
    line("assembled", state(&at));
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..50 {
        rk4.step(&zoo, &mut at, |_, _| inputs)?;
    }
    line("moved", state(&at));
    let mut solved = zoo.workspace();
    zoo.solve_into(&at, &inputs, &mut solved)?;
    ok(1);
    let mut numbers: Vec<f32> = solved.accelerations().iter().copied().collect();
    numbers.extend([solved.kinetic_energy(), solved.potential_energy()]);
    for point in solved.points() {
        numbers.extend(&point.position());
        numbers.extend(point.orientation().matrix().transpose().iter());
        numbers.extend(&point.velocity());
        numbers.extend(&point.angular_velocity());
        numbers.extend(&point.acceleration());
        numbers.extend(&point.angular_acceleration());
        numbers.extend(&point.moment());
        numbers.extend(&point.force());
    }
    line("results", numbers);
    ok(1);
    let mut efforts = *solved.accelerations();
    zoo.inverse_dynamics_into(&at, solved.accelerations(), &inputs, &mut efforts)?;
    line("efforts", efforts.iter().copied());
    ok(1);
    zoo.mass_matrix_times_into(&at, &inputs, solved.accelerations(), &mut efforts)?;
    line("product", efforts.iter().copied());
    let mut matrix = mstmm::nalgebra::SMatrix::zeros();
    zoo.mass_matrix_into(&at, &inputs, &mut matrix)?;
    ok(1);
    line("matrix", matrix.transpose().iter().copied());
    let jacobian = zoo.kinematics(&at, &inputs)?.wheel().rim().jacobian();
    ok(1);
    line("jacobian", jacobian.transpose().iter().copied());
    let momentum = zoo.momentum(&at, &inputs)?;
    ok(1);
    let vectors = [momentum.center_of_mass, momentum.linear, momentum.angular];
    let vectors = vectors.iter().flat_map(|vector| [vector.x, vector.y, vector.z]);
    line("momentum", std::iter::once(momentum.mass).chain(vectors));
    println!("MSTMM_QUATERNION link\nMSTMM_NULL_POINTER ");
    Ok(())
}

fn others() -> Result<(), Error> {
    let mut swing = Swing::<f32>::new();
    swing.set_length(0.7)?;
    let mut at = swing.initial_state();
    let inputs = SwingInputs { A_B: 0.5 };
    Rk4::new(1e-3).step(&swing, &mut at, |_, _| inputs)?;
    let mut solved = swing.workspace();
    swing.solve_into(&at, &inputs, &mut solved)?;
    ok(5);
    let mut numbers: Vec<f32> = solved.accelerations().iter().copied().collect();
    for point in solved.points() {
        numbers.extend(&point.position());
        numbers.extend(<[f32; 2]>::from(point.cos_sin()));
        numbers.extend(&point.acceleration());
        numbers.extend([point.angular_acceleration(), point.moment()]);
        numbers.extend(&point.force());
    }
    line("swing", numbers);
    let linear = swing.linearize(&at, &inputs)?;
    ok(1);
    line("a", linear.a().transpose().iter().copied());
    line("b", linear.b().transpose().iter().copied());
    let matrix = swing.mass_matrix(&at, &inputs)?;
    ok(1);
    line("matrix", matrix.transpose().iter().copied());

    let cart = Cart::<f32>::new();
    let mut at = cart.initial_state();
    Rk4::new(1e-3).step(&cart, &mut at, |_, _| cart.no_inputs())?;
    let mut solved = cart.workspace();
    cart.solve_into(&at, &cart.no_inputs(), &mut solved)?;
    ok(5);
    line("cart", [solved.accelerations()[0], solved.kinetic_energy(), solved.potential_energy()]);
    Ok(())
}
