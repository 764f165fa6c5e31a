//! The texts of errors.

use mstmm_runtime::Error;
use mstmm_runtime::description::Origin;

#[test]
fn errors_have_these_texts() {
    let text = |error: Error| error.to_string();
    assert_eq!(
        text(Error::Singular { hinge: "elbow" }),
        "the bodies outboard of hinge `elbow` have no inertia along one of its axes in this state, the three \
         axes of a gimbal are in one plane, or rounding has lost the inertia next to much larger inertias: if so, use `f64`, or masses that differ less"
    );
    for (origin, expected) in [
        (Origin::Time, "the time is not finite"),
        (Origin::Coordinate(0), "coordinate 0 (counted from 0) is not finite"),
        (Origin::Rate(2), "rate 2 (counted from 0) is not finite"),
        (Origin::Input(12), "input 12 (counted from 0) is not finite"),
        (
            Origin::Argument { name: "accelerations", index: 3 },
            "entry 3 (counted from 0) of `accelerations` is not finite",
        ),
        (Origin::End, "the end time is not finite"),
        (
            Origin::Result,
            "a result overflows: a value of the state, the inputs, the step or another argument is too large",
        ),
    ] {
        assert_eq!(text(Error::NotFinite(origin)), expected);
    }
    assert_eq!(
        text(Error::InvalidQuaternion { hinge: "wrist" }),
        "the quaternion of `wrist` is not a rotation: its length must be between 0.9 and 1.1"
    );
    let refused = Error::InvalidParameter { name: "payload", reason: "must not be negative" };
    assert_eq!(text(refused), "`payload` must not be negative");
    assert_eq!(
        text(Error::StepTooSmall),
        "the tolerance cannot be met, even with the smallest step: use a larger tolerance or `f64`"
    );
    assert_eq!(text(Error::OutsideStep), "the time is outside the last step");
    assert_eq!(
        text(Error::NotAssembled),
        "the chain is not closed and cannot be closed from this state: call `assemble` before the first step, from a \
         start closer to a pose in which the chain is closed, with its links bent"
    );
    assert_eq!(
        text(Error::SingularMatrix),
        "a matrix is singular, or not positive definite, up to rounding"
    );
    assert_eq!(
        text(Error::NotStabilizable),
        "no gain was found that makes the closed loop stable: the inputs must act on each motion that does not decay, \
         and the cost must have a weight for it"
    );
    let _: &dyn core::error::Error = &refused;
}
