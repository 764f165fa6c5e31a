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
/// chain    := attributes visibility ['space' | 'plane' | 'line'] 'chain' Name '{' item* '}'
/// item     := 'gravity' '=' (vector | 'input') ';'
///          | 'method' '=' ('riccati' | 'transfer') ';'
///          | 'param' name ['[' count ']'] '=' number ';'
///          | 'body' Type '{' (field | point)* '}'            a type of body, before the route
///          | route ';'                                       once
///          | 'hinge' name (',' name)* '{' field* '}'         after the route
///          | 'body' name '{' field* '}'                      after the route: the first body's start
///          | 'load' name '{' field* '}'                      after the route
///          | 'spring' name '{' field* '}'                    after the route
/// route    := part ('->' part)*
/// part     := stop | 'repeat' count '{' stop ('->' stop)* '}'
/// stop     := 'ground' ['at' vector] ['turned' turn] | 'moving' name
///          | kind ['(' argument (',' argument)* ')'] name    a hinge
///          | Type [name]                                     a body
/// field    := name '=' value ';'
/// point    := 'point' name '=' vector ';'
/// argument := axis | number
/// axis     := ['-'] ('x' | 'y' | 'z') | vector
/// vector   := '[' number (',' number)* ']' [unit]            as many as the chain has dimensions
/// turn     := 'rpy' '(' roll ',' pitch ',' yaw ')' [unit] | 'quaternion' '(' w ',' x ',' y ',' z ')'
///          | number                                          an angle, where the axis is known
/// tensor   := ('diag' '(' xx ',' yy ',' zz ')' | 'tensor' '(' xx ',' yy ',' zz ',' xy ',' xz ',' yz ')')
///             [unit] 'about' ('input' | 'com')
/// number   := product (('+' | '-') product)*
/// product  := factor (('*' | '/') factor)* [unit]
/// factor   := ['-'] primary ['^' integer]
/// primary  := literal | 'PI' | parameter | rust_path | ('sqrt' | 'sin' | 'cos') '(' number ')'
///          | '(' number ')'
/// unit     := symbol ['^' integer] (('*' | '/') symbol ['^' integer])*
/// ```
///
/// Doc comments may stand before items and fields. Docs and attributes before a chain become those of
/// its type; its visibility becomes that of all its types and their methods.
///
/// # The chain
///
/// | setting | unit | if left away |
/// |---|---|---|
/// | `gravity` | m/s², inertial frame: the acceleration of free fall; or the word `input` | no gravity |
/// | `method` | `riccati` or `transfer` | the one with fewer operations, or `riccati` for more than two bodies |
///
/// `param name = number;` is a number that may change at run time, by a setter. Everything else is
/// folded into the generated code; what follows from parameters is computed when they are set, not in
/// every step. A default may use Rust constants, but no other parameter. `param name[100] = number;` has a
/// number for every time of a part that is repeated 100 times, see [below](#repeated-parts).
///
/// # Dimensions
///
/// | | moves | vectors | turns | z at a connection point |
/// |---|---|---|---|---|
/// | `space chain`, or `chain` | in space | three numbers | about any axis | 13 numbers |
/// | `plane chain` | along x and y, and turns about z | two numbers | an angle about z | 7 numbers |
/// | `line chain` | along x | a number | none | 3 numbers |
///
/// What leads out of the plane or off the line cannot be written: there are no such hinges, axes or
/// components.
///
/// ```
/// mstmm::mstmm_chain! {
///     plane chain Swing {
///         gravity = [0, -9.8] m/s^2;
///         body Rod {
///             mass = 1 kg;
///             com = [0.5, 0] m;
///             inertia = 1/12 kg*m^2 about com;
///             output = [1, 0] m turned 30 deg;
///         }
///         ground at [0, 2] m turned -90 deg -> pin a -> Rod upper -> pin b -> Rod lower;
///     }
///     line chain Train {
///         body Car { mass = 20 t; output = 15 m; }
///         Car first -> elastic a -> Car second -> elastic b -> Car last;
///         hinge a, b { stiffness = 1e6 N/m; damping = 1e4 N*s/m; }
///     }
/// }
/// ```
///
/// # Bodies
///
/// A body has an input, where the chain comes in, and an output, where it goes on. Its frame has its
/// origin at the input.
///
/// | field | unit | if left away |
/// |---|---|---|
/// | `mass` | kg | must be given |
/// | `com`: centre of mass, body frame | m | must be given; on a line at the input |
/// | `inertia`: `diag(…)` or `tensor(…)`, axes of the body frame, `about com` or `about input`; in a plane a number; on a line there is none | kg m² | must be given |
/// | `output`: the output point, body frame; `turned …` turns the frame that the next hinge sits in | m | must be given where something follows on the route |
/// | `point name`: a point with a name, body frame, at which a load or a spring may act | m | |
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
/// coincide in its zero position. From there the outboard side turns, right-handed, and shifts against
/// the inboard one: R turns outboard components into inboard ones, d is the way of the outboard origin
/// from the inboard one, along inboard axes. The module `mstmm::hinges` has a page for each kind, with a
/// picture, the equations and an example.
///
/// | kind | lets free | coordinates | R and d | rates, each with an effort |
/// |---|---|---|---|---|
/// | `weld` | nothing | – | 1, 0 | – |
/// | `pin(axis)` | a turn | the angle θ | Rot(θ), 0 | θ̇: torque |
/// | `slider(axis)` | a shift | the way x | 1, x along the axis | ẋ: force |
/// | `screw(axis, pitch)` | a turn that shifts | the angle θ | Rot(θ), pitch · θ along the axis | θ̇: torque |
/// | `cylindrical(axis)` | a shift and a turn | x, θ | Rot(θ), x along the axis | ẋ, θ̇: force, torque |
/// | `universal(a, b)` | two turns | α, β | Rot(a, α) Rot(b, β), 0 | α̇, β̇: torques |
/// | `ball` | all turns | a unit quaternion | R of it, 0 | angular velocity: torque, outboard frame |
/// | `planar(normal)` | shifts in a plane, a turn | u, w, θ | Rot(θ), u and w along the axes after the normal: x, y for z | u̇, ẇ, θ̇: forces, torque |
/// | `floating` | everything | d, a unit quaternion | R of it, d | ḋ, inboard axes, and angular velocity, outboard frame: force at the outboard origin, torque |
/// | `elastic` | everything | Δ, θ₁, θ₂, θ₃ | A_z(θ₃) A_y(θ₂) A_x(θ₁), A_z(θ₃) Δ | as `floating` |
///
/// An axis has any length but zero and the same components on both sides. It is z where none is written,
/// and `universal` has x and y. A pitch is a length for a turn: `screw(z, 5 mm/rev)`. An elastic hinge is
/// meant for springs: its coordinates are the paper's, Δ along axes that turn with θ₃, which may be any
/// number of turns, and |θ₂| stays below a right angle.
///
/// | in a chain of | there are |
/// |---|---|
/// | plane | `weld`, `pin` about z, `slider(axis)` along x where none is written, `planar` and `floating`, which are the same, and `elastic` with Δ, θ |
/// | line | `weld`, `slider` along x, and `floating` and `elastic`, which are sliders |
///
/// What can be said of hinges after the route goes by their shifts and their turns. Of a hinge with both,
/// the fields of the turns begin with `turning_`, but for `start_rate` and `torque`:
///
/// | field | of shifts | of turns | if left away |
/// |---|---|---|---|
/// | `start`: the coordinates at first | m | rad | zero position |
/// | `rest`: the coordinates at which springs are at rest | m | rad | zero position |
/// | `start_velocity`, `start_rate` | m/s | rad/s | at rest |
/// | `stiffness` of a spring | N/m | N m/rad | none |
/// | `damping` | N s/m | N m s/rad | none |
/// | `armature`: inertia of a rotor that turns with the hinge | kg | kg m² | none |
/// | `friction`: dry friction at speed; it needs `friction_speed` | N | N m | none |
/// | `friction_speed`: the speed that makes friction smooth | m/s | rad/s | |
/// | `limits`: `[lowest, highest]`, each coordinate's; they need `limit_stiffness` | m | rad | none |
/// | `limit_stiffness`, `limit_damping`: beyond the limits | N/m, N s/m | N m/rad, N m s/rad | no damping |
/// | `force`, `torque` of a motor: constant, or the word `input` | N | N m | none |
/// | `motion = input`: the whole hinge moves as it is told at each step | | | |
///
/// A single freedom takes a number; two or three take a vector, or for springs, dampers, rotors and
/// friction one number for all. `start` and `rest` say both: of a cylindrical hinge `1 m turned 30 deg`, of
/// a planar one `[1, 2] m turned 30 deg`, of a floating one `[1, 2, 3] m turned rpy(…)` or `quaternion(…)`,
/// of an elastic one `[1, 2, 3] m turned rpy(θ₁, θ₂, θ₃)`; of a ball only `rpy(…)` or `quaternion(…)`.
///
/// With the strains s, the coordinates less those at rest, a hinge has the efforts −k s of springs, −c ṡ of
/// dampers, −f ṡ/√(ṡ² + v²) of friction, and beyond a limit a spring back and a damper. For the turns of a
/// ball and of a floating hinge s is the rotation vector from rest, outboard axes, the shorter way, and ṡ
/// the angular velocity; they share one stiffness, one damping and so on, and their `limits` are one angle,
/// the largest from rest. A positive motor drives the rate up: it acts on the outboard side, its opposite
/// on the inboard one.
///
/// A hinge with `motion = input` is no part of the state. What its drive has to supply is reported as its
/// effort.
///
/// # Ends
///
/// | the route | |
/// |---|---|
/// | begins with `ground` | is held there |
/// | begins with `moving name` | is held by a frame that moves as it is told at each step |
/// | begins with a body | that body's input is free |
///
/// It ends in the same way. `ground at [x, y, z] m turned …` puts the frame on the ground elsewhere than in
/// the inertial origin. What is held at both ends is a closed chain; all hinges have coordinates there too,
/// and where closure leaves reactions open they are the smallest ones.
///
/// A chain with a body at both ends floats: it has all the freedoms of its dimension besides, which go by
/// the name of its first body. After the route `body name { … }` says how that one starts:
///
/// | field | unit | if left away |
/// |---|---|---|
/// | `start`: position of its input, `turned …` | m | at the inertial origin, not turned |
/// | `start_velocity` of its input, inertial frame | m/s | at rest |
/// | `start_rate`: angular velocity, body frame | rad/s | at rest |
///
/// # Loads and springs to the ground
///
/// | field of a `load` | unit | if left away |
/// |---|---|---|
/// | `on`: the body | | must be given |
/// | `at`: where the force acts: `input`, `output`, `com`, a named point, or a vector, body frame | m | `com` |
/// | `force`, a vector, or the word `input` | N | none, but one of both must be given |
/// | `torque`, in a plane a number, or the word `input`; besides the moment of the force | N m | none |
/// | `axes`: `inertial` or `body` | | `inertial` |
///
/// | field of a `spring` | unit | if left away |
/// |---|---|---|
/// | `on`, `at` | | as for loads |
/// | `to`: the point on the ground, inertial frame | m | must be given |
/// | `stiffness` | N/m | must be given |
/// | `damping`, along the spring | N s/m | none |
/// | `length` without load | m | 0 |
///
/// ```
/// # use mstmm::prelude::*;
/// mstmm_chain! {
///     chain Mast {
///         body Rod {
///             mass = 1 kg;
///             com = [0.5, 0, 0] m;
///             inertia = diag(0.01, 1/12, 1/12) kg*m^2 about com;
///             point tip = [1, 0.1, 0] m;
///         }
///         moving deck -> ball joint -> Rod rod;
///         load wind { on = rod; force = input; }
///         spring rope { on = rod; at = tip; to = [0, 3, 0] m; stiffness = 500 N/m; length = 2 m; }
///     }
/// }
///
/// let inputs = MastInputs::<f64> {
///     wind_force: [0.0, 20.0, 0.0].into(),
///     deck: mstmm::HingeMotion {
///         state: mstmm::FloatingState::new([0.0; 3], [1.0, 0.0, 0.0, 0.0], [0.0; 3], [0.1, 0.0, 0.0]),
///         acceleration: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0].into(),
///     },
/// };
/// let mast = Mast::new();
/// assert!(mast.accelerations(&mast.initial_state(), &inputs).is_ok());
/// ```
///
/// # Repeated parts
///
/// `repeat 100 { pin joint -> Rod rod }` on the route is the same as its contents a hundred times in a row.
/// They begin with a hinge and end with a body, so that they follow on each other. What is said of a hinge
/// in it, of a load or of a spring on a body in it holds for each time. The length of the generated code
/// does not depend on the count.
///
/// ```
/// use mstmm::prelude::*;
///
/// mstmm_chain! {
///     plane chain Rope {
///         gravity = [0, -9.8] m/s^2;
///         param knot[100] = 0 kg; // one for each rod
///         body Rod {
///             mass = 10 g + knot;
///             com = [5, 0] mm;
///             output = [10, 0] mm;
///             inertia = 1e-6 kg*m^2 about com;
///         }
///         body Weight { mass = 1 kg; com = [0, -5] cm; inertia = 1e-3 kg*m^2 about com; }
///
///         ground -> repeat 100 { pin joint -> Rod rod } -> pin hook -> Weight weight;
///
///         hinge joint { damping = 1e-4 N*m*s/rad; }
///     }
/// }
///
/// let mut rope = Rope::<f64>::new();
/// rope.set_knot(|index| if index == 50 { 0.02 } else { 0.0 })?;
/// let mut state = rope.initial_state();
/// state.set_each_joint(|index| mstmm::PinState::new(1e-3 * index as f64, 0.0));
/// let mut at = rope.workspace();
/// rope.solve_into(&state, &rope.no_inputs(), &mut at)?;
/// let middle = at.rod(50).ok_or("there are 100 rods")?;
/// println!("{:?} N", middle.input().force());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A state has `joint(index)`, `joint_mut(index)`, which are `None` behind the last time, and
/// `set_each_joint(|index| …)`; a workspace has `joint(index)` and `rod(index)`. Inputs of repeated hinges
/// and bodies are arrays. The step keeps a few numbers for each time on the stack, and so do the state and
/// the workspace: for tens of thousands of bodies, run it in a thread with a stack to match.
///
/// A chain that is held at its end alone cannot have repeated parts: it can be written the other way round.
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
/// Hinges, bodies, moving ends, parameters, loads and springs share one set of names, which become
/// methods and fields: none may be a word of Rust, the word `gravity`, or a method that every state or
/// workspace has, such as `q`, `t`, `points` or `energy`. The generated code calls `::mstmm`, so the
/// dependency has to keep its name.
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
/// | z at a connection point | acceleration, angular acceleration, moment m and force q, all in the inertial frame; in a plane ẍ, ÿ, Ω̇z, mz, qx, qy, on a line ẍ, qx; then 1 |
/// | force on a body | +q at its input end, −q at its output end |
/// | torque on a body | −m at its input end, +m at its output end |
/// | loads and springs | act on the body between its ends, as gravity does |
/// | potential energy | of constant gravity, of springs and of limits |
///
/// # What is generated
///
/// For a chain `Name` these types stand beside each other, where the macro is called:
///
/// | type | |
/// |---|---|
/// | `Name<T>` | the chain: parameters and what follows from them |
/// | `NameState<T>` | coordinates `q`, rates `v` and time `t`; hinges lie in the order written, without those that move as they are told |
/// | `NameInputs<T>` | what is given at each step |
/// | `NameParameters<T>` | the parameters' values, a method each |
/// | `NameWorkspace<T>` | results of `solve_into` |
///
/// | method of `Name` | |
/// |---|---|
/// | `new()` | as described, parameters at their defaults |
/// | `parameters()`, `set_name(value)` | SI units; a setter refuses what is not finite, or leaves something derived from it not finite, a mass not positive or a stiffness, damping or the like negative; of a parameter with a number for every time it takes `\|index\| value` |
/// | `initial_state()`, `no_inputs()`, `workspace()` | to start with; inputs are zero |
/// | `accelerations(&state, &inputs)`, `accelerations_into(…, &mut accelerations)` | accelerations alone, the fast path |
/// | `solve_into(&state, &inputs, &mut workspace)` | accelerations, efforts, energies and everything at every connection point |
/// | `assemble(&mut state, &inputs)` | of a closed chain: moves to coordinates and rates nearby with which both ends fit |
/// | `energy(&state)` | kinetic and potential energy, the latter zero with all centres of mass at the inertial origin and all springs at rest |
///
/// | field of the inputs | for | |
/// |---|---|---|
/// | `gravity` | `gravity = input` | a vector |
/// | hinge | `force = input`, `torque = input` | a number, or a vector of its input efforts in the order of its rates |
/// | hinge or moving end | `motion = input`, `moving` | `HingeMotion { state, acceleration }`: coordinates and rates such as a `PinState`, of a moving end a `FloatingState`, in a plane a `PlanarState`, on a line a `SliderState`; the derivatives of the rates, a number or a vector |
/// | `load_force`, `load_torque` | `force = input`, `torque = input` of a load | a vector; in a plane the torque is a number, on a line the force |
///
/// For a hinge or a body inside `repeat` these are arrays, an entry for each time. A vector on a line is a
/// number everywhere.
///
/// A state has `hinge()` and `hinge_mut()` for every hinge but welds and those that move as they are
/// told, and the same under the first body's name where the chain floats: `angle`, `orientation`,
/// `position`, `displacement`, `velocity`, `rate` and the like, to read and to set. A workspace has a method for every hinge and body, with the points `input()` and
/// `output()`, and for hinges `acceleration()` and `effort()`; besides `accelerations()`, `points()`,
/// `kinetic_energy()` and `potential_energy()`, and `closure()` for a closed chain. Points know their
/// position, orientation, velocity, angular velocity and z. Repeated hinges and bodies take an index.
///
/// `Name` implements `mstmm::Chain`, which the integrators step (`mstmm::integrate` says which to take),
/// and `mstmm::GeneratedChain`, for code that works with any chain. After every step integrators put a
/// closed chain back onto its closure. The documentation of the generated items tells how many operations
/// each function costs.
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
