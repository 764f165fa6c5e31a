//! Checks of the reference against what is known without it: closed forms, balances, conserved
//! quantities and recorded motions.

mod balances;
mod closed_forms;
mod derivatives;
mod descriptions;
mod golden_motions;
mod motions;
mod samples;
