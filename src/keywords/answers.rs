// Written by the test `keywords` of `mstmm-codegen` from `src/language.md` and `src/terms.md`: change the tables there.

/// `answers = basic;`: all of `inverse_dynamics`, `mass_matrix` and `jacobian`.
///
/// `basic` stands for three words. It may be one of several words in a list.
///
/// See [answers](crate::mstmm_chain#answers).
pub enum basic {}

/// `answers = bias_efforts;`: the bias efforts only: gravity, Coriolis and centrifugal terms, springs, dampers, friction, loads.
///
/// This word generates `bias_efforts(&state, &inputs)` and nothing else, [see the reference](crate::mstmm_chain#bias-efforts).
///
/// Other tools and textbooks: `CalcBiasTerm`, `CalcInverseDynamics`, `mj_rne`, `nle`, `nonLinearEffects`, `qfrc_bias`, `qfrc_passive`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "CalcBiasTerm")]
#[doc(alias = "CalcInverseDynamics")]
#[doc(alias = "Coriolis force")]
#[doc(alias = "bias force")]
#[doc(alias = "centrifugal force")]
#[doc(alias = "mj_rne")]
#[doc(alias = "nle")]
#[doc(alias = "nonLinearEffects")]
#[doc(alias = "nonlinear effects")]
#[doc(alias = "qfrc_bias")]
#[doc(alias = "qfrc_passive")]
pub enum bias_efforts {}

/// `answers = coriolis_matrix;`: the Coriolis matrix C(q, v), with dM/dt = C + Cᵀ, and its product with a vector.
///
/// | method | result |
/// |---|---|
/// | `coriolis_matrix(&state, &inputs)` | C, N × N, in kg m²/s, kg m/s and kg/s |
/// | `coriolis_matrix_times(&state, &inputs, &x)` | C x, in O(n) operations |
///
/// C has the entries ∫ Jᵢᵀ J̇ⱼ dm over all masses. Jⱼ is the velocity that a unit of rate j gives to a mass, J̇ⱼ is
/// its time derivative along the motion. Thus dM/dt = C + Cᵀ, and dM/dt − 2 C is skew-symmetric along all motions,
/// also with moving ends and prescribed motions. Adaptive and passivity-based controllers need C: with reference
/// rates w and the gravity efforts g, M ẇ + C w + g is the feed-forward of J.-J. Slotine and W. Li. Without moving
/// ends and prescribed motions, C v are the Coriolis and centrifugal efforts. Of the inputs only prescribed motions
/// matter. A closed chain has the matrix of its open chain.
///
/// Other tools and textbooks: `computeCoriolisMatrix`, `getCoriolisMatrix`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "Christoffel symbols")]
#[doc(alias = "Coriolis matrix")]
#[doc(alias = "Slotine-Li controller")]
#[doc(alias = "adaptive control")]
#[doc(alias = "computeCoriolisMatrix")]
#[doc(alias = "getCoriolisMatrix")]
#[doc(alias = "passivity-based control")]
pub enum coriolis_matrix {}

/// `answers = derivatives;`: the derivatives of inverse dynamics.
///
/// `inverse_dynamics_derivatives(&state, &accelerations, &inputs)` returns
/// [`InverseDynamicsDerivatives`](crate::InverseDynamicsDerivatives): the N × N derivatives of τ with
/// respect to coordinates (along the rates), rates, and accelerations; the last one is M.
///
/// Other tools and textbooks: `computeGeneralizedGravityDerivatives`, `computeRNEADerivatives`, `computeStaticTorqueDerivatives`, `mjd_inverseFD`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "computeGeneralizedGravityDerivatives")]
#[doc(alias = "computeRNEADerivatives")]
#[doc(alias = "computeStaticTorqueDerivatives")]
#[doc(alias = "derivatives of inverse dynamics")]
#[doc(alias = "mjd_inverseFD")]
#[doc(alias = "tangent stiffness matrix")]
pub enum derivatives {}

