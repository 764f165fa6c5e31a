//! `defmt`: the bytes that a logger receives. With the encoding `raw` texts and numbers are in them as they are.

use std::sync::Mutex;

use mstmm::description::Origin;
use mstmm::{Chain, Error};
use mstmm_formats::{Arm, ArmState, RopeState};

static BYTES: Mutex<Vec<u8>> = Mutex::new(Vec::new());
/// One test at a time logs.
static TURN: Mutex<()> = Mutex::new(());

#[defmt::global_logger]
struct Logger;

// SAFETY: the test that holds `TURN` is the only one that logs.
unsafe impl defmt::Logger for Logger {
    fn acquire() {}
    unsafe fn flush() {}
    unsafe fn release() {}
    unsafe fn write(bytes: &[u8]) {
        BYTES.lock().expect("a running logger").extend_from_slice(bytes);
    }
}

defmt::timestamp!("");

/// Returns what is logged.
fn logged(log: impl FnOnce()) -> Vec<u8> {
    let _turn = TURN.lock();
    BYTES.lock().expect("a running logger").clear();
    log();
    std::mem::take(&mut *BYTES.lock().expect("a running logger"))
}

/// Checks that some bytes follow each other, with others between them.
fn assert_in_order(mut bytes: &[u8], parts: &[&[u8]]) {
    for part in parts {
        let found = bytes.windows(part.len()).position(|window| window == *part);
        let found = found.unwrap_or_else(|| panic!("{part:?} is not in {bytes:?}"));
        bytes = &bytes[found + part.len()..];
    }
}

#[test]
fn states_have_names_values_and_units() {
    let state = ArmState::<f64> { t: 2.5, ..ArmState::default() };
    let bytes = logged(|| defmt::println!("{}", state));
    let angle = state.shoulder().angle().to_le_bytes();
    assert_in_order(
        &bytes,
        &[
            b"shoulder",
            b"angle",
            &angle,
            b"rad",
            b"rail",
            b"position",
            &0.125f64.to_le_bytes(),
            b"m",
            b"shoulder",
            b"rate",
            &0.0f64.to_le_bytes(),
            b"rad/s",
            b"rail",
            b"velocity",
            &(-2.0f64).to_le_bytes(),
            b"m/s",
            b"time",
            &2.5f64.to_le_bytes(),
            b"s",
        ],
    );
    let bytes = logged(|| defmt::println!("{}", RopeState::<f32>::default()));
    let one = 1.0f32.to_le_bytes();
    // The index of a repetition is a number.
    assert_in_order(
        &bytes,
        &[b"joint", &12u32.to_le_bytes(), b"orientation", &u32::from('w').to_le_bytes(), &one],
    );
}

#[test]
fn errors_and_points_have_their_names() -> Result<(), Error> {
    let error = Error::Singular { hinge: "elbow" };
    assert_in_order(&logged(|| defmt::println!("{}", error)), &[b"elbow"]);
    let error = Error::NotFinite(Origin::Coordinate(7));
    assert_in_order(&logged(|| defmt::println!("{}", error)), &[&[7, 0, 0, 0]]);
    let error = Error::NotFinite(Origin::Argument { name: "accelerations", index: 3 });
    assert_in_order(&logged(|| defmt::println!("{}", error)), &[b"accelerations", &[3, 0, 0, 0]]);
    let error = Error::InvalidParameter { name: "payload", reason: "must be positive" };
    assert_in_order(&logged(|| defmt::println!("{}", error)), &[b"payload", b"must be positive"]);

    let arm = Arm::<f32>::new();
    let (state, mut at) = (ArmState::default(), arm.workspace());
    arm.check_state(&state)?;
    arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
    let tool = at.lower().tool();
    let bytes = logged(|| defmt::println!("{}", tool));
    let speed = tool.velocity().z.to_le_bytes();
    assert_in_order(&bytes, &[b"position", b"velocity", &speed, b"m/s", b"angular acceleration"]);
    assert!(!bytes.windows(5).any(|window| window == b"force"));
    let point = at.lower().input();
    let bytes = logged(|| defmt::println!("{}", point));
    let (position, moment) = (point.position(), point.moment());
    assert_in_order(
        &bytes,
        &[
            b"position",
            &position.x.to_le_bytes(),
            &position.z.to_le_bytes(),
            b"m",
            b"velocity",
            b"force",
            b"N",
            b"moment",
            &moment.y.to_le_bytes(),
            b"N*m",
        ],
    );
    let inputs = logged(|| defmt::println!("{} {}", arm.no_inputs(), arm.parameters()));
    assert_in_order(&inputs, &[b"push.force", b"payload", &0.5f32.to_le_bytes(), b"kg"]);
    Ok(())
}
