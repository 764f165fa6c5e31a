//! A four-bar by its one equation of motion, `J θ̈ + ½ J′ θ̇² + V′ = 0`, where θ is the angle of its
//! crank, J the sum of all inertias reduced to it, and V the potential energy; a dash is a derivative
//! by θ (Eksergian, J. Franklin Inst. 209, 1930). The bars are placed by intersecting two circles. No
//! hinge and no internal force is in it, but these follow from the bars' accelerations.

use std::ops::Add;

use nalgebra::{Matrix2, Vector2};

type Vector = Vector2<f64>;

/// A bar, with its frame at the end that the chain comes from.
pub struct Bar {
    pub length: f64,
    pub mass: f64,
    pub com: [f64; 2],
    /// About the centre of mass.
    pub inertia: f64,
}

/// Crank, coupler and rocker between the origin and a point on the x axis, the coupler's far end to the
/// left of the line from the crank's end to that point, seen from the crank.
pub struct FourBar {
    pub bars: [Bar; 3],
    /// From pin to pin on the ground.
    pub base: f64,
    pub gravity: f64,
}

/// A number or vector with its first two derivatives by the crank's angle.
#[derive(Clone, Copy)]
struct Course<V> {
    value: V,
    first: V,
    second: V,
}

/// The four-bar at an angle of its crank.
struct Pose {
    /// Absolute angles of the bars.
    angles: [Course<f64>; 3],
    centres: [Course<Vector>; 3],
}

/// A motion at one time.
pub struct Instant {
    /// Absolute angles of the bars in rad, between −π and π but for the crank's.
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

    /// All that is compared.
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
        let far = joint + across * along + turned(across) * aside;
        let angle_of = |way: Vector| way.y.atan2(way.x);
        let values = [angle, angle_of(far - joint), angle_of(base - far)];
        let angles = self.courses(values);
        let crank_end = arm([crank.length, 0.0], angles[0]);
        let coupler_end = arm([coupler.length, 0.0], angles[1]);
        let centres = [
            arm(crank.com, angles[0]),
            crank_end + arm(coupler.com, angles[1]),
            crank_end + coupler_end + arm(rocker.com, angles[2]),
        ];
        Pose { angles, centres }
    }

    /// The derivatives of the angles, from those of the closed way `Σ lᵢ e(φᵢ) = base`: its first
    /// derivative `Σ lᵢ φᵢ′ e⊥ᵢ = 0` and its second one `Σ lᵢ (φᵢ″ e⊥ᵢ − φᵢ′² eᵢ) = 0`.
    fn courses(&self, values: [f64; 3]) -> [Course<f64>; 3] {
        let [crank, coupler, rocker] =
            [0, 1, 2].map(|k| direction(values[k]) * self.bars[k].length);
        let (left, right) = (turned(coupler), turned(rocker));
        // The numbers with u left + v right = sum.
        let parts = |sum: Vector| {
            [cross(sum, right), cross(left, sum)].map(|part| part / cross(left, right))
        };
        let [u, v] = parts(-turned(crank));
        let [a, b] = parts(crank + coupler * (u * u) + rocker * (v * v));
        let derivatives = [(1.0, 0.0), (u, a), (v, b)];
        [0, 1, 2].map(|k| Course {
            value: values[k],
            first: derivatives[k].0,
            second: derivatives[k].1,
        })
    }

    /// Where the rocker is held.
    fn base(&self) -> Vector {
        Vector::new(self.base, 0.0)
    }

    /// Newton's and Euler's equations of rocker and coupler: moments about the ends that each of them
    /// has alone give the force between them.
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

impl Add for Course<Vector> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Course {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

/// A vector fixed in a bar that turns.
fn arm([x, y]: [f64; 2], turn: Course<f64>) -> Course<Vector> {
    let along = direction(turn.value);
    let value = along * x + turned(along) * y;
    Course {
        value,
        first: turned(value) * turn.first,
        second: turned(value) * turn.second - value * turn.first.powi(2),
    }
}

fn direction(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// Turned to the left by a right angle.
fn turned(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}
