//! The description of a chain and of a comparison, in addition to the chain's traits.

use serde::{Deserialize, Serialize};

/// The task of a program.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Task {
    /// The chain.
    pub description: Description,
    /// The settings of the comparison.
    pub settings: Settings,
}

/// The settings of a comparison.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Settings {
    /// The duration of the motion in s.
    pub time: f64,
    /// The step in s.
    pub step: f64,
    /// The number of random states.
    pub states: usize,
    /// The seed of the random states and inputs.
    pub seed: u64,
    /// Whether inputs are random; otherwise they are zero.
    pub random_inputs: bool,
    /// Whether the results are printed as JSON.
    pub json: bool,
}

/// A chain.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Description {
    /// Its name.
    pub name: String,
    /// Whether it is held at both ends.
    pub closed: bool,
    /// Whether all efforts and loads have a potential.
    pub conservative: bool,
    /// The hinges with coordinates, in the order of the state.
    pub parts: Vec<Part>,
    /// The inputs, in the order of [`Subject::inputs`](crate::Subject::inputs).
    pub inputs: Vec<Input>,
}

/// A sequence of hinges, possibly repeated.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Part {
    /// The number of repetitions; none for hinges that are not repeated.
    pub times: Option<usize>,
    /// The hinges of one repetition.
    pub hinges: Vec<Hinge>,
}

/// A hinge.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Hinge {
    /// Its name.
    pub name: String,
    /// Whether it is an elastic hinge, with small motions.
    pub elastic: bool,
    /// Its degrees of freedom, translations first.
    pub groups: Vec<Group>,
}

/// Translational or rotational degrees of freedom of a hinge.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Group {
    /// Whether they are rotations; otherwise they are translations.
    pub rotational: bool,
    /// Whether the coordinates are a quaternion; otherwise there is one coordinate for each.
    pub quaternion: bool,
    /// The names of their rates; empty for a hinge with a single rate.
    pub rates: Vec<String>,
    /// The lowest and the highest coordinate, if there are limits and their values are known.
    pub limits: Vec<Option<[f64; 2]>>,
}

/// An input of the chain.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Input {
    /// The number of repetitions, if it belongs to a repeated part.
    pub times: usize,
    /// Its kind.
    pub what: InputKind,
}

/// The kind of an input.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum InputKind {
    /// The acceleration of free fall, with this number of components.
    Gravity(usize),
    /// Forces (false) and torques (true).
    Efforts(Vec<bool>),
    /// The motion of a hinge: coordinates, rates, accelerations.
    Motion(Hinge),
}

impl Description {
    /// Returns all hinges with coordinates, with the index of the repetition for repeated hinges.
    pub fn hinges(&self) -> impl Iterator<Item = (Option<usize>, &Hinge)> {
        self.parts.iter().flat_map(|part| {
            let each = move |time| part.hinges.iter().map(move |hinge| (time, hinge));
            (0..part.times.unwrap_or(1)).flat_map(move |time| each(part.times.map(|_| time)))
        })
    }

    /// Returns all groups of degrees of freedom, in the order of the state.
    pub fn groups(&self) -> impl Iterator<Item = &Group> {
        self.hinges().flat_map(|(_, hinge)| &hinge.groups)
    }

    /// Returns for each rate whether it is rotational.
    pub fn turning(&self) -> Vec<bool> {
        self.groups().flat_map(|group| group.rates.iter().map(|_| group.rotational)).collect()
    }

    /// Returns the name of the first rate for which `is` returns true.
    pub fn rate_name(&self, number: usize) -> String {
        let names = self.hinges().flat_map(|(time, hinge)| {
            let repetition = time.map_or(String::new(), |time| format!("[{time}]"));
            hinge.groups.iter().flat_map(|group| &group.rates).map(move |rate| {
                let dot = if rate.is_empty() { "" } else { "." };
                format!("{}{repetition}{dot}{rate}", hinge.name)
            })
        });
        names.into_iter().nth(number).unwrap_or_default()
    }
}

impl Group {
    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        if self.quaternion { 4 } else { self.rates.len() }
    }
}
