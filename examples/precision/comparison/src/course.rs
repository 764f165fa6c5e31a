//! A motion, sampled at discrete times.

use mstmm::{ChainState, Energy, Error, Rk4, Scalar};

use crate::description::Description;
use crate::mixed::Mixed;
use crate::sample::product;
use crate::statistics::{distance, largest};
use crate::subject::{Reading, Subject, convert, doubles};

/// The largest number of samples of a motion.
const INSTANTS: usize = 64;

/// The ratio of the longest step to the specified step.
pub const COARSEST: usize = 4;

/// A sample of the motion.
pub struct Instant {
    pub time: f64,
    pub q: Vec<f64>,
    /// The nearby coordinates with which a closed chain closes, if there are any.
    pub closed: Option<Vec<f64>>,
    pub positions: Vec<[f64; 3]>,
    /// In double precision.
    pub energy: Energy<f64>,
}

/// A motion up to its end or to an error.
pub struct Course {
    pub instants: Vec<Instant>,
    pub stopped: Option<Error>,
}

/// The steps and the times of the samples.
#[derive(Clone, Copy)]
pub struct Plan {
    /// The specified step in s, exact in single precision, so that both precisions use the same step.
    pub step: f64,
    /// The number of longest steps between two samples.
    between: usize,
    /// The number of samples after the start.
    pub instants: usize,
}

impl Plan {
    /// Returns the schedule of a motion of about `time` seconds.
    pub fn new(time: f64, step: f64) -> Self {
        let coarse = ((time / (step * COARSEST as f64)).round() as usize).max(1);
        let between = coarse.div_ceil(INSTANTS);
        Self { step, between, instants: coarse.div_ceil(between) }
    }

    /// Returns the duration in s.
    pub fn time(&self) -> f64 {
        self.instant(self.instants)
    }

    /// Returns the time of a sample in s.
    fn instant(&self, number: usize) -> f64 {
        (number * self.between * COARSEST) as f64 * self.step
    }

    /// Returns the schedule up to one of its samples.
    pub fn until(self, instants: usize) -> Self {
        Self { instants, ..self }
    }
}

/// Simulates a chain from `start` with constant inputs. The state has the precision of `kept`, the
/// rates are computed in the precision of `computed`. The step is the specified step times `part`, a
/// power of two of at least 1/4.
pub fn course<K, C, D>(
    (kept, computed, double): (&K, &C, &D),
    (start, inputs): (&D::State, &[f64]),
    plan: Plan,
    part: f64,
) -> Course
where
    K: Subject,
    C: Subject,
    D: Subject<Scalar = f64>,
{
    let steps = ((plan.between * COARSEST) as f64 / part) as usize;
    let mixed = Mixed { kept, computed };
    let mut rk4 = Rk4::new(K::Scalar::constant(part * plan.step));
    let mut state = K::State::zero_position();
    convert(start, &mut state);
    let mut course = Course { instants: Vec::new(), stopped: None };
    for number in 0..=plan.instants {
        let mut reach = || {
            for _ in 0..if number > 0 { steps } else { 0 } {
                rk4.step(&mixed, &mut state, |_, _| (K::inputs(inputs), C::inputs(inputs)))?;
            }
            instant((kept, double), &state, inputs)
        };
        match reach() {
            Ok(instant) => {
                course.instants.push(Instant { time: plan.instant(number), ..instant });
            }
            Err(error) => {
                course.stopped = Some(error);
                break;
            }
        }
    }
    course
}

fn instant<K, D>(
    (kept, double): (&K, &D),
    state: &K::State,
    inputs: &[f64],
) -> Result<Instant, Error>
where
    K: Subject,
    D: Subject<Scalar = f64>,
{
    let mut at = kept.workspace();
    kept.solve_into(state, &K::inputs(inputs), &mut at)?;
    let positions = K::points(&at).iter().map(Reading::position).collect();
    let mut in_double = D::State::zero_position();
    convert(state, &mut in_double);
    let mut at = double.workspace();
    double.solve_into(&in_double, &D::inputs(inputs), &mut at)?;
    let closed = double.assemble(&mut in_double, &D::inputs(inputs));
    Ok(Instant {
        time: 0.0,
        q: doubles(state.coordinates()),
        closed: closed.ok().map(|()| doubles(in_double.coordinates())),
        positions,
        energy: D::energy_at(&at),
    })
}

/// The difference of two motions at one time.
#[derive(Clone, Copy, Debug, Default)]
pub struct MotionError {
    /// Of angles, in rad.
    pub turn: f64,
    /// Of translations, in m.
    pub shift: f64,
    /// Of connection points, in m.
    pub point: f64,
    /// Of the last connection point, in m.
    pub tip: f64,
}

impl MotionError {
    pub fn of(a: &Instant, b: &Instant, description: &Description) -> Self {
        let ways = || a.positions.iter().zip(&b.positions).map(|(&a, &b)| distance(a, b));
        let (point, tip) = (largest(ways()), ways().next_back().unwrap_or(0.0));
        Self { point, tip, ..Self::of_coordinates(&a.q, &b.q, description) }
    }

    /// Returns the difference of coordinates only.
    pub fn of_coordinates(a: &[f64], b: &[f64], description: &Description) -> Self {
        let mut apart = Self::default();
        let mut start = 0;
        for group in description.groups() {
            let range = start..start + group.coordinates();
            start = range.end;
            let (a, b) = (&a[range.clone()], &b[range]);
            let error = if group.quaternion {
                angle_between([a[0], a[1], a[2], a[3]], [b[0], b[1], b[2], b[3]])
            } else {
                largest(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
            };
            let of_kind = if group.rotational { &mut apart.turn } else { &mut apart.shift };
            *of_kind = largest([*of_kind, error]);
        }
        apart
    }

    /// Returns the larger values of both.
    pub fn or(self, other: Self) -> Self {
        let larger = |of: fn(&Self) -> f64| largest([of(&self), of(&other)]);
        Self {
            turn: larger(|apart| apart.turn),
            shift: larger(|apart| apart.shift),
            point: larger(|apart| apart.point),
            tip: larger(|apart| apart.tip),
        }
    }

    /// Returns the larger of the rotation in rad and the translation relative to the chain's size.
    pub fn scaled(&self, size: f64) -> f64 {
        largest([self.turn, self.shift / size])
    }
}

/// Returns the angle between two orientations, for quaternions of any length.
fn angle_between([w, x, y, z]: [f64; 4], b: [f64; 4]) -> f64 {
    let [w, x, y, z] = product([w, -x, -y, -z], b);
    2.0 * (x * x + y * y + z * z).sqrt().atan2(w.abs())
}

#[cfg(test)]
mod tests {
    use super::{Plan, angle_between};

    #[test]
    fn turns_are_measured_by_their_angle() {
        let turned = |angle: f64| [(angle / 2.0).cos(), 0.0, (angle / 2.0).sin(), 0.0];
        for angle in [0.0, 1e-9, 0.5, 3.0] {
            // A quaternion and its negative are the same orientation, for any length.
            let other = turned(1.0 + angle).map(|entry| -1.001 * entry);
            assert!((angle_between(turned(1.0), other) - angle).abs() < 1e-12);
        }
    }

    #[test]
    fn instants_are_whole_numbers_of_the_longest_steps() {
        for time in [0.1, 1.0, 10.0, 123.4] {
            let plan = Plan::new(time, 0.015625);
            assert!((plan.time() / 0.0625).fract() == 0.0 && plan.instants <= 64);
            assert!(plan.time() >= time - 0.04 && plan.time() < 1.04 * time + 0.07);
        }
    }
}
