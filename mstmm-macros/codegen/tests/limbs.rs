//! Limbs of one shape side by side: the packed form of a function has the results of its straight form, bit for bit except
//! for the sign of zeros.

mod common;

use common::given::Given;
use common::interpreter::{Failed, run};
use mstmm_codegen::compile::{Compiled, compile, compile_packed};
use mstmm_codegen::model::{self, Answer, Layout};
use mstmm_codegen::program::{Argument, ArrayRole, PACK, Procedure, Statement};
use mstmm_reference::Random;

/// Answers that are generated on request.
const ANSWERS: &str = "answers = [basic, bias_efforts, kinematics, momentum, regressor, derivatives, linearize, push, pull];";

fn compiled(text: &str) -> Compiled {
    let chains = model_of(text);
    let (chain, findings) = &chains[0];
    let layout = Layout::of(chain);
    let straight = compile(chain, findings, &layout);
    assert!(straight.functions.iter().all(|function| function.packed.is_none()));
    compile_packed(chain, findings, &layout)
}

fn model_of(text: &str) -> Vec<(model::Chain, mstmm_codegen::examine::Findings)> {
    let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
    mstmm_codegen::read_and_examine(tokens).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Returns the numbers of operations on scalars and on packs.
fn operations(procedure: &Procedure) -> [usize; 2] {
    let mut is_pack = vec![false; procedure.values.count()];
    let mut counts = [0; 2];
    for statement in procedure.sections().flat_map(|section| &section.statements) {
        match statement {
            Statement::Let(value, _) => {
                let packed = statement
                    .operands()
                    .any(|operand| operand.value().is_some_and(|value| is_pack[value.index()]));
                is_pack[value.index()] = packed;
                counts[usize::from(packed)] += 1;
            }
            Statement::Pack { pack, .. } => is_pack[pack.index()] = true,
            Statement::Lane { .. } | Statement::SinCos { .. } => {}
        }
    }
    counts
}

/// Runs both forms of all functions that have two, at random arguments, and compares all results. Returns the number of
/// such functions.
fn compare(random: &mut Random, text: &str) -> usize {
    let compiled = compiled(text);
    let mut given: Given<f64> = Given::zeros(&compiled);
    given.fill(|argument, _| match argument {
        Argument::Parameter(_) | Argument::Step => random.between(0.1, 1.0),
        _ => random.between(-2.0, 2.0),
    });
    given.normalize();
    let mut count = 0;
    for function in &compiled.functions {
        let Some(packed) = &function.packed else { continue };
        let both = [&function.procedure, packed].map(|procedure| results(procedure, &given));
        assert!(both[0] == both[1], "{} differs\n{text}", function.name());
        count += 1;
    }
    count
}

/// Returns all results of a procedure. Equal numbers have the same bits, unless both are zero.
fn results(procedure: &Procedure, given: &Given<f64>) -> Result<Vec<f64>, Failed> {
    let mut arrays = given.arrays.clone();
    run(procedure, &mut arrays)?;
    let ids = procedure.arrays.iter().filter_map(|array| match array.role {
        ArrayRole::Result(id) => Some(id),
        _ => None,
    });
    Ok(ids.flat_map(|id| arrays.result(id)).collect())
}

/// Returns the text of a robot: a body on the ground or floating, with limbs of one to three hinges that are mirrored.
fn robot(random: &mut Random) -> String {
    let (count, hinges) = *random.choose(&[(2, 3), (3, 2), (4, 2), (5, 1), (6, 1), (7, 1)]);
    let mut part = String::new();
    let mut route = Vec::new();
    for hinge in 0..hinges {
        let kind = *random.choose(&[
            "pin(z)",
            "pin(x)",
            "pin([0.6, 0, 0.8])",
            "slider(y)",
            "universal(x, y)",
            "gimbal",
            "ball",
            "cylindrical(z)",
        ]);
        let mut number = |low, high| random.rounded(low, high, 3);
        part += &format!(
            "body B{hinge} {{ mass = {} kg; com = [{}, side*front*{}, side*{}] m;
               inertia = tensor({}, {}, {}, side*{}, front*{}, {}) kg*m^2 about com;
               output = [{}, front*{}, 0] m turned rpy(side*90, 0, {}) deg; }}\n",
            number(0.5, 2.0),
            number(-0.2, 0.2),
            number(-0.2, 0.2),
            number(-0.2, 0.2),
            number(0.5, 0.6),
            number(0.5, 0.6),
            number(0.5, 0.6),
            number(-0.1, 0.1),
            number(-0.1, 0.1),
            number(-0.1, 0.1),
            number(0.1, 0.5),
            number(-0.1, 0.1),
            number(0.0, 90.0),
        );
        route.push(format!("{kind} h{hinge} -> B{hinge} b{hinge}"));
        if kind.starts_with("pin") && random.chance(0.7) {
            part += &format!("hinge h{hinge} {{ torque = input; damping = damping; }}\n");
        }
    }
    if random.chance(0.5) {
        part += "load push { on = b0.output; force = input; }\n";
    }
    let base = if random.chance(0.5) { "" } else { "ground -> universal(y, z) neck -> " };
    let points: Vec<String> = (0..count)
        .map(|limb| {
            let [x, y, z] = [0; 3].map(|_| random.rounded(-0.5, 0.5, 2));
            format!("point p{limb} = [{x}, {y}, {z}] m turned rpy({}, 90, 0) deg;", 90 * (limb % 4))
        })
        .collect();
    let limbs: Vec<String> = (0..count)
        .map(|limb| {
            let [side, front] = [0; 2].map(|_| if random.chance(0.5) { 1 } else { -1 });
            format!("trunk.p{limb} -> Limb({side}, {front}) l{limb};\n")
        })
        .collect();
    format!(
        "pub chain Robot {{ gravity = [0, 0, -9.81] m/s^2; {ANSWERS}
           param damping = 0.1 N*m*s/rad;
           body Trunk {{ mass = 5 kg; com = [0.1, 0.02, 0.03] m;
             inertia = diag(0.3, 0.4, 0.5) kg*m^2 about com; {} }}
           part Limb(side, front) {{ {part} {}; }}
           {base}Trunk trunk;
           {} }}",
        points.join(" "),
        route.join(" -> "),
        limbs.concat(),
    )
}

