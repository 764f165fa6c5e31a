//! Checks that a text is a chain: only the rules of the language know whether a body can have its inertia, and whether
//! the bodies outboard of a hinge have any.

use proc_macro2::{LexError, TokenStream, TokenTree};

use super::error::{ImportError, Result};
use super::robot::Robot;
use super::text::Written;

/// Refuses a text that is not a chain, with the link that a rule refuses.
pub fn check(robot: &Robot, written: &Written) -> Result<()> {
    let tokens: TokenStream = written.text.parse().map_err(|error: LexError| {
        refused(robot, written, error.span().start().line, &error.to_string())
    })?;
    let inside = tokens.into_iter().find_map(|token| match token {
        TokenTree::Group(group) => Some(group.stream()),
        _ => None,
    });
    match mstmm_codegen::read_and_examine(inside.unwrap_or_default()) {
        Ok(_) => Ok(()),
        Err(errors) => {
            Err(refused(robot, written, errors.span().start().line, &errors.to_string()))
        }
    }
}

fn refused(robot: &Robot, written: &Written, line: usize, reason: &str) -> ImportError {
    let before: Vec<&str> = written.text.lines().take(line).map(str::trim).collect();
    let shown = before.last().copied().unwrap_or_default();
    let is_head = |line: &&str| line.starts_with("body ") && line.ends_with('{');
    // The error is in a block of a body, if the block has no end before.
    let inside =
        before.iter().rev().find(|line| is_head(line) || **line == "}").is_some_and(is_head);
    let count = before.iter().filter(|line| is_head(line)).count();
    let index = count.checked_sub(1).filter(|_| inside);
    let link = index.and_then(|index| robot.links.get(*written.types.get(index)?));
    match link {
        Some(link) => {
            let name = link.name.escape_debug();
            ImportError::at(
                link.place,
                format!("link `{name}`, with what is fixed to it: {reason}"),
            )
        }
        None => ImportError::new(format!("the chain is refused: {reason}: `{shown}`")),
    }
}
