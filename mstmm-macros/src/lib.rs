//! The macro [`mstmm_chain!`]; use it through the crate `mstmm`.

use proc_macro::TokenStream;

/// Turns a written chain of bodies and hinges into a type that computes its dynamics.
///
/// A chain is written as one would draw it: the bodies with their masses, then the route from the
/// ground over hinges and bodies to the free end, then what is to be said of each hinge. It is
/// checked while the crate compiles. What comes out are plain Rust types whose functions are
/// straight-line arithmetic on fixed-size arrays, without heap, panics or `unsafe`, for `f32`, `f64`
/// and any other `mstmm::Scalar`.
///
/// ```
/// # #![deny(warnings, missing_docs)]
/// # //! The complete example.
/// use mstmm::prelude::*;
///
/// mstmm_chain! {
///     /// Three unit cubes on ball-and-socket hinges, a motor in the first.
///     pub chain Pendulum {
///         gravity = [0, -9.8, 0] m/s^2;
///         param payload = 500 g;
///
///         body Cube {
///             mass = 1 kg;
///             com = [0.5, 0, 0] m;
///             output = [1, 0, 0] m;
///             inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
///         }
///         body Tip {
///             mass = 1 kg + payload;
///             com = [500, 0, 0] mm;
///             inertia = diag(1/6, 1/6, 1/6) kg*m^2 about com;
///         }
///
///         ground -> ball shoulder -> Cube upper
///                -> pin(z) elbow  -> Cube middle
///                -> ball wrist    -> Tip;
///
///         hinge shoulder { torque = input; }
///         hinge elbow { start = -90 deg; start_rate = 2 rpm; }
///     }
/// }
///
/// fn main() -> Result<(), mstmm::Error> {
///     let mut chain = Pendulum::<f64>::new();
///     chain.set_payload(0.25)?; // kg
///     let mut state = chain.initial_state();
///     state.wrist_mut().set_bryan_angles([0.0, 0.1, 0.0]);
///
///     let mut rk4 = Rk4::new(1e-3);
///     for _ in 0..100 {
///         rk4.step(&chain, &mut state, |_time, state| PendulumInputs {
///             shoulder: state.shoulder().rate() * -0.5, // a damper
///         })?;
///     }
///     let mut at = chain.workspace();
///     chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
///     println!("{} rad/s^2", at.elbow().acceleration());
///     println!("{} N", at.tip().input().force()); // inertial frame
///     Ok(())
/// }
/// ```
///
/// # What can be written
///
/// One call holds one chain or several. In this grammar `[…]` may be left away and `…*` stands any
/// number of times:
///
/// ```text
/// chain   := attributes visibility ['space'] 'chain' Name '{' item* '}'
/// item    := 'gravity' '=' vector ';'
///          | 'method' '=' ('riccati' | 'transfer') ';'
///          | 'param' name '=' number ';'
///          | 'body' Type '{' field* '}'                     a type of body, before the route
///          | route ';'                                      once
///          | 'hinge' name (',' name)* '{' field* '}'        after the route
///          | 'body' name '{' field* '}'                     after the route: the first body's start
/// route   := stop ('->' stop)*
/// stop    := 'ground' ['at' vector] ['turned' turn]
///          | 'pin' ['(' axis ')'] name | 'ball' name | 'weld' name
///          | Type [name]
/// field   := name '=' value ';'
/// axis    := ['-'] ('x' | 'y' | 'z') | vector
/// vector  := '[' number ',' number ',' number ']' [unit]
/// turn    := 'rpy' '(' roll ',' pitch ',' yaw ')' [unit] | 'quaternion' '(' w ',' x ',' y ',' z ')'
/// tensor  := ('diag' '(' xx ',' yy ',' zz ')' | 'tensor' '(' xx ',' yy ',' zz ',' xy ',' xz ',' yz ')')
///            [unit] 'about' ('input' | 'com')
/// number  := product (('+' | '-') product)*
/// product := factor (('*' | '/') factor)* [unit]
/// factor  := ['-'] primary ['^' integer]
/// primary := literal | 'PI' | parameter | rust_path | ('sqrt' | 'sin' | 'cos') '(' number ')'
///          | '(' number ')'
/// unit    := symbol ['^' integer] (('*' | '/') symbol ['^' integer])*
/// ```
///
/// Doc comments may stand before items and fields. Docs and attributes before a chain become those of
/// its type; its visibility becomes that of all its types and their methods.
///
/// # The chain
///
/// | setting | unit | if left away |
/// |---|---|---|
/// | `gravity` | m/s², inertial frame: the acceleration of free fall | no gravity |
/// | `method` | `riccati` or `transfer` | the one with fewer operations, or `riccati` for more than two bodies |
///
/// `param name = number;` is a number that may change at run time, by a setter. Everything else is
/// folded into the generated code. A default may use Rust constants, but no other parameter.
///
/// # Bodies
///
/// A body has an input, where the chain comes in, and an output, where it goes on. Its frame has its
/// origin at the input.
///
/// | field | unit | if left away |
/// |---|---|---|
/// | `mass` | kg | must be given |
/// | `com`: centre of mass, body frame | m | must be given |
/// | `inertia`: `diag(…)` or `tensor(…)`, axes of the body frame, `about com` or `about input` | kg m² | must be given |
/// | `output`: the output point, body frame; `turned …` turns the frame that the next hinge sits in | m | must be given where something follows on the route |
///
/// The products of inertia xy, xz and yz are the tensor's own entries, xy = −∫ x y dm. Masses must be
/// positive, and the inertia that of a body: no principal moment more than the sum of the other two.
///
/// On the route a body is called by its type and a name; without one it gets its type's in snake case,
/// `UpperArm` is `upper_arm`.
///
/// # Hinges
///
/// A hinge joins two frames, its inboard side and its outboard side, in the order of the route. Both
/// coincide in its zero position; then the outboard side turns against the inboard one, right-handed.
///
/// | kind | lets free | coordinates | rates |
/// |---|---|---|---|
/// | `pin(axis)` | a turn about an axis, z if none is written | the angle | its derivative |
/// | `ball` | all turns | a unit quaternion | the angular velocity, outboard frame |
/// | `weld` | nothing | – | – |
///
/// The axis has any length but zero and the same components on both sides. What can be said of hinges
/// after the route:
///
/// | field | of a pin | of a ball | if left away |
/// |---|---|---|---|
/// | `start` | angle, rad | `rpy(…)` or `quaternion(…)` | zero position |
/// | `start_rate` | rad/s | vector, rad/s, outboard frame | at rest |
/// | `torque` | N m, constant, or the word `input` | vector, N m, outboard frame, or the word `input` | none |
///
/// A positive torque drives the rate up: it acts on the outboard side, its opposite on the inboard one.
///
/// # Ends
///
/// | the route | |
/// |---|---|
/// | begins with `ground` | is held there; the far end is free |
/// | ends with `ground` | is held there; the first body's input is free |
/// | begins and ends with a body | floats: it is free of the ground |
///
/// `ground at [x, y, z] m turned …` puts the frame on the ground elsewhere than in the inertial origin.
/// A floating chain has six more degrees of freedom, which go by the name of its first body. After the
/// route `body name { … }` says how that one starts:
///
/// | field | unit | if left away |
/// |---|---|---|
/// | `start`: position of its input, `turned …` | m | at the inertial origin, not turned |
/// | `start_velocity` of its input, inertial frame | m/s | at rest |
/// | `start_rate`: angular velocity, body frame | rad/s | at rest |
///
/// # Numbers and units
///
/// A unit closes a product, and terms add: `1/6 kg + 250 g`, `(2 kg) * 3`, `sqrt(2) * (1 m)`. In a unit
/// `m/s^2` is m/(s²). `1/6` is a real number. A unit behind a vector, a turn or a tensor is that of all
/// its numbers; otherwise each may have its own.
///
/// Units may be left away: a number without one is in SI units, an angle in radians. Where one is
/// written it is checked. In a sum with units every term needs one, but for 0 and Rust constants. An
/// angle counts as a plain number, so `N*m/rad` is a torque.
///
/// | | symbols |
/// |---|---|
/// | with the prefixes n, u, m, c, d, k, M | `m`, `g`, `s`, `N`, `J`, `W`, `Pa`, `Hz`, `rad` |
/// | without | `deg`, `rev`, `rpm`, `min`, `h`, `t` |
///
/// `g` is gram, and `Hz` is no angular velocity: `rev/s` and `rad/s` say which is meant.
///
/// Rust constants of type `f64` in SI units may stand in numbers: by a path such as `consts::MASS`, or
/// by a single name that begins with a capital letter. They are evaluated in `new`; one in a function
/// serves a chain in that function. Constants, statics and unit structs with lower-case names in scope
/// can clash with the generated variables.
///
/// # Names
///
/// Hinges, bodies and parameters share one set of names, which become methods: none may be a word of
/// Rust or a method that every state or workspace has, such as `q`, `t`, `points` or `energy`. The
/// generated code calls `::mstmm`, so the dependency has to keep its name.
///
/// # Conventions
///
/// | | |
/// |---|---|
/// | units | SI |
/// | frames | right-handed; the inertial frame unless said otherwise |
/// | `rpy(roll, pitch, yaw)` | Bryan angles: A = A_z(yaw) A_y(pitch) A_x(roll), turns about fixed axes in the order x, y, z |
/// | quaternions | w, x, y, z, of any length in a description; they turn components of the body, outboard or inner frame into those of the inertial, inboard or outer one |
/// | `gravity` | the acceleration of free fall: `[0, -9.8, 0] m/s^2` if y points up |
/// | accelerations | the true ones: a body at rest under gravity has none |
/// | z at a connection point | acceleration, angular acceleration, moment m and force q, all in the inertial frame |
/// | force on a body | +q at its input end, −q at its output end |
/// | torque on a body | −m at its input end, +m at its output end |
///
/// # What is generated
///
/// For a chain `Name` these types stand beside each other, where the macro is called:
///
/// | type | |
/// |---|---|
/// | `Name<T>` | the chain: parameters and what follows from them |
/// | `NameState<T>` | coordinates `q`, rates `v` and time `t`; hinges lie in the order written |
/// | `NameInputs<T>` | a field for every hinge with `torque = input`, a number or a vector |
/// | `NameParameters<T>` | the parameters' values, a method each |
/// | `NameWorkspace<T>` | results of `solve_into` |
///
/// | method of `Name` | |
/// |---|---|
/// | `new()` | as described, parameters at their defaults |
/// | `parameters()`, `set_name(value)` | SI units; a setter refuses what is not finite, or leaves something derived from it not finite or a mass not positive |
/// | `initial_state()`, `no_inputs()`, `workspace()` | to start with; inputs are zero |
/// | `accelerations(&state, &inputs)`, `accelerations_into(…, &mut accelerations)` | accelerations alone, the fast path |
/// | `solve_into(&state, &inputs, &mut workspace)` | accelerations, efforts, energies and everything at every connection point |
/// | `energy(&state)` | kinetic and potential energy, the latter zero with all centres of mass at the inertial origin |
///
/// A state has `hinge()` and `hinge_mut()` for every hinge but welds, and the same under the first
/// body's name where the chain floats: `angle`, `orientation`, `position`, `velocity` and `rate`, to
/// read and to set. A workspace has a method for every hinge and body, with the points `input()` and
/// `output()`, and for hinges `acceleration()` and `effort()`; besides `accelerations()`, `points()`,
/// `kinetic_energy()` and `potential_energy()`. Points know their position, orientation, velocity,
/// angular velocity and z.
///
/// `Name` implements `mstmm::Chain`, which the integrators `Rk4` and `Dopri5` step, and
/// `mstmm::GeneratedChain`, for code that works with any chain. The documentation of the generated
/// items tells how many operations each function costs.
///
/// # Errors
///
/// All mistakes in a description are reported in one build, each at the place to edit; parameters are
/// judged by their defaults. Of what hangs on Rust constants only a mass is checked, while they are
/// evaluated. At run time `accelerations`,
/// `solve_into` and steps return `Error::Singular`, with the hinge beyond which nothing has inertia, or
/// `Error::NotFinite` for a state or inputs that are not finite; setters return `Error::Parameter`.
/// What was there before is kept then.
///
/// ```compile_fail
/// mstmm::mstmm_chain! {
///     chain Pendulum {
///         body Rod { mass = 2 m; com = [0.5, 0, 0] m; inertia = diag(0, 1/6, 1/6) about com; }
///         ground -> pin joint -> Rod rod; // expected a mass, found a length
///     }
/// }
/// ```
#[proc_macro]
pub fn mstmm_chain(input: TokenStream) -> TokenStream {
    match mstmm_codegen::compile(input.into()) {
        Ok(items) => items.into(),
        Err(errors) => errors.into_compile_error().into(),
    }
}
