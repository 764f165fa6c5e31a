//! Pairs of a random chain with repeated parts and the same chain written out.

use super::folded::texts;
use super::given::slots;
use super::interpreter::{Arrays, Judge, run};
use super::lifted::lifted;
use super::numbers;
use mstmm_codegen::compile::{Compiled, compile};
use mstmm_codegen::ids::InputId;
use mstmm_codegen::model::{Chain, HingeKind, InputKind, Layout};
use mstmm_codegen::program::Argument;
use mstmm_reference::{Dimension, Ends, HingeChoice, Random, Recipe};
use std::collections::HashMap;

/// A chain with its functions.
pub struct Twin {
    pub chain: Chain,
    pub compiled: Compiled,
    layout: Layout,
}

/// The same chain twice.
pub struct Twins {
    pub seed: u64,
    pub repeated: Twin,
    pub unrolled: Twin,
}

/// The stage at which numbers become known.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// As in the text: most at compile time.
    Written,
    /// With the parameters, at setup.
    Lifted,
}

/// The ends of chains with repeated parts: the start is attached, or neither end is.
const ENDS: [Ends; 7] = [
    Ends::HeldFree,
    Ends::MovingFree,
    Ends::FreeFree,
    Ends::HeldHeld,
    Ends::HeldMoving,
    Ends::MovingHeld,
    Ends::MovingMoving,
];

/// Returns the recipe for a seed; every fourth chain is closed.
pub fn recipe(seed: u64, random: &mut Random) -> Recipe {
    let dimension = match seed % 5 {
        0 => Dimension::Plane,
        1 if seed.is_multiple_of(3) => Dimension::Line,
        _ => Dimension::Space,
    };
    let number = seed as usize / 4;
    let ends = if seed % 4 == 3 { ENDS[3 + number % 4] } else { ENDS[number % 3] };
    let rich = Recipe::rich(dimension, 2 + random.below(2), ends, &HingeChoice::ALL);
    Recipe { loads: 0.4, springs: 0.3, ..rich }
}

impl Twins {
    /// Returns the pair for a seed, if both are valid and can be compared in any state.
    pub fn random(seed: u64, numbers: Numbers) -> Option<Twins> {
        let mut random = Random::new(seed);
        let recipe = recipe(seed, &mut random);
        Twins::of(seed, &mut random, &recipe, numbers)
    }

    /// Returns the pair for a recipe.
    pub fn of(seed: u64, random: &mut Random, recipe: &Recipe, numbers: Numbers) -> Option<Twins> {
        let texts = texts(random, &format!("Twin{seed}"), recipe);
        let [repeated, unrolled] = texts.each_ref().map(|text| Twin::new(text, numbers));
        match (repeated, unrolled) {
            (Ok(repeated), Ok(unrolled)) => {
                let twins = Twins { seed, repeated, unrolled };
                twins.close_alike().then_some(twins)
            }
            (Err(_), Err(_)) => None,
            (repeated, unrolled) => {
                let [repeated, unrolled] = [repeated.err(), unrolled.err()];
                panic!("seed {seed}: one is refused, {repeated:?} {unrolled:?}\n{}", texts[0])
            }
        }
    }

    /// Returns whether both are closed at the same hinge. A final weld is merged, unless the repeated part is next to it; then
    /// the chains agree only in closed states.
    fn close_alike(&self) -> bool {
        let names = |twin: &Twin| -> Vec<String> {
            let loop_hinges = twin.layout.loop_hinges.iter();
            loop_hinges.map(|&hinge| twin.chain.hinges[hinge].name.to_string()).collect()
        };
        names(&self.repeated) == names(&self.unrolled)
    }

    /// Returns the arguments of both in a random state, closed or not, with random parameters and inputs, after the setup.
    pub fn state<S: Judge>(&self, number: u64) -> [Arrays<S>; 2] {
        let mut random = Random::new(1000 * self.seed + number);
        let unrolled = self.unrolled.random_arguments::<S>(&mut random);
        let repeated = self.repeated_arguments(&unrolled);
        [self.repeated.set_up(repeated), self.unrolled.set_up(unrolled)]
    }

    /// Converts the arguments of the chain written out to those of the repeated chain.
    fn repeated_arguments<S: Judge>(
        &self,
        given: &HashMap<Argument, Vec<S>>,
    ) -> HashMap<Argument, Vec<S>> {
        let (repeated, unrolled) = (&self.repeated, &self.unrolled);
        let count = |part| repeated.chain.repeats[part].count;
        // Elements outside of parts have the same names.
        let gathered = |times: Option<usize>, name: &str, find: &dyn Fn(&str) -> Argument| {
            let names: Vec<String> = match times {
                None => vec![name.to_owned()],
                Some(times) => (0..times).map(|time| format!("{name}_{time}")).collect(),
            };
            names.iter().flat_map(|name| given[&find(name)].clone()).collect::<Vec<S>>()
        };
        let of = |argument| match argument {
            Argument::Parameter(parameter) => {
                let parameter = &repeated.chain.parameters[parameter];
                gathered(parameter.repetitions, &parameter.name.to_string(), &|name| {
                    let id = unrolled.chain.parameters.position(|it| it.name == name);
                    Argument::Parameter(id.expect("the same parameter"))
                })
            }
            Argument::Input(input) => {
                let what = repeated.layout.inputs[input].what;
                let times = repeated.chain.repeat_of_input(what).map(count);
                let (kind, name) = repeated.name_of(input);
                gathered(times, &name, &|name| {
                    let mut inputs = unrolled.layout.inputs.ids().into_iter();
                    let input = inputs.find(|&it| unrolled.name_of(it) == (kind, name.to_owned()));
                    Argument::Input(input.expect("the same input"))
                })
            }
            same => given[&same].clone(),
        };
        let arguments = repeated.compiled.unknowns.arguments().map(|(argument, layout)| {
            let values = of(argument);
            assert_eq!(values.len(), layout.total, "seed {}: {argument:?}", self.seed);
            (argument, values)
        });
        let time = (Argument::Time, given[&Argument::Time].clone());
        arguments.chain([time]).collect()
    }
}

