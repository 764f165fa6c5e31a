//! The status that the functions of the header return.

use core::ffi::CStr;

use mstmm::Error;

/// The status of a call: `mstmm_status` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Status {
    /// One of the header's `MSTMM_…`.
    pub code: i32,
    /// The index of the hinge, or -1 if the error has none.
    pub hinge: i32,
}

impl Status {
    /// `MSTMM_OK`.
    pub const OK: Self = Self::new(0);
    /// `MSTMM_NULL_POINTER`.
    pub const NULL_POINTER: Self = Self::new(1);
    /// `MSTMM_NOT_FINITE`.
    pub const NOT_FINITE: Self = Self::new(2);
    /// `MSTMM_PARAMETER`.
    pub const PARAMETER: Self = Self::new(4);
    /// `MSTMM_OTHER`.
    pub const OTHER: Self = Self::new(5);

    const fn new(code: i32) -> Self {
        Self { code, hinge: -1 }
    }

    /// `MSTMM_SINGULAR` at a hinge.
    pub const fn singular(hinge: i32) -> Self {
        Self { code: 3, hinge }
    }
}

impl From<Result<(), Error>> for Status {
    fn from(result: Result<(), Error>) -> Self {
        match result {
            Ok(()) => Self::OK,
            Err(Error::NotFinite) => Self::NOT_FINITE,
            Err(Error::Singular { hinge }) => {
                let of_name = |name: &&CStr| name.to_bytes() == hinge.as_bytes();
                Self::singular(HINGES.iter().position(of_name).map_or(-1, |index| index as i32))
            }
            Err(Error::InvalidParameter { .. }) => Self::PARAMETER,
            // Open chains with fixed steps have no other errors.
            Err(_) => Self::OTHER,
        }
    }
}

/// The codes by their names, in the order of their numbers.
const CODES: [&CStr; 6] = [
    c"MSTMM_OK",
    c"MSTMM_NULL_POINTER",
    c"MSTMM_NOT_FINITE",
    c"MSTMM_SINGULAR",
    c"MSTMM_PARAMETER",
    c"MSTMM_OTHER",
];

/// The hinges, in the order of the chain.
const HINGES: [&CStr; 5] = [c"waist", c"shoulder", c"elbow", c"hook", c"mount"];

/// Returns the name of a code; empty for an unknown code.
pub(crate) fn code_name(code: i32) -> &'static CStr {
    name(&CODES, code)
}

/// Returns the name of a hinge; empty for an unknown hinge.
pub(crate) fn hinge_name(hinge: i32) -> &'static CStr {
    name(&HINGES, hinge)
}

fn name(names: &[&'static CStr], index: i32) -> &'static CStr {
    let name = usize::try_from(index).ok().and_then(|index| names.get(index));
    name.copied().unwrap_or_default()
}
