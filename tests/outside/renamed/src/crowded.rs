//! Constants, statics, types, functions, modules and macros with the names of what generated code
//! uses.

#![allow(non_upper_case_globals, non_camel_case_types, dead_code, unused_macros)]

mod core {}
mod std {}
mod mstmm {}
mod nalgebra {}

const state: f64 = 1.0;
const inputs: f64 = 2.0;
const accelerations: f64 = 3.0;
const c: f64 = 4.0;
const q: f64 = 5.0;
const v: f64 = 6.0;
const value: f64 = 7.0;
const index: f64 = 8.0;
const spring: f64 = 9.0;
const car: f64 = 10.0;
const spring_x: f64 = 10.0;
static at: f64 = 11.0;
static t0: f64 = 12.0;
static x0: f64 = 13.0;
static parameters: f64 = 14.0;
static constants: f64 = 15.0;
static derived: f64 = 16.0;
struct zero;
struct one;
struct point;
struct result;
struct rate;
struct step;
struct T;
struct Scalar;
struct Chain;
struct State;
struct Error;
struct Point;
enum Option {}
enum Result {}
trait Default {}
trait Clone {}
trait Debug {}
trait PartialEq {}
fn vec() {}
fn new() {}
macro_rules! assert {
    () => {};
}
macro_rules! mstmm_chain {
    () => {};
}

dynamics::mstmm_chain! {
    line chain Car {
        gravity = input;
        param more = 1 kg;
        body Box { mass = self::step_mass + more; }
        ground -> slider spring -> Box car;
        hinge spring { stiffness = 50 N/m; force = input; }
        load push { on = car; force = input; }
    }
}

/// The other part of the mass.
const step_mass: f64 = 1.0;

/// The acceleration at 1 m.
#[must_use]
pub fn acceleration() -> f64 {
    let chain = Car::<f64>::new();
    let mut start = chain.initial_state();
    start.spring_mut().set_position(1.0);
    chain.accelerations(&start, &chain.no_inputs()).map_or(f64::NAN, |result_| result_[0])
}