#[test]
fn both_forms_of_random_robots_have_the_same_results() {
    let first = std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    let (mut functions, mut robots) = (0, 0);
    for seed in first..first + 12 {
        println!("seed {seed}");
        let mut random = Random::new(seed);
        let text = robot(&mut random);
        let found = compare(&mut random, &text);
        functions += found;
        robots += usize::from(found > 0);
    }
    println!("{functions} functions of {robots} robots have two forms");
    assert!(robots >= 10 && functions > 80, "few robots have limbs side by side");
}

/// A quadruped whose legs are mirrored from left to right and from front to back.
const QUADRUPED: &str = "pub chain Quadruped { gravity = [0, 0, -9.81] m/s^2;
    body Trunk { mass = 60 kg; com = [0.05, 0.02, 0] m; inertia = tensor(1.5, 8.5, 9.1, 0.02, -0.2, 0) kg*m^2 about com;
      point lf = [0.37, 0.2, 0] m turned rpy(0, 90, 180) deg; point rf = [0.37, -0.2, 0] m turned rpy(0, 90, 0) deg;
      point lh = [-0.37, 0.2, 0] m turned rpy(0, 90, 180) deg; point rh = [-0.37, -0.2, 0] m turned rpy(0, 90, 0) deg; }
    part Leg(side, front) {
      body Hip { mass = 2.9 kg; com = [0.04, 0, side*front*0.17] m; inertia = diag(0.05, 0.05, 0.01) kg*m^2 about com;
        output = [0.08, 0, 0] m turned rpy(side*90, 0, 0) deg; }
      body Thigh { mass = 2.6 kg; com = [0.15, -front*0.03, 0] m; inertia = diag(0.01, 0.03, 0.03) kg*m^2 about com;
        output = [0.35, 0, 0] m; }
      body Shank { mass = 0.9 kg; com = [0.13, 0, 0] m; inertia = diag(0.001, 0.01, 0.01) kg*m^2 about com; }
      pin(z) haa -> Hip hip -> pin(z) hfe -> Thigh thigh -> pin(z) kfe -> Shank shank;
      hinge haa, hfe, kfe { torque = input; } }
    Trunk trunk; trunk.lf -> Leg(1, 1) lf; trunk.rf -> Leg(-1, 1) rf; trunk.lh -> Leg(1, -1) lh; trunk.rh -> Leg(-1, -1) rh; }";

