//! The reference compared with other forms of the same mechanics.

use super::algebra::{Real, norm};
use super::bennett;
use super::linkage::Linkage;
use super::states::{NEAR, linkages, ordinary};
use crate::double_double::DoubleDouble;
use mstmm::Scalar;

/// In twice the precision each linkage closes to rounding with exactly the rank it should have,
/// far from losing more: its proportions are exact.
#[test]
fn linkages_close_and_have_their_rank() {
    for linkage in linkages() {
        let mut least = f64::INFINITY;
        for crank in NEAR.into_iter().chain(ordinary(&linkage)) {
            let q = linkage.angles(crank.exact());
            let values = linkage.reference(&q, &linkage.rates(&q, 1.0)).values;
            let nothing = values[linkage.rank].double() / values[0].double();
            let strength = values[linkage.rank - 1].double() / values[0].double();
            assert!(nothing < 1e-28, "{} at {crank:e}: {nothing:e}", linkage.name);
            least = least.min(strength);
        }
        // Rounded to `f64`, coordinates miss by their last bits.
        let gap = linkage.gap(&linkage.start.iter().map(|x| x.exact()).collect::<Vec<_>>());
        let drift = linkage.drift(&linkage.start, &linkage.start_rate);
        println!(
            "{}: strength at least {least:.1e}, start misses by {gap:.1e}, moving by {drift:.1e}",
            linkage.name
        );
        assert!(least > 1e-2 && gap < 1e-14 && drift < 1e-14, "{}", linkage.name);
    }
}

/// Mass and potential of the linkage as a system of one degree of freedom, 2 T = m(θ) θ̇².
fn reduced(linkage: &Linkage, crank: DoubleDouble) -> [DoubleDouble; 2] {
    let q = linkage.angles(crank);
    let [kinetic, potential] = linkage.energy(&q, &linkage.rates(&q, 1.0));
    [kinetic + kinetic, potential]
}

/// Lagrange's equation of one degree of freedom, m θ̈ + m' θ̇² / 2 + V' = 0, and the chain rule
/// q̈ = q' θ̈ + q'' θ̇² give the accelerations without constraints. Derivatives are central
/// differences: off by the square of the step, 1e-18, times third derivatives, some thousands.
#[test]
fn accelerations_are_those_of_lagrange() {
    let step = 1e-9.exact();
    let slope = |high: DoubleDouble, low: DoubleDouble| (high - low) * (step + step).recip();
    for linkage in linkages() {
        let mut largest = 0.0_f64;
        for crank in NEAR.into_iter().chain(ordinary(&linkage)) {
            let crank = crank.exact();
            let [high, low] = [crank + step, crank - step].map(|x| reduced(&linkage, x));
            let rates = |x: DoubleDouble| linkage.rates(&linkage.angles(x), 1.0);
            let (after, before) = (rates(crank + step), rates(crank - step));
            let mass = reduced(&linkage, crank)[0];
            let rate = 1.5.exact();
            let square = rate * rate;
            let fall = slope(high[0], low[0]) * square * 0.5.exact() + slope(high[1], low[1]);
            let acceleration = -fall * mass.recip();
            let q = linkage.angles(crank);
            let tangent = linkage.rates(&q, 1.0);
            let found = linkage.reference(&q, &linkage.rates(&q, 1.5)).accelerations;
            for k in 0..q.len() {
                let curved = slope(after[k], before[k]) * square;
                let off = found[k] - (tangent[k] * acceleration + curved);
                largest = largest.max(off.high.abs());
            }
        }
        println!("{}: off by {largest:.1e} rad/s²", linkage.name);
        assert!(largest < 1e-13, "{}: {largest:e}", linkage.name);
    }
}

/// The closure equation of Bennett's linkage, tan(θ/2) tan(φ/2) the same in all configurations:
/// here θ + θ₃ = 0 and φ + φ₄ = 0.
#[test]
fn angles_of_bennett_are_in_closed_form() {
    for (linkage, first, second) in [
        (bennett::bennett(), [2.0, 1.0], [3.0, 1.0]),
        (bennett::bennett_tilted(), [2.0, 1.0], [3.0, 1.0]),
        (bennett::bennett_slender(), [3.0, 2.0], [5.0, 1.0]),
        (bennett::bennett_slender_tilted(), [3.0, 2.0], [5.0, 1.0]),
    ] {
        // With half the twists of the links: tan(φ/2) = − sin(½(α + β)) / sin(½(α − β)) / tan(θ/2).
        let [cosine, sine] = first.map(|x: f64| x.exact());
        let [other_cosine, other_sine] = second.map(|x: f64| x.exact());
        let sum = sine * other_cosine + cosine * other_sine;
        let difference = sine * other_cosine - cosine * other_sine;
        for crank in NEAR.into_iter().chain(ordinary(&linkage)) {
            let half = crank.exact() * 0.5.exact();
            let ([sine], [cosine]) = Scalar::sin_cos([half]);
            let q = linkage.angles(crank.exact());
            let ([other_sine], [other_cosine]) = Scalar::sin_cos([q[1] * 0.5.exact()]);
            let off = [
                sine * other_sine * difference + cosine * other_cosine * sum,
                q[0] + q[2],
                q[1] + q[3],
            ];
            assert!(norm(&off).high < 1e-28, "{} at {crank:e}: {off:?}", linkage.name);
        }
    }
}