/// `answers = inverse_dynamics;`: efforts for given accelerations, and their parts: gravity, bias, passive elements.
///
/// Inverse dynamics is τ = M v̇ + bias.
///
/// | method | result |
/// |---|---|
/// | `inverse_dynamics(&state, &accelerations, &inputs)` | τ, the efforts that the drives must supply for the accelerations v̇ |
/// | `bias_efforts(&state, &inputs)` | the efforts at v̇ = 0, [see the reference](crate::mstmm_chain#bias-efforts) |
/// | `gravity_efforts(&state, &inputs)` | the efforts that balance gravity at rest (gravity compensation) |
/// | `passive_efforts(&state, &inputs)` | the efforts of springs, dampers, friction and limits. They act in addition to the drives, with the same sign |
/// | `inverse_solve_into(&state, &accelerations, &inputs, &mut workspace)` | all results of a workspace for the given accelerations, also force and moment at every connection point; not for closed chains |
///
/// The inputs are read for gravity, loads, moving ends and prescribed motions; the efforts of motors in
/// them are not read. `inputs.set_efforts(&efforts)` sets the efforts of all motors and leaves the other inputs as they are. In a chain without springs, dampers, friction, limits, loads, moving ends and
/// prescribed motions, `bias_efforts` less `gravity_efforts` are the Coriolis and centrifugal efforts C(q, v) v; the matrix C is the
/// answer [`coriolis_matrix`](crate::mstmm_chain#coriolis_matrix).
///
/// Other tools and textbooks: `CalcBiasTerm`, `CalcForceElementsContribution`, `CalcGravityGeneralizedForces`, `CalcInverseDynamics`, `MakeActuationMatrix`, `computeGeneralizedGravity`, `computeStaticTorque`, `ctrl`, `mj_inverse`, `mj_passive`, `mj_rne`, `nle`, `nonLinearEffects`, `qfrc_bias`, `qfrc_inverse`, `qfrc_passive`, `rnea`, `underactuated`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "CalcBiasTerm")]
#[doc(alias = "CalcForceElementsContribution")]
#[doc(alias = "CalcGravityGeneralizedForces")]
#[doc(alias = "CalcInverseDynamics")]
#[doc(alias = "Coriolis force")]
#[doc(alias = "MakeActuationMatrix")]
#[doc(alias = "actuation matrix")]
#[doc(alias = "bias force")]
#[doc(alias = "centrifugal force")]
#[doc(alias = "computeGeneralizedGravity")]
#[doc(alias = "computeStaticTorque")]
#[doc(alias = "computed torque")]
#[doc(alias = "ctrl")]
#[doc(alias = "feed-forward torque")]
#[doc(alias = "gravity compensation")]
#[doc(alias = "gravity vector")]
#[doc(alias = "holding torque")]
#[doc(alias = "inverse dynamics")]
#[doc(alias = "mj_inverse")]
#[doc(alias = "mj_passive")]
#[doc(alias = "mj_rne")]
#[doc(alias = "nle")]
#[doc(alias = "nonLinearEffects")]
#[doc(alias = "nonlinear effects")]
#[doc(alias = "qfrc_bias")]
#[doc(alias = "qfrc_inverse")]
#[doc(alias = "qfrc_passive")]
#[doc(alias = "recursive Newton-Euler algorithm")]
#[doc(alias = "rnea")]
#[doc(alias = "selection matrix")]
#[doc(alias = "underactuated")]
pub enum inverse_dynamics {}

