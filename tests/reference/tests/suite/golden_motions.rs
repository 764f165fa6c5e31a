//! Recorded motions of three unit cubes of 1 kg, on balls and on pins, under 9.8 m/s² along -y.
//!
//! The numbers are those of `golden/ball_pendulum_4_1.json` and `golden/pin_arm_4_2_axes_zzz.json`,
//! in which the greatest `maxdiff` is 1.2e-11.

use crate::samples::{assert_close, matrix, three_cubes};
use mstmm_reference::{HingeKind, State, simulate};
use std::f64::consts::TAU;

/// The required accuracy of the reference at all of [`TIMES`].
const TOLERANCE: f64 = 1e-9;

const TIMES: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 5.0];

/// Bryan angles of the three bodies, `A = Az(third) Ay(second) Ax(first)`, at every time.
const BALL_ANGLES: [[[f64; 3]; 3]; 5] = [
    [
        [-3.170144361771093e-06, 0.0005273134789344452, -0.9605733512863613],
        [-0.0018467581554076427, 0.006763871897458692, -0.4257438040802137],
        [0.00020200557183046902, 0.027244382577096393, 0.006597993867661629],
    ],
    [
        [-0.006942857534477968, 0.003907184672013446, -1.8971841660094793],
        [-0.011934143640577384, 0.0008879528749146208, -1.9561453972218492],
        [-0.001523675139238166, 0.0001650423186288879, -2.8394287691977214],
    ],
    [
        [0.0026009106593254836, -0.004160811734289655, -2.614963516816888],
        [-0.008893540015826784, -0.023574495508774506, 3.092382890034503],
        [0.002933212262759647, -0.036976567001542934, -2.766766746517965],
    ],
    [
        [0.0005895740263844909, 0.03220194779818592, -0.6024689195568861],
        [-0.00954840160338238, -0.0005102064452442837, 0.1091284688226001],
        [0.014490766856798912, 0.011228154934029877, -0.1904245543482614],
    ],
    [
        [0.042428007438954064, -0.00828667152433328, 3.0521793880840487],
        [-0.018542633921452324, -0.04871941161189318, -3.019401316136408],
        [0.03665538441338842, -0.08105794237441434, -3.049145839816793],
    ],
];

/// Inertial angular velocities of the three bodies at every time.
const BALL_SPINS: [[[f64; 3]; 3]; 5] = [
    [
        [0.00864516407644032, 0.007420663351388144, -2.1377621639664066],
        [-0.008954514085205862, 0.040097242767486364, -3.6539540264907204],
        [-0.01187821412923384, -0.05376080989933176, -0.44888665486637325],
    ],
    [
        [-0.07195583899109576, 0.03180650669246217, -1.8060457858669932],
        [0.0011908317213108076, 0.0035636852610495427, -4.2231548633733285],
        [0.020773317606921672, -0.0645086801703875, -3.8490090021135965],
    ],
    [
        [-0.004294724302128721, 0.031094660584362513, 2.863858945434193],
        [0.025855367990401144, -0.05469290603902966, 1.2093206787026554],
        [-0.07040887334849198, 0.06745376535570169, -1.1035729836569086],
    ],
    [
        [0.07849380030931549, -0.03008548919362351, 2.5369476224992957],
        [-0.0010764719583738563, 0.0016241164845791061, 1.7506298010683705],
        [0.012266897118275312, 0.12346468674829812, -1.0084684717092833],
    ],
    [
        [-0.010061831232177286, -0.1322687731643749, 0.21590727701583756],
        [-0.028303969641442456, 0.12441852173613147, -0.26514361269456405],
        [-0.03823419452558721, 0.21106368467997502, -0.2287970684887017],
    ],
];

