//! Quaternions that are no rotations are refused wherever a state or a prescribed motion comes from
//! outside; the states of an integrator's stages may have any length near one.

mod support;

mod quaternions {
    mod lanes;
    mod models;
    mod prescribed;
    mod setters;
    mod stages;
    mod states;
}