/// `answers = jacobian;`: the Jacobian of any point of any body, and its products, in addition to `kinematics`.
///
/// The word adds methods to the points of `kinematics`, which it generates, too:
///
/// | method of a point | result |
/// |---|---|
/// | `jacobian()` | J, 6 × N: three rows of velocity, then three of angular velocity, all in inertial axes. 3 × N in a plane: x, y, angle. 1 × N on a line |
/// | `jacobian_times(&x)` | J x, without the matrix |
/// | `jacobian_transpose_times(force, moment)` | Jᵀ times a force in N at the point and a moment in N m, inertial axes: the efforts of the same power |
/// | `acceleration(&accelerations)`, `angular_acceleration(&accelerations)` | J v̇ + J̇ v in m/s² and rad/s² |
///
/// The rows of angular velocity are `jacobian().fixed_rows::<3>(3)`.
///
/// | method of the chain | result |
/// |---|---|
/// | `foot_jacobian(&state, &inputs, &place)`, for each body `foot` at a free end | J of the point at `place`, a vector in m from the input of the body in the body frame, such as a tool. It is computed without the kinematics of other bodies: for the Panda it costs a third of `kinematics` with `jacobian()`. Not with `repeat`, not for closed chains |
/// | `inverse_operational_space_inertia(&state, &inputs, &point)`, with `mass_matrix` | J M⁻¹ Jᵀ for a point of the kinematics, with the rows of J |
/// | `operational_space_inertia(&state, &inputs, &point)`, with `mass_matrix` | Λ = (J M⁻¹ Jᵀ)⁻¹. `Error::SingularMatrix` if the point cannot move in every direction, as that of an arm with fewer than six joints. The inertia against a force only is the inverse of the upper left block of J M⁻¹ Jᵀ, by [`linear::solve_positive_definite`](crate::linear::solve_positive_definite) |
/// | `closure_jacobian(&state, &inputs)`, for a closed chain | the constraint Jacobian G, in axes of the outboard frame of the closing hinge: rates v with G v = 0 keep the chain closed if moving ends and prescribed motions are at rest, and [`linear::null_space`](crate::linear::null_space) is a basis of them |
///
/// Other tools and textbooks: `CalcGeneralizedForces`, `CalcJacobianAngularVelocity`, `CalcJacobianSpatialVelocity`, `CalcJacobianTranslationalVelocity`, `CalcSpatialAccelerationsFromVdot`, `EvalBodySpatialAccelerationInWorld`, `LOCAL_WORLD_ALIGNED`, `cacc`, `computeDelassusMatrix`, `computeFrameJacobian`, `computeJointJacobians`, `efc_AR`, `efc_J`, `getConstraintJacobian`, `getConstraintsJacobian`, `getFrameAcceleration`, `getFrameClassicalAcceleration`, `getFrameJacobian`, `getJointJacobian`, `mj_applyFT`, `mj_jac`, `mj_jacBody`, `mj_jacBodyCom`, `mj_jacPointAxis`, `mj_jacSite`, `mj_mulJacTVec`, `mj_mulJacVec`, `mj_objectAcceleration`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "CalcGeneralizedForces")]
#[doc(alias = "CalcJacobianAngularVelocity")]
#[doc(alias = "CalcJacobianSpatialVelocity")]
#[doc(alias = "CalcJacobianTranslationalVelocity")]
#[doc(alias = "CalcSpatialAccelerationsFromVdot")]
#[doc(alias = "Delassus matrix")]
#[doc(alias = "EvalBodySpatialAccelerationInWorld")]
#[doc(alias = "Jacobian transpose")]
#[doc(alias = "KKT conditions")]
#[doc(alias = "LOCAL_WORLD_ALIGNED")]
#[doc(alias = "Lagrange multipliers")]
#[doc(alias = "cacc")]
#[doc(alias = "computeDelassusMatrix")]
#[doc(alias = "computeFrameJacobian")]
#[doc(alias = "computeJointJacobians")]
#[doc(alias = "constraint Jacobian")]
#[doc(alias = "contact Jacobian")]
#[doc(alias = "efc_AR")]
#[doc(alias = "efc_J")]
#[doc(alias = "effective mass")]
#[doc(alias = "end effector")]
#[doc(alias = "external force at a point")]
#[doc(alias = "frame Jacobian")]
#[doc(alias = "geometric Jacobian")]
#[doc(alias = "getConstraintJacobian")]
#[doc(alias = "getConstraintsJacobian")]
#[doc(alias = "getFrameAcceleration")]
#[doc(alias = "getFrameClassicalAcceleration")]
#[doc(alias = "getFrameJacobian")]
#[doc(alias = "getJointJacobian")]
#[doc(alias = "mj_applyFT")]
#[doc(alias = "mj_jac")]
#[doc(alias = "mj_jacBody")]
#[doc(alias = "mj_jacBodyCom")]
#[doc(alias = "mj_jacPointAxis")]
#[doc(alias = "mj_jacSite")]
#[doc(alias = "mj_mulJacTVec")]
#[doc(alias = "mj_mulJacVec")]
#[doc(alias = "mj_objectAcceleration")]
#[doc(alias = "mobility tensor")]
#[doc(alias = "operational space")]
#[doc(alias = "operational space inertia")]
#[doc(alias = "static forces")]
#[doc(alias = "task space inertia")]
#[doc(alias = "tool Jacobian")]
#[doc(alias = "tool centre point")]
#[doc(alias = "tool point")]
pub enum jacobian {}

