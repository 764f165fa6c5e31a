//! Random chains and trees with answers, each in a random state, with the same chain of the reference.

use crate::common::drives;
use crate::common::given::Given;
use crate::common::interpreter::{Arrays, Judge};
use crate::common::lifted::lifted;
use crate::common::numbers;
use mstmm_codegen::compile::{Compiled, compile};
use mstmm_codegen::examine::Findings;
use mstmm_codegen::ids::ParameterId;
use mstmm_codegen::model::{Answer, Chain, Layout};
use mstmm_codegen::program::{Argument, Given as Vector, OutputId};
use mstmm_reference::{
    Drives, Ends, Features, Random, Recipe, State, TreeRecipe, random_described_tree,
    random_mechanism, random_motion, random_tree,
};

/// A chain in a state.
pub struct Sample {
    pub seed: u64,
    pub text: String,
    pub chain: Chain,
    pub compiled: Compiled,
    pub truth: mstmm_reference::Chain,
    pub state: State,
    pub drives: Drives,
}

/// The kind of a random chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One route.
    Route,
    /// One route that is not closed.
    OpenRoute,
    Tree,
    /// A tree that is not closed.
    OpenTree,
    /// A tree with parts and repeated parts, not closed.
    Described,
    /// One route, whose numbers are all parameters.
    Lifted,
    /// A tree without springs, dampers, loads and prescribed motions, not closed.
    Bare,
    /// The same on a moving frame, with gravity as an input.
    Carried,
}

/// Returns the first seed, which `MSTMM_SEED` sets.
fn first_seed() -> u64 {
    std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0)
}

/// Returns the samples of some seeds with answers, for example `[basic, push]`.
pub fn samples(
    kind: Kind,
    seeds: std::ops::Range<u64>,
    answers: &str,
) -> impl Iterator<Item = Sample> {
    changed_samples(kind, seeds, answers, |chain| chain)
}

/// Returns the samples of some seeds with answers after a change of their chains that keeps bodies, hinges and coordinates.
pub fn changed_samples(
    kind: Kind,
    seeds: std::ops::Range<u64>,
    answers: &str,
    change: fn(Chain) -> Chain,
) -> impl Iterator<Item = Sample> {
    let first = first_seed();
    let (seeds, answers) = (first + seeds.start..first + seeds.end, answers.to_owned());
    println!("{kind:?}, seeds {seeds:?}");
    seeds.filter_map(move |seed| Sample::new(kind, seed, &answers, change))
}

impl Sample {
    fn new(kind: Kind, seed: u64, answers: &str, change: fn(Chain) -> Chain) -> Option<Sample> {
        let mut random = Random::new(seed);
        let (text, truth) = drawn(kind, &mut random, &format!("Random{seed}"));
        let (state, drives) = random_motion(&mut random, &truth);
        let text = text.replacen('{', &format!("{{ answers = {answers};"), 1);
        let tokens = text.parse().unwrap_or_else(|error| panic!("seed {seed}: {error}\n{text}"));
        let read = mstmm_codegen::read_and_examine(tokens);
        let mut read = match read {
            Ok(read) => read,
            Err(error) if truth.closed() && error.to_string().contains("cannot move") => {
                return None;
            }
            Err(error) => panic!("seed {seed}: {error}\n{text}"),
        };
        let (chain, findings) = read.remove(0);
        let (chain, findings) = match kind {
            Kind::Lifted => (lifted(chain), Findings::default()),
            _ => (change(chain), findings),
        };
        let compiled = compile(&chain, &findings, &Layout::of(&chain));
        Some(Sample { seed, text, chain, compiled, truth, state, drives })
    }

