//! What a comparison needs to know of a chain besides its traits, read from its text.

use serde::{Deserialize, Serialize};

/// What to do.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Task {
    /// The chain.
    pub description: Description,
    /// How it is compared.
    pub settings: Settings,
}

/// How a chain is compared.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Settings {
    /// How long the motion is, in s.
    pub time: f64,
    /// The step in s.
    pub step: f64,
    /// How many random states.
    pub states: usize,
    /// They follow from it.
    pub seed: u64,
    /// Whether what the chain takes from outside is random, and zero otherwise.
    pub random_inputs: bool,
    /// Whether all numbers are printed as JSON.
    pub json: bool,
}

/// A chain.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Description {
    /// Its name.
    pub name: String,
    /// Whether it is held at both ends.
    pub closed: bool,
    /// Whether nothing that acts gives or takes energy but what has a potential.
    pub conservative: bool,
    /// The hinges with coordinates, in the order of the state.
    pub parts: Vec<Part>,
    /// What is given at every step, in the order of [`Subject::inputs`](crate::Subject::inputs).
    pub inputs: Vec<Input>,
}

/// Hinges that follow on each other so many times.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Part {
    /// How many times; none for hinges that are not repeated.
    pub times: Option<usize>,
    /// Them all, once.
    pub hinges: Vec<Hinge>,
}

/// A hinge.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Hinge {
    /// Its name.
    pub name: String,
    /// Whether it is one for springs, which moves little.
    pub elastic: bool,
    /// Its freedoms, shifts first.
    pub groups: Vec<Group>,
}

/// Freedoms of one sort.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Group {
    /// Whether they are turns; shifts otherwise.
    pub turns: bool,
    /// Whether they are kept as a quaternion, and as a number each otherwise.
    pub quaternion: bool,
    /// The names of their rates; empty for the only one of a hinge.
    pub rates: Vec<String>,
    /// The lowest and the highest coordinate, where they are limited and that is known.
    pub limits: Vec<Option<[f64; 2]>>,
}

/// Something given at every step.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Input {
    /// How many times it stands there.
    pub times: usize,
    /// What it is.
    pub what: Given,
}

/// What is given.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Given {
    /// So many components of the acceleration of free fall.
    Gravity(usize),
    /// Forces, and torques where true.
    Efforts(Vec<bool>),
    /// The motion of a hinge: coordinates, rates, accelerations.
    Motion(Hinge),
}

impl Description {
    /// All hinges with coordinates, and which time it is of repeated ones.
    pub fn hinges(&self) -> impl Iterator<Item = (Option<usize>, &Hinge)> {
        self.parts.iter().flat_map(|part| {
            let each = move |time| part.hinges.iter().map(move |hinge| (time, hinge));
            (0..part.times.unwrap_or(1)).flat_map(move |time| each(part.times.map(|_| time)))
        })
    }

    /// All groups of freedoms, in the order of the state.
    pub fn groups(&self) -> impl Iterator<Item = &Group> {
        self.hinges().flat_map(|(_, hinge)| &hinge.groups)
    }

    /// For each rate whether it is that of a turn.
    pub fn turning(&self) -> Vec<bool> {
        self.groups().flat_map(|group| group.rates.iter().map(|_| group.turns)).collect()
    }

    /// What a rate is called: the first one that `is` it.
    pub fn rate_name(&self, number: usize) -> String {
        let names = self.hinges().flat_map(|(time, hinge)| {
            let place = time.map_or(String::new(), |time| format!("[{time}]"));
            hinge.groups.iter().flat_map(|group| &group.rates).map(move |rate| {
                let dot = if rate.is_empty() { "" } else { "." };
                format!("{}{place}{dot}{rate}", hinge.name)
            })
        });
        names.into_iter().nth(number).unwrap_or_default()
    }
}

impl Group {
    /// How many coordinates it has.
    pub fn coordinates(&self) -> usize {
        if self.quaternion { 4 } else { self.rates.len() }
    }
}
