//! Checks of the reference against what is known without it: closed forms, balances, conserved
//! quantities and recorded motions.

mod balances;
mod closed_forms;
mod compounds;
mod derivatives;
mod descriptions;
mod equivalents;
mod golden_motions;
mod hinge_forms;
mod inverse;
mod motions;
mod outside;
mod samples;
