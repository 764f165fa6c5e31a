//! Accelerations of chains of cubes to any number of digits: Newton's and Euler's equations of every
//! cube about its centre, with the forces and torques of all hinges as unknowns.
//!
//! It shares neither equations nor an order of elimination with the ways that are measured by it, and
//! with generated code nothing at all.

use std::collections::BTreeMap;
use std::mem;

use mstmm::Error;
use nalgebra::{Matrix3, Vector3};

use super::pose::{Joint, Placed, Pose, Real, crossing, exact, exact_vector};

/// The unknowns of a cube, three numbers each: the force and the torque of its hinge on it, the
/// acceleration of its centre and its angular acceleration.
const FORCE: usize = 0;
const TORQUE: usize = 3;
const CENTRE: usize = 6;
const TURNING: usize = 9;
const UNKNOWNS: usize = 12;

/// r̈ of every cube's input and Ω̇, six numbers a cube, to about so many binary digits.
///
/// # Errors
/// [`Error::NotFinite`] if they are not determined.
pub fn accelerations(pose: &Pose, digits: usize) -> Result<Vec<Real>, Error> {
    let cubes: Vec<Cube> =
        pose.placed(digits).into_iter().map(|placed| Cube::new(placed, digits)).collect();
    let mut equations = Vec::new();
    for (k, joint) in pose.joints.iter().enumerate() {
        let inboard = k.checked_sub(1).map(|before| &cubes[before]);
        let has_next = k + 1 < cubes.len();
        equations.extend(cubes[k].newton_and_euler(k * UNKNOWNS, has_next, digits));
        equations.extend(cubes[k].stays_at(inboard, k * UNKNOWNS, digits));
        equations.extend(cubes[k].turns_on(inboard, k * UNKNOWNS, joint, digits));
    }
    let solution = solve(equations, UNKNOWNS * cubes.len()).ok_or(Error::NotFinite)?;
    let of_cube = |(cube, found): (&Cube, &[Real])| {
        let three = |at: usize| Vector3::from_fn(|row, _| found[at + row].clone());
        let (centre, turning) = (three(CENTRE), three(TURNING));
        let input = centre + turning.cross(&cube.input) + &cube.input_drift;
        input.iter().chain(turning.iter()).cloned().collect::<Vec<_>>()
    };
    Ok(cubes.iter().zip(solution.chunks_exact(UNKNOWNS)).flat_map(of_cube).collect())
}

/// A homogeneous cube of 1 kg and 1 m on the move, inertial frame.
struct Cube {
    spin: Vector3<Real>,
    rotation: Matrix3<Real>,
    /// Input and output as seen from the centre, and the parts of their accelerations against it that
    /// velocities make.
    input: Vector3<Real>,
    output: Vector3<Real>,
    input_drift: Vector3<Real>,
    output_drift: Vector3<Real>,
}

impl Cube {
    fn new(Placed { rotation, spin }: Placed, digits: usize) -> Self {
        let drift = |arm: &Vector3<Real>| spin.cross(&spin.cross(arm));
        let output = &rotation * exact_vector(&[0.5, 0.0, 0.0], digits);
        let input = -&output;
        let (input_drift, output_drift) = (drift(&input), drift(&output));
        Cube { spin, rotation, input, output, input_drift, output_drift }
    }

    /// m c̈ = f − f₊ + m g and J Ω̇ = t − t₊ + a × f − b × f₊ about the centre, of which all axes are
    /// principal with J = 1/6 kg m², so that nothing is gyroscopic.
    fn newton_and_euler(&self, own: usize, has_next: bool, digits: usize) -> Vec<Equation> {
        let one = identity(digits);
        let gravity = exact(-98.0, digits) / exact(10.0, digits);
        let mut newton = vec![(own + CENTRE, one.clone()), (own + FORCE, -&one)];
        let inertia = &one / exact(6.0, digits);
        let mut euler = vec![
            (own + TURNING, inertia),
            (own + TORQUE, -&one),
            (own + FORCE, -crossing(&self.input)),
        ];
        if has_next {
            let next = own + UNKNOWNS;
            newton.push((next + FORCE, one.clone()));
            euler.push((next + TORQUE, one));
            euler.push((next + FORCE, crossing(&self.output)));
        }
        let mut both = three(&newton, Vector3::new(Real::ZERO, gravity, Real::ZERO));
        both.extend(three(&euler, Vector3::zeros()));
        both
    }

