//! The crate `mstmm` is no dependency here, but one of a dependency; nothing is imported; and no
//! warning is let pass.

#![no_implicit_prelude]
#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, unused, nonstandard_style, clippy::all, rustdoc::all)]

use ::mstmm_outside_kit::machine;

machine! {
    /// By the macro alone.
    pub chain Arm {
        gravity = [0, -9.8, 0] m/s^2;
        param payload = 0.5 kg;
        body Rod {
            mass = 1 kg + payload;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin(z) shoulder -> Rod upper -> ball elbow -> Rod lower;
        hinge shoulder { torque = input; }
    }
}

::mstmm_outside_kit::dynamics::mstmm_chain! {
    /// By the crate.
    pub plane chain Rope {
        gravity = input;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        moving hand -> repeat 3 { pin joint -> Rod rod } -> pin last -> ground at [2, 1] m;
        hinge joint { torque = input; }
        load wind { on = rod; force = input; }
    }
}

machine! {
    /// A tree with a part, and a repeated part with a branch.
    pub chain Walker {
        gravity = [0, 0, -9.8] m/s^2;
        body Trunk {
            mass = 5 kg;
            com = [0, 0, 0.1] m;
            output = [0.5, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point left = [0, 0.2, 0] m;
            point right = [0, -0.2, 0] m;
        }
        body Link {
            mass = 1 kg;
            com = [0.2, 0, 0] m;
            output = [0.4, 0, 0] m;
            inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
        }
        /// A leg.
        part Leg(side) {
            universal(x, y) hip -> Link thigh -> pin([0, side, 0]) knee -> Link shank;
            hinge hip, knee { torque = input; }
            load contact { on = shank; at = output; force = input; }
        }
        Trunk trunk -> repeat 2 { ball joint -> Link link; link.output -> pin(z) side -> Link tail; };
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        spring cord { on = left.shank.output; to = right.shank.output; stiffness = 50; length = 0.4 m; }
    }
}

/// A number that all chains give.
#[must_use]
pub fn sum() -> f64 {
    let (arm, rope, walker) = (Arm::<f64>::new(), Rope::<f64>::new(), Walker::<f64>::new());
    let shoulder = match arm.accelerations(&arm.initial_state(), &arm.no_inputs()) {
        ::core::result::Result::Ok(accelerations) => accelerations[0],
        ::core::result::Result::Err(_) => f64::NAN,
    };
    shoulder
        + rope.energy(&rope.initial_state()).kinetic
        + walker.energy(&walker.initial_state()).kinetic
}
