//! Conversion from hinge coordinates to the motions of the bodies, and back.

use crate::chain::{End, State};
use crate::hinge::HingeKind;
use crate::mechanism::{FrameState, Joint, Mechanism, Motion, Rigid, Side};
use crate::relative::{Relative, Twist, twist};
use crate::rotation::{Mat3, Vec3};

impl Mechanism<'_> {
    /// Returns the motions of all bodies for the coordinates and rates of the chain.
    pub(crate) fn motions(&self, state: &State) -> Vec<Motion> {
        if self.chain.floats() {
            let kind = HingeKind::of_base(self.chain.dimension);
            let (q, v) = (&state.q[..kind.coordinates()], &state.v[..kind.dof_count()]);
            let first = outboard(&kind.relative(q, v), v, &inertial());
            self.motions_onwards(state, self.bodies[0].motion_from_input(&first))
        } else if self.chain.start == End::Free {
            self.motions_backwards(state)
        } else {
            let start = self.frame_motion(&Side::Start, &[]);
            let first = self.joints[0].outboard_motion(state, &start);
            self.motions_onwards(state, self.bodies[0].motion_from_input(&first))
        }
    }

    /// Returns the motions of the bodies one after the other, from the motion of the first.
    fn motions_onwards(&self, state: &State, first: Motion) -> Vec<Motion> {
        let mut motions = vec![first];
        for joint in &self.joints {
            if let (Side::Output(_), Side::Input(body)) = (joint.inboard, joint.outboard) {
                let inboard = self.frame_motion(&joint.inboard, &motions);
                let input = joint.outboard_motion(state, &inboard);
                motions.push(self.bodies[body].motion_from_input(&input));
            }
        }
        motions
    }

    /// Returns the motions of the bodies from the last to the first, from the frame after the last
    /// hinge.
    fn motions_backwards(&self, state: &State) -> Vec<Motion> {
        let mut motions: Vec<Motion> = Vec::new();
        let mut outboard = self.frame_motion(&Side::Finish, &[]);
        for (joint, rigid) in self.joints.iter().zip(&self.bodies).rev() {
            let motion = rigid.motion_from_output(&joint.inboard_motion(state, &outboard));
            outboard = rigid.input_motion(&motion);
            motions.push(motion);
        }
        motions.reverse();
        motions
    }

    /// Returns the coordinates and rates of moving bodies.
    ///
    /// Of all equivalent angles and quaternions, those nearest to the coordinates of `near` are
    /// returned, so angles do not jump and quaternions do not change their sign.
    pub(crate) fn measure(&self, motions: &[Motion], near: &State) -> State {
        let mut state = State { q: Vec::new(), v: Vec::new() };
        let mut add =
            |kind: &HingeKind, inboard: &FrameState, outboard: &FrameState, near: &[f64]| {
                let (rotation, offset) = relative_pose(inboard, outboard);
                let q = kind.measure(&rotation, &offset, near);
                // The twist is linear in the rates, so any rates will do to find its directions.
                let relative = kind.relative(&q, &vec![0.0; kind.dof_count()]);
                state.v.extend(relative.rates(&relative_twist(inboard, outboard)));
                state.q.extend(q);
            };
        if self.chain.floats() {
            let kind = HingeKind::of_base(self.chain.dimension);
            add(&kind, &inertial(), &self.frame_motion(&Side::Input(0), motions), &near.q);
        }
        for joint in self.joints.iter().filter(|joint| joint.prescribed.is_none()) {
            let inboard = self.frame_motion(&joint.inboard, motions);
            let outboard = self.frame_motion(&joint.outboard, motions);
            add(joint.kind(), &inboard, &outboard, joint.q(near));
        }
        state
    }
}

/// The inertial frame.
fn inertial() -> FrameState {
    FrameState::at_rest(Vec3::zeros(), Mat3::identity())
}

/// Returns the rotation and the offset of the outboard frame relative to the inboard frame, in
/// inboard axes.
pub(crate) fn relative_pose(inboard: &FrameState, outboard: &FrameState) -> (Mat3, Vec3) {
    let back = inboard.rotation.transpose();
    (back * outboard.rotation, back * (outboard.position - inboard.position))
}

/// Returns the twist of the outboard frame relative to the inboard frame, in inboard axes.
pub(crate) fn relative_twist(inboard: &FrameState, outboard: &FrameState) -> Twist {
    let back = inboard.rotation.transpose();
    let carried = inboard.spin.cross(&(outboard.position - inboard.position));
    let velocity = outboard.velocity - inboard.velocity - carried;
    twist(back * velocity, back * (outboard.spin - inboard.spin))
}

/// Returns the outboard side of a hinge, given its inboard side.
fn outboard(relative: &Relative, v: &[f64], inboard: &FrameState) -> FrameState {
    let moving = relative.twist(v);
    let offset = inboard.rotation * relative.offset;
    let velocity = inboard.rotation * moving.fixed_rows::<3>(0);
    FrameState {
        velocity: inboard.velocity + inboard.spin.cross(&offset) + velocity,
        spin: inboard.spin + inboard.rotation * moving.fixed_rows::<3>(3),
        ..FrameState::at_rest(inboard.position + offset, inboard.rotation * relative.rotation)
    }
}

impl Joint<'_> {
    /// Returns the outboard side of the hinge, given its inboard side, without accelerations.
    pub(crate) fn outboard_motion(&self, state: &State, inboard: &FrameState) -> FrameState {
        let v = self.v(state);
        outboard(&self.kind().relative(self.q(state), v), v, inboard)
    }

    /// Returns the inboard side of the hinge, given its outboard side, without accelerations.
    fn inboard_motion(&self, state: &State, outboard: &FrameState) -> FrameState {
        let v = self.v(state);
        let relative = self.kind().relative(self.q(state), v);
        let moving = relative.twist(v);
        let rotation = outboard.rotation * relative.rotation.transpose();
        let offset = rotation * relative.offset;
        let spin = outboard.spin - rotation * moving.fixed_rows::<3>(3);
        FrameState {
            velocity: outboard.velocity
                - spin.cross(&offset)
                - rotation * moving.fixed_rows::<3>(0),
            spin,
            ..FrameState::at_rest(outboard.position - offset, rotation)
        }
    }
}

impl Rigid {
    fn motion_from_input(&self, input: &FrameState) -> Motion {
        Motion::from_point(input, &input.rotation, &self.input)
    }

    fn motion_from_output(&self, output: &FrameState) -> Motion {
        let rotation = output.rotation * self.output_turn.transpose();
        Motion::from_point(output, &rotation, &self.output)
    }

    fn input_motion(&self, motion: &Motion) -> FrameState {
        let arm = motion.rotation * self.input;
        FrameState {
            velocity: motion.velocity + motion.spin.cross(&arm),
            spin: motion.spin,
            ..FrameState::at_rest(motion.position + arm, motion.rotation)
        }
    }
}

impl Motion {
    /// Returns the motion of a body with the orientation `rotation` whose point at `place`, counted
    /// from its centre of mass in body axes, moves like `point`.
    fn from_point(point: &FrameState, rotation: &Mat3, place: &Vec3) -> Motion {
        let arm = rotation * place;
        Motion {
            position: point.position - arm,
            rotation: *rotation,
            velocity: point.velocity - point.spin.cross(&arm),
            spin: point.spin,
        }
    }
}
