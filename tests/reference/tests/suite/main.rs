//! Tests of the reference solver against closed forms, balances, conserved quantities and recorded
//! motions.

mod answers;
mod balances;
mod closed_forms;
mod compounds;
mod derivatives;
mod descriptions;
mod equivalents;
mod golden_motions;
mod graph;
mod hinge_forms;
mod inverse;
mod loads;
mod motions;
mod samples;
mod trees;
