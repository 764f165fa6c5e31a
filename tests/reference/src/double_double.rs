//! Sums of products in twice the working precision.
//!
//! The algorithms are those of Dekker, *A floating-point technique for extending the available
//! precision*, Numer. Math. 18 (1971), and Knuth's sum of two numbers.

/// An unevaluated sum of two numbers, the second of which is at most a rounding error of the first.
#[derive(Clone, Copy, Default)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// Returns the number without error.
    pub(crate) fn new(number: f64) -> DoubleDouble {
        DoubleDouble { high: number, low: 0.0 }
    }

    /// Returns the nearest number.
    pub(crate) fn rounded(self) -> f64 {
        self.high + self.low
    }

    /// Returns the sum with another number.
    pub(crate) fn plus(self, number: f64) -> DoubleDouble {
        let (sum, error) = two_sum(self.high, number);
        DoubleDouble::normalised(sum, error + self.low)
    }

    /// Returns `self − factor · other`.
    pub(crate) fn minus_product(self, factor: f64, other: DoubleDouble) -> DoubleDouble {
        let (product, error) = two_product(-factor, other.high);
        let (sum, carried) = two_sum(self.high, product);
        DoubleDouble::normalised(sum, carried + self.low + error - factor * other.low)
    }

    fn normalised(high: f64, low: f64) -> DoubleDouble {
        let sum = high + low;
        DoubleDouble { high: sum, low: low - (sum - high) }
    }
}

/// Returns the rounded sum and its error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// Returns the rounded product and its error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, error)
}

/// Splits a number into two numbers with half the digits each.
fn halves(a: f64) -> (f64, f64) {
    let scaled = a * 134_217_729.0;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::DoubleDouble;

    /// Plain arithmetic returns zero.
    #[test]
    fn products_keep_their_rounding_errors() {
        let (a, b) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        let difference = DoubleDouble::new(1.0).minus_product(a, DoubleDouble::new(b));
        assert_eq!(difference.rounded(), f64::EPSILON * f64::EPSILON);
    }

    #[test]
    fn sums_keep_small_terms() {
        let sum = DoubleDouble::new(1e16).plus(0.25).plus(-1e16);
        assert_eq!(sum.rounded(), 0.25);
    }
}
