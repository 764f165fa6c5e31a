//! Orientations and frames.

use super::context::Context;
use super::dimension::{ANGLE, COMPONENT, LENGTH};
use super::vector::zeros;
use crate::diag::did_you_mean;
use crate::model::{Dimension, Frame, Value, length};
use crate::syntax::{FormSyntax, OrientationSyntax, ValueSyntax};

/// An orientation in one of its representations.
pub(super) enum Orientation {
    /// Roll, pitch and yaw: `A = A_z(yaw) A_y(pitch) A_x(roll)`, [P, Eq. (1)].
    Rpy([Value; 3]),
    /// A quaternion (w, x, y, z) of any length but zero.
    Quaternion([Value; 4]),
}

/// Reads one of the forms of an orientation.
type OrientationReader = fn(&mut Context, &FormSyntax) -> Option<Orientation>;

/// The forms of an orientation.
const ORIENTATIONS: &[(&str, OrientationReader)] = &[("rpy", rpy), ("quaternion", quaternion)];
const ZERO_QUATERNION: &str = "a quaternion of zeros is not an orientation";
const EXPECTED: &str = "expected `rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`";

fn rpy(context: &mut Context, form: &FormSyntax) -> Option<Orientation> {
    context.form_numbers(form, ["roll", "pitch", "yaw"], ANGLE).map(Orientation::Rpy)
}

fn quaternion(context: &mut Context, form: &FormSyntax) -> Option<Orientation> {
    let entries = context.form_numbers(form, ["w", "x", "y", "z"], COMPONENT)?;
    if entries.iter().all(Value::is_zero) {
        return context.refuse(form.list.extent, ZERO_QUATERNION);
    }
    let entries = length::within_bounds(entries);
    let (square, at) = (length::squared(&entries), form.list.extent);
    if square.known().is_none() && !context.quaternions.contains(&square) {
        context.quaternions.push(square);
    }
    context.requirements.push(length::requirement(&entries, at, "a quaternion", ZERO_QUATERNION));
    Some(Orientation::Quaternion(entries))
}

impl Context<'_> {
    /// An orientation.
    pub fn orientation(&mut self, form: &FormSyntax) -> Option<Orientation> {
        let word = form.word.to_string();
        let Some((_, read)) = ORIENTATIONS.iter().find(|(known, _)| *known == word) else {
            let hint = did_you_mean(&word, ORIENTATIONS.iter().map(|(known, _)| *known));
            return self.refuse(&form.word, format!("{EXPECTED}, found `{word}`{hint}"));
        };
        if let Some(about) = &form.about {
            return self.refuse(about, "only an inertia has a reference point: remove `about …`");
        }
        read(self, form)
    }

    /// Reads an orientation after `=`.
    pub fn read_orientation(&mut self, syntax: &ValueSyntax) -> Option<Orientation> {
        match syntax {
            ValueSyntax::Form(form) => self.orientation(form),
            other => {
                let message = format!("{EXPECTED}, found {}", other.described());
                self.refuse(other.extent(), message)
            }
        }
    }

    /// Reads an orientation in a chain of this dimension.
    fn rotation(&mut self, orientation: &OrientationSyntax) -> Option<Orientation> {
        match self.space {
            Dimension::Space => self.turned(orientation),
            Dimension::Plane => self.angle(orientation).map(Orientation::about_z),
            Dimension::Line => self.refuse(
                orientation.extent(),
                "a line chain has no orientations: \
                remove `turned …`",
            ),
        }
    }

    /// Reads an orientation in space after `turned`.
    pub fn turned(&mut self, orientation: &OrientationSyntax) -> Option<Orientation> {
        match orientation {
            OrientationSyntax::Form(form) => self.orientation(form),
            OrientationSyntax::Angle(angle) => {
                self.refuse(angle.extent, format!("{EXPECTED}, found a number"))
            }
        }
    }

    /// Reads the angle of a rotation about a known axis.
    pub fn angle(&mut self, orientation: &OrientationSyntax) -> Option<Value> {
        match orientation {
            OrientationSyntax::Angle(angle) => self.number(angle, ANGLE),
            OrientationSyntax::Form(form) => {
                let message = format!("expected an angle, found `{}(…)`", form.word);
                self.refuse(form.extent(), message)
            }
        }
    }

    /// Reads a frame after `=`: its position and, if written, its orientation.
    pub fn read_frame(&mut self, syntax: &ValueSyntax) -> Option<Frame> {
        match syntax {
            ValueSyntax::Turned(position, orientation) => {
                self.frame(Some(position), Some(orientation))
            }
            other => self.frame(Some(other), None),
        }
    }

    /// Reads a frame from its position and its orientation, both of which may be omitted.
    pub fn frame(
        &mut self,
        position: Option<&ValueSyntax>,
        orientation: Option<&OrientationSyntax>,
    ) -> Option<Frame> {
        let position = match position {
            None => Some(zeros()),
            Some(syntax) => self.read_vector(syntax, LENGTH),
        };
        let turned = orientation.map(|orientation| self.rotation(orientation));
        let (rotation, angles) = match turned {
            None => (Frame::identity().rotation, None),
            Some(turned) => {
                let turned = turned?;
                (turned.rotation(), turned.angles())
            }
        };
        Some(Frame { position: position?, rotation, angles })
    }
}

impl Orientation {
    /// Returns a rotation about z.
    pub fn about_z(angle: Value) -> Self {
        let zero = || Value::number(0.0);
        Orientation::Rpy([zero(), zero(), angle])
    }

