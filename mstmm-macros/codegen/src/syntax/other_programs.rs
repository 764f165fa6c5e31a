//! Items that other programs have, or have under another keyword.

use super::separators::BRANCHES;
use proc_macro2::Ident;

/// Keywords of other programs, each with that of the language.
const KEYWORDS: &[(&str, &str)] = &[("link", "body"), ("joint", "hinge"), ("parameter", "param")];

/// Items that a chain does not have, each with its message.
const ITEMS: &[(&str, &str)] = &[
    ("branch", BRANCHES),
    ("fork", BRANCHES),
    ("tree", BRANCHES),
    ("close", LOOPS),
    ("closure", LOOPS),
    ("constraint", LOOPS),
    ("loop", LOOPS),
    ("motor", MOTORS),
    ("actuator", MOTORS),
    (
        "damper",
        "write a damper as the field `damping` of a hinge, or as a `spring` with `damping` and \
         `stiffness = 0`",
    ),
    ("const", CONSTANTS),
    ("let", CONSTANTS),
    (
        "sensor",
        "a chain has no sensors: the results have the positions, velocities and forces at all \
         points",
    ),
    (
        "contact",
        "a chain has no contacts: compute the force at each step, and apply it by a `load` with \
         `force = input`",
    ),
];

/// The message for a loop between two bodies.
const LOOPS: &str = "a closed chain is a first route that ends as it began, `ground -> … -> ground at \
                     […]`; for a loop between two bodies write a `spring` that is stiff and damped, or constraints as \
                     in `mstmm::tutorial::several_loops`";

/// The message for a motor.
const MOTORS: &str = "write a motor as the field `torque` or `force` of its hinge; an actuator between two points is a \
                      `spring` with `force = input`";

/// The message for a constant.
const CONSTANTS: &str = "write a value with a name as `param name = …;`, which can be set at run time, or as a `const` of \
                         Rust before the macro, with a name in capital letters";

/// The message for a coupling of two hinges.
const GEARS: &str = "a chain has no gears and mimic joints between two hinges: give both motors whose efforts hold the ratio; \
                     the rotor of a motor behind a gear is the `armature` of its hinge";

/// Fields of hinges that a chain does not have, each with its message.
const FIELDS: &[(&str, &str)] = &[
    ("mimic", GEARS),
    ("gear", GEARS),
    ("gear_ratio", GEARS),
    ("ratio", GEARS),
    ("coupling", GEARS),
];

/// Words for a point of a body.
pub(super) const POINTS: &[&str] = &["site", "frame", "marker"];

/// Words for `turned`.
pub(super) const TURNED: &[&str] = &["rotated", "rotate", "rotation", "oriented", "orientation"];

/// Returns the keyword of the language for one of another program.
pub(super) fn keyword(word: &Ident) -> Option<&'static str> {
    KEYWORDS.iter().find(|(other, _)| word == other).map(|&(_, keyword)| keyword)
}

/// Returns the message for a field of a hinge that a chain does not have.
pub fn field(word: &str) -> Option<&'static str> {
    FIELDS.iter().find(|(other, _)| word == *other).map(|&(_, message)| message)
}

/// Returns the message for an item that a chain does not have.
pub(super) fn item(word: &Ident) -> Option<&'static str> {
    ITEMS.iter().find(|(other, _)| word == other).map(|&(_, message)| message)
}
