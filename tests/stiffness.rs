//! Stiffness detection of `Dopri5` on generated chains: rods with strong dampers and free rods.

use mstmm::Dopri5;
use mstmm::prelude::*;

mstmm_chain! {
    /// Rods of 0.1 m and 0.1 kg. Dampers of 1 N·m·s/rad give decays of at least
    /// 1 N·m·s/rad / (0.1 kg · (0.1 m)²) = 10³ /s.
    plane chain Damped {
        gravity = [0, -9.8] m/s^2;
        body Rod {
            mass = 0.1 kg; com = [0.05, 0] m; inertia = 1e-4 kg*m^2 about com; output = [0.1, 0] m;
        }
        ground -> repeat 20 { pin joint -> Rod rod };
        hinge joint { stiffness = 100; damping = 1; }
    }
    /// Three of these rods without springs and dampers.
    plane chain Free {
        gravity = [0, -9.8] m/s^2;
        body Rod {
            mass = 0.1 kg; com = [0.05, 0] m; inertia = 1e-4 kg*m^2 about com; output = [0.1, 0] m;
        }
        ground -> repeat 3 { pin joint -> Rod rod };
    }
}

#[test]
fn strong_dampers_are_stiff() {
    let chain = Damped::<f64>::new();
    let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(1e-6, 1e-6));
    dopri5.advance_to(&chain, &mut state, 0.02, |_, _| Default::default()).expect("steps");
    assert!(dopri5.is_stiff());
}

#[test]
fn free_rods_are_not_stiff() {
    let chain = Free::<f64>::new();
    let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(1e-6, 1e-6));
    for _ in 0..200 {
        dopri5.step(&chain, &mut state, |_, _| Default::default()).expect("a step");
        assert!(!dopri5.is_stiff(), "{:?}", dopri5.statistics());
    }
}
