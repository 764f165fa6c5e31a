//! Regressors of chains in space, several rates at a time.

use crate::{Columns, Scalar};

/// The pose and the motion of a body, as generated code stores them: position of the input, rows of the rotation to
/// common axes; in axes of the body the angular velocity, the proper acceleration of the input and the angular
/// acceleration.
pub type BodyMotions<T> = [[T; 3]; 7];

/// The columns of the regressor for one body: mass, first moment, then the inertia's entries xx, yy, zz, xy, xz, yz.
const PARAMETERS: usize = 10;

/// The largest position, in metres, with which products of rates are tested for overflow.
const REACH: f64 = 1e12;

/// Writes the columns of the inertial parameters of all bodies. Returns the sum of the squares of all angular velocities,
/// times `REACH`: if it and all motions are finite, so are the entries, unless a motion itself is near overflow.
///
/// `unit_motions` are the motions at unit rates in common axes: for each of the three components of the velocity, then of
/// the angular velocity, one entry for each of the `N` rates, and zeros up to `P`, a multiple of the lanes. Bit `k` of a
/// path tells whether rate `k` moves the body, with 64 bits in each word.
#[inline]
pub fn regressor_of_bodies<
    T: Scalar,
    C: Columns<T>,
    const N: usize,
    const P: usize,
    const W: usize,
>(
    motions: &[BodyMotions<T>],
    paths: &[[u64; W]],
    unit_motions: &[[T; P]],
    regressor: &mut [[T; N]],
) -> T {
    let mut squares = T::constant(0.0);
    let Some(unit_motions) = unit_motions.first_chunk() else { return squares };
    let (bodies, _) = regressor.as_chunks_mut::<PARAMETERS>();
    for ((motion, path), columns) in motions.iter().zip(paths).zip(bodies) {
        let body = BodyTerms::new(motion);
        let [.., [p, q, r], _, _] = *motion;
        squares = p.mul_add(p, q.mul_add(q, r.mul_add(r, squares)));
        for first in (0..N - N % C::COUNT).step_by(C::COUNT) {
            rows::<T, C, N, P>(&body, path, unit_motions, columns, [first, C::COUNT]);
        }
        if !N.is_multiple_of(C::COUNT) {
            let last = [N - N % C::COUNT, N % C::COUNT];
            rows::<T, C, N, P>(&body, path, unit_motions, columns, last);
        }
    }
    squares * T::constant(REACH)
}

/// Writes rows of the columns of a body, from a first one on.
#[inline(always)]
fn rows<T: Scalar, C: Columns<T>, const N: usize, const P: usize>(
    body: &BodyTerms<T>,
    path: &[u64],
    [ux, uy, uz, wx, wy, wz]: &[[T; P]; 6],
    columns: &mut [[T; N]; PARAMETERS],
    [first, count]: [usize; 2],
) {
    let word = path.get(first / 64).copied().unwrap_or_default() >> (first % 64);
    if word & (u64::MAX >> (64 - C::COUNT)) == 0 {
        for column in columns {
            column.iter_mut().skip(first).take(count).for_each(|place| *place = T::constant(0.0));
        }
        return;
    }
    let mask = C::from_fn(|lane| T::constant(f64::from((word >> lane) as u32 & 1)));
    // Not by `map` of arrays, which LLVM does not always inline.
    let velocity: [C; 3] = [lanes(ux, first, mask), lanes(uy, first, mask), lanes(uz, first, mask)];
    let omega: [C; 3] = [lanes(wx, first, mask), lanes(wy, first, mask), lanes(wz, first, mask)];
    for (column, entry) in columns.iter_mut().zip(body.entries(velocity, omega)) {
        if let Some(places) = column.get_mut(first..first + count) {
            for (lane, place) in places.iter_mut().enumerate() {
                *place = entry.column(lane);
            }
        }
    }
}

/// Returns the entries from index `first` on, times the entries of `mask`.
#[inline(always)]
fn lanes<T: Scalar, C: Columns<T>, const P: usize>(entries: &[T; P], first: usize, mask: C) -> C {
    C::from_fn(|lane| entries.get(first + lane).copied().unwrap_or_default()) * mask
}

/// Writes the columns of passive elements: for each the entries at the rates of its hinge, from a first rate on.
#[inline]
pub fn regressor_of_elements<T: Scalar, const N: usize>(
    mut entries: &[T],
    hinges: &[[usize; 2]],
    regressor: &mut [[T; N]],
) {
    for (&[first, count], column) in hinges.iter().zip(regressor) {
        *column = [T::constant(0.0); N];
        if let Some((own, rest)) = entries.split_at_checked(count) {
            entries = rest;
            column.iter_mut().skip(first).zip(own).for_each(|(place, &entry)| *place = entry);
        }
    }
}

