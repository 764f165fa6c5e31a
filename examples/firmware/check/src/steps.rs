//! Steps from random states, to be counted by callgrind.

use std::hint::black_box;

use anyhow::{Result, anyhow};
use models::{Model, Random, SEED};
use mstmm::Error;

use crate::case::{Case, Visitor};

/// The number of steps: each is slow under callgrind.
const STATES: usize = 200;

/// Takes steps, for this program under callgrind.
pub fn take(case: Case) -> Result<()> {
    case.visit(Steps).map_err(|error| anyhow!("{error}"))
}

struct Steps;

impl Visitor for Steps {
    type Result = std::result::Result<(), Error>;

    fn visit<M: Model>(self) -> Self::Result {
        let (model, mut work, mut random) = (M::new(), M::work(), Random::new(SEED));
        for _ in 0..STATES {
            let mut state = model.random_state(&mut random);
            model.advance(&mut work, &mut state)?;
            counted_step(black_box(&model), &mut work, black_box(&mut state))?;
        }
        Ok(())
    }
}

/// Takes one step; a separate function, so that callgrind finds its name.
#[inline(never)]
fn counted_step<M: Model>(
    model: &M,
    work: &mut M::Work,
    state: &mut M::State,
) -> std::result::Result<(), Error> {
    model.step(work, state)
}
