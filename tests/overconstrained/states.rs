//! Accelerations, redundancy and reactions in states near special positions and in ordinary ones.

use super::algebra::{Real, dot, norm};
use super::face::{Answer, Closed, doubles};
use super::linkage::Linkage;
use super::reference::{Reference, apart};
use super::svd::decomposed;
use crate::double_double::DoubleDouble;
use mstmm::{Chain, Scalar};
use std::fmt::{self, Display, Formatter};

/// The least singular value relative to the greatest, up to which a closure counts as regular.
const REGULAR: f64 = 1e-3;
/// The rate of the first pin in rad/s.
pub const RATE: f64 = 1.5;
/// Rounding errors that a result may have, each multiplied by the condition of the closure.
pub const OPERATIONS: f64 = 64.0;

/// A configuration of a linkage near one in which a link and its neighbour lie in a line.
pub const NEAR: [f64; 8] = [0.0, 1e-12, -1e-9, 1e-6, 1e-5, -1e-3, 1e-2, 0.1];
/// Ordinary configurations.
pub const ORDINARY: [f64; 6] = [0.4, -0.7, 1.1, 1.9, -2.4, 3.0];

/// One state, with what it should lead to.
pub struct Instant<T> {
    pub q: Vec<T>,
    pub v: Vec<T>,
    pub reference: Reference<DoubleDouble>,
}

impl Linkage {
    /// Returns the state with this angle of the first pin, rounded to the precision of T, and the
    /// reference for what it was rounded from.
    pub fn instant<T: Real>(&self, crank: f64, rate: f64) -> Instant<T> {
        let crank = T::constant(crank).exact();
        let q = self.angles(crank);
        let v = self.rates(&q, rate);
        let reference = self.reference(&q, &v);
        let rounded = |list: &[DoubleDouble]| list.iter().map(|x| T::nearest(*x)).collect();
        Instant { q: rounded(&q), v: rounded(&v), reference }
    }
}

/// How far an answer is from the reference, relative to the bound.
struct Off {
    accelerations: f64,
    reaction: f64,
    undetermined: f64,
}

impl Off {
    /// Each of the operations of the chain counts as a change of the numbers by ε.
    fn new(answer: &Answer, reference: &Reference<DoubleDouble>, epsilon: f64) -> Off {
        let rounding = OPERATIONS * epsilon;
        let expected = doubles(&reference.accelerations);
        let found = [&answer.fast, &answer.accelerations].map(|found| apart(found, &expected));
        let reaction = apart(&answer.reaction, &doubles(&reference.reaction));
        let undetermined = answer.undetermined.iter().filter(|wrench| norm(&wrench[..]) > 0.0);
        let work = undetermined.clone().map(|wrench| {
            let power = reference.jacobian.iter().map(|column| dot(&doubles(column), wrench));
            let long = norm(&wrench[..]) - 1.0;
            power.chain([long]).fold(0.0, |largest: f64, x| worst(largest, x.abs()))
        });
        Off {
            accelerations: worst(found[0], found[1]) / (rounding * reference.acceleration_change),
            reaction: reaction / (rounding * reference.reaction_change),
            undetermined: work.fold(0.0, worst) / (rounding * reference.condition),
        }
    }

    fn within(&self) -> bool {
        // Not a number is not within.
        [self.accelerations, self.reaction, self.undetermined].iter().all(|off| *off < 1.0)
    }

    fn with(&self, other: &Off) -> Off {
        Off {
            accelerations: worst(self.accelerations, other.accelerations),
            reaction: worst(self.reaction, other.reaction),
            undetermined: worst(self.undetermined, other.undetermined),
        }
    }
}

impl Display for Off {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Off { accelerations, reaction, undetermined } = self;
        write!(
            f,
            "accelerations off by {accelerations:.1e}, reactions by {reaction:.1e}, \
             undetermined wrenches by {undetermined:.1e} of the bounds"
        )
    }
}

/// The larger number; a NaN wins.
pub fn worst(a: f64, b: f64) -> f64 {
    if b.is_nan() || b > a { b } else { a }
}