/// A motion of a body, and the wrenches that a body of one unit parameter needs for it. Axes of the body.
struct BodyTerms<T> {
    position: [T; 3],
    /// The columns of the rotation to common axes.
    axes: [[T; 3]; 3],
    acceleration: [T; 3],
    /// The force for a unit of each first moment.
    forces: [[T; 3]; 3],
    /// The moment for a unit of each entry of the inertia.
    moments: [[T; 3]; 6],
}

impl<T: Scalar> BodyTerms<T> {
    #[inline(always)]
    fn new(&[position, x, y, z, [p, q, r], acceleration, [a, b, c]]: &BodyMotions<T>) -> Self {
        let (pp, qq, rr) = (p * p, q * q, r * r);
        let (pq, pr, qr) = (p * q, p * r, q * r);
        let zero = T::constant(0.0);
        Self {
            position,
            axes: [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]],
            acceleration,
            // α × e + ω × (ω × e)
            forces: [
                [zero - qq - rr, c + pq, pr - b],
                [pq - c, zero - pp - rr, a + qr],
                [b + pr, qr - a, zero - pp - qq],
            ],
            // I α + ω × I ω
            moments: [
                [a, pr, zero - pq],
                [zero - qr, b, pq],
                [qr, zero - pr, c],
                [b - pr, a + qr, pp - qq],
                [c + pq, rr - pp, a - qr],
                [qq - rr, c - pq, b + pr],
            ],
        }
    }

    /// Returns the powers of all wrenches on motions in common axes.
    #[inline(always)]
    fn entries<C: Columns<T>>(&self, velocity: [C; 3], omega: [C; 3]) -> [C; PARAMETERS] {
        let velocity = plus_cross(velocity, omega, self.position);
        let [x, y, z] = self.axes;
        let u = [dot(velocity, x), dot(velocity, y), dot(velocity, z)];
        let w = [dot(omega, x), dot(omega, y), dot(omega, z)];
        let mass = dot(u, self.acceleration);
        // The moment of a first moment e is e × r̈, and w · (e × r̈) is the component of r̈ × w along e.
        let moments: [C; 3] = cross_from(self.acceleration, w);
        let first = |k: usize| plus_dot(moments[k], u, self.forces[k]);
        let inertia = |k: usize| dot(w, self.moments[k]);
        [
            mass,
            first(0),
            first(1),
            first(2),
            inertia(0),
            inertia(1),
            inertia(2),
            inertia(3),
            inertia(4),
            inertia(5),
        ]
    }
}

/// Returns `c + a × b`.
#[inline(always)]
fn plus_cross<T: Scalar, C: Columns<T>>(c: [C; 3], [x, y, z]: [C; 3], b: [T; 3]) -> [C; 3] {
    let [p, q, r] = [C::repeated(b[0]), C::repeated(b[1]), C::repeated(b[2])];
    [
        z.mul_neg_add(q, y.mul_add(r, c[0])),
        x.mul_neg_add(r, z.mul_add(p, c[1])),
        y.mul_neg_add(p, x.mul_add(q, c[2])),
    ]
}

/// Returns `a × b`.
#[inline(always)]
fn cross_from<T: Scalar, C: Columns<T>>(a: [T; 3], [x, y, z]: [C; 3]) -> [C; 3] {
    let [p, q, r] = [C::repeated(a[0]), C::repeated(a[1]), C::repeated(a[2])];
    [z.mul_sub(q, y * r), x.mul_sub(r, z * p), y.mul_sub(p, x * q)]
}

#[inline(always)]
fn dot<T: Scalar, C: Columns<T>>(a: [C; 3], b: [T; 3]) -> C {
    let [p, q, r] = [C::repeated(b[0]), C::repeated(b[1]), C::repeated(b[2])];
    a[0].mul_add(p, a[1].mul_add(q, a[2] * r))
}

/// Returns `c + a · b`.
#[inline(always)]
fn plus_dot<T: Scalar, C: Columns<T>>(c: C, a: [C; 3], b: [T; 3]) -> C {
    let [p, q, r] = [C::repeated(b[0]), C::repeated(b[1]), C::repeated(b[2])];
    a[0].mul_add(p, a[1].mul_add(q, a[2].mul_add(r, c)))
}
