//! What joins the stops of a route.

use super::cursor::Cursor;
use crate::diag::Diagnostics;

/// What is said where a route branches.
pub(super) const BRANCHES: &str = "a chain has no branches: write a branch as a separate chain, \
                                   and couple the two by a `load` with `force = input` in each";

/// What joins stops. Where it is written otherwise all along, that is reported once.
#[derive(Default)]
pub(super) struct Separators {
    reported: bool,
    /// Whether an arrow was read: then what stands in place of one may begin a branch.
    has_arrow: bool,
    /// Whether it did.
    pub branches: bool,
}

impl Separators {
    /// Between stops that are reported as a whole.
    pub fn reported() -> Self {
        Separators { reported: true, ..Separators::default() }
    }

    /// Reads a `->`, or what stands in its place.
    pub fn read(&mut self, input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
        if input.pair('-', '>').is_some() {
            self.has_arrow = true;
            return true;
        }
        let (at, before) = (input.next_span(), *input);
        let branches = self.has_arrow && [',', '|', '&'].iter().any(|&sign| input.peek_punct(sign));
        let mut signs = 0;
        while ['-', '=', '<', '>', ',', '|', '&'].iter().any(|&sign| input.punct(sign).is_some()) {
            signs += 1;
        }
        if input.peek_ident().is_none() {
            // No stop stands behind it.
            *input = before;
            return false;
        }
        if signs > 0 && !self.reported {
            let more = if branches { format!("; {}", BRANCHES) } else { String::new() };
            diagnostics.error(at, format!("join the items of a route by `->`{more}"));
            self.reported = true;
            self.branches |= branches;
        }
        signs > 0
    }
}
