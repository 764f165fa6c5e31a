#![doc = include_str!("hinges/hinges.md")]
#![doc(alias("joint", "joints"))]

pub mod weld {
    #![doc(alias("fixed", "WeldJoint"))]
    #![doc = include_str!("hinges/weld.md")]
}

pub mod pin {
    #![doc(alias("revolute", "hinge", "continuous", "JointModelRX", "RevoluteJoint"))]
    #![doc = include_str!("hinges/pin.md")]
}

pub mod slider {
    #![doc(alias("prismatic", "slide", "JointModelPX", "PrismaticJoint"))]
    #![doc = include_str!("hinges/slider.md")]
}

pub mod screw {
    #![doc(alias("helical", "JointModelHX", "ScrewJoint"))]
    #![doc = include_str!("hinges/screw.md")]
}

pub mod cylindrical {
    #![doc(alias("JointModelComposite"))]
    #![doc = include_str!("hinges/cylindrical.md")]
}

pub mod universal {
    #![doc(alias("cardan", "hooke", "JointModelUniversal", "UniversalJoint"))]
    #![doc = include_str!("hinges/universal.md")]
}

pub mod gimbal {
    #![doc(alias("euler angles", "roll pitch yaw", "rpy", "JointModelSphericalZYX"))]
    #![doc = include_str!("hinges/gimbal.md")]
}

pub mod ball {
    #![doc(alias("spherical", "JointModelSpherical", "BallRpyJoint"))]
    #![doc = include_str!("hinges/ball.md")]
}

pub mod planar {
    #![doc(alias("JointModelPlanar", "PlanarJoint"))]
    #![doc = include_str!("hinges/planar.md")]
}

pub mod floating {
    #![doc(alias("free flyer", "freejoint", "free", "floating base"))]
    #![doc(alias("JointModelFreeFlyer", "QuaternionFloatingJoint"))]
    #![doc = include_str!("hinges/floating.md")]
}

pub mod elastic {
    #![doc(alias("bushing", "LinearBushingRollPitchYaw"))]
    #![doc = include_str!("hinges/elastic.md")]
}
