//! The momentum of a chain.

use super::space::{cross, minus, plus, scaled};
use super::{Answers, Pose, Real, Twist, Vector, place, twist, values};

/// The momentum of a chain, in inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Momentum {
    /// The mass in kg.
    pub mass: f64,
    /// The centre of mass in m.
    pub centre: [f64; 3],
    /// The linear momentum in kg·m/s.
    pub linear: [f64; 3],
    /// The angular momentum about the centre of mass in kg·m²/s.
    pub angular: [f64; 3],
}

impl Answers<'_> {
    /// Returns the momentum.
    pub fn momentum(&self) -> Momentum {
        let poses = self.moving(&self.now);
        let twists: Vec<Twist> = poses.iter().map(twist).collect();
        let (mass, centre) = self.centre(&poses);
        let [linear, angular] = self.momentum_of(&poses, &twists);
        let all = |vector: Vector| vector.map(|entry| entry.high);
        Momentum {
            mass: mass.high,
            centre: all(centre),
            linear: all(linear),
            angular: all(angular),
        }
    }

    /// Returns the matrix of six rows from the free rates to the linear momentum and to the angular
    /// momentum about the centre of mass.
    pub fn momentum_matrix(&self) -> Vec<Vec<f64>> {
        let poses = self.at_rest(&self.now);
        let columns = self.columns(&self.now);
        let columns: Vec<Vec<Real>> =
            columns.iter().map(|twists| self.momentum_of(&poses, twists).concat()).collect();
        (0..6).map(|row| columns.iter().map(|column| column[row].high).collect()).collect()
    }

    /// Returns the mass and the centre of mass.
    fn centre(&self, poses: &[Pose]) -> (Real, Vector) {
        let (mut mass, mut moment) = (Real::new(0.0), [Real::new(0.0); 3]);
        for (pose, matter) in poses.iter().zip(&self.now.matter) {
            let com = place(pose, matter.com()).map(|entry| entry.value);
            mass += matter.mass;
            moment = plus(moment, scaled(com, matter.mass));
        }
        (mass, scaled(moment, mass.recip()))
    }

    /// Returns the linear momentum, and the angular momentum about the centre of mass.
    fn momentum_of(&self, poses: &[Pose], twists: &[Twist]) -> Twist {
        let (_, centre) = self.centre(poses);
        let mut total = [[Real::new(0.0); 3]; 2];
        for ((pose, matter), twist) in poses.iter().zip(&self.now.matter).zip(twists) {
            let [linear, angular] = matter.momentum(values(pose), *twist);
            let com = place(pose, matter.com()).map(|entry| entry.value);
            let about = plus(angular, cross(minus(com, centre), linear));
            total = [plus(total[0], linear), plus(total[1], about)];
        }
        total
    }
}
