//! Accelerations and closing reactions, from d'Alembert's principle and singular values.
//!
//! With the columns of Jacobians for the motions of all bodies the route is
//!
//! ```text
//! M v̇ = f + Jᵀ λ,   J v̇ = γ
//! ```
//!
//! where λ is the wrench of the ground on the last body, at the closing pin. M has a row of zeros
//! for the closing pin, which moves no body. With J = U Σ Vᵀ of known rank r the accelerations are
//! v̇ = J⁺ γ + V₀ y with V₀ᵀ M v̇ = V₀ᵀ f, and the least reactions are λ = (Jᵀ)⁺ (M v̇ − f).

use super::algebra::{
    Real, Vector, constants, cross, dot, less, norm, product, scaled, sum, transformed, transposed,
};
use super::linkage::{Link, Linkage, Motion, Place};
use super::svd::decomposed;

/// What a linkage does at one instant.
pub struct Reference<T> {
    pub accelerations: Vec<T>,
    /// Force and moment of the ground on the last body, at the closing pin, inertial axes: of all
    /// that are possible those of least norm in N and N m.
    pub reaction: Vec<T>,
    /// The velocity and the angular velocity of the end of the route for unit rate of each pin.
    pub jacobian: Vec<Vec<T>>,
    /// The singular values of that Jacobian in m and rad, the greatest first.
    pub values: Vec<T>,
    /// The least singular value that is not zero, relative to the greatest.
    pub strength: f64,
    /// The condition number of G = J M⁻¹ Jᵀ on its range, without the direction of the closing pin.
    pub condition: f64,
    /// How much a relative change of all numbers may change the accelerations, in rad/s².
    ///
    /// The accelerations minimise Gauss' constraint, (v̇ − a)ᵀ M (v̇ − a) with the accelerations a of
    /// the route without its closing pin, under J v̇ = γ. A change ε of J moves that minimum by
    /// ε κ² (|v̇| + |a|) in the norm of M, where κ² is the condition number of G.
    pub acceleration_change: f64,
    /// How much it may change the reactions, which are that minimum times the inverse of J M^-½:
    /// its norm times the same, in N and N m.
    pub reaction_change: f64,
}

/// The mass matrix and the efforts of gravity and of inertia for zero accelerations.
pub struct Dynamics<T> {
    pub mass: Vec<Vec<T>>,
    pub efforts: Vec<T>,
}

impl Linkage {
    pub fn dynamics<T: Real>(&self, motion: &Motion<T>) -> Dynamics<T> {
        let count = self.pins();
        let mut mass = vec![vec![T::default(); count]; count];
        let mut efforts = vec![T::default(); count];
        for (k, (link, body)) in self.links.iter().zip(&motion.bodies).enumerate() {
            let inertia = Inertia::new(link, body);
            let fall = less(constants(self.gravity), body.acceleration);
            let force = scaled(fall, T::constant(link.mass));
            let momentum = inertia.times(body.spin);
            let gyroscopic = cross(body.spin, momentum);
            let torque = scaled(sum(inertia.times(body.spin_rate), gyroscopic), T::constant(-1.0));
            let carried = &motion.pins[..=k];
            let velocity =
                |[origin, axis]: [Vector<T>; 2]| cross(axis, less(body.position, origin));
            for (i, pin) in carried.iter().enumerate() {
                let (shift, turn) = (velocity(*pin), pin[1]);
                efforts[i] += dot(&shift, &force) + dot(&turn, &torque);
                let (momentum, spin) = (scaled(shift, T::constant(link.mass)), inertia.times(turn));
                for (j, other) in carried.iter().enumerate() {
                    mass[i][j] += dot(&momentum, &velocity(*other)) + dot(&spin, &other[1]);
                }
            }
        }
        Dynamics { mass, efforts }
    }

