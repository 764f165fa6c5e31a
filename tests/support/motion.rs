//! Motions that the reference prescribes, in the words of the generated inputs.

use mstmm::{
    BallState, CylindricalState, ElasticState, FloatingState, GimbalState, HingeMotion, PinState,
    PlanarState, PlaneElasticState, ScrewState, SliderState, UniversalState,
};
use mstmm_reference::{FrameMotion, HingeMotion as Motion};
use nalgebra::SVector;

/// The entries from `start` on.
pub fn part<const N: usize>(list: &[f64], start: usize) -> [f64; N] {
    std::array::from_fn(|k| list[start + k])
}

/// Some entries as a vector.
pub fn vector<const N: usize>(list: &[f64], places: [usize; N]) -> SVector<f64, N> {
    places.map(|place| list[place]).into()
}

pub fn pin(of: &Motion) -> HingeMotion<PinState<f64>, f64> {
    HingeMotion { state: PinState::new(of.q[0], of.v[0]), acceleration: of.a[0] }
}

pub fn slider(of: &Motion) -> HingeMotion<SliderState<f64>, f64> {
    HingeMotion { state: SliderState::new(of.q[0], of.v[0]), acceleration: of.a[0] }
}

pub fn screw(of: &Motion) -> HingeMotion<ScrewState<f64>, f64> {
    HingeMotion { state: ScrewState::new(of.q[0], of.v[0]), acceleration: of.a[0] }
}

pub fn cylindrical(of: &Motion) -> HingeMotion<CylindricalState<f64>, SVector<f64, 2>> {
    let state = CylindricalState::new(of.q[0], of.q[1], of.v[0], of.v[1]);
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn universal(of: &Motion) -> HingeMotion<UniversalState<f64>, SVector<f64, 2>> {
    let state = UniversalState::new(part(&of.q, 0), part(&of.v, 0));
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn gimbal(of: &Motion) -> HingeMotion<GimbalState<f64>, SVector<f64, 3>> {
    let state = GimbalState::new(part(&of.q, 0), part(&of.v, 0));
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn ball(of: &Motion) -> HingeMotion<BallState<f64>, SVector<f64, 3>> {
    let state = BallState::new(part(&of.q, 0), part(&of.v, 0));
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn planar(of: &Motion) -> HingeMotion<PlanarState<f64>, SVector<f64, 3>> {
    let state = PlanarState::new(part(&of.q, 0), of.q[2], part(&of.v, 0), of.v[2]);
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn plane_elastic(of: &Motion) -> HingeMotion<PlaneElasticState<f64>, SVector<f64, 3>> {
    let state = PlaneElasticState::new(part(&of.q, 0), of.q[2], part(&of.v, 0), of.v[2]);
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn floating(of: &Motion) -> HingeMotion<FloatingState<f64>, SVector<f64, 6>> {
    let (q, v) = (&of.q, &of.v);
    let state = FloatingState::new(part(q, 0), part(q, 3), part(v, 0), part(v, 3));
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

pub fn elastic(of: &Motion) -> HingeMotion<ElasticState<f64>, SVector<f64, 6>> {
    let (q, v) = (&of.q, &of.v);
    let state = ElasticState::new(part(q, 0), part(q, 3), part(v, 0), part(v, 3));
    HingeMotion { state, acceleration: part(&of.a, 0).into() }
}

/// The motion of a frame in space.
pub fn space_frame(of: &FrameMotion) -> HingeMotion<FloatingState<f64>, SVector<f64, 6>> {
    let state = FloatingState::new(of.position, of.orientation, of.velocity, of.rate);
    let acceleration = [of.acceleration, of.rate_derivative].concat();
    HingeMotion { state, acceleration: part(&acceleration, 0).into() }
}

/// The motion of a frame in the plane.
pub fn plane_frame(of: &FrameMotion) -> HingeMotion<PlanarState<f64>, SVector<f64, 3>> {
    let [w, _, _, z] = of.orientation;
    let (position, velocity) = (part(&of.position, 0), part(&of.velocity, 0));
    let [x, y, _] = of.acceleration;
    HingeMotion {
        state: PlanarState::new(position, 2.0 * z.atan2(w), velocity, of.rate[2]),
        acceleration: [x, y, of.rate_derivative[2]].into(),
    }
}

/// The motion of a frame along a line.
pub fn line_frame(of: &FrameMotion) -> HingeMotion<SliderState<f64>, f64> {
    let state = SliderState::new(of.position[0], of.velocity[0]);
    HingeMotion { state, acceleration: of.acceleration[0] }
}
