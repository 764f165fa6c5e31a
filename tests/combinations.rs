//! Answers of chains that combine what other tests have one at a time: prescribed hinges in repeated parts and on their
//! branches, moving ground, springs between repetitions, parameters with a value for each repetition, closed chains with
//! branches and repeated parts. The answers, by their names, are held to identities between them and to central
//! differences.

mod combinations {
    mod chains;
    mod closed;
    mod differences;
    mod identities;
    mod sample;
}
