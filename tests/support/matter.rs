//! Newton's and Euler's laws for bodies, each about its centre of mass, from what is reported at
//! connection points. Generated code knows neither these equations nor these points.

use mstmm::Point;
use nalgebra::{Matrix3, Vector3};

/// The mass of one body.
#[derive(Clone, Copy, Debug)]
pub struct Lump {
    pub mass: f64,
    /// In the body's frame.
    pub com: [f64; 3],
    /// About the centre of mass: xx, yy, zz, xy, xz, yz.
    pub inertia: [f64; 6],
}

/// A body in motion.
struct Moving {
    arm: Vector3<f64>,
    inertia: Matrix3<f64>,
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    spin: Vector3<f64>,
    spin_rate: Vector3<f64>,
}

impl Lump {
    fn at(&self, input: &Point<f64>) -> Moving {
        let rotation = *input.orientation().matrix();
        let [xx, yy, zz, xy, xz, yz] = self.inertia;
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let arm = rotation * Vector3::from(self.com);
        let (spin, spin_rate) = (input.angular_velocity(), input.angular_acceleration());
        Moving {
            arm,
            inertia: rotation * tensor * rotation.transpose(),
            velocity: input.velocity() + spin.cross(&arm),
            acceleration: input.acceleration()
                + spin_rate.cross(&arm)
                + spin.cross(&spin.cross(&arm)),
            spin,
            spin_rate,
        }
    }

    /// What is missing in Newton's law and in Euler's, relative to the largest term in either.
    pub fn imbalance(&self, ends: [&Point<f64>; 2], gravity: [f64; 3]) -> f64 {
        let [input, output] = ends;
        self.imbalance_of_joined(input, &[output], gravity)
    }

    /// The same for a body with any number of points at which something is joined.
    pub fn imbalance_of_joined(
        &self,
        input: &Point<f64>,
        outputs: &[&Point<f64>],
        gravity: [f64; 3],
    ) -> f64 {
        let body = self.at(input);
        let mut forces =
            vec![input.force(), Vector3::from(gravity) * self.mass, -body.acceleration * self.mass];
        let mut torques = vec![
            -input.moment(),
            (-body.arm).cross(&input.force()),
            -(body.inertia * body.spin_rate),
            -body.spin.cross(&(body.inertia * body.spin)),
        ];
        for output in outputs {
            let to_output = output.position() - input.position() - body.arm;
            forces.push(-output.force());
            torques.extend([output.moment(), to_output.cross(&-output.force())]);
        }
        remainder(&forces).max(remainder(&torques))
    }

    /// Linear momentum, and angular momentum about the inertial origin.
    fn momenta(&self, input: &Point<f64>) -> [Vector3<f64>; 2] {
        let body = self.at(input);
        let linear = body.velocity * self.mass;
        let place = input.position() + body.arm;
        [linear, place.cross(&linear) + body.inertia * body.spin]
    }
}

/// The length of a sum relative to its largest term, or to one.
fn remainder(terms: &[Vector3<f64>]) -> f64 {
    let largest = terms.iter().fold(1.0, |largest: f64, term| largest.max(term.norm()));
    terms.iter().sum::<Vector3<f64>>().norm() / largest
}

/// The points at the inputs and outputs of all bodies. Bodies and hinges alternate; `first` is the
/// index of the first body's input.
pub fn ends(points: &[Point<f64>], first: usize) -> impl Iterator<Item = [&Point<f64>; 2]> {
    points[first..].windows(2).step_by(2).map(|pair| [&pair[0], &pair[1]])
}

/// The momenta of all bodies together.
pub fn momenta(bodies: &[Lump], points: &[Point<f64>], first: usize) -> [Vector3<f64>; 2] {
    let each = bodies.iter().zip(ends(points, first)).map(|(body, [input, _])| body.momenta(input));
    each.fold([Vector3::zeros(); 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]])
}

/// The rate of linear momentum Σ m a of all centres of mass.
pub fn momentum_rate(bodies: &[Lump], points: &[Point<f64>], first: usize) -> Vector3<f64> {
    let each = bodies.iter().zip(ends(points, first));
    each.map(|(body, [input, _])| body.at(input).acceleration * body.mass).sum()
}
