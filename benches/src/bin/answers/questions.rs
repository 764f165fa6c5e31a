//! The questions, each a call of a generated method.

/// Expands to the answer to a question: `None`, or the results and times.
macro_rules! answer {
    (
        $chain:ident,
        $type:ident,
        $variation:ident,
        ($rates:literal, $base:literal, $columns:literal, $inertial:literal),
        $question:ident,
        $numbers:ident,
        $task:ident,
        $set:expr
    ) => {{
        use mstmm::nalgebra::{SMatrix, SVector};

        use crate::sample::{Sample, perform, rows, samples_of};

        let chain = &$chain;
        let direction_of = |[coordinates, rates, efforts]: [SVector<T, $rates>; 3]| {
            let mut direction = $variation { coordinates, rates, ..$variation::default() };
            // A floating base has no motor.
            direction.inputs.copy_from_slice(&efforts.as_slice()[$base..]);
            direction
        };
        let samples: Vec<Sample<$type<T>, $variation<T>, $rates>> =
            samples_of(chain, $numbers, $set, direction_of);
        let (samples, task) = (samples.as_slice(), $task);
        let zero = T::constant(0.0);
        let vector = SVector::<T, $rates>::repeat(zero);
        let of_vector = |vector: &SVector<T, $rates>| vector.as_slice().to_vec();
        Some(match $question {
            "accelerations" => perform(
                samples,
                task,
                vector,
                |s, out| chain.accelerations_into(&s.state, &s.inputs, out),
                of_vector,
            ),
            "inverse_dynamics" => perform(
                samples,
                task,
                vector,
                |s, out| chain.inverse_dynamics_into(&s.state, &s.accelerations, &s.inputs, out),
                of_vector,
            ),
            "bias_efforts" => perform(
                samples,
                task,
                vector,
                |s, out| chain.bias_efforts_into(&s.state, &s.inputs, out),
                of_vector,
            ),
            "push" => perform(
                samples,
                task,
                (vector, vector),
                |s, (a, out)| chain.push_into(&s.state, &s.inputs, &s.direction, a, out),
                |(a, out)| [of_vector(out), of_vector(a)].concat(),
            ),
            "pull" => perform(
                samples,
                task,
                (vector, $variation::default()),
                |s, (a, out)| chain.pull_into(&s.state, &s.inputs, &s.weights, a, out),
                |(a, out)| {
                    let parts =
                        [out.coordinates.as_slice(), out.rates.as_slice(), out.inputs.as_slice()];
                    [parts.concat(), of_vector(a)].concat()
                },
            ),
            "regressor" => perform(
                samples,
                task,
                SMatrix::<T, $rates, $columns>::repeat(zero),
                |s, out| chain.regressor_into(&s.state, &s.accelerations, &s.inputs, out),
                |out| rows(out, $inertial),
            ),
            _ => return None,
        })
    }};
}
pub(crate) use answer;
