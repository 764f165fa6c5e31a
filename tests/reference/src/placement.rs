//! From hinge coordinates to the motions of the bodies, and back.

use crate::chain::State;
use crate::mechanism::{Base, Freedom, Joint, Mechanism, Motion, Place, Rigid};
use crate::rotation::{self, Mat3, Vec3};
use std::f64::consts::TAU;

/// The outboard side of a hinge relative to its inboard side.
struct Turn {
    /// Turns outboard components into inboard ones.
    rotation: Mat3,
    /// The relative angular velocity in inboard components.
    spin: Vec3,
}

impl Mechanism {
    /// Places every body according to the coordinates and rates of the chain.
    pub(crate) fn motions(&self, state: &State) -> Vec<Motion> {
        match self.base {
            Base::Start => {
                let ground = self.place(&self.joints[0].inboard, &[]);
                let first = self.joints[0].turn(state).outboard(&ground);
                self.motions_onwards(state, &first)
            }
            Base::Floating => self.motions_onwards(state, &floating_input(state)),
            Base::Finish => self.motions_backwards(state),
        }
    }

    /// Places the bodies one after the other, given the input of the first.
    fn motions_onwards(&self, state: &State, first_input: &Place) -> Vec<Motion> {
        let held = self.joints.len() + 1 - self.bodies.len();
        let mut motions: Vec<Motion> = vec![self.bodies[0].motion_from_input(first_input)];
        for (joint, rigid) in self.joints[held..].iter().zip(&self.bodies[1..]) {
            let inboard = self.place(&joint.inboard, &motions);
            motions.push(rigid.motion_from_input(&joint.turn(state).outboard(&inboard)));
        }
        motions
    }

    /// Places the bodies from the last to the first, starting at the ground after the last hinge.
    fn motions_backwards(&self, state: &State) -> Vec<Motion> {
        let mut motions: Vec<Motion> = Vec::new();
        let last = &self.joints[self.joints.len() - 1];
        let mut outboard = self.place(&last.outboard, &[]);
        for (joint, rigid) in self.joints.iter().zip(&self.bodies).rev() {
            let motion = rigid.motion_from_output(&joint.turn(state).inboard(&outboard));
            outboard = rigid.input_place(&motion);
            motions.push(motion);
        }
        motions.reverse();
        motions
    }

    /// Measures the coordinates and rates of moving bodies.
    ///
    /// Angles are given without jumps and quaternions without changes of sign: of all values that
    /// say the same, the ones nearest to the coordinates `near` are taken.
    pub(crate) fn measure(&self, motions: &[Motion], near: &[f64]) -> State {
        let mut state = State { q: Vec::new(), v: Vec::new() };
        if let Base::Floating = self.base {
            let input = self.bodies[0].input_place(&motions[0]);
            state.q.extend(input.position.iter());
            state.q.extend(rotation::to_quaternion(&input.rotation, &near[3..7]));
            state.v.extend(input.velocity.iter());
            state.v.extend((input.rotation.transpose() * input.spin).iter());
        }
        for joint in &self.joints {
            let inboard = self.place(&joint.inboard, motions);
            let outboard = self.place(&joint.outboard, motions);
            joint.measure(&inboard, &outboard, &near[joint.first_coordinate..], &mut state);
        }
        state
    }
}

/// Returns the input of the first body of a floating chain.
fn floating_input(state: &State) -> Place {
    let (q, v) = (&state.q, &state.v);
    let rotation = rotation::from_quaternion(&q[3..7]);
    Place {
        velocity: Vec3::from_column_slice(&v[0..3]),
        spin: rotation * Vec3::from_column_slice(&v[3..6]),
        ..Place::at_rest(Vec3::from_column_slice(&q[0..3]), rotation)
    }
}

impl Joint {
    fn turn(&self, state: &State) -> Turn {
        let q = &state.q[self.first_coordinate..];
        let v = &state.v[self.first_rate..];
        match &self.freedom {
            Freedom::None => Turn { rotation: Mat3::identity(), spin: Vec3::zeros() },
            Freedom::About(axis) => {
                Turn { rotation: rotation::about_axis(axis, q[0]), spin: axis * v[0] }
            }
            Freedom::AnyTurn => {
                let rotation = rotation::from_quaternion(&q[..4]);
                Turn { rotation, spin: rotation * Vec3::from_column_slice(&v[..3]) }
            }
        }
    }

    /// Adds the coordinates and rates of this hinge to `state`.
    fn measure(&self, inboard: &Place, outboard: &Place, near: &[f64], state: &mut State) {
        let relative = inboard.rotation.transpose() * outboard.rotation;
        let spin = outboard.spin - inboard.spin;
        match &self.freedom {
            Freedom::None => {}
            Freedom::About(axis) => {
                let angle = rotation::angle_about(axis, &relative);
                state.q.push(angle + TAU * ((near[0] - angle) / TAU).round());
                state.v.push((inboard.rotation * axis).dot(&spin));
            }
            Freedom::AnyTurn => {
                state.q.extend(rotation::to_quaternion(&relative, &near[..4]));
                state.v.extend((outboard.rotation.transpose() * spin).iter());
            }
        }
    }
}

impl Turn {
    /// Returns the outboard side of the hinge, given its inboard side.
    fn outboard(&self, inboard: &Place) -> Place {
        Place {
            rotation: inboard.rotation * self.rotation,
            spin: inboard.spin + inboard.rotation * self.spin,
            ..inboard.clone()
        }
    }

    /// Returns the inboard side of the hinge, given its outboard side.
    fn inboard(&self, outboard: &Place) -> Place {
        let rotation = outboard.rotation * self.rotation.transpose();
        Place { rotation, spin: outboard.spin - rotation * self.spin, ..outboard.clone() }
    }
}

impl Rigid {
    fn motion_from_input(&self, input: &Place) -> Motion {
        Motion::from_point(input, &input.rotation, &self.input)
    }

    fn motion_from_output(&self, output: &Place) -> Motion {
        let rotation = output.rotation * self.output_turn.transpose();
        Motion::from_point(output, &rotation, &self.output)
    }

    fn input_place(&self, motion: &Motion) -> Place {
        let arm = motion.rotation * self.input;
        Place {
            velocity: motion.velocity + motion.spin.cross(&arm),
            spin: motion.spin,
            ..Place::at_rest(motion.position + arm, motion.rotation)
        }
    }
}

impl Motion {
    /// Returns the motion of a body turned by `rotation` that has `point` at `place` of its frame,
    /// counted from its centre of mass.
    fn from_point(point: &Place, rotation: &Mat3, place: &Vec3) -> Motion {
        let arm = rotation * place;
        Motion {
            position: point.position - arm,
            rotation: *rotation,
            velocity: point.velocity - point.spin.cross(&arm),
            spin: point.spin,
        }
    }
}
