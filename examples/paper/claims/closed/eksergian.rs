//! A four-bar by its one equation of motion, `J θ̈ + ½ J′ θ̇² + V′ = 0`, where θ is the crank angle, J the
//! sum of all inertias reduced to the crank, and V the potential energy; a prime is a derivative with
//! respect to θ (Eksergian, J. Franklin Inst. 209, 1930). The bars are placed by intersecting two circles.
//! The equation has no hinges and no internal forces; the forces follow from the bars' accelerations.

use std::ops::Add;

use nalgebra::{Matrix2, Vector2};

type Vector = Vector2<f64>;

/// A bar. Its frame is at its inboard end.
pub struct Bar {
    pub length: f64,
    pub mass: f64,
    pub com: [f64; 2],
    /// About the centre of mass in kg m².
    pub inertia: f64,
}

/// Crank, coupler and rocker between the origin and a point on the x axis. Seen from the crank, the far
/// end of the coupler is on the left of the line from the crank's end to that point.
pub struct FourBar {
    pub bars: [Bar; 3],
    /// The distance between the pins on the ground in m.
    pub base: f64,
    pub gravity: f64,
}

/// A scalar or vector with its first two derivatives with respect to the crank angle.
#[derive(Clone, Copy)]
struct Derivatives<V> {
    value: V,
    first: V,
    second: V,
}

/// The four-bar at a crank angle.
struct Pose {
    /// Absolute angles of the bars.
    angles: [Derivatives<f64>; 3],
    centres: [Derivatives<Vector>; 3],
}

/// A motion at one time.
pub struct Instant {
    /// Absolute angles of the bars in rad, between −π and π except the crank's.
    pub angles: [f64; 3],
    /// In rad/s².
    pub accelerations: [f64; 3],
    /// The force of the ground on the rocker in N.
    pub force: Vector,
}

impl FourBar {
    /// The crank's acceleration.
    fn acceleration(&self, angle: f64, rate: f64) -> f64 {
        let pose = self.pose(angle);
        let (mut inertia, mut half_slope, mut weight) = (0.0, 0.0, 0.0);
        for ((bar, turn), centre) in self.bars.iter().zip(pose.angles).zip(pose.centres) {
            inertia += bar.mass * centre.first.norm_squared() + bar.inertia * turn.first.powi(2);
            half_slope += bar.mass * centre.first.dot(&centre.second)
                + bar.inertia * turn.first * turn.second;
            weight += bar.mass * self.gravity * centre.first.y;
        }
        -(half_slope * rate * rate + weight) / inertia
    }

