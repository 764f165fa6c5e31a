//! Frames: a position, and a rotation by roll, pitch and yaw.
//!
//! The rotation is R = A_z(yaw) A_y(pitch) A_x(roll). It rotates components in the frame into components in
//! the frame that contains it. Multiples of a right angle have exact sines and cosines.

use nalgebra::{Matrix3, Vector3};

/// An angle in rad; whole degrees keep their number of degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    pub radians: f64,
    /// The number of degrees, if the angle is within the tolerance of this whole number.
    pub degrees: Option<f64>,
}

impl Angle {
    /// Takes an angle that is within `snap` of a whole number of degrees for this number.
    pub fn snapped(radians: f64, snap: f64) -> Self {
        let degrees = radians.to_degrees().round();
        let exact = degrees.to_radians();
        if (radians - exact).abs() <= snap {
            // Without the sign of a negative zero.
            Angle { radians: exact + 0.0, degrees: Some(degrees + 0.0) }
        } else {
            Angle { radians, degrees: None }
        }
    }

    fn sin_cos(self) -> (f64, f64) {
        match self.degrees.map(|degrees| degrees.rem_euclid(360.0)) {
            Some(0.0) => (0.0, 1.0),
            Some(90.0) => (1.0, 0.0),
            Some(180.0) => (0.0, -1.0),
            Some(270.0) => (-1.0, 0.0),
            _ => self.radians.sin_cos(),
        }
    }
}

/// A frame in another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub position: Vector3<f64>,
    pub rotation: Matrix3<f64>,
    /// Roll, pitch and yaw as the file has them, if the frame has the rotation of a single element.
    angles: Option<[Angle; 3]>,
}

impl Frame {
    pub fn identity() -> Self {
        Frame::new(Vector3::zeros(), [Angle { radians: 0.0, degrees: Some(0.0) }; 3])
    }

    pub fn new(position: Vector3<f64>, angles: [Angle; 3]) -> Self {
        Frame { position, rotation: rotation(angles), angles: Some(angles) }
    }

    /// Returns the frame at a position, with the axes of the outer frame.
    pub fn at(position: Vector3<f64>) -> Self {
        Frame { position: position.map(|x| x + 0.0), ..Frame::identity() }
    }

    /// Returns the frame with a rotation whose angles are within `snap` of whole degrees where they become these.
    pub fn rotated(position: Vector3<f64>, rotation: &Matrix3<f64>, snap: f64) -> Self {
        Frame::new(position, angles_of(rotation).map(|angle| Angle::snapped(angle, snap)))
    }

    pub fn is_identity(&self) -> bool {
        self.position == Vector3::zeros() && self.is_parallel()
    }

    /// Returns whether the axes are those of the outer frame.
    pub fn is_parallel(&self) -> bool {
        self.rotation == Matrix3::identity()
    }

    /// Returns the frame `inner`, which is given in this frame, in the outer frame.
    pub fn compose(&self, inner: &Frame) -> Frame {
        let angles = match (self.is_parallel(), inner.is_parallel()) {
            (true, _) => inner.angles,
            (_, true) => self.angles,
            _ => None,
        };
        let position = self.position + self.rotation * inner.position;
        Frame { position, rotation: self.rotation * inner.rotation, angles }
    }

    /// Returns roll, pitch and yaw.
    pub fn angles(&self, snap: f64) -> [Angle; 3] {
        self.angles
            .unwrap_or_else(|| angles_of(&self.rotation).map(|angle| Angle::snapped(angle, snap)))
    }
}

fn rotation(angles: [Angle; 3]) -> Matrix3<f64> {
    let [(sr, cr), (sp, cp), (sy, cy)] = angles.map(Angle::sin_cos);
    Matrix3::new(
        cy * cp,
        cy * sp * sr - sy * cr,
        cy * sp * cr + sy * sr,
        sy * cp,
        sy * sp * sr + cy * cr,
        sy * sp * cr - cy * sr,
        -sp,
        cp * sr,
        cp * cr,
    )
}

/// Returns roll, pitch and yaw of a rotation matrix.
///
/// The roll is that of A_z(yaw)ᵀ R. So close to a pitch of ±90°, where roll and yaw are determined only together,
/// the error of one compensates the error of the other.
pub fn angles_of(r: &Matrix3<f64>) -> [f64; 3] {
    let across = r[(0, 0)].hypot(r[(1, 0)]);
    let pitch = (-r[(2, 0)]).atan2(across);
    let yaw = if across < f64::EPSILON { 0.0 } else { r[(1, 0)].atan2(r[(0, 0)]) };
    let (sin, cos) = yaw.sin_cos();
    let roll = (sin * r[(0, 2)] - cos * r[(1, 2)]).atan2(cos * r[(1, 1)] - sin * r[(0, 1)]);
    [roll, pitch, yaw]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn angles_give_their_rotation_back() {
        // A grid with right angles, and with pitches so close to 90° that roll and yaw are hardly determined.
        let values = [0.0, 1e-9, 0.7, FRAC_PI_2 - 4.9e-12, FRAC_PI_2 - 1e-6, -FRAC_PI_2, 3.0, -2.0];
        let count = values.len();
        for index in 0..count.pow(3) {
            let [roll, pitch, yaw] = [index % count, index / count % count, index / count / count]
                .map(|index| values[index]);
            let frame = rotation([roll, pitch, yaw].map(|angle| Angle::snapped(angle, 1e-12)));
            let back = rotation(angles_of(&frame).map(|angle| Angle::snapped(angle, 0.0)));
            // Each entry has a few roundings of numbers up to 1.
            let error = (frame - back).abs().max();
            assert!(error < 8.0 * f64::EPSILON, "rpy({roll}, {pitch}, {yaw}): {error:e}");
        }
    }

    #[test]
    fn only_close_angles_become_whole_degrees() {
        assert_eq!(Angle::snapped(FRAC_PI_2 + 0.9e-12, 1e-12).degrees, Some(90.0));
        // As 1.57079632679 in many files.
        assert_eq!(Angle::snapped(FRAC_PI_2 - 4.9e-12, 1e-12).degrees, None);
        assert_eq!(Angle::snapped(FRAC_PI_2 - 4.9e-12, 1e-11).degrees, Some(90.0));
        assert_eq!(Angle::snapped(FRAC_PI_2, 0.0).sin_cos(), (1.0, 0.0));
    }
}
