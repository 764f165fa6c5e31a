//! The unknowns of a chain: their numbers in the graph and their names in the program.

use crate::model::{Chain, ClosureRank, Driven, Hinge, Input, Layout, RepeatId, Shape};
use proc_macro2::Ident;
use std::collections::HashSet;
use std::ops::Range;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Numbers and names of all unknowns: parameters, constants, the steps of a closure, coordinates, rates,
/// inputs, and the length of an implicit step.
#[derive(Clone, Debug)]
pub struct Symbols {
    names: Vec<String>,
    /// Which belong to which repeated part.
    parts: Vec<Option<RepeatId>>,
    /// Where each of the seven groups ends.
    ends: [usize; 7],
}

impl Symbols {
    /// The unknowns of `chain`, whose closure has this rank.
    pub fn of(chain: &Chain, layout: &Layout, rank: ClosureRank) -> Self {
        let parameters = chain.parameters.iter().map(|parameter| text(&parameter.name));
        let constants = (0..chain.constants).map(|number| format!("constant{number}"));
        let free = || chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
        let inputs = || layout.inputs.iter().flat_map(|input| input_names(chain, input));
        let steps = match rank {
            ClosureRank::FoundAtRunTime(directions) => directions,
            ClosureRank::Unknown | ClosureRank::Known { .. } => 0,
        };
        let groups: [Vec<String>; 7] = [
            parameters.collect(),
            constants.collect(),
            (0..steps).map(|step| format!("closure_step{step}")).collect(),
            free().flat_map(|hinge| named(hinge, coordinates(hinge.kind.shape()))).collect(),
            free().flat_map(|hinge| named(hinge, hinge.kind.shape().rates.to_vec())).collect(),
            inputs().collect(),
            vec!["step".to_owned()],
        ];
        let mut names = Vec::new();
        let ends = groups.map(|group| {
            names.extend(group);
            names.len()
        });
        let parts = parts(chain, layout, &ends);
        Symbols { names: distinct(names), parts, ends }
    }

    /// The names by number.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Which unknowns belong to which repeated part, by number.
    pub fn parts(&self) -> &[Option<RepeatId>] {
        &self.parts
    }

    /// Numbers of the parameters.
    pub fn parameters(&self) -> Range<usize> {
        0..self.ends[0]
    }

    /// Numbers of the constants.
    pub fn constants(&self) -> Range<usize> {
        self.ends[0]..self.ends[1]
    }

    /// Numbers of the steps of a closure.
    pub fn closure_steps(&self) -> Range<usize> {
        self.ends[1]..self.ends[2]
    }

    /// Numbers of the coordinates.
    pub fn q(&self) -> Range<usize> {
        self.ends[2]..self.ends[3]
    }

    /// Numbers of the rates.
    pub fn v(&self) -> Range<usize> {
        self.ends[3]..self.ends[4]
    }

    /// Numbers of the inputs.
    pub fn inputs(&self) -> Range<usize> {
        self.ends[4]..self.ends[5]
    }

    /// The number of the implicit step.
    pub fn step(&self) -> Range<usize> {
        self.ends[5]..self.ends[6]
    }
}

/// Which unknowns belong to which repeated part; `ends` are those of the groups.
fn parts(chain: &Chain, layout: &Layout, ends: &[usize; 7]) -> Vec<Option<RepeatId>> {
    let mut parts = vec![None; ends[6]];
    for (index, repeat) in chain.repeats.enumerate() {
        for hinge in repeat.hinges {
            parts[ends[2]..][layout.q[hinge].clone()].fill(Some(index));
            parts[ends[3]..][layout.v[hinge].clone()].fill(Some(index));
        }
    }
    for (index, parameter) in chain.parameters.iter().enumerate() {
        if parameter.times.is_some() {
            parts[index] = chain.repeat_of_parameter(index);
        }
    }
    for input in &layout.inputs {
        parts[ends[4]..][input.range.clone()].fill(chain.repeat_of_input(input.what));
    }
    parts
}

fn coordinates(shape: &Shape) -> Vec<&'static str> {
    shape.coordinates.iter().map(|coordinate| coordinate.name).collect()
}

fn named(hinge: &Hinge, suffixes: Vec<&str>) -> Vec<String> {
    let name = text(&hinge.name);
    suffixes.into_iter().map(|suffix| format!("{name}_{suffix}")).collect()
}

fn input_names(chain: &Chain, input: &Input) -> Vec<String> {
    let along = |name: &str, axes: &[usize]| -> Vec<String> {
        axes.iter().map(|&axis| format!("{name}_{}", AXES[axis])).collect()
    };
    match input.what {
        Driven::Gravity => along("gravity", chain.dimension.shifts()),
        Driven::Force(load) => {
            along(&format!("{}_force", text(&chain.loads[load].name)), chain.dimension.shifts())
        }
        Driven::Torque(load) => {
            along(&format!("{}_torque", text(&chain.loads[load].name)), chain.dimension.turns())
        }
        Driven::Efforts(hinge) => {
            let name = text(&chain.hinges[hinge].name);
            (0..input.range.len()).map(|k| format!("{name}_input{k}")).collect()
        }
        Driven::Motion(index) => {
            let hinge = &chain.hinges[index];
            let shape = hinge.kind.shape();
            let accelerations: Vec<String> =
                shape.rates.iter().map(|rate| format!("{rate}_dot")).collect();
            let mut names = named(hinge, coordinates(shape));
            names.extend(named(hinge, shape.rates.to_vec()));
            names.extend(named(hinge, accelerations.iter().map(String::as_str).collect()));
            names
        }
    }
}

/// Makes names differ from each other: a parameter `elbow_angle` may stand beside a hinge `elbow`.
fn distinct(names: Vec<String>) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::new();
    let one = |mut name: String| {
        while !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    names.into_iter().map(one).collect()
}

/// A name as a variable is written: an upper-case one could be taken for a constant of the user's.
///
/// Rust compares names in normal form C, which letters may have left with their case: it is the compiler
/// that brings them back.
fn text(ident: &Ident) -> String {
    let lower = ident.to_string().to_lowercase();
    syn::parse_str::<Ident>(&lower).map_or(lower, |normal| normal.to_string())
}
