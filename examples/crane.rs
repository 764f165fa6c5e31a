//! A crane moves a load along its rail; the rope swings.
//!
//! `cargo run --release --example crane`; with `-- --page crane.html` it also writes a page that shows the motion.

mod page;

use mstmm::prelude::*;
use page::Page;

mstmm_chain! {
    /// A trolley on a rail, a rope of twenty rods and a load of one ton.
    plane chain Crane {
        gravity = [0, -9.81] m/s^2;

        body Trolley { mass = 500 kg; com = [0, 0] m; output = [0, 0] m; inertia = 100 kg*m^2 about com; }
        body Rod { mass = 2 kg; com = [0, -25] cm; output = [0, -50] cm; inertia = 0.04 kg*m^2 about com; }
        body Load { mass = 1 t; com = [0, -1] m; inertia = 600 kg*m^2 about com; }

        ground -> slider(x) rail -> Trolley trolley
               -> repeat 20 { pin joint -> Rod rod }
               -> pin hook -> Load load;

        hinge rail { force = input; }
        hinge joint { damping = 5 N*m*s/rad; }
    }
}

fn main() -> Result<(), mstmm::Error> {
    let crane = Crane::<f64>::new();
    let mut state = crane.initial_state();
    let mut at = crane.workspace();

    // At rest the rope carries its own weight and the load's.
    crane.solve_into(&state, &crane.no_inputs(), &mut at)?;
    let tension = at.trolley().output().force().norm();
    println!("tension at the trolley, at rest: {tension:.1} N");
    assert!((tension - (20.0 * 2.0 + 1000.0) * 9.81).abs() < 1e-6);

    // The motor accelerates for one period of the swing, and later brakes for one: the load hardly swings afterwards.
    let period = 3.82;
    let force = |time: f64| match time {
        _ if time < period => 600.0,
        _ if time < 10.0 => 0.0,
        _ if time < 10.0 + period => -600.0,
        _ => 0.0,
    };
    let impulse = |time: f64| 600.0 * (time.min(period) - (time - 10.0).clamp(0.0, period));

    let mut page = Page::of(&crane, 40);
    let mut rk4 = Rk4::new(1e-3);
    for step in 0..16_000 {
        let rail = force(state.time());
        page.record(&state, &CraneInputs { rail })?;
        rk4.step(&crane, &mut state, |_time, _state| CraneInputs { rail })?;
        if step % 1000 == 999 {
            crane.solve_into(&state, &crane.no_inputs(), &mut at)?;
            let (trolley, load) = (at.trolley().com(), at.load().com());
            println!(
                "{:4.0} s   trolley at {:6.2} m   load {:5.2} m ahead of it",
                state.time(),
                trolley.position().x,
                load.position().x - trolley.position().x,
            );

            // Only the motor acts along the rail: its impulse is the momentum of all bodies.
            let rods: f64 =
                (0..20).filter_map(|k| at.rod(k)).map(|rod| rod.com().velocity().x).sum();
            let momentum = 500.0 * trolley.velocity().x + 2.0 * rods + 1000.0 * load.velocity().x;
            let expected = impulse(state.time());
            assert!((momentum - expected).abs() < 1e-6, "{momentum} N s is not {expected} N s");
        }
    }
    page.write();
    Ok(())
}

#[test]
fn momentum_and_tension_are_right() -> Result<(), mstmm::Error> {
    main()
}
