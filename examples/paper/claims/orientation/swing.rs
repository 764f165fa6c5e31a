//! Swings of a cube on a ball, and their ends by an independent solver.

use std::f64::consts::FRAC_PI_2;

use mstmm_reference::{
    About, Body, Chain, Element, Frame, Hinge, HingeKind, Sample, State, simulate,
};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::END;
use crate::system::GRAVITY;

/// The moments of inertia about the hinge, about the axis of symmetry and perpendicular to it, in kg m².
const ALONG: f64 = 1.0 / 6.0;
const ACROSS: f64 = 5.0 / 12.0;
/// The work of the weight from the level to the lowest position in J, about the largest kinetic energy.
pub const FALL: f64 = GRAVITY / 2.0;

/// A swing from the level position.
pub struct Swing {
    pub name: String,
    /// Ω at the start in rad/s.
    pub start: Vector3<f64>,
}

/// The orientation and the angular velocity of the cube in the inertial frame.
pub struct Pose {
    pub orientation: UnitQuaternion<f64>,
    pub angular_velocity: Vector3<f64>,
}

impl Swing {
    /// A swing up to this θ₂.
    pub fn up_to(degrees: f64) -> Self {
        let missing = FRAC_PI_2 - degrees.to_radians();
        // The angular momentum about z is J Ω_z(0) at the start, and J Ω_z sin² δ at the largest θ₂. There
        // the kinetic energy is ½ J Ω_z² sin² δ, which is m g l cos δ more than at the start.
        let turn = missing.tan() * (2.0 * FALL * missing.cos() / ACROSS).sqrt();
        Swing { name: format!("θ₂ up to {degrees}°"), start: Vector3::new(0.0, 0.0, turn) }
    }

    /// A swing through 90°: the momentum about z is that of a spin of the cube when it points down.
    pub fn through() -> Self {
        let start = Vector3::new(1.0, 0.0, -ALONG / ACROSS);
        Swing { name: "θ₂ through 90°, with a spin of 1 rad/s".into(), start }
    }

    /// A planar swing through 90°, without rotation about z.
    pub fn in_plane() -> Self {
        Swing { name: "θ₂ through 90°, in a plane".into(), start: Vector3::zeros() }
    }

    /// The end by the Newton–Euler equations, with positions and quaternions of bodies and step-size
    /// control.
    pub fn reference(&self) -> Option<Reference> {
        let body = Element::Body(Body {
            name: "cube".into(),
            mass: 1.0,
            com: [0.5, 0.0, 0.0],
            output: Frame::at([1.0, 0.0, 0.0]),
            inertia: [ALONG, ACROSS, ACROSS, 0.0, 0.0, 0.0],
            about: About::Input,
            points: Vec::new(),
        });
        let hinge = Element::Hinge(Hinge::new("joint", HingeKind::Ball));
        let chain = Chain::new("Top", [0.0, 0.0, -GRAVITY], vec![hinge, body]);
        let start = State { q: vec![1.0, 0.0, 0.0, 0.0], v: self.start.as_slice().to_vec() };
        let mut found = None;
        simulate(&chain, &start, &[0.0; 3], &[END], |sample| found = self.at_end(sample));
        found
    }

    fn at_end(&self, sample: &Sample) -> Option<Reference> {
        let body = sample.bodies.first()?;
        let rotation = Matrix3::from_fn(|row, column| body.rotation[row][column]);
        let angular_velocity = Vector3::from(body.angular_velocity);
        let inertia = Matrix3::from_diagonal(&Vector3::new(ALONG, ACROSS, ACROSS));
        let momentum = (rotation * inertia * rotation.transpose() * angular_velocity).z;
        let energy = sample.kinetic_energy + sample.potential_energy;
        // In the level position, the centre of mass is at the height of the hinge.
        let first_energy = 0.5 * self.start.dot(&(inertia * self.start));
        let first_momentum = (inertia * self.start).z;
        Some(Reference {
            end: Pose {
                orientation: UnitQuaternion::from_rotation_matrix(
                    &Rotation3::from_matrix_unchecked(rotation),
                ),
                angular_velocity,
            },
            energy: (energy - first_energy).abs(),
            momentum: (momentum - first_momentum).abs(),
        })
    }
}

/// The end of a swing, and the changes of the conserved quantities.
pub struct Reference {
    pub end: Pose,
    /// The change of the energy in J.
    pub energy: f64,
    /// The change of the angular momentum about z in N m s.
    pub momentum: f64,
}
