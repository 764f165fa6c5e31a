//! Elastic: a displacement in m and three angles in rad; a velocity in m/s and an angular velocity in
//! rad/s.

use super::spec::{
    DofGroup, HingeSpec, Representation, StateView, ViewArgument, displacements, zero,
};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "elastic",
    coordinates: &[zero("x"), zero("y"), zero("z"), zero("roll"), zero("pitch"), zero("yaw")],
    rates: &["vx", "vy", "vz", "wx", "wy", "wz"],
    groups: &[
        displacements(3),
        DofGroup {
            names: ["angles", "rate"],
            rotational: true,
            representation: Representation::Angles,
            coordinates: 3..6,
            rates: 3..6,
        },
    ],
    view: Some(StateView {
        name: "ElasticState",
        groups: &[
            ViewArgument::Coordinates(0..3),
            ViewArgument::Coordinates(3..6),
            ViewArgument::Rates(0..3),
            ViewArgument::Rates(3..6),
        ],
    }),
};