    /// Returns the arguments of all functions; vectors that the caller gives are zero.
    pub fn given<S: Judge>(&self) -> Given<'_, S> {
        let of = |values: Vec<f64>| values.into_iter().map(S::number).collect::<Vec<S>>();
        let mut given = Given::zeros(&self.compiled);
        let state = (&self.state, &self.drives);
        let arguments = drives::arguments(&self.chain, &self.compiled, &self.truth, state);
        let arguments = arguments.into_iter().map(|(argument, values)| (argument, of(values)));
        given.arrays.arguments.extend(arguments);
        let defaults = numbers::<f64>(&self.chain).parameters;
        for (index, value) in defaults.iter().enumerate() {
            let argument = Argument::Parameter(ParameterId(index));
            let count = self.compiled.unknowns.layout(argument).total;
            given.arrays.arguments.insert(argument, of(vec![value.value(); count]));
        }
        given.set_up();
        given
    }

    /// Returns the result of a function with vectors that the caller gives.
    #[track_caller]
    pub fn ask<S: Judge>(
        &self,
        given: &Given<S>,
        (answer, id): (Answer, OutputId),
        vectors: &[(Vector, &[S])],
    ) -> Vec<S> {
        self.all(given, answer, vectors).result(id)
    }

    /// Returns all results of a function with vectors that the caller gives.
    #[track_caller]
    pub fn all<S: Judge>(
        &self,
        given: &Given<S>,
        answer: Answer,
        vectors: &[(Vector, &[S])],
    ) -> Arrays<S> {
        let mut own = Given { compiled: given.compiled, arrays: given.arrays.clone() };
        for (vector, values) in vectors {
            own.arrays.arguments.insert(Argument::Given(*vector), values.to_vec());
        }
        own.run(answer).unwrap_or_else(|error| panic!("{}: {error:?}", self.named(answer.name())))
    }

    /// Returns the number of free rates.
    pub fn rates(&self) -> usize {
        self.truth.dof_count()
    }

    /// Returns a random vector with an entry for every rate.
    pub fn random_rates(&self, number: u64) -> Vec<f64> {
        let mut random = Random::new(1_000_000 * (number + 1) + self.seed);
        (0..self.rates()).map(|_| random.between(-1.0, 1.0)).collect()
    }

    /// Returns whether the motion of a hinge or of a frame is prescribed.
    pub fn is_prescribed(&self) -> bool {
        let layout = Layout::of(&self.chain);
        let is_motion = |input: &mstmm_codegen::model::Input| {
            matches!(input.what, mstmm_codegen::model::InputKind::Motion(_))
        };
        layout.inputs.iter().any(is_motion)
    }

    /// Returns a description of this sample for messages.
    pub fn named(&self, what: &str) -> String {
        format!("seed {}: {what}\n{}", self.seed, self.text)
    }

    /// Checks that the entries of two lists differ by at most `tolerance` times `scale`.
    #[track_caller]
    pub fn check(
        &self,
        what: &str,
        (found, expected): (&[f64], &[f64]),
        scale: f64,
        tolerance: f64,
    ) {
        assert_eq!(found.len(), expected.len(), "{}", self.named(what));
        for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
            let off = (found - expected).abs() / scale;
            // NaN must fail.
            let is_close = off <= tolerance;
            let what = format!("entry {k} of {what}: {found} is not {expected}, off by {off:.1e}");
            assert!(is_close, "{}", self.named(&what));
        }
    }
}

/// Returns the largest entry, at least one.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(1.0, |most, value| most.max(value.abs()))
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns the product of a matrix by rows with a vector.
pub fn times(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

fn drawn(kind: Kind, random: &mut Random, name: &str) -> (String, mstmm_reference::Chain) {
    let truth = match kind {
        Kind::Route => {
            let recipe = Recipe::any(random, 5);
            random_mechanism(random, name, &recipe)
        }
        Kind::OpenRoute | Kind::Lifted => {
            let ends = *random.choose(&Ends::OPEN);
            let recipe = Recipe { ends, ..Recipe::any(random, 4) };
            random_mechanism(random, name, &recipe)
        }
        Kind::Tree => {
            let recipe = TreeRecipe::any(random, 7);
            random_tree(random, name, &recipe)
        }
        Kind::OpenTree => {
            let dimension = Recipe::any(random, 1).dimension;
            let ends = *random.choose(&Ends::OPEN);
            let recipe = TreeRecipe::rich(random, dimension, 7, ends);
            random_tree(random, name, &recipe)
        }
        Kind::Bare => {
            let ends = *random.choose(&[Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld]);
            let recipe = bare(random, ends);
            random_tree(random, name, &recipe)
        }
        Kind::Carried => {
            let ends = *random.choose(&[Ends::MovingFree, Ends::FreeMoving]);
            let recipe = bare(random, ends);
            let chain = Recipe { gravity_inputs: 1.0, ..recipe.chain };
            random_tree(random, name, &TreeRecipe { chain, ..recipe })
        }
        Kind::Described => {
            let ends = *random.choose(&[Ends::HeldFree, Ends::MovingFree, Ends::FreeFree]);
            let dimension = Recipe::any(random, 1).dimension;
            let recipe = TreeRecipe::rich(random, dimension, 3, ends);
            let features = Features { parts: random.chance(0.5), repeats: true };
            return random_described_tree(random, name, &recipe, features);
        }
    };
    (truth.to_macro_text(None), truth)
}

/// Returns a tree of any dimension with nothing but gravity and motors.
fn bare(random: &mut Random, ends: Ends) -> TreeRecipe {
    let dimension = Recipe::any(random, 1).dimension;
    let bodies = 2 + random.below(4);
    let recipe = TreeRecipe::rich(random, dimension, bodies, ends);
    let chain = Recipe {
        constant_motors: 0.0,
        passive: 0.0,
        prescribed: 0.0,
        loads: 0.0,
        springs: 0.0,
        gravity_inputs: 0.0,
        ..recipe.chain
    };
    TreeRecipe { chain, forest: 0.0, springs_between: 0.0, ..recipe }
}
