//! The paper's two pendulums against numbers computed elsewhere: accelerations at the start and
//! the motion of five seconds, by both methods and both integrators.
//!
//! The numbers come from two maximal-coordinate Newton–Euler programs in Python with Lagrange
//! multipliers, integrated at tolerances near rounding; they differ by at most 1.2e-11 from each
//! other. Assumed where the paper is silent: three homogeneous unit cubes of 1 kg, g = 9.8 m/s²
//! along −y, and in section 4.2 pins about z, z, z (A) or z, y, z (B).

mod support;

use mstmm::{ChainState, Dopri5, Rk4};
use std::f64::consts::{PI, TAU};
use support::mechanism::{Answer, Mechanism, both};

both! { BallPendulum BallPendulumByTransfer [Ball, Ball, Ball] {
    gravity = [0, -9.8, 0] m/s^2;
    body Cube {
        mass = 1 kg;
        com = [0.5, 0, 0] m;
        output = [1, 0, 0] m;
        inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
    }
    ground -> ball shoulder -> Cube upper -> ball elbow -> Cube middle -> ball wrist -> Cube lower;
    hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
} }

both! { ArmA ArmAByTransfer [Pin, Pin, Pin] {
    gravity = [0, -9.8, 0] m/s^2;
    body Cube {
        mass = 1 kg;
        com = [0.5, 0, 0] m;
        output = [1, 0, 0] m;
        inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
    }
    ground
        -> pin(z) first -> Cube upper -> pin(z) second -> Cube middle -> pin(z) third -> Cube lower;
    hinge second { start_rate = 1 rad/s; }
} }

both! { ArmB ArmBByTransfer [Pin, Pin, Pin] {
    gravity = [0, -9.8, 0] m/s^2;
    body Cube {
        mass = 1 kg;
        com = [0.5, 0, 0] m;
        output = [1, 0, 0] m;
        inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
    }
    ground
        -> pin(z) first -> Cube upper -> pin(y) second -> Cube middle -> pin(z) third -> Cube lower;
    hinge second { start_rate = 1 rad/s; }
} }

/// The quantities of a motion that are compared.
type Measure = fn(&Answer, &[f64], &[f64]) -> Vec<f64>;

/// The times of the goldens of a motion, in s.
const TIMES: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 5.0];

/// Bryan angles and inertial angular velocities of the three bodies of section 4.1.
const BALLS: [[f64; 18]; 5] = [
    [
        -3.170144361771093e-06,
        0.0005273134789344452,
        -0.9605733512863613,
        -0.0018467581554076427,
        0.006763871897458692,
        -0.4257438040802137,
        0.00020200557183046902,
        0.027244382577096393,
        0.006597993867661629,
        0.00864516407644032,
        0.007420663351388144,
        -2.1377621639664066,
        -0.008954514085205862,
        0.040097242767486364,
        -3.6539540264907204,
        -0.01187821412923384,
        -0.05376080989933176,
        -0.44888665486637325,
    ],
    [
        -0.006942857534477968,
        0.003907184672013446,
        -1.8971841660094793,
        -0.011934143640577384,
        0.0008879528749146208,
        -1.9561453972218492,
        -0.001523675139238166,
        0.0001650423186288879,
        -2.8394287691977214,
        -0.07195583899109576,
        0.03180650669246217,
        -1.8060457858669932,
        0.0011908317213108076,
        0.0035636852610495427,
        -4.2231548633733285,
        0.020773317606921672,
        -0.0645086801703875,
        -3.8490090021135965,
    ],
    [
        0.0026009106593254836,
        -0.004160811734289655,
        -2.614963516816888,
        -0.008893540015826784,
        -0.023574495508774506,
        3.092382890034503,
        0.002933212262759647,
        -0.036976567001542934,
        -2.766766746517965,
        -0.004294724302128721,
        0.031094660584362513,
        2.863858945434193,
        0.025855367990401144,
        -0.05469290603902966,
        1.2093206787026554,
        -0.07040887334849198,
        0.06745376535570169,
        -1.1035729836569086,
    ],
    [
        0.0005895740263844909,
        0.03220194779818592,
        -0.6024689195568861,
        -0.00954840160338238,
        -0.0005102064452442837,
        0.1091284688226001,
        0.014490766856798912,
        0.011228154934029877,
        -0.1904245543482614,
        0.07849380030931549,
        -0.03008548919362351,
        2.5369476224992957,
        -0.0010764719583738563,
        0.0016241164845791061,
        1.7506298010683705,
        0.012266897118275312,
        0.12346468674829812,
        -1.0084684717092833,
    ],
    [
        0.042428007438954064,
        -0.00828667152433328,
        3.0521793880840487,
        -0.018542633921452324,
        -0.04871941161189318,
        -3.019401316136408,
        0.03665538441338842,
        -0.08105794237441434,
        -3.049145839816793,
        -0.010061831232177286,
        -0.1322687731643749,
        0.21590727701583756,
        -0.028303969641442456,
        0.12441852173613147,
        -0.26514361269456405,
        -0.03823419452558721,
        0.21106368467997502,
        -0.2287970684887017,
    ],
];

