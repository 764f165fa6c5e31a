//! A satellite in free space: momenta are conserved, and the motor of the wheel balances it.

use mstmm::nalgebra::{Matrix3, Vector3};
use mstmm::{ChainState, Dopri5, Point, mstmm_chain};

include!("models/satellite.chain");

/// A body: mass in kg, centre of mass in m, principal moments in kg m².
struct Lump(f64, [f64; 3], [f64; 3]);

const HUB: Lump = Lump(400.0, [0.0; 3], [180.0, 160.0, 200.0]);
const WHEEL: Lump = Lump(8.0, [0.0; 3], [0.05, 0.05, 0.09]);
const YOKE: Lump = Lump(3.0, [0.0, 0.25, 0.0], [0.08, 0.02, 0.09]);
const PANEL: Lump = Lump(9.0, [0.0, 0.6, 0.0], [1.1, 1.7, 2.8]);

impl Lump {
    /// Returns linear momentum in N s and angular momentum about the inertial origin in N m s.
    fn momenta(&self, input: &Point<f64>) -> [Vector3<f64>; 2] {
        let Lump(mass, com, moments) = self;
        let rotation = *input.orientation().matrix();
        let (arm, omega) = (rotation * Vector3::from(*com), input.angular_velocity());
        let linear = (input.velocity() + omega.cross(&arm)) * *mass;
        let inertia = Matrix3::from_diagonal(&Vector3::from(*moments));
        let spin = rotation * (inertia * (rotation.transpose() * omega));
        [linear, (input.position() + arm).cross(&linear) + spin]
    }
}

/// Returns the momenta of the whole satellite, and the sums of their terms' sizes.
fn momenta(at: &SatelliteWorkspace<f64>) -> ([Vector3<f64>; 2], [f64; 2]) {
    let mut bodies = vec![
        (HUB, at.hub().input()),
        (WHEEL, at.wheel().input()),
        (YOKE, at.left_yoke().input()),
        (YOKE, at.right_yoke().input()),
    ];
    for index in 0..3 {
        bodies.push((PANEL, at.left_panel(index).expect("three panels").input()));
        bodies.push((PANEL, at.right_panel(index).expect("three panels").input()));
    }
    let zero = ([Vector3::zeros(); 2], [0.0; 2]);
    bodies.iter().fold(zero, |(sums, sizes), (lump, input)| {
        let momenta = lump.momenta(input);
        let add = |k: usize| (sums[k] + momenta[k], sizes[k] + momenta[k].norm());
        let [(linear, p), (angular, l)] = [0, 1].map(add);
        ([linear, angular], [p, l])
    })
}

#[test]
fn momenta_of_a_free_satellite_are_conserved() {
    let satellite = Satellite::<f64>::new();
    let mut state = satellite.initial_state();
    let mut at = satellite.workspace();
    let torque = |time: f64| SatelliteInputs { axle: 0.05 * (0.2 * time).cos() };
    satellite.solve_into(&state, &torque(0.0), &mut at).expect("a regular chain");
    let (initial, _) = momenta(&at);
    let mut integrator = Dopri5::new(1e-13, 1e-13);
    for second in 1..=100 {
        integrator
            .advance_to(&satellite, &mut state, f64::from(second), |time, _| torque(time))
            .expect("a regular chain");
        let inputs = torque(state.time());
        satellite.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let (now, sizes) = momenta(&at);
        for (k, size) in sizes.into_iter().enumerate() {
            let change = (now[k] - initial[k]).norm() / size;
            assert!(change < 1e-12, "{second} s: momentum {k} changed by {change:e}");
        }
        // The wheel has equal moments about x and y, so that it needs no moment about z to precess.
        let wheel = at.wheel().input();
        let axis = wheel.orientation() * Vector3::z();
        let balance = WHEEL.2[2] * axis.dot(&wheel.angular_acceleration());
        assert!((balance - inputs.axle).abs() < 1e-14, "{balance} N m for {} N m", inputs.axle);
        let moment = -axis.dot(&at.axle().output().moment());
        assert!((moment - inputs.axle).abs() < 1e-14, "{moment} N m for {} N m", inputs.axle);
    }
    assert!(state.axle().rate().abs() > 1.0);
}