    /// Returns what the linkage does with these angles and rates, which close it.
    pub fn reference<T: Real>(&self, q: &[T], v: &[T]) -> Reference<T> {
        let motion = self.motion(q, v);
        let Dynamics { mass, efforts } = self.dynamics(&motion);
        let columns = motion.jacobian();
        let jacobian = decomposed(&columns);
        let rank = self.rank;
        let bias = [motion.end.acceleration, motion.end.spin_rate].concat();
        let demand: Vec<T> = bias.into_iter().map(|x| -x).collect();
        let mut accelerations = jacobian.solved(rank, &demand);
        // One degree of freedom: the tangent is a single vector.
        let tangent = &jacobian.directions[rank];
        let left = left_over(&mass, &efforts, &accelerations);
        let inertia = dot(tangent, &applied(&mass, tangent));
        let along = -dot(tangent, &left) * inertia.recip();
        accelerations.iter_mut().zip(tangent).for_each(|(a, t)| *a += *t * along);
        let missing = left_over(&mass, &efforts, &accelerations);
        let reaction = jacobian.solved_transposed(rank, &missing);
        let route = Route::new(&mass, &efforts, &columns, rank);
        let size = dot(&accelerations, &applied(&mass, &accelerations)).sqrt().double();
        let change = route.condition * (size + route.free);
        Reference {
            strength: jacobian.ratio(rank),
            condition: route.condition,
            acceleration_change: change / route.lightest.sqrt(),
            reaction_change: change / route.weakest,
            accelerations,
            reaction,
            values: jacobian.values,
            jacobian: columns,
        }
    }

    /// Returns kinetic and potential energy.
    pub fn energy<T: Real>(&self, q: &[T], v: &[T]) -> [T; 2] {
        let motion = self.motion(q, v);
        let mass = self.dynamics(&motion).mass;
        let kinetic = dot(v, &applied(&mass, v)) * T::constant(0.5);
        let gravity: Vector<T> = constants(self.gravity);
        let potential = self.links.iter().zip(&motion.bodies).fold(T::default(), |sum, (l, b)| {
            sum - dot(&gravity, &b.position) * T::constant(l.mass)
        });
        [kinetic, potential]
    }
}

/// The tensor of a body in inertial axes.
struct Inertia<T>(super::algebra::Matrix<T>);

impl<T: Real> Inertia<T> {
    fn new(link: &Link, body: &Place<T>) -> Inertia<T> {
        let [xx, yy, zz, xy, xz, yz] = constants(link.inertia);
        let own = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let half = product(&body.rotation, &own);
        Inertia(product(&half, &transposed(&body.rotation)))
    }

    fn times(&self, vector: Vector<T>) -> Vector<T> {
        transformed(&self.0, vector)
    }
}

fn applied<T: Real>(matrix: &[Vec<T>], vector: &[T]) -> Vec<T> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

/// Returns M v̇ − f.
fn left_over<T: Real>(mass: &[Vec<T>], efforts: &[T], accelerations: &[T]) -> Vec<T> {
    let needed = applied(mass, accelerations);
    needed.into_iter().zip(efforts).map(|(needed, given)| needed - *given).collect()
}

/// Properties of the route without its closing pin.
struct Route {
    /// The condition number of G.
    condition: f64,
    /// The least singular value of J M^-½ that is not zero.
    weakest: f64,
    /// The least eigenvalue of M.
    lightest: f64,
    /// The accelerations in the norm of M.
    free: f64,
}

impl Route {
    fn new<T: Real>(mass: &[Vec<T>], efforts: &[T], columns: &[Vec<T>], rank: usize) -> Route {
        let bodies = mass.len() - 1;
        let mass: Vec<Vec<T>> = mass[..bodies].iter().map(|row| row[..bodies].to_vec()).collect();
        let spectrum = decomposed(&mass);
        let free = spectrum.solved(bodies, &efforts[..bodies]);
        // The mass matrix is V Σ Vᵀ, and J V Σ^-½ has the singular values that belong to G.
        let closing = &columns[bodies];
        let along = dot(closing, closing).recip();
        let scaled: Vec<Vec<T>> = (0..bodies)
            .map(|k| {
                let factor = spectrum.values[k].sqrt().recip();
                let mut column = vec![T::default(); 6];
                for (j, part) in columns[..bodies].iter().enumerate() {
                    let weight = spectrum.directions[k][j] * factor;
                    column.iter_mut().zip(part).for_each(|(sum, x)| *sum += *x * weight);
                }
                let excess = dot(&column, closing) * along;
                column.iter_mut().zip(closing).for_each(|(sum, x)| *sum -= *x * excess);
                column
            })
            .collect();
        let weighted = decomposed(&scaled);
        Route {
            condition: weighted.ratio(rank - 1).powi(-2),
            weakest: weighted.values[rank - 2].double(),
            lightest: spectrum.values[bodies - 1].double(),
            free: dot(&free, &efforts[..bodies]).sqrt().double(),
        }
    }
}

/// Returns the norm of a difference.
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    let off: Vec<f64> = a.iter().zip(b).map(|(x, y)| x - y).collect();
    norm(&off)
}
