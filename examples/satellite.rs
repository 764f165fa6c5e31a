//! A satellite unfolds its two wings while a reaction wheel stops its rotation about one axis; the total angular momentum
//! is constant.
//!
//! `cargo run --release --example satellite`; with `-- --page satellite.html` it also writes a page that shows the motion.

mod page;

use mstmm::prelude::*;
use page::Page;

mstmm_chain! {
    /// A hub that floats, two wings of panels on springs, and a wheel with a motor.
    chain Satellite {
        answers = momentum;

        body Hub {
            mass = 100 kg;
            com = [0, 0, 0] m;
            output = [0.1, 0, 0.3] m;
            inertia = diag(20, 25, 18) kg*m^2 about com;
            point left = [0, 0.5, 0] m;
            point right = [0, -0.5, 0] m turned rpy(0, 0, 180) deg;
        }
        body Wheel { mass = 5 kg; com = [0, 0, 0] m; inertia = diag(0.03, 0.03, 0.05) kg*m^2 about com; }

        part Wing {
            body Panel {
                mass = 3 kg;
                com = [0, 0.5, 0] m;
                output = [0, 1, 0] m;
                inertia = diag(0.25, 0.06, 0.31) kg*m^2 about com;
            }
            pin(x) root -> Panel inner -> repeat 2 { pin(x) fold -> Panel panel };
            hinge root, fold { start = 40 deg; stiffness = 1 N*m/rad; damping = 4 N*m*s/rad; }
        }

        Hub hub -> pin(z) axle -> Wheel wheel;
        hub.left -> Wing left;
        hub.right -> Wing right;

        body hub { start_rate = [0.002, -0.004, 0.05] rad/s; }
        hinge axle { torque = input; }
    }
}

/// Returns the motor's torque in N m: the wheel stops the hub's rotation about z.
fn control(state: &SatelliteState<f64>) -> SatelliteInputs<f64> {
    SatelliteInputs { axle: (20.0 * state.hub().rate().z).clamp(-0.1, 0.1) }
}

fn main() -> Result<(), mstmm::Error> {
    let satellite = Satellite::<f64>::new();
    let mut state = satellite.initial_state();
    let initial = satellite.momentum(&state, &satellite.no_inputs())?;
    let mut page = Page::of(&satellite, 10);
    let mut rk4 = Rk4::new(1e-2);
    for step in 0..6000 {
        page.record(&state, &control(&state))?;
        rk4.step(&satellite, &mut state, |_time, state| control(state))?;
        if step % 1000 == 999 {
            let momentum = satellite.momentum(&state, &satellite.no_inputs())?;
            let change = (momentum.angular - initial.angular).norm();
            println!(
                "{:3.0} s   wings {:5.1}°   hub {:8.5} rad/s about z   wheel {:7.3} rad/s   change of momentum {change:.0e} N m s",
                state.time(),
                state.left_root().angle().to_degrees(),
                state.hub().rate().z,
                state.axle().rate(),
            );
            // No moment acts from outside.
            assert!(change < 1e-9);
        }
    }
    assert!(state.hub().rate().z.abs() < 1e-3);
    page.write();
    Ok(())
}

#[test]
fn angular_momentum_is_conserved() -> Result<(), mstmm::Error> {
    main()
}