/// Angles of the three pins at every time.
const PIN_ANGLES: [[f64; 3]; 5] = [
    [-0.9396580954344401, 0.9171591251737952, 0.5396311034080112],
    [-1.713045007411809, 0.20963838596269377, -1.0746858470241987],
    [-3.0716732145555357, -0.007438695964721109, 0.7638838081614192],
    [-0.8433348297306823, 0.7464794250768254, 0.23211027947776414],
    [-2.5609435139718477, -1.1425057859581982, -1.3795679429276886],
];

/// Rates of the three pins at every time.
const PIN_RATES: [[f64; 3]; 5] = [
    [-2.4857799505976534, -0.42674537442082716, 3.7071996634930597],
    [-2.2970278751700954, 0.8716703663504014, -8.316779784010144],
    [1.7253773675978519, -1.0545091343762247, 0.9764030436001672],
    [0.9787916940718621, 3.0015952056782904, -2.4726726295491126],
    [-0.45089910507853714, -1.0332319833137837, 2.448960512277794],
];

/// Accelerations of the three pins at the start.
const PIN_ACCELERATIONS: [f64; 3] = [-10.790103092783504, 11.881237113402022, -1.212371134020188];

#[test]
fn cubes_on_balls() {
    let chain = three_cubes(&HingeKind::Ball);
    let mut start = State { q: [1.0, 0.0, 0.0, 0.0].repeat(3), v: vec![0.0; 9] };
    start.v[7] = 0.1;
    let mut expected = BALL_ANGLES.iter().zip(&BALL_SPINS);
    simulate(&chain, &start, &[0.0; 9], &TIMES, |sample| {
        let (angles, spins) = expected.next().unwrap();
        let energy = sample.kinetic_energy + sample.potential_energy;
        assert_close(energy, 0.5 * 5.0 / 12.0 * 0.01, TOLERANCE, "energy");
        for (body, (angles, spin)) in sample.bodies.iter().zip(angles.iter().zip(spins)) {
            for (found, expected) in bryan_angles(&body.rotation).iter().zip(angles) {
                assert_same_angle(*found, *expected, sample.time);
            }
            for (found, expected) in body.angular_velocity.iter().zip(spin) {
                assert_close(*found, *expected, TOLERANCE, "angular velocity");
            }
        }
    });
    assert_eq!(expected.next(), None);
}

#[test]
fn cubes_on_pins() {
    let chain = three_cubes(&HingeKind::Pin { axis: [0.0, 0.0, 1.0] });
    let start = State { q: vec![0.0; 3], v: vec![0.0, 1.0, 0.0] };
    let solution = chain.solve(&start, &[0.0; 3]);
    // The last recorded value has an error of 4e-13: the exact value is -117.6 / 97.
    for (found, expected) in solution.accelerations.iter().zip(PIN_ACCELERATIONS) {
        assert_close(*found, expected, 1e-12, "acceleration at the start");
    }
    let mut expected = PIN_ANGLES.iter().zip(&PIN_RATES);
    simulate(&chain, &start, &[0.0; 3], &TIMES, |sample| {
        let (angles, rates) = expected.next().unwrap();
        for k in 0..3 {
            assert_same_angle(sample.pin_angles[k].unwrap(), angles[k], sample.time);
            assert_close(sample.state.v[k], rates[k], TOLERANCE, "rate");
        }
    });
    assert_eq!(expected.next(), None);
}

/// Returns the angles about x, y and z of a rotation `Az Ay Ax`.
fn bryan_angles(rotation: &[[f64; 3]; 3]) -> [f64; 3] {
    let r = matrix(rotation);
    let about_y = (-r[(2, 0)]).atan2(r[(2, 1)].hypot(r[(2, 2)]));
    [r[(2, 1)].atan2(r[(2, 2)]), about_y, r[(1, 0)].atan2(r[(0, 0)])]
}

#[track_caller]
fn assert_same_angle(found: f64, expected: f64, time: f64) {
    let turns = ((found - expected) / TAU).round();
    assert_close(found - TAU * turns, expected, TOLERANCE, &format!("angle at {time} s"));
}
