//! The questions, each a call of a generated method.
//!
//! Each macro expands to the run of a question, or to `None` if the question is not one of its questions.

/// Efforts, accelerations, and products in O(n).
macro_rules! vectors {
    ($chain:ident, $samples:ident, $task:ident, $question:ident, $variation:ident, $sizes:tt, $tip:tt) => {{
        let zero = vector_of!($sizes);
        match $question {
            "accelerations" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.accelerations_into(&s.state, &s.inputs, out),
                |out| out.as_slice().to_vec(),
            )),
            "inverse_dynamics" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.inverse_dynamics_into(&s.state, &s.accelerations, &s.inputs, out),
                |out| out.as_slice().to_vec(),
            )),
            "bias_efforts" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.bias_efforts_into(&s.state, &s.inputs, out),
                |out| out.as_slice().to_vec(),
            )),
            "push" => Some(perform(
                &$samples,
                $task,
                (zero, zero),
                |s, (a, out)| $chain.push_into(&s.state, &s.inputs, &s.direction, a, out),
                |(a, out)| [out.as_slice(), a.as_slice()].concat(),
            )),
            "pull" => Some(perform(
                &$samples,
                $task,
                (zero, $variation::default()),
                |s, (a, out)| $chain.pull_into(&s.state, &s.inputs, &s.weights, a, out),
                |(a, out)| {
                    let [q, v] = [out.coordinates.as_slice(), out.rates.as_slice()];
                    [q, v, out.inputs.as_slice(), a.as_slice()].concat()
                },
            )),
            _ => None,
        }
    }};
}

/// The regressor.
macro_rules! regressor {
    ($chain:ident, $samples:ident, $task:ident, $question:ident, $variation:ident, $sizes:tt, $tip:tt) => {
        match $question {
            "regressor" => Some(perform(
                &$samples,
                $task,
                regressor_of!($sizes),
                |s, out| $chain.regressor_into(&s.state, &s.accelerations, &s.inputs, out),
                |out| rows(out, inertial_of!($sizes)),
            )),
            _ => None,
        }
    };
}

/// Matrices with one row for each rate.
macro_rules! matrices {
    ($chain:ident, $samples:ident, $task:ident, $question:ident, $variation:ident, $sizes:tt, $tip:tt) => {{
        let zero = square_of!($sizes);
        match $question {
            "mass_matrix" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.mass_matrix_into(&s.state, &s.inputs, out),
                entries,
            )),
            "inverse_mass_matrix" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.inverse_mass_matrix_into(&s.state, &s.inputs, out),
                entries,
            )),
            "coriolis_matrix" => Some(perform(
                &$samples,
                $task,
                zero,
                |s, out| $chain.coriolis_matrix_into(&s.state, &s.inputs, out),
                entries,
            )),
            "derivatives" => Some(perform(
                &$samples,
                $task,
                Default::default(),
                |s, out| {
                    let a = &s.accelerations;
                    $chain.inverse_dynamics_derivatives_into(&s.state, a, &s.inputs, out)
                },
                |out| {
                    let [q, v] = [entries(&out.by_coordinates), entries(&out.by_rates)];
                    [q, v, entries(&out.by_accelerations)].concat()
                },
            )),
            "linearize" => Some(perform(
                &$samples,
                $task,
                Default::default(),
                |s, out| $chain.linearize_into(&s.state, &s.inputs, out),
                |out| {
                    let [q, v] = [entries(&out.by_coordinates), entries(&out.by_rates)];
                    [q, v, entries(&out.by_inputs), out.accelerations.as_slice().to_vec()].concat()
                },
            )),
            _ => None,
        }
    }};
}

/// The Jacobian of a point.
macro_rules! jacobian {
    (
        $chain:ident,
        $samples:ident,
        $task:ident,
        $question:ident,
        $variation:ident,
        $sizes:tt,
        (|$kinematics:ident| $tip:expr)
    ) => {
        match $question {
            // The body is repeated: it has its Jacobian by the kinematics.
            "jacobian" => Some(perform(
                &$samples,
                $task,
                (Default::default(), jacobian_of!($sizes)),
                |s, ($kinematics, out)| {
                    $chain.kinematics_into(&s.state, &s.inputs, $kinematics)?;
                    if let Some(tip) = $tip {
                        tip.jacobian_into(out);
                    }
                    Ok(())
                },
                |(_, out)| entries(out),
            )),
            _ => None,
        }
    };
    (
        $chain:ident,
        $samples:ident,
        $task:ident,
        $question:ident,
        $variation:ident,
        $sizes:tt,
        ($jacobian_into:ident, $place:expr)
    ) => {{
        let place = SVector::from($place.map(T::constant));
        match $question {
            "jacobian" => Some(perform(
                &$samples,
                $task,
                jacobian_of!($sizes),
                |s, out| $chain.$jacobian_into(&s.state, &s.inputs, &place, out),
                entries,
            )),
            _ => None,
        }
    }};
}

/// Sizes are the numbers of rates, of a floating base's rates, of dynamic parameters, and of inertial
/// parameters.
macro_rules! vector_of {
    (($rates:literal, $base:literal, $columns:literal, $inertial:literal)) => {
        SVector::<T, $rates>::repeat(T::constant(0.0))
    };
}

macro_rules! square_of {
    (($rates:literal, $base:literal, $columns:literal, $inertial:literal)) => {
        SMatrix::<T, $rates, $rates>::repeat(T::constant(0.0))
    };
}

macro_rules! jacobian_of {
    (($rates:literal, $base:literal, $columns:literal, $inertial:literal)) => {
        SMatrix::<T, 6, $rates>::repeat(T::constant(0.0))
    };
}

macro_rules! regressor_of {
    (($rates:literal, $base:literal, $columns:literal, $inertial:literal)) => {
        SMatrix::<T, $rates, $columns>::repeat(T::constant(0.0))
    };
}

macro_rules! inertial_of {
    (($rates:literal, $base:literal, $columns:literal, $inertial:literal)) => {
        $inertial
    };
}

/// Returns the samples in numbers.
macro_rules! samples_of {
    (
        $chain:ident,
        $type:ident,
        $variation:ident,
        ($rates:literal, $base:literal, $columns:literal, $inertial:literal),
        $numbers:ident,
        $set:expr
    ) => {{
        let direction_of = |[coordinates, rates, efforts]: [SVector<T, $rates>; 3]| {
            let mut direction = $variation { coordinates, rates, ..$variation::default() };
            // A floating base has no motor.
            direction.inputs.copy_from_slice(&efforts.as_slice()[$base..]);
            direction
        };
        let samples: Vec<Sample<$type<T>, $variation<T>, $rates>> =
            samples_of($chain, $numbers, $set, direction_of);
        samples
    }};
}

pub(crate) use {
    inertial_of, jacobian, jacobian_of, matrices, regressor, regressor_of, samples_of, square_of,
    vector_of, vectors,
};
