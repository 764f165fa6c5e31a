//! Numbers anywhere in a description.

use crate::model::condition::Requirement;
use crate::model::lower::Draft;

/// No number is infinite or undefined, and no quaternion is zero.
pub(super) fn numbers_are_finite(draft: &Draft) -> Vec<Requirement> {
    draft.requirements.clone()
}
