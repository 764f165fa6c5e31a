#![doc = include_str!("hinges/hinges.md")]

pub mod weld {
    #![doc = include_str!("hinges/weld.md")]
}

pub mod pin {
    #![doc = include_str!("hinges/pin.md")]
}

pub mod slider {
    #![doc = include_str!("hinges/slider.md")]
}

pub mod screw {
    #![doc = include_str!("hinges/screw.md")]
}

pub mod cylindrical {
    #![doc = include_str!("hinges/cylindrical.md")]
}

pub mod universal {
    #![doc = include_str!("hinges/universal.md")]
}

pub mod ball {
    #![doc = include_str!("hinges/ball.md")]
}

pub mod planar {
    #![doc = include_str!("hinges/planar.md")]
}

pub mod floating {
    #![doc = include_str!("hinges/floating.md")]
}

pub mod elastic {
    #![doc = include_str!("hinges/elastic.md")]
}
