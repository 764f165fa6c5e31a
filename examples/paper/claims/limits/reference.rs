//! The accelerations of chains of cubes with any number of digits: the Newton–Euler equations of every cube
//! about its centre, with the forces and torques of all hinges as unknowns.
//!
//! The solution shares neither equations nor the order of elimination with the methods that it measures, and
//! no code with generated code.

use std::collections::BTreeMap;
use std::mem;

use mstmm::Error;
use mstmm::description::Origin;
use nalgebra::{Matrix3, Vector3};

use super::pose::{Joint, Placed, Pose, Real, crossing, exact, exact_vector};

/// The unknowns of a cube, three components each: the force and the torque of its hinge on the cube, the
/// acceleration of its centre and its angular acceleration.
const FORCE: usize = 0;
const TORQUE: usize = 3;
const CENTRE: usize = 6;
const ROTATION: usize = 9;
const UNKNOWNS: usize = 12;

/// r̈ of every cube's input and Ω̇, six components per cube, with this precision in binary digits.
///
/// # Errors
/// [`Error::NotFinite`] if they are not determined.
pub fn accelerations(pose: &Pose, digits: usize) -> Result<Vec<Real>, Error> {
    let cubes: Vec<Cube> =
        pose.placed(digits).into_iter().map(|placed| Cube::new(placed, digits)).collect();
    let mut equations = Vec::new();
    for (k, joint) in pose.joints.iter().enumerate() {
        let inboard = k.checked_sub(1).map(|previous| &cubes[previous]);
        let has_next = k + 1 < cubes.len();
        equations.extend(cubes[k].newton_and_euler(k * UNKNOWNS, has_next, digits));
        equations.extend(cubes[k].position_constraints(inboard, k * UNKNOWNS, digits));
        equations.extend(cubes[k].rotation_constraints(inboard, k * UNKNOWNS, joint, digits));
    }
    let solution =
        solve(equations, UNKNOWNS * cubes.len()).ok_or(Error::NotFinite(Origin::Result))?;
    let of_cube = |(cube, values): (&Cube, &[Real])| {
        let three = |at: usize| Vector3::from_fn(|row, _| values[at + row].clone());
        let (centre, angular) = (three(CENTRE), three(ROTATION));
        let input = centre + angular.cross(&cube.input) + &cube.input_bias;
        input.iter().chain(angular.iter()).cloned().collect::<Vec<_>>()
    };
    Ok(cubes.iter().zip(solution.chunks_exact(UNKNOWNS)).flat_map(of_cube).collect())
}

/// A moving homogeneous cube of 1 kg and 1 m, in the inertial frame.
struct Cube {
    angular_velocity: Vector3<Real>,
    rotation: Matrix3<Real>,
    /// Input and output relative to the centre, and the centripetal parts of their relative accelerations.
    input: Vector3<Real>,
    output: Vector3<Real>,
    input_bias: Vector3<Real>,
    output_bias: Vector3<Real>,
}

impl Cube {
    fn new(Placed { rotation, angular_velocity }: Placed, digits: usize) -> Self {
        let bias = |arm: &Vector3<Real>| angular_velocity.cross(&angular_velocity.cross(arm));
        let output = &rotation * exact_vector(&[0.5, 0.0, 0.0], digits);
        let input = -&output;
        let (input_bias, output_bias) = (bias(&input), bias(&output));
        Cube { angular_velocity, rotation, input, output, input_bias, output_bias }
    }

    /// m c̈ = f − f₊ + m g and J Ω̇ = t − t₊ + a × f − b × f₊ about the centre. All axes
    /// are principal with J = 1/6 kg m², so there is no gyroscopic term.
    fn newton_and_euler(&self, first: usize, has_next: bool, digits: usize) -> Vec<Equation> {
        let identity = identity(digits);
        let gravity = exact(-98.0, digits) / exact(10.0, digits);
        let mut newton = vec![(first + CENTRE, identity.clone()), (first + FORCE, -&identity)];
        let inertia = &identity / exact(6.0, digits);
        let mut euler = vec![
            (first + ROTATION, inertia),
            (first + TORQUE, -&identity),
            (first + FORCE, -crossing(&self.input)),
        ];
        if has_next {
            let next = first + UNKNOWNS;
            newton.push((next + FORCE, identity.clone()));
            euler.push((next + TORQUE, identity));
            euler.push((next + FORCE, crossing(&self.output)));
        }
        let mut both = three(&newton, Vector3::new(Real::ZERO, gravity, Real::ZERO));
        both.extend(three(&euler, Vector3::zeros()));
        both
    }

    /// The input has the acceleration of the inboard cube's output, or zero.
    fn position_constraints(
        &self,
        inboard: Option<&Cube>,
        first: usize,
        digits: usize,
    ) -> Vec<Equation> {
        let identity = identity(digits);
        // ω̇ × a = −ã ω̇
        let mut parts =
            vec![(first + CENTRE, identity.clone()), (first + ROTATION, -crossing(&self.input))];
        let mut right = -&self.input_bias;
        if let Some(inboard) = inboard {
            let previous = first - UNKNOWNS;
            parts.push((previous + CENTRE, -identity));
            parts.push((previous + ROTATION, crossing(&inboard.output)));
            right += &inboard.output_bias;
        }
        three(&parts, right)
    }

