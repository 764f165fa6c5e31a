//! The structs of the header and their methods, in safe Rust.

use mstmm::{Error, Rk4};

use crate::{Chain, ChainInputs, ChainState, ChainWorkspace, Real};

/// The chain and its integrator: `mstmm_arm` of the header, there an array of numbers.
///
/// It consists of floating-point numbers only, so every bit pattern in its memory is a valid value.
#[repr(C)]
pub struct Arm {
    chain: Chain<Real>,
    rk4: Rk4<Chain<Real>>,
}

/// `mstmm_arm_state` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Coordinates: angles of the three pins in rad, then the unit quaternion w, x, y, z of the
    /// ball, then the angle of the camera's mount.
    pub q: [Real; 8],
    /// Their rates in rad/s: of the three pins, then the angular velocity of the ball in its
    /// outboard frame, then that of the mount.
    pub v: [Real; 7],
    /// Time in s.
    pub t: Real,
}

/// `mstmm_arm_inputs` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// Torques of the motors in N m.
    pub torque: [Real; 3],
}

/// `mstmm_point` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// In m.
    pub position: [Real; 3],
    /// The rotation matrix by rows, from components in the point's frame to inertial components.
    pub orientation: [[Real; 3]; 3],
    /// In m/s.
    pub velocity: [Real; 3],
    /// In rad/s.
    pub angular_velocity: [Real; 3],
    /// In m/s².
    pub acceleration: [Real; 3],
    /// In rad/s².
    pub angular_acceleration: [Real; 3],
    /// In N m.
    pub moment: [Real; 3],
    /// In N.
    pub force: [Real; 3],
}

/// `mstmm_arm_results` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Results {
    /// Derivatives of the rates in rad/s².
    pub accelerations: [Real; 7],
    /// In J.
    pub kinetic_energy: Real,
    /// In J.
    pub potential_energy: Real,
    /// The ground, then the output of every hinge and body; the mast follows the column's output.
    pub points: [Point; 12],
}

impl Arm {
    /// Returns the arm of the description with a step in s.
    pub(crate) fn new(step: Real) -> Self {
        Self { chain: Chain::new(), rk4: Rk4::new(step) }
    }

    /// Returns the start of the description.
    pub(crate) fn initial_state(&self) -> State {
        self.chain.initial_state().into()
    }

    /// Sets the payload's mass in kg.
    pub(crate) fn set_payload_mass(&mut self, mass: Real) -> Result<(), Error> {
        self.chain.set_payload_mass(mass)
    }

    /// Sets the payload's moment of inertia about its own z in kg m².
    pub(crate) fn set_payload_spin(&mut self, moment: Real) -> Result<(), Error> {
        self.chain.set_payload_spin(moment)
    }

    /// Takes one step with constant torques.
    pub(crate) fn step(&mut self, state: &mut State, inputs: Inputs) -> Result<(), Error> {
        let mut moved = ChainState::from(*state);
        self.rk4.step(&self.chain, &mut moved, |_, _| inputs.into())?;
        *state = moved.into();
        Ok(())
    }

    /// Computes all results.
    pub(crate) fn solve(&self, state: State, inputs: Inputs) -> Result<Results, Error> {
        let mut at = self.chain.workspace();
        self.chain.solve_into(&state.into(), &inputs.into(), &mut at)?;
        Ok(at.into())
    }
}

impl From<State> for ChainState<Real> {
    fn from(State { q, v, t }: State) -> Self {
        Self { q: q.into(), v: v.into(), t }
    }
}

impl From<ChainState<Real>> for State {
    fn from(ChainState { q, v, t }: ChainState<Real>) -> Self {
        Self { q: q.into(), v: v.into(), t }
    }
}

impl From<Inputs> for ChainInputs<Real> {
    fn from(Inputs { torque: [waist, shoulder, elbow] }: Inputs) -> Self {
        Self { waist, shoulder, elbow }
    }
}

impl From<ChainWorkspace<Real>> for Results {
    fn from(at: ChainWorkspace<Real>) -> Self {
        Self {
            accelerations: (*at.accelerations()).into(),
            kinetic_energy: at.kinetic_energy(),
            potential_energy: at.potential_energy(),
            points: at.points().map(Point::from),
        }
    }
}

impl From<mstmm::Point<Real>> for Point {
    fn from(point: mstmm::Point<Real>) -> Self {
        Self {
            position: point.position().into(),
            orientation: point.orientation().matrix().transpose().into(),
            velocity: point.velocity().into(),
            angular_velocity: point.angular_velocity().into(),
            acceleration: point.acceleration().into(),
            angular_acceleration: point.angular_acceleration().into(),
            moment: point.moment().into(),
            force: point.force().into(),
        }
    }
}

// The sizes in the header, as lengths of arrays, so that the compiler reports the right size. A test
// compares the offsets of fields.
const REAL: usize = size_of::<Real>();
const _: [(); 65 * REAL] = [(); size_of::<Arm>()];
const _: [(); REAL] = [(); align_of::<Arm>()];
const _: [(); 16 * REAL] = [(); size_of::<State>()];
const _: [(); 3 * REAL] = [(); size_of::<Inputs>()];
const _: [(); 30 * REAL] = [(); size_of::<Point>()];
const _: [(); 369 * REAL] = [(); size_of::<Results>()];
