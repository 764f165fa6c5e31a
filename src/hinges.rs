#![doc = include_str!("hinges/hinges.md")]
#![doc(alias("joint", "joints"))]

pub mod weld {
    #![doc(alias("fixed"))]
    #![doc = include_str!("hinges/weld.md")]
}

pub mod pin {
    #![doc(alias("revolute", "hinge", "continuous"))]
    #![doc = include_str!("hinges/pin.md")]
}

pub mod slider {
    #![doc(alias("prismatic", "slide"))]
    #![doc = include_str!("hinges/slider.md")]
}

pub mod screw {
    #![doc(alias("helical"))]
    #![doc = include_str!("hinges/screw.md")]
}

pub mod cylindrical {
    #![doc = include_str!("hinges/cylindrical.md")]
}

pub mod universal {
    #![doc(alias("cardan", "hooke"))]
    #![doc = include_str!("hinges/universal.md")]
}

pub mod gimbal {
    #![doc(alias("euler angles", "roll pitch yaw", "rpy"))]
    #![doc = include_str!("hinges/gimbal.md")]
}

pub mod ball {
    #![doc(alias("spherical"))]
    #![doc = include_str!("hinges/ball.md")]
}

pub mod planar {
    #![doc = include_str!("hinges/planar.md")]
}

pub mod floating {
    #![doc(alias("free flyer", "freejoint", "free", "floating base"))]
    #![doc = include_str!("hinges/floating.md")]
}

pub mod elastic {
    #![doc(alias("bushing"))]
    #![doc = include_str!("hinges/elastic.md")]
}