    /// The torque about each free axis of the hinge is zero. About the other axes, both sides of the hinge have
    /// the same angular acceleration, except the part that velocities cause.
    fn rotation_constraints(
        &self,
        inboard: Option<&Cube>,
        first: usize,
        joint: &Joint,
        digits: usize,
    ) -> Vec<Equation> {
        let Joint::Pin { axis, rate, .. } = joint else {
            return three(&[(first + TORQUE, identity(digits))], Vector3::zeros());
        };
        let axis = &self.rotation * exact_vector(axis, digits);
        let mut equations = vec![Equation::new([(first + TORQUE, &axis)], Real::ZERO)];
        for direction in &across(&axis) {
            let mut parts = vec![(first + ROTATION, direction)];
            let back = -direction;
            let mut right = Real::ZERO;
            if let Some(inboard) = inboard {
                parts.push((first - UNKNOWNS + ROTATION, &back));
                // The axis rotates with the inboard cube.
                right =
                    direction.dot(&(inboard.angular_velocity.cross(&axis) * exact(*rate, digits)));
            }
            equations.push(Equation::new(parts, right));
        }
        equations
    }
}

fn identity(digits: usize) -> Matrix3<Real> {
    Matrix3::from_diagonal_element(exact(1.0, digits))
}

/// Two directions perpendicular to an axis.
fn across(axis: &Vector3<Real>) -> [Vector3<Real>; 2] {
    let least = axis.iter().map(|x| x * x).enumerate().min_by(|(_, a), (_, b)| a.cmp(b));
    let mut other = Vector3::zeros();
    other[least.map_or(0, |(entry, _)| entry)] = Real::ONE;
    let first = axis.cross(&other);
    [axis.cross(&first), first]
}

/// A linear equation of the unknowns with these indices.
struct Equation {
    terms: BTreeMap<usize, Real>,
    right: Real,
}

/// The three equations Σ Mᵢ xᵢ = right; each xᵢ is the three unknowns from an index on.
fn three(parts: &[(usize, Matrix3<Real>)], right: Vector3<Real>) -> Vec<Equation> {
    let row = |row: usize| {
        let rows: Vec<_> =
            parts.iter().map(|(at, matrix)| (*at, matrix.row(row).transpose())).collect();
        Equation::new(rows.iter().map(|(at, row)| (*at, row)), right[row].clone())
    };
    (0..3).map(row).collect()
}

impl Equation {
    fn new<'a>(
        parts: impl IntoIterator<Item = (usize, &'a Vector3<Real>)>,
        right: Real,
    ) -> Equation {
        let terms = parts.into_iter().flat_map(|(at, factors)| {
            factors.iter().cloned().enumerate().map(move |(k, factor)| (at + k, factor))
        });
        Equation { terms: terms.filter(|(_, factor)| *factor != Real::ZERO).collect(), right }
    }

    /// The first unknown of the equation, and its factor.
    fn first(&self) -> Option<(usize, &Real)> {
        self.terms.first_key_value().map(|(unknown, factor)| (*unknown, factor))
    }

    /// The absolute value of the factor of the first unknown.
    fn weight(&self) -> Real {
        let factor = self.first().map_or(Real::ZERO, |(_, factor)| factor.clone());
        if factor < Real::ZERO { -factor } else { factor }
    }

    /// Eliminates the first unknown by subtracting a multiple of `other`, which has the same first unknown.
    fn eliminate(&mut self, other: &Equation) {
        let (Some((_, factor)), Some((unknown, pivot))) = (self.first(), other.first()) else {
            return;
        };
        let share = factor / pivot;
        self.terms.remove(&unknown);
        for (&unknown, factor) in other.terms.iter().skip(1) {
            *self.terms.entry(unknown).or_default() -= factor * &share;
        }
        self.terms.retain(|_, factor| *factor != Real::ZERO);
        self.right -= &other.right * share;
    }
}

/// Gaussian elimination. The pivot is the equation with the largest factor of the first unknown. Returns
/// `None` if not all unknowns are determined.
fn solve(equations: Vec<Equation>, count: usize) -> Option<Vec<Real>> {
    let mut remaining: Vec<Vec<Equation>> = Vec::new();
    remaining.resize_with(count, Vec::new);
    for equation in equations {
        let (unknown, _) = equation.first()?;
        remaining[unknown].push(equation);
    }
    let mut triangle = Vec::with_capacity(count);
    for unknown in 0..count {
        let mut candidates = mem::take(&mut remaining[unknown]);
        candidates.sort_by_cached_key(Equation::weight);
        let pivot = candidates.pop()?;
        for mut equation in candidates {
            equation.eliminate(&pivot);
            let (unknown, _) = equation.first()?;
            remaining[unknown].push(equation);
        }
        triangle.push(pivot);
    }
    let mut solution = vec![Real::ZERO; count];
    for (unknown, Equation { terms, right }) in triangle.into_iter().enumerate().rev() {
        let later = terms.iter().skip(1).map(|(later, factor)| factor * &solution[*later]);
        let known = later.fold(Real::ZERO, |sum, term| sum + term);
        solution[unknown] = (right - known) / terms.get(&unknown)?;
    }
    Some(solution)
}
