//! Detection of steps that stability limits and not the tolerance, as in Hairer's `dopri5.f` (Hairer and Wanner,
//! *Solving Ordinary Differential Equations II*, section IV.2), which tests every thousandth step instead of every step.
//!
//! Stages 6 and 7 are at the same time. With their states y₆, y₇ and their rates k₆, k₇, |k₇ − k₆| / |y₇ − y₆| estimates
//! the largest |λ| of the eigenvalues of the Jacobian.

use crate::integrate::combine::entries;
use crate::integrate::tableau::{A6, B};
use crate::{ChainState, Scalar};

/// The method is stable on the negative real axis to about h·|λ| = 3.3.
const LIMIT: f64 = 3.25;

/// The number of steps at the limit of stability after which the detector reports stiffness.
const MANY: u8 = 15;

/// The number of consecutive steps within the limit after which the count starts again.
const CLEAR: u8 = 6;

/// The counts of steps at the limit of stability and within it.
#[derive(Clone, Copy, Default)]
pub(super) struct Detector {
    limited: u8,
    free: u8,
}

impl Detector {
    /// Counts an accepted step.
    pub(super) fn count(&mut self, limited: bool) {
        if limited {
            self.free = 0;
            self.limited = MANY.min(self.limited.saturating_add(1));
        } else {
            self.free = CLEAR.min(self.free.saturating_add(1));
            if self.free == CLEAR {
                self.limited = 0;
            }
        }
    }

    /// Returns whether the last steps were limited by stability.
    pub(super) fn is_stiff(self) -> bool {
        self.limited == MANY
    }
}

/// Returns whether h·|λ| exceeds the limit in any lane, from the rates at all stages 1 to 7.
pub(super) fn is_limited<S: ChainState>(rates: [&S; 7]) -> bool {
    let [k1, k2, k3, k4, k5, k6, k7] = rates;
    // y₇ − y₆ = h Σ (b − a₆) k, so the step cancels.
    let [a1, a2, a3, a4, a5] = A6;
    let [b1, b3, b4, b5, b6] = B;
    let weights = [b1 - a1, -a2, b3 - a3, b4 - a4, b5 - a5, b6].map(S::Scalar::constant);
    let [w1, w2, w3, w4, w5, w6] = weights;
    let (mut change, mut distance) = (S::Scalar::default(), S::Scalar::default());
    let early = entries(k1).zip(entries(k2)).zip(entries(k3)).zip(entries(k4));
    let late = entries(k5).zip(entries(k6)).zip(entries(k7));
    for ((((k1, k2), k3), k4), ((k5, k6), k7)) in early.zip(late) {
        let apart = w1 * k1 + w2 * k2 + w3 * k3 + w4 * k4 + w5 * k5 + w6 * k6;
        distance += apart * apart;
        change += (k7 - k6) * (k7 - k6);
    }
    // h |k₇ − k₆| > limit · |y₇ − y₆|, where y₇ − y₆ is h · apart.
    let excess = change - S::Scalar::constant(LIMIT * LIMIT) * distance;
    excess.max_lane() > S::Scalar::default().max_lane()
}
