//! The mass properties of bodies, and the regressor.

use super::jet::Jet;
use super::space::{constant, cross_matrix, sum};
use super::{
    Answers, Matrix, Now, Pose, Real, Twist, Vector, constant_matrix, cross, floats, minus, place,
    plus, product, reals, scaled, times, transposed,
};
use crate::chain::{About, Body};

/// The mass properties of a body about the origin of its frame, the input.
#[derive(Clone, Copy)]
pub(super) struct Matter {
    pub(super) mass: Real,
    /// The mass times the centre of mass, in body axes.
    pub(super) moment: Vector,
    /// The inertia about the origin.
    pub(super) inertia: Matrix,
}

impl Matter {
    pub(super) fn of(body: &Body) -> Matter {
        let [xx, yy, zz, xy, xz, yz] = body.inertia.map(Real::new);
        let given = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let (mass, com) = (Real::new(body.mass), body.com.map(Real::new));
        let inertia = match body.about {
            About::Input => given,
            About::Com => sum(given, steiner(mass, com)),
        };
        Matter { mass, moment: scaled(com, mass), inertia }
    }

    pub(super) fn com(&self) -> Vector {
        scaled(self.moment, self.mass.recip())
    }

    /// Returns the inertia about the centre of mass.
    fn central_inertia(&self) -> Matrix {
        sum(self.inertia, steiner(-self.mass, self.com()))
    }

    /// Returns the linear momentum, and the angular momentum about the body's centre of mass.
    pub(super) fn momentum(&self, rotation: Matrix, [velocity, spin]: Twist) -> Twist {
        let arm = times(rotation, self.com());
        let linear = scaled(plus(velocity, cross(spin, arm)), self.mass);
        let own_spin = times(transposed(rotation), spin);
        [linear, times(rotation, times(self.central_inertia(), own_spin))]
    }

    /// Returns the linear momentum, and the angular momentum about the origin of the body's frame.
    pub(super) fn momentum_about_origin(&self, rotation: Matrix, twist: Twist) -> Twist {
        let [linear, angular] = self.momentum(rotation, twist);
        [linear, plus(angular, cross(times(rotation, self.com()), linear))]
    }

    /// Returns the force and the moment about the origin that accelerate the body against gravity: the
    /// derivatives of the momenta about the centre of mass [Newton, Euler].
    pub(super) fn inertial_wrench(&self, pose: &Pose, gravity: Vector) -> Twist {
        let com = place(pose, self.com()).map(|entry| entry.second);
        let force = scaled(minus(com, gravity), self.mass);
        let [spin, angular] = pose.spin();
        let spin: Vector<Jet> =
            std::array::from_fn(|k| Jet::new(spin[k], angular[k], Real::new(0.0)));
        let tensor = product(
            product(pose.rotation, constant_matrix(self.central_inertia())),
            transposed(pose.rotation),
        );
        let moment = times(tensor, spin).map(|entry| entry.rate);
        let arm = times(pose.rotation, constant(self.com())).map(|entry| entry.value);
        [force, plus(moment, cross(arm, force))]
    }

    /// Returns the properties with one of the ten inertial parameters increased by one: the mass, the
    /// three moments, then the entries xx, yy, zz, xy, xz and yz of the inertia.
    fn increased(&self, parameter: usize) -> Matter {
        let mut changed = *self;
        let one = Real::new(1.0);
        match parameter {
            0 => changed.mass += one,
            1..4 => changed.moment[parameter - 1] += one,
            _ => {
                let [i, j] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]][parameter - 4];
                changed.inertia[i][j] += one;
                if i != j {
                    changed.inertia[j][i] += one;
                }
            }
        }
        changed
    }
}

/// Returns the inertia of a point mass.
fn steiner(mass: Real, at: Vector) -> Matrix {
    let turning = cross_matrix(at);
    product(turning, turning).map(|row| row.map(|entry| -(entry * mass)))
}

impl Answers<'_> {
    /// Returns the efforts of inverse dynamics at unit inertial parameters: for every body ten columns,
    /// each with an entry for every rate. The parameters of a body are its mass, the mass times the
    /// centre of mass, and the entries xx, yy, zz, xy, xz and yz of the inertia about the input, in body
    /// axes.
    ///
    /// Efforts are linear in these parameters, so the difference of two of them is exact.
    pub fn body_regressor(&self, accelerations: &[f64]) -> Vec<[Vec<f64>; 10]> {
        let now = Now { a: reals(accelerations), ..self.now.clone() };
        let without = self.efforts(&now);
        let column = |body: usize, parameter: usize| {
            let mut changed = now.clone();
            changed.matter[body] = now.matter[body].increased(parameter);
            let more = self.efforts(&changed);
            let by_one = more.iter().zip(&without).map(|(&more, &without)| more - without);
            floats(&by_one.collect::<Vec<_>>())
        };
        let of_body = |body| std::array::from_fn(|parameter| column(body, parameter));
        (0..now.matter.len()).map(of_body).collect()
    }

    /// Returns the ten inertial parameters of every body.
    pub fn inertial_parameters(&self) -> Vec<[f64; 10]> {
        let of_body = |matter: &Matter| {
            let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = matter.inertia;
            let [x, y, z] = matter.moment;
            [matter.mass, x, y, z, xx, yy, zz, xy, xz, yz].map(|entry| entry.high)
        };
        self.now.matter.iter().map(of_body).collect()
    }
}
