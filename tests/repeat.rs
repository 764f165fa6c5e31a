//! A repeated part is the same as its contents written out in a row.

mod repeat {
    mod branches;
    mod closed;
    mod counts;
    mod flat;
    mod forces;
    mod kinds;
    mod known;
    mod motions;
    mod named;
    mod parameters;
    mod places;
    mod redundant;
    mod shares;
    mod twins;
}
mod support;