    /// The input is where the inboard cube's output is, or at rest.
    fn stays_at(&self, inboard: Option<&Cube>, own: usize, digits: usize) -> Vec<Equation> {
        let one = identity(digits);
        // ω̇ × a = −ã ω̇
        let mut parts = vec![(own + CENTRE, one.clone()), (own + TURNING, -crossing(&self.input))];
        let mut right = -&self.input_drift;
        if let Some(inboard) = inboard {
            let before = own - UNKNOWNS;
            parts.push((before + CENTRE, -one));
            parts.push((before + TURNING, crossing(&inboard.output)));
            right += &inboard.output_drift;
        }
        three(&parts, right)
    }

    /// What a hinge leaves free carries no torque; about the rest both its sides turn alike.
    fn turns_on(
        &self,
        inboard: Option<&Cube>,
        own: usize,
        joint: &Joint,
        digits: usize,
    ) -> Vec<Equation> {
        let Joint::Pin { axis, rate, .. } = joint else {
            return three(&[(own + TORQUE, identity(digits))], Vector3::zeros());
        };
        let axis = &self.rotation * exact_vector(axis, digits);
        let mut equations = vec![Equation::new([(own + TORQUE, &axis)], Real::ZERO)];
        for direction in &across(&axis) {
            let mut parts = vec![(own + TURNING, direction)];
            let back = -direction;
            let mut right = Real::ZERO;
            if let Some(inboard) = inboard {
                parts.push((own - UNKNOWNS + TURNING, &back));
                // The axis turns with the inboard cube.
                right = direction.dot(&(inboard.spin.cross(&axis) * exact(*rate, digits)));
            }
            equations.push(Equation::new(parts, right));
        }
        equations
    }
}

fn identity(digits: usize) -> Matrix3<Real> {
    Matrix3::from_diagonal_element(exact(1.0, digits))
}

/// Two directions at right angles to an axis.
fn across(axis: &Vector3<Real>) -> [Vector3<Real>; 2] {
    let least = axis.iter().map(|x| x * x).enumerate().min_by(|(_, a), (_, b)| a.cmp(b));
    let mut other = Vector3::zeros();
    other[least.map_or(0, |(entry, _)| entry)] = Real::ONE;
    let first = axis.cross(&other);
    [axis.cross(&first), first]
}

/// A linear equation of the unknowns with these numbers.
struct Equation {
    terms: BTreeMap<usize, Real>,
    right: Real,
}

/// The three equations Σ Mᵢ xᵢ = right, each xᵢ three unknowns from a number on.
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

    /// The first unknown in it.
    fn first(&self) -> Option<(usize, &Real)> {
        self.terms.first_key_value().map(|(unknown, factor)| (*unknown, factor))
    }

    /// How much its first unknown counts.
    fn weight(&self) -> Real {
        let factor = self.first().map_or(Real::ZERO, |(_, factor)| factor.clone());
        if factor < Real::ZERO { -factor } else { factor }
    }

    /// Takes as much of `other`, which has the same first unknown, from it that this one is gone.
    fn eliminate(&mut self, other: &Equation) {
        let (Some((_, own)), Some((unknown, pivot))) = (self.first(), other.first()) else {
            return;
        };
        let share = own / pivot;
        self.terms.remove(&unknown);
        for (&unknown, factor) in other.terms.iter().skip(1) {
            *self.terms.entry(unknown).or_default() -= factor * &share;
        }
        self.terms.retain(|_, factor| *factor != Real::ZERO);
        self.right -= &other.right * share;
    }
}

/// Gauss's elimination, of all equations with the same first unknown by the one where it counts most.
/// None if not all unknowns are determined.
fn solve(equations: Vec<Equation>, count: usize) -> Option<Vec<Real>> {
    let mut waiting: Vec<Vec<Equation>> = Vec::new();
    waiting.resize_with(count, Vec::new);
    for equation in equations {
        let (unknown, _) = equation.first()?;
        waiting[unknown].push(equation);
    }
    let mut triangle = Vec::with_capacity(count);
    for unknown in 0..count {
        let mut all = mem::take(&mut waiting[unknown]);
        all.sort_by_cached_key(Equation::weight);
        let pivot = all.pop()?;
        for mut equation in all {
            equation.eliminate(&pivot);
            let (unknown, _) = equation.first()?;
            waiting[unknown].push(equation);
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