    /// Roll, pitch and yaw, if they are written.
    pub fn angles(&self) -> Option<[Value; 3]> {
        match self {
            Orientation::Rpy(angles) => Some(angles.clone()),
            Orientation::Quaternion(_) => None,
        }
    }

    /// Rows of the rotation matrix.
    pub fn rotation(&self) -> [[Value; 3]; 3] {
        match self {
            Orientation::Rpy(angles) => rpy_rotation(angles),
            Orientation::Quaternion(entries) => quaternion_rotation(entries),
        }
    }

    /// The unit quaternion (w, x, y, z).
    pub fn quaternion(&self) -> [Value; 4] {
        match self {
            Orientation::Rpy(angles) => rpy_quaternion(angles),
            Orientation::Quaternion(entries) => normalised(entries),
        }
    }
}

/// [P, Eq. (1)]: `A = A_z A_y A_x`.
fn rpy_rotation(angles: &[Value; 3]) -> [[Value; 3]; 3] {
    let [sx, sy, sz] = angles.clone().map(Value::sin);
    let [cx, cy, cz] = angles.clone().map(Value::cos);
    let product = |a: &Value, b: &Value| a.clone().times(b.clone());
    let (sy_sx, sy_cx) = (product(&sy, &sx), product(&sy, &cx));
    [
        [
            product(&cz, &cy),
            product(&cz, &sy_sx).minus(product(&sz, &cx)),
            product(&cz, &sy_cx).plus(product(&sz, &sx)),
        ],
        [
            product(&sz, &cy),
            product(&sz, &sy_sx).plus(product(&cz, &cx)),
            product(&sz, &sy_cx).minus(product(&cz, &sx)),
        ],
        [sy.negated(), product(&cy, &sx), product(&cy, &cx)],
    ]
}

/// Returns the product of the quaternions of the three rotations.
fn rpy_quaternion(angles: &[Value; 3]) -> [Value; 4] {
    let half = angles.clone().map(|angle| angle.over(Value::number(2.0)));
    let [sx, sy, sz] = half.clone().map(Value::sin);
    let [cx, cy, cz] = half.map(Value::cos);
    let product = |a: &Value, b: &Value, c: &Value| a.clone().times(b.clone()).times(c.clone());
    [
        product(&cz, &cy, &cx).plus(product(&sz, &sy, &sx)),
        product(&cz, &cy, &sx).minus(product(&sz, &sy, &cx)),
        product(&cz, &sy, &cx).plus(product(&sz, &cy, &sx)),
        product(&sz, &cy, &cx).minus(product(&cz, &sy, &sx)),
    ]
}

/// The homogeneous form, divided by the squared length: without a root, so that right angles
/// written as `quaternion(1, 1, 0, 0)` are exact.
fn quaternion_rotation(entries: &[Value; 4]) -> [[Value; 3]; 3] {
    let square = length::squared(entries);
    let product = |a: usize, b: usize| entries[a].clone().times(entries[b].clone());
    let double = |value: Value| value.times(Value::number(2.0));
    [0, 1, 2].map(|row| {
        [0, 1, 2].map(|column| {
            // Indices of the vector part: x is 1.
            let (i, j) = (row + 1, column + 1);
            let entry = if i == j {
                let others = (1..4).filter(|&k| k != i);
                others.fold(product(0, 0).plus(product(i, i)), |sum, k| sum.minus(product(k, k)))
            } else {
                let k = 6 - i - j;
                let term = product(0, k);
                // −w z in row x, column y, and cyclically.
                let forward = j == i % 3 + 1;
                let term = if forward { term.negated() } else { term };
                double(product(i, j).plus(term))
            };
            entry.over(square.clone())
        })
    })
}

fn normalised(entries: &[Value; 4]) -> [Value; 4] {
    let length = length::squared(entries).sqrt();
    entries.clone().map(|entry| entry.over(length.clone()))
}

#[cfg(test)]
mod tests {
    use super::Orientation;
    use crate::model::Value;

    fn known(rows: [[Value; 3]; 3]) -> [[f64; 3]; 3] {
        rows.map(|row| row.map(|entry| entry.known().unwrap_or(f64::NAN)))
    }

    /// The matrix of a quaternion is computed independently of the products of sines.
    #[test]
    fn angles_and_their_quaternion_are_the_same_turn() {
        let turned = Orientation::Rpy([0.3, -1.1, 2.5].map(Value::number));
        let again = Orientation::Quaternion(turned.quaternion());
        let (a, b) = (known(turned.rotation()), known(again.rotation()));
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            // Some ten operations on numbers up to 1.
            assert!((a - b).abs() < 2e-15, "{a} {b}");
        }
    }

    #[test]
    fn right_angles_are_exact() {
        let quarter = (-90.0_f64).to_radians();
        let about_x = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]];
        let turned = Orientation::Rpy([quarter, 0.0, 0.0].map(Value::number));
        assert_eq!(known(turned.rotation()), about_x);
        let turned = Orientation::Quaternion([1.0, -1.0, 0.0, 0.0].map(Value::number));
        assert_eq!(known(turned.rotation()), about_x);
        // Yaw by a right angle takes the x axis to the y axis.
        let turned = Orientation::Rpy([0.0, 0.0, -quarter].map(Value::number));
        assert_eq!(known(turned.rotation())[1][0], 1.0);
    }
}