    /// A step of the classical method of order four.
    pub fn step(&self, [angle, rate]: [f64; 2], h: f64) -> [f64; 2] {
        let slope = |[angle, rate]: [f64; 2]| [rate, self.acceleration(angle, rate)];
        let after = |by: f64, k: [f64; 2]| [angle + by * k[0], rate + by * k[1]];
        let k1 = slope([angle, rate]);
        let k2 = slope(after(h / 2.0, k1));
        let k3 = slope(after(h / 2.0, k2));
        let k4 = slope(after(h, k3));
        let mean = [0, 1].map(|i| (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0);
        after(h, mean)
    }

    /// Returns the quantities that are compared.
    pub fn at(&self, [angle, rate]: [f64; 2]) -> Instant {
        let pose = self.pose(angle);
        let crank = self.acceleration(angle, rate);
        let accelerations = pose.angles.map(|turn| turn.second * rate * rate + turn.first * crank);
        let centres = pose.centres.map(|r| r.second * (rate * rate) + r.first * crank);
        Instant {
            angles: pose.angles.map(|turn| turn.value),
            accelerations,
            force: self.force(&pose, accelerations, centres),
        }
    }

    fn pose(&self, angle: f64) -> Pose {
        let [crank, coupler, rocker] = &self.bars;
        let (base, joint) = (self.base(), direction(angle) * crank.length);
        // The circles about both points have the lengths of coupler and rocker as radii.
        let across = base - joint;
        let along = (across.norm_squared() + coupler.length.powi(2) - rocker.length.powi(2))
            / (2.0 * across.norm_squared());
        let aside = (coupler.length.powi(2) / across.norm_squared() - along * along).sqrt();
        let far = joint + across * along + perpendicular(across) * aside;
        let angle_of = |arm: Vector| arm.y.atan2(arm.x);
        let values = [angle, angle_of(far - joint), angle_of(base - far)];
        let angles = self.angle_derivatives(values);
        let crank_end = arm([crank.length, 0.0], angles[0]);
        let coupler_end = arm([coupler.length, 0.0], angles[1]);
        let centres = [
            arm(crank.com, angles[0]),
            crank_end + arm(coupler.com, angles[1]),
            crank_end + coupler_end + arm(rocker.com, angles[2]),
        ];
        Pose { angles, centres }
    }

    /// The derivatives of the angles, from the derivatives of the loop equation `Σ lᵢ e(φᵢ) = base`:
    /// `Σ lᵢ φᵢ′ e⊥ᵢ = 0` and `Σ lᵢ (φᵢ″ e⊥ᵢ − φᵢ′² eᵢ) = 0`.
    fn angle_derivatives(&self, values: [f64; 3]) -> [Derivatives<f64>; 3] {
        let [crank, coupler, rocker] =
            [0, 1, 2].map(|k| direction(values[k]) * self.bars[k].length);
        let (left, right) = (perpendicular(coupler), perpendicular(rocker));
        // The factors u and v with u left + v right = sum.
        let parts = |sum: Vector| {
            [cross(sum, right), cross(left, sum)].map(|part| part / cross(left, right))
        };
        let [u, v] = parts(-perpendicular(crank));
        let [a, b] = parts(crank + coupler * (u * u) + rocker * (v * v));
        let derivatives = [(1.0, 0.0), (u, a), (v, b)];
        [0, 1, 2].map(|k| Derivatives {
            value: values[k],
            first: derivatives[k].0,
            second: derivatives[k].1,
        })
    }

    /// The position of the rocker's pin on the ground.
    fn base(&self) -> Vector {
        Vector::new(self.base, 0.0)
    }

    /// The force of the ground on the rocker. The moments of rocker and coupler about their other ends
    /// give the force between them.
    fn force(&self, pose: &Pose, turns: [f64; 3], centres: [Vector; 3]) -> Vector {
        let [crank, coupler, _] = &self.bars;
        let joint = direction(pose.angles[0].value) * crank.length;
        let far = joint + direction(pose.angles[1].value) * coupler.length;
        let loads =
            [1, 2].map(|k| (centres[k] + Vector::new(0.0, self.gravity)) * self.bars[k].mass);
        let moment = |k: usize, about: Vector| {
            self.bars[k].inertia * turns[k] + cross(pose.centres[k].value - about, loads[k - 1])
        };
        let (to_rocker, to_coupler) = (far - self.base(), far - joint);
        let matrix = Matrix2::new(-to_rocker.y, to_rocker.x, to_coupler.y, -to_coupler.x);
        let right = Vector::new(moment(2, self.base()), moment(1, joint));
        let nowhere = Vector::repeat(f64::NAN);
        let between = matrix.try_inverse().map_or(nowhere, |inverse| inverse * right);
        loads[1] - between
    }
}

impl Add for Derivatives<Vector> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Derivatives {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

/// A vector fixed in a rotating bar.
fn arm([x, y]: [f64; 2], turn: Derivatives<f64>) -> Derivatives<Vector> {
    let along = direction(turn.value);
    let value = along * x + perpendicular(along) * y;
    Derivatives {
        value,
        first: perpendicular(value) * turn.first,
        second: perpendicular(value) * turn.second - value * turn.first.powi(2),
    }
}

fn direction(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// The vector rotated by +90°.
fn perpendicular(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}
