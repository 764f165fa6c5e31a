//! Chains of all kinds, for the tests of the formats of their states, inputs and parameters.

mstmm::mstmm_chain! {
    /// An arm with a motor, a load and parameters.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        param payload = 0.5 kg;
        param reach = 0.4 m;
        body Upper {
            mass = 2 kg; com = [0.2, 0, 0] m; output = [0.4, 0, 0] m;
            inertia = diag(0.01, 0.02, 0.03) kg*m^2 about com;
        }
        body Lower {
            mass = 1 kg + payload; com = [reach, 0 m, 0 m];
            inertia = diag(0.01, 0.02, 0.03) kg*m^2 about com;
            point tool = [0.5, 0, 0] m;
        }
        ground -> pin(y) shoulder -> Upper upper -> slider(x) rail -> Lower lower;
        hinge shoulder { start = 30 deg; torque = input; }
        hinge rail { start = 0.125 m; start_velocity = -2 m/s; }
        load push { on = lower; at = [0.5, 0, 0] m; force = input; }
    }
}

mstmm::mstmm_chain! {
    /// A rope of balls with a repeated parameter.
    pub chain Rope {
        gravity = [0, 0, -9.81] m/s^2;
        body Rod {
            mass = 1 kg; com = [0, 0, -0.5] m; output = [0, 0, -1] m;
            inertia = diag(0.1, 0.1, 0.01) kg*m^2 about com;
        }
        ground -> repeat 13 { ball joint -> Rod rod } -> pin(x) hook -> Rod weight;
        hinge joint { damping = stiffness; }
        param stiffness[13] = 0.25 N*m*s/rad;
        hinge hook { torque = input; }
    }
}

mstmm::mstmm_chain! {
    /// A floating trunk with two arms.
    pub chain Crab {
        body Trunk {
            mass = 5 kg; com = [0, 0, 0] m; inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
            point left = [0.2, 0, 0] m; point right = [-0.2, 0, 0] m;
        }
        part Claw(side) {
            body Link {
                mass = 1 kg; com = [0.1*side, 0, 0] m; inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
            }
            pin(z) knuckle -> Link link;
        }
        Trunk trunk;
        trunk.left -> Claw(1) left;
        trunk.right -> Claw(-1) right;
        hinge left.knuckle { torque = input; }
    }
}

mstmm::mstmm_chain! {
    /// A weight on a spring, along a line, without inputs and parameters.
    pub line chain Weight {
        gravity = -9.81 m/s^2;
        body Block { mass = 1 kg; point top = 0.5 m; }
        ground -> slider hold -> Block block;
        hinge hold { stiffness = 100 N/m; }
    }
}

mstmm::mstmm_chain! {
    /// A rod on a hub, without gravity.
    pub plane chain Swing {
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; point tip = [1, 0] m; }
        ground -> pin hub -> Rod rod;
    }
}

mstmm::mstmm_chain! {
    /// The same rod, with poses as its only results.
    pub plane chain Poses {
        results = poses;
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; point tip = [1, 0] m; }
        ground -> pin hub -> Rod rod;
    }
}
