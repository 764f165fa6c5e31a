//! The controller of the example `computed_torque`, on an arm whose payload it does not know.

use mstmm::Error;

use crate::payload_control::{Arm, ArmInputs, ArmState, Control, Joints, desired, inputs};
use crate::{Hash, MOTION_STEPS, Model, Number, PAYLOAD, STEP};

/// The period from which on the controller uses its estimate, and the periods of a second.
const FIRST_WITH_ESTIMATE: usize = MOTION_STEPS / 2;
const SECOND: usize = 1000;

/// The controller, and the arm with its payload.
pub struct Bench<T: Number> {
    control: Control<T>,
    arm: Arm<T>,
    /// The torques of the last step, which the drives hold until the next.
    torques: Joints<T>,
    /// What encoders measured in the last period.
    measured: (ArmState<T>, Joints<T>),
    periods: u16,
    /// The largest errors of an angle in rad in the last second before the estimate is used, and at the end.
    errors: [T; 2],
    /// The largest torque in N m.
    torque: T,
}

impl<T: Number> Bench<T> {
    /// Compares the angles with those of the desired motion, and the torques with the largest.
    fn compare(&mut self, state: &ArmState<T>) {
        self.torque = largest(self.torque, self.torques.iter().map(|torque| torque.abs()));
        let [desired, ..] = desired(state.t);
        let periods = usize::from(self.periods);
        for (error, end) in self.errors.iter_mut().zip([FIRST_WITH_ESTIMATE, MOTION_STEPS]) {
            if (end - SECOND..end).contains(&periods) {
                let joints = state.q.iter().zip(&desired);
                *error = largest(*error, joints.map(|(&q, &wanted)| (q - wanted).abs()));
            }
        }
    }
}

fn largest<T: Number>(first: T, others: impl Iterator<Item = T>) -> T {
    others.fold(first, |most, value| T::select(value.simd_gt(most), value, most))
}

impl<T: Number> Model for Arm<T> {
    type Work = Bench<T>;

    fn new() -> Self {
        Arm::new()
    }

    fn start(&self) -> ArmState<T> {
        let mut state = self.initial_state();
        [state.q, state.v, _] = desired(state.t);
        state
    }

    fn inputs(&self, _: &ArmState<T>) -> ArmInputs<T> {
        self.no_inputs()
    }

    fn work() -> Bench<T> {
        let (arm, zero) = (Arm::new(), T::constant(0.0));
        Bench {
            control: Control::new(),
            torques: Joints::from([zero; 7]),
            measured: (arm.initial_state(), Joints::from([zero; 7])),
            arm,
            periods: 0,
            errors: [zero; 2],
            torque: zero,
        }
    }

    /// The arm grasps its payload in the first period, and moves under the held torques: a step of the semi-implicit Euler
    /// method. The controller uses its estimate in the second half of the motion.
    fn advance(&self, bench: &mut Bench<T>, state: &mut ArmState<T>) -> Result<(), Error> {
        match usize::from(bench.periods) {
            0 => bench.arm.set_payload(T::constant(PAYLOAD))?,
            FIRST_WITH_ESTIMATE => bench.control.use_estimate()?,
            _ => (),
        }
        let accelerations = bench.arm.accelerations(state, &inputs(&bench.torques))?;
        bench.measured = (state.clone(), accelerations);
        bench.periods = bench.periods.wrapping_add(1);

        let step = T::constant(STEP);
        state.v.iter_mut().zip(&accelerations).for_each(|(v, &a)| *v += step * a);
        state.q.iter_mut().zip(&state.v).for_each(|(q, &v)| *q += step * v);
        state.t = step * T::from(bench.periods.cast_signed());
        bench.compare(state);
        Ok(())
    }

    /// Adds the last period to the estimate, and computes the torques.
    fn step(&self, bench: &mut Bench<T>, state: &mut ArmState<T>) -> Result<(), Error> {
        let Bench { control, torques, measured: (before, accelerations), .. } = bench;
        control.observe(before, accelerations, torques)?;
        control.torques_into(state, torques)
    }

    fn add_results(bench: &Bench<T>, hash: &mut Hash) {
        hash.add(bench.torques.iter().copied());
    }

    /// Returns the estimated parameters of the payload, their deviations, both errors and the largest torque.
    fn results(bench: &Bench<T>) -> impl IntoIterator<Item = T> {
        let Bench { control, errors, torque, .. } = bench;
        control.payload().into_iter().chain(control.deviations()).chain(*errors).chain([*torque])
    }
}
