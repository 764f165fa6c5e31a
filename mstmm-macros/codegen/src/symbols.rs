//! The unknowns of a chain: their numbers in the graph and their names in the program.

use crate::model::{Chain, Hinge, Layout, Shape};
use proc_macro2::Ident;
use std::collections::HashSet;
use std::ops::Range;

/// Names that generated functions keep for themselves.
const KEPT: &[&str] = &["c", "constants", "parameters"];

/// Numbers and names of all unknowns: parameters, constants, coordinates, rates, inputs.
#[derive(Clone, Debug)]
pub struct Symbols {
    names: Vec<String>,
    /// Where each of the five groups ends.
    ends: [usize; 5],
}

impl Symbols {
    /// The unknowns of `chain`.
    pub fn of(chain: &Chain, layout: &Layout) -> Self {
        let parameters = chain.parameters.iter().map(|parameter| text(&parameter.name));
        let constants = (0..chain.constants).map(|number| format!("constant{number}"));
        let names_of = |suffixes: fn(&'static Shape) -> Vec<&'static str>| {
            let hinge = move |hinge: &Hinge| {
                let name = text(&hinge.name);
                suffixes(hinge.kind.shape())
                    .into_iter()
                    .map(move |suffix| format!("{name}_{suffix}"))
            };
            chain.hinges.iter().flat_map(hinge)
        };
        let driven = chain.hinges.iter().zip(&layout.inputs).filter(|(_, range)| !range.is_empty());
        let inputs = driven.flat_map(|(hinge, range)| {
            let name = text(&hinge.name);
            (0..range.len()).map(move |k| format!("{name}_input{k}"))
        });
        let mut names = Vec::new();
        let mut ends = [0; 5];
        names.extend(parameters);
        ends[0] = names.len();
        names.extend(constants);
        ends[1] = names.len();
        names.extend(names_of(|shape| shape.coordinates.iter().map(|c| c.name).collect()));
        ends[2] = names.len();
        names.extend(names_of(|shape| shape.rates.to_vec()));
        ends[3] = names.len();
        names.extend(inputs);
        ends[4] = names.len();
        Symbols { names: distinct(names), ends }
    }

    /// The names by number.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Numbers of the parameters.
    pub fn parameters(&self) -> Range<usize> {
        0..self.ends[0]
    }

    /// Numbers of the constants.
    pub fn constants(&self) -> Range<usize> {
        self.ends[0]..self.ends[1]
    }

    /// Numbers of the coordinates.
    pub fn q(&self) -> Range<usize> {
        self.ends[1]..self.ends[2]
    }

    /// Numbers of the rates.
    pub fn v(&self) -> Range<usize> {
        self.ends[2]..self.ends[3]
    }

    /// Numbers of the inputs.
    pub fn inputs(&self) -> Range<usize> {
        self.ends[3]..self.ends[4]
    }
}

/// Makes names differ, from each other and from those that are kept: a parameter `elbow_angle` may
/// stand beside a hinge `elbow`.
fn distinct(names: Vec<String>) -> Vec<String> {
    let mut taken: HashSet<String> = KEPT.iter().map(|&name| name.to_owned()).collect();
    let one = |mut name: String| {
        // In lower case a name may have become a word of Rust.
        while syn::parse_str::<Ident>(&name).is_err() || !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    names.into_iter().map(one).collect()
}

/// A name as a variable is written: an upper-case one could be taken for a constant of the user's.
fn text(ident: &Ident) -> String {
    ident.to_string().to_lowercase()
}