/// `answers = kinematics;`: poses, velocities and bias accelerations of points on bodies, without dynamics.
///
/// `kinematics(&state, &inputs)` returns the motions of all bodies, `NameKinematics`. It has a method
/// for each body, which returns `None` beyond the last repetition of a repeated body. A body has
/// `input()`, `output()`, `com()`, its named points, and `at(place)` for any point: an array of the
/// coordinates in m from the input, in the body frame. A point has
///
/// | method | result |
/// |---|---|
/// | `position()`, `velocity()` | m and m/s, inertial frame |
/// | `orientation()` | the rotation from the frame of the point to the inertial frame |
/// | `angular_velocity()` | rad/s, inertial axes |
/// | `bias_acceleration()`, `angular_bias_acceleration()` | J̇ v in m/s² and rad/s²: the accelerations at v̇ = 0. Gravity is not part of them |
///
/// Other tools and textbooks: `AutoDiffXd`, `CalcBiasSpatialAcceleration`, `CalcBiasTranslationalAcceleration`, `CalcPointsPositions`, `CalcPoseInWorld`, `CalcSpatialAccelerationsFromVdot`, `CalcSpatialVelocityInWorld`, `EvalBodyPoseInWorld`, `EvalBodySpatialAccelerationInWorld`, `EvalBodySpatialVelocityInWorld`, `cacc`, `computeForwardKinematicsDerivatives`, `computeJointJacobiansTimeVariation`, `cvel`, `forwardKinematics`, `framesForwardKinematics`, `getFrameAcceleration`, `getFrameClassicalAcceleration`, `getFrameJacobianTimeVariation`, `getFrameVelocity`, `getFrameVelocityDerivatives`, `mj_jacDot`, `mj_kinematics`, `mj_local2Global`, `mj_objectAcceleration`, `mj_objectVelocity`, `oMf`, `oMi`, `site_xmat`, `site_xpos`, `updateFramePlacements`, `xipos`, `xmat`, `xpos`, `xquat`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "AutoDiffXd")]
#[doc(alias = "CalcBiasSpatialAcceleration")]
#[doc(alias = "CalcBiasTranslationalAcceleration")]
#[doc(alias = "CalcPointsPositions")]
#[doc(alias = "CalcPoseInWorld")]
#[doc(alias = "CalcSpatialAccelerationsFromVdot")]
#[doc(alias = "CalcSpatialVelocityInWorld")]
#[doc(alias = "EvalBodyPoseInWorld")]
#[doc(alias = "EvalBodySpatialAccelerationInWorld")]
#[doc(alias = "EvalBodySpatialVelocityInWorld")]
#[doc(alias = "J-dot")]
#[doc(alias = "J-dot v")]
#[doc(alias = "Jacobian rate")]
#[doc(alias = "cacc")]
#[doc(alias = "computeForwardKinematicsDerivatives")]
#[doc(alias = "computeJointJacobiansTimeVariation")]
#[doc(alias = "cvel")]
#[doc(alias = "forward kinematics")]
#[doc(alias = "forwardKinematics")]
#[doc(alias = "framesForwardKinematics")]
#[doc(alias = "getFrameAcceleration")]
#[doc(alias = "getFrameClassicalAcceleration")]
#[doc(alias = "getFrameJacobianTimeVariation")]
#[doc(alias = "getFrameVelocity")]
#[doc(alias = "getFrameVelocityDerivatives")]
#[doc(alias = "mj_jacDot")]
#[doc(alias = "mj_kinematics")]
#[doc(alias = "mj_local2Global")]
#[doc(alias = "mj_objectAcceleration")]
#[doc(alias = "mj_objectVelocity")]
#[doc(alias = "oMf")]
#[doc(alias = "oMi")]
#[doc(alias = "pose of a frame")]
#[doc(alias = "site_xmat")]
#[doc(alias = "site_xpos")]
#[doc(alias = "updateFramePlacements")]
#[doc(alias = "velocity-product acceleration")]
#[doc(alias = "xipos")]
#[doc(alias = "xmat")]
#[doc(alias = "xpos")]
#[doc(alias = "xquat")]
pub enum kinematics {}

