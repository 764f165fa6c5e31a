//! Elastic: a displacement in m and three angles in rad; a velocity in m/s and an angular velocity in
//! rad/s.

use super::{Form, Freedoms, Group, Shape, View, shifts, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "elastic",
    coordinates: &[zero("x"), zero("y"), zero("z"), zero("roll"), zero("pitch"), zero("yaw")],
    rates: &["vx", "vy", "vz", "wx", "wy", "wz"],
    groups: &[
        shifts(3),
        Freedoms { turns: true, form: Form::Angles, coordinates: 3..6, rates: 3..6 },
    ],
    view: Some(View {
        name: "ElasticState",
        groups: &[
            Group::Coordinates(0..3),
            Group::Coordinates(3..6),
            Group::Rates(0..3),
            Group::Rates(3..6),
        ],
    }),
};
