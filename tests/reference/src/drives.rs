//! The inputs of a chain at one instant.

use crate::chain::{Chain, End, Gravity, State};
use crate::hinge::Source;

/// The inputs of a chain at one instant. Inputs that the chain does not have are ignored.
#[derive(Clone, Debug, PartialEq)]
pub struct Drives {
    /// One effort for every rate of the state. Efforts of hinges are applied even if the chain declares
    /// no input there; if it declares a constant, the constant acts instead. Efforts of a floating base
    /// are ignored.
    pub efforts: Vec<f64>,
    /// The motion of every prescribed hinge, in written order.
    pub motions: Vec<HingeMotion>,
    /// The motion of the frame that the start of the first route is attached to.
    pub start: FrameMotion,
    /// The motion of the frame that the start of each later route is attached to.
    pub route_starts: Vec<FrameMotion>,
    /// The motion of the frame that the finish of the chain is attached to.
    pub finish: FrameMotion,
    /// The values of the inputs of every load, in the order of [`Chain::loads`].
    pub loads: Vec<LoadInput>,
    /// The force of the actuator of every spring in N, in the order of [`Chain::springs`].
    pub springs: Vec<f64>,
    /// The acceleration of free fall in m/s², inertial axes.
    pub gravity: [f64; 3],
}

/// The prescribed motion of a hinge at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct HingeMotion {
    /// The coordinates.
    pub q: Vec<f64>,
    /// The rates.
    pub v: Vec<f64>,
    /// The derivatives of the rates.
    pub a: Vec<f64>,
}

/// The motion of a frame at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameMotion {
    /// The position of the origin in m, inertial.
    pub position: [f64; 3],
    /// The quaternion (w, x, y, z) from the frame's components to inertial ones.
    pub orientation: [f64; 4],
    /// The velocity of the origin in m/s, inertial axes.
    pub velocity: [f64; 3],
    /// The angular velocity in rad/s, the frame's own axes.
    pub rate: [f64; 3],
    /// The acceleration of the origin in m/s², inertial axes.
    pub acceleration: [f64; 3],
    /// The derivatives of the components of the angular velocity in rad/s², own axes.
    pub rate_derivative: [f64; 3],
}

/// The values of a load's inputs, in the axes of the load.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadInput {
    /// The force in N.
    pub force: [f64; 3],
    /// The couple in N·m.
    pub torque: [f64; 3],
}

impl Drives {
    /// Returns inputs that are all zero: no efforts, loads or gravity, prescribed hinges at rest in
    /// their zero positions, and moving frames at rest at the inertial frame.
    pub fn none(chain: &Chain) -> Drives {
        let prescribed = chain.hinges().filter(|hinge| hinge.prescribed);
        let at_rest = |dof_count: usize| vec![0.0; dof_count];
        Drives {
            efforts: at_rest(chain.dof_count()),
            motions: prescribed
                .map(|hinge| HingeMotion {
                    q: hinge.kind.zero_position(),
                    v: at_rest(hinge.kind.dof_count()),
                    a: at_rest(hinge.kind.dof_count()),
                })
                .collect(),
            start: FrameMotion::AT_REST,
            route_starts: vec![FrameMotion::AT_REST; chain.later_routes.len()],
            finish: FrameMotion::AT_REST,
            loads: vec![LoadInput::default(); chain.loads.len()],
            springs: vec![0.0; chain.springs.len()],
            gravity: [0.0; 3],
        }
    }
}

impl FrameMotion {
    /// The frame that coincides with the inertial frame at all times.
    pub const AT_REST: FrameMotion = FrameMotion {
        position: [0.0; 3],
        orientation: [1.0, 0.0, 0.0, 0.0],
        velocity: [0.0; 3],
        rate: [0.0; 3],
        acceleration: [0.0; 3],
        rate_derivative: [0.0; 3],
    };
}

impl Chain {
    /// Returns whether the chain has inputs in addition to efforts: a moving frame, a prescribed
    /// motion, a load, an actuator of a spring or gravity.
    pub fn needs_drives(&self) -> bool {
        let moving = |end: &End| matches!(end, End::Moving { .. });
        self.routes().any(|(start, _, finish)| moving(start) || moving(finish))
            || self.gravity == Gravity::Input
            || self.hinges().any(|hinge| hinge.prescribed)
            || self.loads.iter().any(|l| l.force == Source::Input || l.torque == Source::Input)
            || self.springs.iter().any(|spring| spring.force == Source::Input)
    }

    /// Returns the motion of the moving frame with the given name, if the chain has one.
    pub fn frame_motion<'a>(&self, drives: &'a Drives, name: &str) -> Option<&'a FrameMotion> {
        let is_it = |end: &End| matches!(end, End::Moving { name: own } if own == name);
        let starts = self.routes().map(|(start, _, _)| start);
        let motions = std::iter::once(&drives.start).chain(&drives.route_starts);
        let ends = starts.zip(motions).chain([(self.attached_finish(), &drives.finish)]);
        ends.into_iter().find(|(end, _)| is_it(end)).map(|(_, motion)| motion)
    }

    pub(crate) fn check_lengths(&self, state: &State, drives: &Drives) {
        assert_eq!(state.q.len(), self.coordinates(), "chain {}: coordinates", self.name);
        assert_eq!(state.v.len(), self.dof_count(), "chain {}: rates", self.name);
        assert_eq!(drives.efforts.len(), self.dof_count(), "chain {}: efforts", self.name);
        assert_eq!(drives.loads.len(), self.loads.len(), "chain {}: loads", self.name);
        assert_eq!(drives.springs.len(), self.springs.len(), "chain {}: springs", self.name);
        let later = self.later_routes.len();
        assert_eq!(drives.route_starts.len(), later, "chain {}: routes", self.name);
        let prescribed: Vec<_> = self.hinges().filter(|hinge| hinge.prescribed).collect();
        assert_eq!(drives.motions.len(), prescribed.len(), "chain {}: motions", self.name);
        for (hinge, motion) in prescribed.iter().zip(&drives.motions) {
            let found = [motion.q.len(), motion.v.len(), motion.a.len()];
            let (coordinates, rates) = (hinge.kind.coordinates(), hinge.kind.dof_count());
            assert_eq!(found, [coordinates, rates, rates], "chain {}: {}", self.name, hinge.name);
        }
    }
}
