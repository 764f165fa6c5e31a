//! Separators of route items.

use super::cursor::Cursor;
use crate::diag::Diagnostics;

/// The message for branches in brackets, or after other signs.
pub(super) const BRANCHES: &str = "write a branch as another route, after the `;` of this one: \
                                   `body.output -> …;`";

/// Reads separators; wrong ones are reported once for each route.
#[derive(Default)]
pub(super) struct Separators {
    reported: bool,
    /// Whether an arrow has been read: after one, another separator may begin a branch.
    has_arrow: bool,
    /// Whether a branch began.
    pub branches: bool,
    /// Whether the next item is behind a comma or a similar sign: it may be a further name of the item before it.
    pub is_lost: bool,
}

impl Separators {
    /// For items whose error is reported already.
    pub fn reported() -> Self {
        Separators { reported: true, ..Separators::default() }
    }

    /// Reads `->`, or a wrong separator.
    pub fn read(&mut self, input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
        self.is_lost = false;
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
            // No item follows.
            *input = before;
            return false;
        }
        self.is_lost = branches;
        if signs > 0 && !self.reported {
            let more = if branches { format!("; {}", BRANCHES) } else { String::new() };
            diagnostics.error(at, format!("join the items of a route by `->`{more}"));
            self.reported = true;
            self.branches |= branches;
        }
        signs > 0
    }
}
