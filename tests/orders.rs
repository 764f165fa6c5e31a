//! The orders that the documentation states, of coordinates, rates, accelerations and connection
//! points, and what `assemble` minimises.

mod orders {
    mod least_motions;
    mod points;
    mod states;
}