/// Angles and rates of the three pins of section 4.2A.
const PINS: [[f64; 6]; 5] = [
    [
        -0.9396580954344401,
        0.9171591251737952,
        0.5396311034080112,
        -2.4857799505976534,
        -0.42674537442082716,
        3.7071996634930597,
    ],
    [
        -1.713045007411809,
        0.20963838596269377,
        -1.0746858470241987,
        -2.2970278751700954,
        0.8716703663504014,
        -8.316779784010144,
    ],
    [
        -3.0716732145555357,
        -0.007438695964721109,
        0.7638838081614192,
        1.7253773675978519,
        -1.0545091343762247,
        0.9764030436001672,
    ],
    [
        -0.8433348297306823,
        0.7464794250768254,
        0.23211027947776414,
        0.9787916940718621,
        3.0015952056782904,
        -2.4726726295491126,
    ],
    [
        -2.5609435139718477,
        -1.1425057859581982,
        -1.3795679429276886,
        -0.45089910507853714,
        -1.0332319833137837,
        2.448960512277794,
    ],
];

/// Rounding of the goldens, and of a step of each method.
const AT_START: f64 = 1e-12;

/// The goldens are known to 1.2e-11. With a step of 0.01 s the classical method is off by 5e-5
/// after one second in the fastest rate, so with `STEP` by 5e-5 / 40⁴ = 2e-11; neighbouring motions
/// part by about ten times until 5 s.
const ALONG: f64 = 1e-9;

/// Of the classical method, in s.
const STEP: f64 = 2.5e-4;

fn at_start<C: Mechanism>() -> Answer
where
    C::Inputs: Default,
{
    let chain = C::default();
    let (state, inputs) = (chain.start(), C::Inputs::default());
    let answer = chain.answer(&state, &inputs).expect("a regular chain");
    assert!(
        support::difference(&chain.fast_accelerations(&state, &inputs), &answer.accelerations)
            < AT_START
    );
    answer
}

fn assert_near(computed: &[f64], golden: &[f64], tolerance: f64) {
    assert_eq!(computed.len(), golden.len());
    for (computed, golden) in computed.iter().zip(golden) {
        assert!((computed - golden).abs() <= tolerance, "{computed} instead of {golden}");
    }
}

#[test]
fn cubes_on_balls_start_as_known() {
    for answer in [at_start::<BallPendulum<f64>>(), at_start::<BallPendulumByTransfer<f64>>()] {
        // Each body's input is a hinge's output.
        let turning: Vec<f64> = answer
            .points
            .iter()
            .skip(1)
            .step_by(2)
            .map(|point| point.angular_acceleration().z)
            .collect();
        assert_near(
            &turning,
            &[-10.790103092783504, 1.0911340206185187, -0.12123711340167],
            AT_START,
        );
    }
}

