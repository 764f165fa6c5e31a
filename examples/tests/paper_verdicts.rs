//! The verdicts of the example `paper` fail as soon as a difference exceeds its bound.

#[path = "../paper/verdict.rs"]
mod verdict;

use verdict::{Bound, Check, Verdict};

const TOLERANCE: f64 = 1e-8;

fn check(size: f64, bound: Bound) -> Check {
    Check { what: "difference".into(), size, unit: "rad", bound }
}

fn verdict(checks: Vec<Check>) -> Verdict {
    Verdict { compared: "one motion and another".into(), figure: None, checks }
}

#[test]
fn passes_up_to_the_bound() {
    let passed = verdict(vec![
        check(TOLERANCE, Bound::Tolerance),
        check(0.1, Bound::Fixed(0.1)),
        check(0.0, Bound::Fixed(0.0)),
    ]);
    assert!(passed.passes(TOLERANCE) && passed.figure.is_none());
    assert_eq!(passed.complaints(TOLERANCE), Vec::<String>::new());
}

#[test]
fn one_check_beyond_its_bound_fails_the_verdict() {
    for failed in [
        check(1.1e-8, Bound::Tolerance),
        check(f64::NAN, Bound::Tolerance),
        check(f64::INFINITY, Bound::Tolerance),
        check(0.11, Bound::Fixed(0.1)),
        check(1.0, Bound::Fixed(0.0)),
    ] {
        let size = failed.size;
        let verdict = verdict(vec![check(0.0, Bound::Tolerance), failed]);
        assert!(!verdict.passes(TOLERANCE), "{size}");
        let complaints = verdict.complaints(TOLERANCE);
        assert_eq!(complaints.len(), 1);
        assert!(complaints[0].contains(&format!("{size:.1e} rad")), "{complaints:?}");
        let decisive = verdict.decisive(TOLERANCE).map(|check| check.size.to_bits());
        assert_eq!(decisive, Some(size.to_bits()));
    }
}

#[test]
fn a_verdict_without_checks_fails() {
    let empty = verdict(Vec::new());
    assert!(!empty.passes(TOLERANCE) && empty.decisive(TOLERANCE).is_none());
    assert_eq!(empty.complaints(TOLERANCE).len(), 1);
}

#[test]
fn the_tolerance_changes_its_own_bound_only() {
    let strict = 1e-12;
    assert!(!verdict(vec![check(1e-9, Bound::Tolerance)]).passes(strict));
    assert!(verdict(vec![check(1e-9, Bound::Fixed(1e-8))]).passes(strict));
}
