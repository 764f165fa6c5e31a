//! What errors say.

use mstmm_runtime::Error;

#[test]
fn errors_speak_plainly() {
    let told = |error: Error| error.to_string();
    assert_eq!(
        told(Error::Singular { hinge: "elbow" }),
        "no inertia is left beyond hinge `elbow` in a direction in which it is free: nothing there \
         has any in this state, or rounding has lost it next to much larger inertias; if so, use \
         `f64`, or masses closer together"
    );
    assert_eq!(told(Error::NotFinite), "a coordinate, rate, input or time is not a finite number");
    assert_eq!(
        told(Error::InvalidQuaternion { hinge: "wrist" }),
        "the quaternion of `wrist` is not a rotation: its length must be between 0.9 and 1.1"
    );
    let refused = Error::InvalidParameter { name: "payload", reason: "must not be negative" };
    assert_eq!(told(refused), "`payload` must not be negative");
    assert_eq!(
        told(Error::StepTooSmall),
        "the tolerance cannot be reached: the step became too small"
    );
    assert_eq!(told(Error::OutsideStep), "the time lies outside the last step");
    assert_eq!(told(Error::NotAssembled), "the chain cannot be closed from this start");
    let _: &dyn core::error::Error = &refused;
}