/// `answers = linearize;`: the accelerations and their derivatives: A and B of ẋ = A x + B u.
///
/// `linearize(&state, &inputs)` returns a [`Linearization`](crate::Linearization): the accelerations,
/// M⁻¹, and the derivatives of the accelerations with respect to coordinates (along the rates), rates,
/// inputs, and all parameters. `a()` and `b()` are the matrices of ẋ = A x + B u in continuous time, with x = (δ, dv): N
/// small displacements along the rates, then N changes of the rates. The documentation of
/// `NameLinearization` lists the columns of inputs and parameters.
/// [`linear::discretize`](crate::linear::discretize) computes A and B of a step with held inputs, and
/// [`linear::lqr`](crate::linear::lqr) the gain of a regulator; both need this word. Derivatives with respect to a
/// small inertia are differences of larger numbers. They lose as many digits as the ratio to the inertia of the bodies around
/// it has; those of `push` do not. Derivatives with respect to an orientation are along the rates.
/// [`by_quaternion(number, quaternion)`](crate::Linearization::by_quaternion) returns those with respect to the four
/// components of a quaternion, N × 4, for programs whose variables they are; the page of [`ball`](mod@crate::hinges::ball) has
/// an example.
///
/// Dry friction is linearised where the state is: at rest it acts as a damper f/v, far stronger than in motion if `friction_speed`
/// is small. For a regulator of a motion, linearise a chain with little friction, or with a `friction_speed` near the expected rates.
/// In motion, the derivative f v²/√(ṡ² + v²)³ is the difference of two terms, and is accurate to a rounding error of f/|ṡ|.
///
/// Other tools and textbooks: `FirstOrderTaylorApproximation`, `Linearize`, `computeABADerivatives`, `linearisation`, `linearization`, `mjd_transitionFD`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "FirstOrderTaylorApproximation")]
#[doc(alias = "Linearize")]
#[doc(alias = "computeABADerivatives")]
#[doc(alias = "derivatives of forward dynamics")]
#[doc(alias = "linearisation")]
#[doc(alias = "linearization")]
#[doc(alias = "mjd_transitionFD")]
#[doc(alias = "state space")]
#[doc(alias = "state-space model")]
pub enum linearize {}

/// `answers = mass_matrix;`: the mass matrix M, its inverse, and the products of both with a vector.
///
/// | method | result |
/// |---|---|
/// | `mass_matrix(&state, &inputs)` | M, N × N, in kg m², kg m and kg. It includes the inertia of rotors (`armature`) |
/// | `inverse_mass_matrix(&state, &inputs)` | M⁻¹; not for closed chains |
/// | `mass_matrix_times(&state, &inputs, &x)` | M x, in O(n) operations |
/// | `inverse_mass_matrix_times(&state, &inputs, &x)` | M⁻¹ x, the accelerations that the efforts x add, in O(n) operations; not for closed chains |
///
/// Of the inputs only prescribed motions matter.
///
/// Other tools and textbooks: `CalcMassMatrix`, `CalcMassMatrixViaInverseDynamics`, `computeMinverse`, `crba`, `mj_crb`, `mj_fullM`, `mj_mulM`, `mj_solveM`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "CalcMassMatrix")]
#[doc(alias = "CalcMassMatrixViaInverseDynamics")]
#[doc(alias = "composite rigid body algorithm")]
#[doc(alias = "computeMinverse")]
#[doc(alias = "crba")]
#[doc(alias = "inertia matrix")]
#[doc(alias = "joint-space inertia")]
#[doc(alias = "mass matrix")]
#[doc(alias = "mj_crb")]
#[doc(alias = "mj_fullM")]
#[doc(alias = "mj_mulM")]
#[doc(alias = "mj_solveM")]
pub enum mass_matrix {}

/// `answers = momentum;`: mass, centre of mass, linear and angular momentum, and the centroidal momentum matrix.
///
/// | method | result |
/// |---|---|
/// | `momentum(&state, &inputs)` | mass, centre of mass, linear momentum, and angular momentum about the centre of mass, in inertial axes: a [`Momentum`](crate::Momentum). Bodies that are fixed to the ground count for the mass and its centre |
/// | `momentum_matrix(&state, &inputs)` | the centroidal momentum matrix, 6 × N: linear momentum in kg m/s, then angular momentum in kg m²/s, for rates v. Its first three rows divided by the mass are the Jacobian of the centre of mass. 3 × N in a plane, 1 × N on a line |
///
/// Other tools and textbooks: `CalcCenterOfMassPositionInWorld`, `CalcCenterOfMassTranslationalVelocityInWorld`, `CalcJacobianCenterOfMassTranslationalVelocity`, `CalcSpatialMomentumInWorldAboutPoint`, `CalcTotalMass`, `ccrba`, `centerOfMass`, `computeCentroidalMap`, `computeCentroidalMomentum`, `computeTotalMass`, `getJacobianComFromCrba`, `jacobianCenterOfMass`, `mj_angmomMat`, `mj_comPos`, `mj_getTotalmass`, `mj_jacSubtreeCom`, `mj_subtreeVel`, `subtree_angmom`, `subtree_com`, `subtree_linvel`, `subtreeangmom`, `subtreecom`, `subtreelinvel`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "CalcCenterOfMassPositionInWorld")]
#[doc(alias = "CalcCenterOfMassTranslationalVelocityInWorld")]
#[doc(alias = "CalcJacobianCenterOfMassTranslationalVelocity")]
#[doc(alias = "CalcSpatialMomentumInWorldAboutPoint")]
#[doc(alias = "CalcTotalMass")]
#[doc(alias = "ccrba")]
#[doc(alias = "center of mass")]
#[doc(alias = "center of mass Jacobian")]
#[doc(alias = "centerOfMass")]
#[doc(alias = "centre of mass")]
#[doc(alias = "centre of mass Jacobian")]
#[doc(alias = "centroidal momentum")]
#[doc(alias = "centroidal momentum matrix")]
#[doc(alias = "computeCentroidalMap")]
#[doc(alias = "computeCentroidalMomentum")]
#[doc(alias = "computeTotalMass")]
#[doc(alias = "getJacobianComFromCrba")]
#[doc(alias = "jacobianCenterOfMass")]
#[doc(alias = "mj_angmomMat")]
#[doc(alias = "mj_comPos")]
#[doc(alias = "mj_getTotalmass")]
#[doc(alias = "mj_jacSubtreeCom")]
#[doc(alias = "mj_subtreeVel")]
#[doc(alias = "subtree_angmom")]
#[doc(alias = "subtree_com")]
#[doc(alias = "subtree_linvel")]
#[doc(alias = "subtreeangmom")]
#[doc(alias = "subtreecom")]
#[doc(alias = "subtreelinvel")]
pub enum momentum {}

