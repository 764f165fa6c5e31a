//! Conversion from hinge coordinates to the motions of the bodies, and back.

use crate::chain::State;
use crate::hinge::HingeKind;
use crate::mechanism::{FrameState, Joint, Mechanism, Motion, Rigid, Side};
use crate::relative::{Relative, Twist, twist};
use crate::rotation::{Mat3, Vec3};

impl Mechanism<'_> {
    /// Returns the motions of all bodies for the coordinates and rates of the chain.
    ///
    /// # Panics
    ///
    /// Panics if no hinge joins a body to the others.
    pub(crate) fn motions(&self, state: &State) -> Vec<Motion> {
        let mut motions = vec![Motion::none(); self.bodies.len()];
        let mut known = vec![false; self.bodies.len()];
        if self.chain.floats() {
            let kind = HingeKind::of_base(self.chain.dimension);
            let (q, v) = (&state.q[..kind.coordinates()], &state.v[..kind.dof_count()]);
            let first = outboard(&kind.relative(q, v), v, &inertial());
            motions[0] = self.bodies[0].motion_from_place(0, &first);
            known[0] = true;
        }
        // Written order finds all bodies that the start leads to, and the reverse order those that
        // only the finish leads to.
        let (onwards, backwards) = (0..self.joints.len(), (0..self.joints.len()).rev());
        for number in onwards.clone().chain(backwards).chain(onwards) {
            let joint = &self.joints[number];
            let is_known = |side: Side| side.body().is_none_or(|body| known[body]);
            let (from, to) = (joint.inboard, joint.outboard);
            let found = match (is_known(from), is_known(to)) {
                (true, false) => {
                    let inboard = self.frame_motion(&from, &motions);
                    (to, joint.outboard_motion(state, &inboard))
                }
                (false, true) => {
                    let outboard = self.frame_motion(&to, &motions);
                    (from, joint.inboard_motion(state, &outboard))
                }
                _ => continue,
            };
            if let (Side::On { body, place }, point) = found {
                motions[body] = self.bodies[body].motion_from_place(place, &point);
                known[body] = true;
            }
        }
        assert!(
            known.iter().all(|known| *known),
            "chain {}: a body is not joined",
            self.chain.name
        );
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
            add(&kind, &inertial(), &self.frame_motion(&Side::input(0), motions), &near.q);
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
    /// Returns the motion of the body, of which one place moves like `point`.
    fn motion_from_place(&self, place: usize, point: &FrameState) -> Motion {
        let (position, turn) = &self.places[place];
        Motion::from_point(point, &(point.rotation * turn.transpose()), position)
    }
}

impl Motion {
    /// A motion that is not known yet.
    fn none() -> Motion {
        let none = Vec3::zeros();
        Motion { position: none, rotation: Mat3::identity(), velocity: none, spin: none }
    }

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