impl Twin {
    /// Returns the only chain of a text, or its errors.
    pub fn new(text: &str, numbers: Numbers) -> Result<Twin, String> {
        Twin::edited(text, numbers, |_| ())
    }

    /// Returns the only chain of a text after a change, or the errors of the text.
    pub fn edited(
        text: &str,
        numbers: Numbers,
        edit: impl FnOnce(&mut Chain),
    ) -> Result<Twin, String> {
        let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
        let read = mstmm_codegen::read_and_examine(tokens);
        let (chain, findings) = read.map_err(|error| error.to_string())?.remove(0);
        let mut chain = chain;
        edit(&mut chain);
        let chain = if numbers == Numbers::Lifted { lifted(chain) } else { chain };
        let layout = Layout::of(&chain);
        let compiled = compile(&chain, &findings, &layout);
        Ok(Twin { chain, compiled, layout })
    }

    /// Returns the arrays with these arguments.
    pub fn set_up<S: Judge>(&self, arguments: HashMap<Argument, Vec<S>>) -> Arrays<S> {
        let mut given = Arrays { arguments, ..Arrays::default() };
        let mut derived = given.clone();
        run(&self.compiled.setup.procedure, &mut derived).expect("a setup cannot fail");
        given.arguments.extend(slots(&self.compiled, &derived));
        given
    }

    /// Returns the kind of an input, and the name of the element that it belongs to.
    fn name_of(&self, input: InputId) -> (usize, String) {
        let Chain { hinges, loads, springs, .. } = &self.chain;
        match self.layout.inputs[input].what {
            InputKind::Gravity => (0, String::new()),
            InputKind::Efforts(hinge) => (1, hinges[hinge].name.to_string()),
            InputKind::Motion(hinge) => (2, hinges[hinge].name.to_string()),
            InputKind::Force(load) => (3, loads[load].name.to_string()),
            InputKind::Torque(load) => (4, loads[load].name.to_string()),
            InputKind::SpringForce(spring) => (5, springs[spring].name.to_string()),
        }
    }

    /// Returns random values of all unknowns of a chain without repeated parts. Quaternions have unit length in the precision of
    /// the scalar, since the equations assume it.
    pub fn random_arguments<S: Judge>(&self, random: &mut Random) -> HashMap<Argument, Vec<S>> {
        let mut all = HashMap::from([(Argument::Time, vec![S::number(0.3)])]);
        for (argument, layout) in self.compiled.unknowns.arguments() {
            let values = (0..layout.total).map(|_| self.random_number(argument, random));
            let mut values: Vec<f64> = values.collect();
            let quaternions = self.quaternions(argument);
            // Away from zero.
            quaternions.iter().for_each(|&at| values[at] += values[at].signum());
            let mut values: Vec<S> = values.into_iter().map(S::number).collect();
            quaternions.iter().for_each(|&at| normalise(&mut values[at..at + 4]));
            all.insert(argument, values);
        }
        all
    }

    fn random_number(&self, argument: Argument, random: &mut Random) -> f64 {
        match argument {
            Argument::Parameter(id) => {
                let parameter = &self.chain.parameters[id];
                let default = numbers::<f64>(&self.chain).parameters[id.index()].value();
                let is_lifted = parameter.name.to_string().starts_with("number");
                if is_lifted { default } else { default * random.between(0.9, 1.1) }
            }
            Argument::ClosureSteps => 1.0,
            Argument::Step => random.between(0.0, 0.01),
            Argument::Input(_) => random.between(-3.0, 3.0),
            _ => random.between(-1.0, 1.0),
        }
    }

    /// Returns the indices at which quaternions start.
    fn quaternions(&self, argument: Argument) -> Vec<usize> {
        let hinges = &self.chain.hinges;
        let is_turned = |kind: &HingeKind| kind.coordinates() > kind.dof_count();
        match argument {
            Argument::Coordinates => {
                let free = hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed());
                let turned = free.filter(|(_, hinge)| is_turned(&hinge.kind));
                turned.map(|(index, _)| self.layout.q[index].end - 4).collect()
            }
            Argument::Input(input) => match self.layout.inputs[input].what {
                InputKind::Motion(hinge) if is_turned(&hinges[hinge].kind) => {
                    vec![hinges[hinge].kind.coordinates() - 4]
                }
                _ => Vec::new(),
            },
            _ => Vec::new(),
        }
    }
}

fn normalise<S: Judge>(quaternion: &mut [S]) {
    let square = quaternion.iter().fold(S::zero(), |sum, &x| sum + x * x);
    let scale = square.sqrt().recip();
    quaternion.iter_mut().for_each(|x| *x = *x * scale);
}