/// What is wrong with a state, in words.
fn complaint<C>(chain: &C, linkage: &Linkage, crank: f64, largest: &mut Off) -> Option<String>
where
    C: Closed,
    <C as Chain>::Scalar: Real,
{
    let instant = linkage.instant::<C::Scalar>(crank, RATE);
    let reference = &instant.reference;
    assert!(reference.strength > REGULAR, "singular at {crank:e} rad: {:e}", reference.strength);
    let answer = match chain.answer(&chain.state(&instant.q, &instant.v)) {
        Ok(answer) => answer,
        Err(error) => return Some(format!("{error:?}")),
    };
    let off = Off::new(&answer, reference, C::Scalar::epsilon().double());
    *largest = largest.with(&off);
    let independent = independent(&answer.undetermined);
    if answer.redundant != 6 - linkage.rank || independent != answer.redundant {
        let redundant = answer.redundant;
        return Some(format!("{redundant} redundant directions, {independent} wrenches, {off}"));
    }
    (!off.within()).then(|| off.to_string())
}

/// Returns how many of the wrenches are linearly independent.
fn independent(wrenches: &[[f64; 6]]) -> usize {
    let columns: Vec<Vec<f64>> = wrenches.iter().map(|wrench| wrench.to_vec()).collect();
    decomposed(&columns).values.into_iter().filter(|value| *value > REGULAR).count()
}

/// Compares a chain as written with the reference in many states.
fn check<C>(linkage: &Linkage, cranks: &[f64])
where
    C: Closed,
    <C as Chain>::Scalar: Real,
{
    compare(&C::default(), linkage, cranks);
}

/// Compares a chain with the reference near special positions and in ordinary ones.
pub fn compared<C: Closed<Scalar = f64>>(chain: &C, linkage: &Linkage) {
    compare(chain, linkage, &[&NEAR[..], &ORDINARY].concat());
}

/// Compares a chain with the reference for these angles of the first pin.
pub fn compare<C>(chain: &C, linkage: &Linkage, cranks: &[f64])
where
    C: Closed,
    <C as Chain>::Scalar: Real,
{
    let mut largest = Off { accelerations: 0.0, reaction: 0.0, undetermined: 0.0 };
    let wrong: Vec<String> = cranks
        .iter()
        .filter_map(|&crank| {
            let complaint = complaint(chain, linkage, crank, &mut largest)?;
            Some(format!("at {crank:e} rad: {complaint}"))
        })
        .collect();
    println!("{}: {largest}", linkage.name);
    assert!(wrong.is_empty(), "{}:\n{}", linkage.name, wrong.join("\n"));
}

/// Tests each linkage by both methods in both precisions.
macro_rules! states {
    ($($module:ident::$name:ident $riccati:ident $transfer:ident;)*) => {
        /// Returns all linkages.
        pub fn linkages() -> Vec<Linkage> {
            vec![$(super::$module::$name()),*]
        }

        $( mod $name {
            use super::super::$module as models;
            use super::{check, ordinary, single, NEAR};

            #[test]
            fn riccati_near_special_positions() {
                check::<models::$riccati<f64>>(&models::$name(), &NEAR);
            }

            #[test]
            fn transfer_near_special_positions() {
                check::<models::$transfer<f64>>(&models::$name(), &NEAR);
            }

            #[test]
            fn both_in_ordinary_positions() {
                let linkage = models::$name();
                check::<models::$riccati<f64>>(&linkage, &ordinary(&linkage));
                check::<models::$transfer<f64>>(&linkage, &ordinary(&linkage));
            }

            #[test]
            fn riccati_in_single_precision() {
                let linkage = models::$name();
                check::<models::$riccati<f32>>(&linkage, &single(&linkage));
            }

            #[test]
            fn transfer_in_single_precision() {
                let linkage = models::$name();
                check::<models::$transfer<f32>>(&linkage, &single(&linkage));
            }
        } )*
    };
}

each_linkage! { states }

/// Returns ordinary angles of the first pin, between the ends of its range, or all around.
pub fn ordinary(linkage: &Linkage) -> Vec<f64> {
    linkage.range.map_or(ORDINARY.to_vec(), |[low, high]| {
        (0..6).map(|k| low + (high - low) * (0.1 + 0.16 * f64::from(k))).collect()
    })
}

/// Returns the angles in single precision: 1e-12 rad is nothing there.
fn single(linkage: &Linkage) -> Vec<f64> {
    let near = NEAR.into_iter().filter(|angle| *angle == 0.0 || angle.abs() >= 1e-5);
    near.chain(ordinary(linkage)).collect()
}
