//! Chains that branch do at run time what chains without branches do: a first route that closes, with
//! branches on its bodies; states, parameters and connection points by name and by index.

mod support;

mod branches {
    mod closed;
    mod states;
}
