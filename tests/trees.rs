//! Trees: the models compile as they are written, and obey laws that hold for any mechanism.

mod trees {
    mod laws;
    mod models;
}
