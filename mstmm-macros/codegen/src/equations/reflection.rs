//! Elimination of one unknown by one linear condition, with a Householder reflection. The
//! reflection does not branch on values, and its rounding errors do not grow with the length of the
//! chain.
//!
//! `c x = c₀` with `H = 1 − γ v vᵀ` and `c H = −s e_p` gives `x = H [w; y]`, `w = −c₀ / s`, with
//! `y` free. The index `p` of the eliminated entry depends only on which coefficients vanish in
//! every state, so it is the same in every step.

use crate::math::Scalar;

/// A quantity of which linear combinations can be taken: a column that belongs to an unknown.
pub trait VectorSpace<S>: Copy {
    /// `self + other · factor`
    fn plus_scaled(self, other: Self, factor: S) -> Self;
    /// `self · factor`
    fn scaled(self, factor: S) -> Self;
}

/// The reflection of one condition.
#[derive(Clone, Debug)]
pub struct Reflection<S> {
    /// The index `p`.
    index: usize,
    /// `v`; empty if only one coefficient does not vanish, which needs no reflection.
    vector: Vec<S>,
    /// `γ`
    factor: S,
    /// `−1 / s`
    inverse: S,
}

impl<S: Scalar> Reflection<S> {
    /// Returns the reflection for a condition with these coefficients.
    pub fn of(coefficients: &[S]) -> Self {
        let present: Vec<usize> =
            (0..coefficients.len()).filter(|&k| !coefficients[k].vanishes()).collect();
        // A condition without coefficients occurs only if bodies lack inertia, which the pivots
        // report.
        let index = present.first().copied().unwrap_or(0);
        let entry = coefficients[index];
        if present.len() <= 1 {
            let (vector, factor) = (Vec::new(), S::zero());
            return Reflection { index, vector, factor, inverse: entry.recip() };
        }
        let length = present
            .iter()
            .fold(S::zero(), |sum, &k| sum + coefficients[k] * coefficients[k])
            .sqrt();
        let s = length.copysign(entry);
        let mut vector = coefficients.to_vec();
        vector[index] = entry + s;
        let factor = (vector[index] * s).recip();
        // γ v_p = 1 / s
        Reflection { index, inverse: -(vector[index] * factor), vector, factor }
    }

    /// Returns `w`, the eliminated unknown, if the condition's value is `value`.
    pub fn determine(&self, value: S) -> S {
        value * self.inverse
    }

    /// Rewrites the columns of `x` as those of `y`; returns the column of `w`.
    pub fn apply<M: VectorSpace<S>>(&self, columns: &mut Vec<M>) -> M {
        if let Some(first) = self.vector.first() {
            let mut along = columns[0].scaled(*first);
            for (&column, &v) in columns.iter().zip(&self.vector).skip(1) {
                along = along.plus_scaled(column, v);
            }
            let along = along.scaled(self.factor);
            for (column, &v) in columns.iter_mut().zip(&self.vector) {
                *column = column.plus_scaled(along, -v);
            }
        }
        columns.remove(self.index)
    }

    /// Returns `x` from `y` and `w`.
    pub fn expand(&self, mut unknowns: Vec<S>, determined: S) -> Vec<S> {
        unknowns.insert(self.index, determined);
        if !self.vector.is_empty() {
            let along =
                unknowns.iter().zip(&self.vector).fold(S::zero(), |sum, (&x, &v)| sum + x * v)
                    * self.factor;
            for (x, &v) in unknowns.iter_mut().zip(&self.vector) {
                *x = *x - v * along;
            }
        }
        unknowns
    }

    /// Returns `v`, for the trace.
    pub fn vector(&self) -> &[S] {
        &self.vector
    }
}

impl<S: Scalar> VectorSpace<S> for S {
    fn plus_scaled(self, other: Self, factor: S) -> Self {
        self + other * factor
    }
    fn scaled(self, factor: S) -> Self {
        self * factor
    }
}

#[cfg(test)]
mod tests {
    use super::Reflection;

    #[test]
    fn the_condition_holds_for_all_remaining_unknowns() {
        let c = [0.3, -2.0, 1e-9, 4.0];
        let reflection = Reflection::of(&c);
        for y in [[0.0, 0.0, 0.0], [1.0, -2.0, 3.0], [-0.1, 7.0, 0.4]] {
            let x = reflection.expand(y.to_vec(), reflection.determine(1.7));
            let value: f64 = c.iter().zip(&x).map(|(c, x)| c * x).sum();
            // Four products of size |c| |x| ≤ 40, a few roundings each.
            assert!((value - 1.7).abs() < 40.0 * 16.0 * f64::EPSILON, "{value}");
        }
    }

    #[test]
    fn columns_and_unknowns_are_rewritten_alike() {
        let c = [0.3_f64, -2.0, 0.5, 4.0];
        let row = [1.0, 2.0, -3.0, 0.25];
        let reflection = Reflection::of(&c);
        let mut columns = row.to_vec();
        let known = reflection.apply(&mut columns) * reflection.determine(1.7);
        let y = [0.7, -1.1, 2.0];
        let direct: f64 = reflection
            .expand(y.to_vec(), reflection.determine(1.7))
            .iter()
            .zip(&row)
            .map(|(x, r)| x * r)
            .sum();
        let rewritten: f64 = known + y.iter().zip(&columns).map(|(y, c)| y * c).sum::<f64>();
        assert!((direct - rewritten).abs() < 64.0 * 16.0 * f64::EPSILON);
    }
}