#[test]
fn cubes_on_parallel_pins_start_as_known() {
    for answer in [at_start::<ArmA<f64>>(), at_start::<ArmAByTransfer<f64>>()] {
        let golden = [-10.790103092783504, 11.881237113402022, -1.212371134020188];
        assert_near(&answer.accelerations, &golden, AT_START);
    }
}

#[test]
fn cubes_on_perpendicular_pins_start_as_known() {
    for answer in [at_start::<ArmB<f64>>(), at_start::<ArmBByTransfer<f64>>()] {
        let golden = [-6.189473684210528, 0.0, 9.284210526315796];
        assert_near(&answer.accelerations, &golden, AT_START);
    }
}

/// The largest difference from the goldens, in angles up to full turns.
fn off<C: Mechanism>(chain: &C, state: &C::State, measure: Measure, golden: &[f64]) -> f64
where
    C::Inputs: Default,
{
    let answer = chain.answer(state, &C::Inputs::default()).expect("a regular chain");
    let measured = measure(&answer, state.coordinates(), state.rates());
    assert_eq!(measured.len(), golden.len());
    let parted = |(a, b): (&f64, &f64)| ((a - b + PI).rem_euclid(TAU) - PI).abs();
    measured.iter().zip(golden).map(parted).fold(0.0, support::worst)
}

/// Both integrators from the start to the last golden.
fn moves<C: Mechanism>(name: &str, measure: Measure, golden: &[&[f64]])
where
    C::Inputs: Default,
{
    let chain = C::default();
    let start = chain.start();
    let energy = chain.fast_energy(&start).total();
    let (mut by_rk4, mut by_dopri5) = (start.clone(), start);
    let (mut rk4, mut dopri5) = (Rk4::new(STEP), Dopri5::new(1e-12, 1e-12));
    for (time, golden) in TIMES.into_iter().zip(golden) {
        // Half a step short, so that rounding of the time cannot add one.
        while by_rk4.time() < time - 0.5 * STEP {
            rk4.step(&chain, &mut by_rk4, |_, _| C::Inputs::default()).expect("a step");
        }
        dopri5
            .advance_to(&chain, &mut by_dopri5, time, |_, _| C::Inputs::default())
            .expect("steps");
        for (method, state) in [("Rk4", &by_rk4), ("Dopri5", &by_dopri5)] {
            let off = off(&chain, state, measure, golden);
            let drift = (chain.fast_energy(state).total() - energy).abs();
            println!("{name} {method} {time} s: off by {off:.1e}, energy by {drift:.1e}");
            assert!(off < ALONG && drift < ALONG, "{name} {method} at {time} s: {off:e} {drift:e}");
        }
    }
}

#[test]
fn cubes_on_balls_move_as_known() {
    let measure: Measure = |answer, _, _| {
        let bodies = || answer.points.iter().skip(1).step_by(2);
        let angles = bodies().flat_map(|point| {
            let (first, second, third) = point.orientation().euler_angles();
            [first, second, third]
        });
        let rates = bodies().flat_map(|point| <[f64; 3]>::from(point.angular_velocity()));
        angles.chain(rates).collect()
    };
    let golden = BALLS.each_ref().map(|row| &row[..]);
    moves::<BallPendulum<f64>>("balls, riccati,", measure, &golden);
    moves::<BallPendulumByTransfer<f64>>("balls, transfer,", measure, &golden);
}

#[test]
fn cubes_on_pins_move_as_known() {
    let measure: Measure = |_, q, v| [q, v].concat();
    let golden = PINS.each_ref().map(|row| &row[..]);
    moves::<ArmA<f64>>("pins, riccati,", measure, &golden);
    moves::<ArmAByTransfer<f64>>("pins, transfer,", measure, &golden);
}
