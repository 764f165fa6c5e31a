//! Controllers that fail inside an integrator: their error reaches the caller unchanged, and state and
//! integrator are as before the step.

mod controllers {
    mod errors;
    mod models;
    mod motions;
}
