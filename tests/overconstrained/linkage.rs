//! A closed chain of pins as plain data, and where its bodies are.

use super::algebra::{
    Matrix, Real, Vector, constants, cross, less, norm, product, rotation_about, rotation_of,
    scaled, sum, transformed, transposed,
};

/// A position in m and a quaternion w, x, y, z of any length.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub position: [f64; 3],
    pub turned: [f64; 4],
}

/// A pin and the body outboard of it.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// The direction of the pin, of any length.
    pub axis: [f64; 3],
    pub mass: f64,
    pub com: [f64; 3],
    /// The entries xx, yy, zz, xy, xz, yz about the centre of mass.
    pub inertia: [f64; 6],
    pub output: Frame,
}

/// A closed chain `ground -> pin -> body -> … -> pin -> ground`.
#[derive(Clone, Debug)]
pub struct Linkage {
    pub name: &'static str,
    /// The acceleration of free fall in m/s².
    pub gravity: [f64; 3],
    pub from: Frame,
    pub links: Vec<Link>,
    /// The direction of the closing pin.
    pub last: [f64; 3],
    pub to: Frame,
    /// The rank of the closure wherever the linkage has one degree of freedom.
    pub rank: usize,
    /// The angles in rad between which the first pin can move, or nothing if it turns all around.
    pub range: Option<[f64; 2]>,
    /// Angles in rad at which the linkage closes.
    pub start: Vec<f64>,
    /// Rates in rad/s with which the linkage stays closed.
    pub start_rate: Vec<f64>,
}

/// A frame in inertial axes with what its motion would be if all accelerations of hinges were zero.
#[derive(Clone, Copy)]
pub struct Place<T> {
    pub position: Vector<T>,
    pub rotation: Matrix<T>,
    pub spin: Vector<T>,
    pub acceleration: Vector<T>,
    pub spin_rate: Vector<T>,
}

/// Where everything is.
pub struct Motion<T> {
    /// The origins and the unit directions of all pins.
    pub pins: Vec<[Vector<T>; 2]>,
    /// Frames at the centres of mass, with the axes of the bodies.
    pub bodies: Vec<Place<T>>,
    /// The outboard side of the closing pin, where the route leads.
    pub end: Place<T>,
    /// The frame that it should coincide with.
    pub target: (Vector<T>, Matrix<T>),
}

impl<T: Real> Place<T> {
    fn shifted(&self, offset: [f64; 3]) -> Place<T> {
        let arm = transformed(&self.rotation, constants(offset));
        let centripetal = cross(self.spin, cross(self.spin, arm));
        let acceleration = sum(self.acceleration, sum(cross(self.spin_rate, arm), centripetal));
        Place { position: sum(self.position, arm), acceleration, ..*self }
    }

    fn turned(&self, quaternion: [f64; 4]) -> Place<T> {
        let turn = rotation_of(constants(quaternion));
        Place { rotation: product(&self.rotation, &turn), ..*self }
    }

    fn pinned(&self, axis: Vector<T>, angle: T, rate: T) -> Place<T> {
        let turning = scaled(transformed(&self.rotation, axis), rate);
        Place {
            position: self.position,
            rotation: product(&self.rotation, &rotation_about(axis, angle)),
            spin: sum(self.spin, turning),
            acceleration: self.acceleration,
            spin_rate: sum(self.spin_rate, cross(self.spin, turning)),
        }
    }
}

impl Linkage {
    /// Returns the number of pins.
    pub fn pins(&self) -> usize {
        self.links.len() + 1
    }

    /// Returns where everything is with these angles and rates.
    pub fn motion<T: Real>(&self, q: &[T], v: &[T]) -> Motion<T> {
        let zero = [T::default(); 3];
        let mut place = Place {
            position: constants(self.from.position),
            rotation: rotation_of(constants(self.from.turned)),
            spin: zero,
            acceleration: zero,
            spin_rate: zero,
        };
        let (mut pins, mut bodies) = (Vec::new(), Vec::new());
        for (k, link) in self.links.iter().enumerate() {
            place = pinned(&mut pins, &place, link.axis, q[k], v[k]);
            bodies.push(place.shifted(link.com));
            place = place.shifted(link.output.position).turned(link.output.turned);
        }
        let k = self.links.len();
        let end = pinned(&mut pins, &place, self.last, q[k], v[k]);
        let target = (constants(self.to.position), rotation_of(constants(self.to.turned)));
        Motion { pins, bodies, end, target }
    }
}

fn pinned<T: Real>(
    pins: &mut Vec<[Vector<T>; 2]>,
    place: &Place<T>,
    axis: [f64; 3],
    angle: T,
    rate: T,
) -> Place<T> {
    let axis: Vector<T> = constants(axis);
    let unit = scaled(axis, norm(&axis).recip());
    pins.push([place.position, transformed(&place.rotation, unit)]);
    place.pinned(unit, angle, rate)
}

impl<T: Real> Motion<T> {
    /// Returns how the end of the route misses its target: a displacement in m and, to first order,
    /// a rotation vector in rad.
    pub fn gap(&self) -> Vec<T> {
        let off = product(&self.end.rotation, &transposed(&self.target.1));
        let turn = [off[2][1] - off[1][2], off[0][2] - off[2][0], off[1][0] - off[0][1]];
        [less(self.end.position, self.target.0), scaled(turn, T::constant(0.5))].concat()
    }

    /// Returns for each pin the velocity and the angular velocity of the end for unit rate.
    pub fn jacobian(&self) -> Vec<Vec<T>> {
        let column = |[origin, axis]: &[Vector<T>; 2]| {
            [cross(*axis, less(self.end.position, *origin)), *axis].concat()
        };
        self.pins.iter().map(column).collect()
    }
}