/// `answers = pull;`: the accelerations and the gradient of a weighted sum of them, in O(n) operations (reverse mode).
///
/// `pull(&state, &inputs, &weights)` returns the accelerations and the gradient of the scalar
/// `weights` · v̇ with respect to coordinates, rates, inputs and parameters, a `NameVariation`. The number
/// of inputs and parameters does not change the order of the cost. `pull_into(…, &mut accelerations,
/// &mut gradient)` writes both to the caller's storage.
///
/// Other tools and textbooks: `VJP`, `adjoint`, `backpropagation`, `gradient`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "VJP")]
#[doc(alias = "adjoint")]
#[doc(alias = "backpropagation")]
#[doc(alias = "gradient")]
#[doc(alias = "reverse mode")]
#[doc(alias = "vector-Jacobian product")]
pub enum pull {}

/// `answers = push;`: the accelerations and their derivative along a direction, in O(n) operations (forward mode).
///
/// `push(&state, &inputs, &direction)` returns the accelerations and their derivative along a direction,
/// a `NameVariation` with the changes of coordinates, rates, inputs and parameters. Its `coordinates` are
/// displacements along the rates: the change of a quaternion q is ½ q ∘ (0, δ), with δ in the axes of the
/// rates. `push_into(…, &mut accelerations, &mut change)` writes both vectors to the caller's storage.
///
/// Other tools and textbooks: `AutoDiffXd`, `JVP`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "AutoDiffXd")]
#[doc(alias = "JVP")]
#[doc(alias = "Jacobian-vector product")]
#[doc(alias = "directional derivative")]
#[doc(alias = "forward mode")]
#[doc(alias = "tangent model")]
pub enum push {}

/// `answers = regressor;`: the matrix Y with Y π = τ, the dynamic parameters π, and the base parameters.
///
/// | method or constant | result |
/// |---|---|
/// | `regressor(&state, &accelerations, &inputs)` | Y with Y π = the efforts of inverse dynamics, without loads, springs between bodies and limits |
/// | `dynamic_parameters()` | π: mass, first moments (mass times centre of mass) and inertia about the input of each body, then friction, damping, armature and stiffness of the hinges |
/// | `DYNAMIC_PARAMETERS` | the name of each column, such as `fore.first_moment.x` |
/// | `BASE_PARAMETERS` | the indices of independent columns, those that a motion can identify |
/// | `regressor_times_into(&state, &accelerations, &inputs, &parameters, &mut product)` | Y π in O(n) operations, for any values π |
///
/// A chain with `repeat` does not have the two constants.
///
/// Other tools and textbooks: `computeJointTorqueRegressor`, `toDynamicParameters`.
///
/// See [answers](crate::mstmm_chain#answers).
#[doc(alias = "base parameters")]
#[doc(alias = "computeJointTorqueRegressor")]
#[doc(alias = "inertial parameters")]
#[doc(alias = "parameter identification")]
#[doc(alias = "regressor matrix")]
#[doc(alias = "toDynamicParameters")]
pub enum regressor {}
