//! The parts that all libraries have.

/// The names that all headers have.
pub const NAMES: [&str; 4] =
    ["mstmm_real", "mstmm_status", "mstmm_code_name", "mstmm_code_message"];

/// The codes of a status: the name after `MSTMM_`, what it means in the header, and the message.
pub const CODES: [(&str, &str); 10] = [
    ("OK", "no error"),
    ("NULL_POINTER", "a pointer is null"),
    ("NOT_FINITE", "a number of the state, the inputs or the results is not finite, or too large"),
    (
        "SINGULAR",
        "the bodies outboard of the hinge have no inertia along one of its axes in this state",
    ),
    ("PARAMETER", "the parameter or the step cannot have this value"),
    ("QUATERNION", "the length of a quaternion is not between 0.9 and 1.1"),
    ("INDEX", "an index is negative or too large"),
    ("NOT_ASSEMBLED", "the loop cannot be closed from this state"),
    ("CLOSURE_RANK", "the loop constraints have a higher rank here than around the start"),
    ("OTHER", "another error"),
];

/// Returns `src/status.rs` without its first line.
#[must_use]
pub fn rust_status() -> String {
    let code =
        |(name, message): &(&str, &str)| format!("    (c\"MSTMM_{name}\", c\"{message}\"),\n");
    include_str!("status.rs.txt").replace("{codes}", &CODES.iter().map(code).collect::<String>())
}

/// `src/lib.rs`
pub const ROOT: &str = include_str!("lib.rs.txt");

/// `Cargo.toml`
pub const MANIFEST: &str = include_str!("Cargo.toml.txt");
