//! Times the expansion of the macro, built as cargo builds macros by default, without optimisation: run it as
//! `benches/compile-time/run` does. An argument selects a chain by its name.

use std::error::Error;
use std::fmt::Write;
use std::time::Instant;

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

macro_rules! mstmm_chain {
    ($($description:tt)*) => {
        /// The description of the Panda.
        const PANDA: &str = stringify!($($description)*);
    };
}

include!("../../../examples/panda.rs");

panda! {
    pub chain Panda {}
}

/// The setting of all answers that are timed, before the gravity.
const ALL: &str = "answers = [basic, regressor, derivatives, linearize, push, pull]; gravity";

/// Robots that branch.
const TREES: [(&str, &str); 2] = [
    ("HyQ", include_str!("../models/trees/hyq.chain")),
    ("G1", include_str!("../models/trees/g1.chain")),
];

/// The number of bodies of the long chain, all different.
const BODIES: usize = 32;

const RUNS: usize = 11;

fn main() -> Result<(), Box<dyn Error>> {
    time("the Panda", &PANDA.parse()?)?;
    time("the Panda with all answers", &PANDA.replacen("gravity", ALL, 1).parse()?)?;
    time("32 different bodies", &different_bodies()?.parse()?)?;
    for (name, text) in TREES {
        time(name, &description(text)?)?;
    }
    Ok(())
}

/// Prints the median of some expansions, unless another chain is selected.
fn time(name: &str, description: &TokenStream) -> Result<(), Box<dyn Error>> {
    if std::env::args().nth(1).is_some_and(|only| name != only) {
        return Ok(());
    }
    let mut milliseconds = Vec::new();
    for _ in 0..RUNS {
        let (description, start) = (description.clone(), Instant::now());
        let expansion = mstmm_codegen::expand(description, &quote!(::mstmm));
        milliseconds.push(start.elapsed().as_secs_f64() * 1e3);
        if let Some(errors) = expansion.errors {
            return Err(errors.into());
        }
    }
    milliseconds.sort_by(f64::total_cmp);
    println!("{name}\t{:.1}", milliseconds[RUNS / 2]);
    Ok(())
}

/// Returns the arguments of the macro call that a file consists of.
fn description(text: &str) -> Result<TokenStream, Box<dyn Error>> {
    let call: TokenStream = text.parse()?;
    match call.into_iter().last() {
        Some(TokenTree::Group(arguments)) => Ok(arguments.stream()),
        _ => Err("not a call of the macro".into()),
    }
}

/// A chain of pins whose bodies have full tensors.
fn different_bodies() -> Result<String, std::fmt::Error> {
    let mut text = String::from("chain Long { gravity = [0, 0, -9.81] m/s^2;");
    for index in 0..BODIES {
        let number = index as f64 / 100.0;
        write!(
            text,
            "body Link{index} {{
                mass = {} kg;
                com = [{}, 0.02, {}] m;
                output = [0.1, {}, 0] m turned rpy(90, 0, 0) deg;
                inertia = tensor({}, 0.11, 0.12, 0.001, 0.002, 0.003) kg*m^2 about com;
            }}",
            1.0 + number,
            0.01 + number,
            0.03 - number,
            0.2 + number,
            0.1 + number / 4.0,
        )?;
    }
    let route =
        (0..BODIES).map(|index| format!("-> pin(z) joint{index} -> Link{index} link{index}"));
    write!(text, "ground {}; }}", route.collect::<String>())?;
    Ok(text)
}
