//! A common interface of the methods of all chains.

use crate::sample::Sample;

/// The small changes of coordinates and rates, one number for each rate.
pub struct Direction<T> {
    pub coordinates: Vec<T>,
    pub rates: Vec<T>,
}

/// A chain with answers.
pub trait Asked: Sample {
    /// Returns the efforts of the motors in the order of the rates.
    fn efforts(inputs: &Self::Inputs) -> Vec<Self::Scalar>;
    /// Sets the efforts of the motors.
    fn set_efforts(inputs: &mut Self::Inputs, efforts: &[Self::Scalar]);

    fn forward(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<Self::Scalar>;
    fn inverse(
        &self,
        state: &Self::State,
        accelerations: &[Self::Scalar],
        inputs: &Self::Inputs,
    ) -> Vec<Self::Scalar>;
    fn bias(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<Self::Scalar>;
    fn gravity(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<Self::Scalar>;
    fn passive(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<Self::Scalar>;
    fn mass_times(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        vector: &[Self::Scalar],
    ) -> Vec<Self::Scalar>;
    fn inverse_mass_times(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        vector: &[Self::Scalar],
    ) -> Vec<Self::Scalar>;
    /// Returns the accelerations and their derivative.
    fn push(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        direction: &Direction<Self::Scalar>,
    ) -> [Vec<Self::Scalar>; 2];
    /// Returns the values of the workspaces of forward dynamics, and of inverse dynamics at its
    /// accelerations.
    fn workspaces(&self, state: &Self::State, inputs: &Self::Inputs) -> [Self::Workspace; 2];
}

/// Implements [`Asked`] for a generated chain, given the efforts of its motors.
macro_rules! asked {
    ($name:ident $variation:ident |$inputs:ident| $efforts:expr) => {
        impl<T: mstmm::Scalar> $crate::answers::asked::Asked for $name<T> {
            fn efforts($inputs: &Self::Inputs) -> Vec<T> {
                $efforts
            }

            fn set_efforts(inputs: &mut Self::Inputs, efforts: &[T]) {
                inputs.set_efforts(&mstmm::nalgebra::SVector::from_column_slice(efforts));
            }

            fn forward(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<T> {
                self.accelerations(state, inputs).expect("a regular chain").as_slice().to_vec()
            }

            fn inverse(&self, state: &Self::State, a: &[T], inputs: &Self::Inputs) -> Vec<T> {
                let a = mstmm::nalgebra::SVector::from_column_slice(a);
                let efforts = self.inverse_dynamics(state, &a, inputs);
                efforts.expect("finite numbers").as_slice().to_vec()
            }

            fn bias(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<T> {
                self.bias_efforts(state, inputs).expect("finite numbers").as_slice().to_vec()
            }

            fn gravity(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<T> {
                self.gravity_efforts(state, inputs).expect("finite numbers").as_slice().to_vec()
            }

            fn passive(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<T> {
                self.passive_efforts(state, inputs).expect("finite numbers").as_slice().to_vec()
            }

            fn mass_times(&self, state: &Self::State, inputs: &Self::Inputs, x: &[T]) -> Vec<T> {
                let x = mstmm::nalgebra::SVector::from_column_slice(x);
                let product = self.mass_matrix_times(state, inputs, &x);
                product.expect("finite numbers").as_slice().to_vec()
            }

            fn inverse_mass_times(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
                x: &[T],
            ) -> Vec<T> {
                let x = mstmm::nalgebra::SVector::from_column_slice(x);
                let product = self.inverse_mass_matrix_times(state, inputs, &x);
                product.expect("a regular chain").as_slice().to_vec()
            }

            fn push(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
                direction: &$crate::answers::asked::Direction<T>,
            ) -> [Vec<T>; 2] {
                let mut variation = $variation::default();
                variation.coordinates.copy_from_slice(&direction.coordinates);
                variation.rates.copy_from_slice(&direction.rates);
                let (mut accelerations, mut change) = (variation.rates, variation.rates);
                self.push_into(state, inputs, &variation, &mut accelerations, &mut change)
                    .expect("a regular chain");
                [accelerations, change].map(|vector| vector.as_slice().to_vec())
            }

            fn workspaces(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
            ) -> [Self::Workspace; 2] {
                let [mut forward, mut inverse] = [(); 2].map(|()| self.workspace());
                self.solve_into(state, inputs, &mut forward).expect("a regular chain");
                let accelerations = *forward.accelerations();
                self.inverse_solve_into(state, &accelerations, inputs, &mut inverse)
                    .expect("finite numbers");
                [forward, inverse]
            }
        }
    };
}
pub(crate) use asked;
