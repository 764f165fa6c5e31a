//! What urdfdom knows of the elements that are read. It omits everything else without a message.

use super::spelling::Known;

pub const KNOWN: &[Known] = &[
    Known {
        tag: "robot",
        attributes: &["name version"],
        elements: "link joint material transmission gazebo sensor",
    },
    Known {
        tag: "link",
        attributes: &["name type"],
        elements: "inertial visual collision contact sensor verbose",
    },
    Known { tag: "inertial", attributes: &[], elements: "origin mass inertia" },
    Known { tag: "origin", attributes: &["xyz rpy quat_xyzw"], elements: "" },
    Known { tag: "mass", attributes: &["value"], elements: "" },
    Known { tag: "inertia", attributes: &["ixx ixy ixz iyy iyz izz"], elements: "" },
    Known { tag: "visual", attributes: &["name"], elements: "origin geometry material" },
    Known {
        tag: "geometry",
        attributes: &["name"],
        elements: "box cylinder sphere capsule mesh plane cone ellipsoid",
    },
    Known { tag: "box", attributes: &["size"], elements: "" },
    Known { tag: "cylinder", attributes: &["radius length"], elements: "" },
    Known { tag: "sphere", attributes: &["radius"], elements: "" },
    Known { tag: "capsule", attributes: &["radius length"], elements: "" },
    Known { tag: "mesh", attributes: &["filename scale"], elements: "" },
    Known {
        tag: "joint",
        attributes: &["name type"],
        elements: "origin parent child axis limit dynamics mimic safety_controller calibration",
    },
    Known { tag: "parent", attributes: &["link"], elements: "" },
    Known { tag: "child", attributes: &["link"], elements: "" },
    Known { tag: "axis", attributes: &["xyz"], elements: "" },
    // Files have the last two, which must not be taken for `velocity`.
    Known {
        tag: "limit",
        attributes: &[
            "lower upper effort velocity acceleration deceleration jerk k_velocity gear_velocity",
        ],
        elements: "",
    },
    Known { tag: "dynamics", attributes: &["damping friction"], elements: "" },
    Known { tag: "mimic", attributes: &["joint multiplier offset"], elements: "" },
];