/// The legs of HyQ, which are mirrored, need 1042 operations instead of 1971. Here most of the hips' products are zero.
#[test]
fn legs_that_are_mirrored_are_side_by_side() {
    let compiled = compiled(QUADRUPED);
    let accelerations = compiled.function(Answer::Accelerations);
    let [straight, none] = operations(&accelerations.procedure);
    assert_eq!(none, 0);
    let packed = accelerations.packed.as_ref().expect("four legs");
    let [scalars, packs] = operations(packed);
    println!("{straight} operations, or {scalars} and {packs} on packs");
    assert!(10 * (scalars + packs) < 6 * straight, "{scalars} + {packs} of {straight}");
    // Every operation is there: those of the legs once for up to four.
    assert!(scalars + PACK * packs >= straight);
    compare(&mut Random::new(0), QUADRUPED);
}

#[test]
fn chains_and_repeated_parts_have_one_form() {
    let chain = "pub chain Chain { body A { mass = 1 kg; com = [0, 0, 1] m; inertia = diag(1, 1, 1) kg*m^2 about com;
        output = [0, 0, 2] m; } ground -> ball a -> A a1 -> ball b -> A a2 -> ball c -> A a3; }";
    let repeated = "pub chain Rope { body A { mass = 1 kg; com = [0, 0, 1] m; inertia = diag(1, 1, 1) kg*m^2 about com;
        output = [0, 0, 2] m; } ground -> repeat 5 { ball a -> A a1 }; }";
    for text in [chain, repeated] {
        let compiled = compiled(text);
        assert!(compiled.functions.iter().all(|function| function.packed.is_none()), "{text}");
    }
}

/// Values that are not finite are found in both forms.
#[test]
fn both_forms_fail_alike() {
    let compiled = compiled(QUADRUPED);
    let accelerations = compiled.function(Answer::Accelerations);
    let packed = accelerations.packed.as_ref().expect("four legs");
    for broken in 0..19 {
        let mut given: Given<f64> = Given::zeros(&compiled);
        given.fill(|_, entry| 0.1 * entry as f64);
        given.normalize();
        let coordinates =
            given.arrays.arguments.get_mut(&Argument::Coordinates).expect("coordinates");
        coordinates[broken] = f64::NAN;
        for procedure in [&accelerations.procedure, packed] {
            assert_eq!(results(procedure, &given), Err(Failed::NotFinite), "coordinate {broken}");
        }
    }
}

/// The packing of long limbs needs no deep stack, also if they differ.
#[test]
fn long_limbs_are_packed() {
    let limb = |name: &str, sign: &str| -> String {
        let hinge = |k: usize| {
            let axis = ["x", "y", "z"][(k * k) % 3];
            format!("pin({axis}) {name}h{k} -> Link {name}b{k}")
        };
        let hinges: Vec<String> = (0..40).map(hinge).collect();
        format!(
            "trunk.{name} -> {};\nhinge {name}h3 {{ damping = 0.1; stiffness = {sign}; }}\n",
            hinges.join(" -> ")
        )
    };
    let text = format!(
        "pub chain Octopus {{ gravity = [0, 0, -9.81] m/s^2;
           body Link {{ mass = 1 kg; com = [0.1, 0.02, 0] m; output = [0.2, 0, 0] m turned rpy(10, 0, 20) deg;
             inertia = tensor(0.1, 0.2, 0.2, 0.01, 0, 0) kg*m^2 about com; }}
           body Trunk {{ mass = 50 kg; com = [0, 0, 0.1] m; inertia = diag(5, 6, 7) kg*m^2 about com;
             point a = [0.4, 0.1, 0] m; point b = [-0.4, 0.2, 0] m turned rpy(0, 0, 170) deg; point c = [0, 0.5, 0] m; }}
           Trunk trunk; {}{}{} }}",
        limb("a", "1"),
        limb("b", "2"),
        limb("c", "3"),
    );
    assert!(compare(&mut Random::new(1), &text) > 0);
}
