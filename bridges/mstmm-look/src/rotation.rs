//! Rotations as matrices of rows and as quaternions w, x, y, z.

/// A vector.
pub type Vector = [f64; 3];
/// A unit quaternion w, x, y, z.
pub type Quaternion = [f64; 4];

/// Returns the quaternion of a rotation matrix, whose first component that is not zero is positive.
///
/// It is computed from the largest of its components, which is at least one half.
pub fn quaternion([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]: [[f64; 3]; 3]) -> Quaternion {
    let squares = [1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz];
    let rows = [
        [squares[0], zy - yz, xz - zx, yx - xy],
        [zy - yz, squares[1], xy + yx, zx + xz],
        [xz - zx, xy + yx, squares[2], yz + zy],
        [yx - xy, zx + xz, yz + zy, squares[3]],
    ];
    let mut largest = 0;
    for (index, square) in squares.iter().enumerate() {
        if *square > squares[largest] {
            largest = index;
        }
    }
    let scale = 0.5 / squares[largest].sqrt();
    let unit = rows[largest].map(|entry| entry * scale);
    let first = unit.iter().copied().find(|entry| *entry != 0.0).unwrap_or(1.0);
    if first < 0.0 { unit.map(|entry| -entry) } else { unit }
}

/// Returns the quaternion or its negative, whichever is nearer to another one.
pub fn nearer(unit: Quaternion, to: Quaternion) -> Quaternion {
    let product: f64 = unit.iter().zip(to).map(|(a, b)| a * b).sum();
    if product < 0.0 { unit.map(|entry| -entry) } else { unit }
}

/// Returns the product of two quaternions.
pub fn product([a, b, c, d]: Quaternion, [w, x, y, z]: Quaternion) -> Quaternion {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// Returns the inverse of a unit quaternion.
pub fn inverse([w, x, y, z]: Quaternion) -> Quaternion {
    [w, -x, -y, -z]
}

/// Rotates a vector.
pub fn rotated(by: Quaternion, [x, y, z]: Vector) -> Vector {
    let [_, x, y, z] = product(product(by, [0.0, x, y, z]), inverse(by));
    [x, y, z]
}

/// Returns the sum of two vectors.
pub fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns the difference of two vectors.
pub fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns the length of a vector.
pub fn norm([x, y, z]: Vector) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns of the matrix of a quaternion are rotated unit vectors.
    fn matrix(of: Quaternion) -> [[f64; 3]; 3] {
        let [x, y, z] =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| rotated(of, axis));
        [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
    }

    /// A matrix leads back to its quaternion, also where the first component is small. Each step rounds a few times.
    #[test]
    fn matrices_lead_back_to_quaternions() {
        for raw in [
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [0.5, -0.5, 0.5, -0.5],
            [1e-9, 0.3, -0.4, 0.2],
            [0.1, 0.2, -0.9, 0.05],
        ] {
            let length = raw.iter().map(|entry: &f64| entry * entry).sum::<f64>().sqrt();
            let unit = raw.map(|entry| entry / length);
            let found = quaternion(matrix(unit));
            let off = found.iter().zip(unit).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-15 * 8.0, "{found:?} is not {unit:?}");
            let negative = unit.map(|entry| -entry);
            assert_eq!(nearer(found, negative), found.map(|entry| -entry));
            let whole = product(unit, inverse(unit));
            assert!((whole[0] - 1.0).abs() < 1e-15 && whole[1..].iter().all(|it| it.abs() < 1e-15));
        }
    }
}
