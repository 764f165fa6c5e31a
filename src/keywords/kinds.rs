// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `ball` (spherical): all rotations.
///
/// Coordinates: a unit quaternion. Rotation R and displacement d: R of it, 0. Rates, each with
/// an effort: angular velocity: torque, outboard frame.
///
/// See [the page of this kind](mod@crate::hinges::ball) for its equations.
pub enum ball {}

/// `cylindrical(axis)`: a translation and a rotation.
///
/// Coordinates: x, θ. Rotation R and displacement d: Rot(θ), x along the axis. Rates, each with
/// an effort: ẋ, θ̇: force, torque.
///
/// See [the page of this kind](mod@crate::hinges::cylindrical) for its equations.
pub enum cylindrical {}

/// `elastic` (bushing): any motion.
///
/// Coordinates: Δ, θ₁, θ₂, θ₃. Rotation R and displacement d: A_z(θ₃) A_y(θ₂) A_x(θ₁), A_z(θ₃)
/// Δ. Rates, each with an effort: as `floating`.
///
/// See [the page of this kind](mod@crate::hinges::elastic) for its equations.
pub enum elastic {}

/// `floating` (free flyer, free joint): any motion.
///
/// Coordinates: d, a unit quaternion. Rotation R and displacement d: R of it, d. Rates, each
/// with an effort: ḋ, inboard axes, and angular velocity, outboard frame: force at the outboard
/// origin, torque.
///
/// See [the page of this kind](mod@crate::hinges::floating) for its equations.
pub enum floating {}

/// `gimbal(a, b, c)`: three rotations.
///
/// Coordinates: α, β, γ. Rotation R and displacement d: Rot(a, α) Rot(b, β) Rot(c, γ), 0.
/// Rates, each with an effort: α̇, β̇, γ̇: torques.
///
/// See [the page of this kind](mod@crate::hinges::gimbal) for its equations.
pub enum gimbal {}

/// `pin(axis)` (revolute): a rotation.
///
/// Coordinates: the angle θ. Rotation R and displacement d: Rot(θ), 0. Rates, each with an
/// effort: θ̇: torque.
///
/// See [the page of this kind](mod@crate::hinges::pin) for its equations.
pub enum pin {}

/// `planar(normal)`: translations in a plane and a rotation.
///
/// Coordinates: u, w, θ. Rotation R and displacement d: Rot(θ), u and w along the axes after
/// the normal: x, y for z. Rates, each with an effort: u̇, ẇ, θ̇: forces, torque.
///
/// See [the page of this kind](mod@crate::hinges::planar) for its equations.
pub enum planar {}

/// `screw(axis, pitch)` (helical): a rotation with a translation.
///
/// Coordinates: the angle θ. Rotation R and displacement d: Rot(θ), pitch · θ along the axis.
/// Rates, each with an effort: θ̇: torque.
///
/// See [the page of this kind](mod@crate::hinges::screw) for its equations.
pub enum screw {}

/// `slider(axis)` (prismatic): a translation.
///
/// Coordinates: the displacement x. Rotation R and displacement d: 1, x along the axis. Rates,
/// each with an effort: ẋ: force.
///
/// See [the page of this kind](mod@crate::hinges::slider) for its equations.
pub enum slider {}

/// `universal(a, b)`: two rotations.
///
/// Coordinates: α, β. Rotation R and displacement d: Rot(a, α) Rot(b, β), 0. Rates, each with
/// an effort: α̇, β̇: torques.
///
/// See [the page of this kind](mod@crate::hinges::universal) for its equations.
pub enum universal {}

/// `weld` (fixed): no motion.
///
/// Rotation R and displacement d: 1, 0.
///
/// See [the page of this kind](mod@crate::hinges::weld) for its equations.
pub enum weld {}
