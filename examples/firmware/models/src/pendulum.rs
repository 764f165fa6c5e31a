//! Section 4.1 of the paper.

use mstmm::{Error, Rk4, mstmm_chain};

use crate::{Model, Number, integrator, simulate};

mstmm_chain! {
    /// Three unit cubes on ball-and-socket hinges (Rui et al. 2016, section 4.1).
    pub chain BallPendulum {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball shoulder -> Cube upper -> ball elbow -> Cube middle -> ball wrist -> Cube lower;
        hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
    }
}

impl<T: Number> Model for BallPendulum<T> {
    type Work = Rk4<Self>;

    fn new() -> Self {
        BallPendulum::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, _: &Self::State) -> Self::Inputs {
        self.no_inputs()
    }

    fn work() -> Rk4<Self> {
        integrator()
    }

    fn step(&self, rk4: &mut Rk4<Self>, state: &mut Self::State) -> Result<(), Error> {
        simulate(self, rk4, state)
    }
}
