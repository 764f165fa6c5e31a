//! Quaternions that are not rotations are rejected in every state and prescribed motion given by the caller;
//! those of an integrator's stages may have any length near one.

mod support;

mod quaternions {
    mod lanes;
    mod models;
    mod prescribed;
    mod setters;
    mod stages;
    mod states;
}
