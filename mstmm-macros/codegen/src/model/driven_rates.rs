//! Which inputs drive which rates.

use super::{Chain, Drive, Effort, InputKind, Layout};

impl Layout {
    /// Returns the rate that each entry of the inputs drives; none for an entry that is no effort of a motor.
    pub fn driven_rates(&self, chain: &Chain) -> Vec<Option<usize>> {
        let count = self.inputs.iter().map(|input| input.range.len()).sum();
        let mut driven = vec![None; count];
        for input in &self.inputs {
            let InputKind::Efforts(hinge) = input.what else { continue };
            let Drive::Efforts(efforts) = &chain.hinges[hinge].drive else { continue };
            let rates = self.v[hinge].clone().zip(efforts);
            let of_inputs = rates.filter(|(_, effort)| matches!(effort, Effort::Input));
            let entries = input.range.clone().zip(of_inputs);
            entries.for_each(|(entry, (rate, _))| driven[entry] = Some(rate));
        }
        driven
    }
}
