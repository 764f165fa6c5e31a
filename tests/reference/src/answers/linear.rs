//! Dense linear equations.

use super::Real;

/// Returns the solution of a regular system, by elimination with row pivots.
pub(super) fn solved(matrix: &[Vec<Real>], right: &[Real]) -> Vec<Real> {
    let count = right.len();
    let with_right = |(row, &right): (&Vec<Real>, &Real)| [&row[..], &[right]].concat();
    let mut rows: Vec<Vec<Real>> = matrix.iter().zip(right).map(with_right).collect();
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].high.abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b)));
        rows.swap(column, pivot.unwrap_or(column));
        let above = rows[column].clone();
        let scale = above[column].recip();
        for row in &mut rows[column + 1..] {
            let factor = row[column] * scale;
            for (entry, &above) in row.iter_mut().zip(&above).skip(column) {
                *entry -= factor * above;
            }
        }
    }
    let mut solution = vec![Real::new(0.0); count];
    for row in (0..count).rev() {
        let known = (row + 1..count).map(|k| rows[row][k] * solution[k]);
        let known = known.fold(Real::new(0.0), |sum, term| sum + term);
        solution[row] = (rows[row][count] - known) * rows[row][row].recip();
    }
    solution
}
