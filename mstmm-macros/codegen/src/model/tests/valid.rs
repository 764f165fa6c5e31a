//! Descriptions without errors.

use super::{PENDULUM, chain, edited};
use super::{all_known, constants, known};
use crate::ids::{BodyId, HingeId, ParameterId};
use crate::model::{
    About, Attachment, Dimension, Drive, Effort, Element, Frame, HingeKind, Passive, Results,
    SolutionMethod, Source, Symbol, Value,
};

/// A number in the place of the rod's mass.
fn mass(value: &str) -> Value {
    let (chain, _) = chain(&edited(&[("mass = 2 kg", &format!("mass = {value}"))]));
    chain.bodies[BodyId(1)].mass.clone()
}

fn known_mass(value: &str) -> f64 {
    mass(value).known().expect("a known number")
}

#[test]
fn the_pendulum_of_the_paper() {
    let (chain, passthrough) = chain(
        "/// Three unit cubes on ball-and-socket hinges.
        pub(crate) space chain BallPendulum {
            gravity = [0, -9.8, 0] m/s^2;
            body Cube {
                mass = 1 kg;
                com = [0.5, 0, 0] m;                                    // r_IC, body frame
                output = [1, 0, 0] m;                                   // r_IO, body frame
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
            }
            ground -> ball shoulder -> Cube upper
                   -> ball elbow    -> Cube middle
                   -> ball wrist    -> Cube lower;
            hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
        }",
    );
    assert_eq!(chain.name, "BallPendulum");
    assert_eq!(passthrough.attributes.len(), 1);
    assert_eq!(chain.dimension, Dimension::Space);
    assert_eq!(chain.gravity, Source::Constant([0.0, -9.8, 0.0].map(Value::number)));
    let names: Vec<_> = chain.bodies.iter().map(|body| body.name.to_string()).collect();
    assert_eq!(names, ["upper", "middle", "lower"]);
    let body = &chain.bodies[BodyId(2)];
    assert_eq!(body.type_name, "Cube");
    assert_eq!(known(&body.com), [0.5, 0.0, 0.0]);
    assert_eq!(body.inertia.about, About::Input);
    assert_eq!(known(&body.inertia.tensor), [1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0, 0.0, 0.0, 0.0]);
    assert_eq!(known(&body.output.position), [1.0, 0.0, 0.0]);
    assert_eq!(body.output.rotation, Frame::identity().rotation);

    let [shoulder, elbow, wrist] = chain.hinges.as_slice() else { panic!("three hinges") };
    assert!(matches!(&shoulder.inboard, Attachment::Ground(frame) if *frame == Frame::identity()));
    assert!(matches!(shoulder.outboard, Attachment::Input(BodyId(0))));
    assert!(matches!(
        (&elbow.inboard, &elbow.outboard),
        (Attachment::Output(BodyId(0)), Attachment::Input(BodyId(1)))
    ));
    assert!(matches!(wrist.kind, HingeKind::Ball));
    assert_eq!(wrist.drive, Drive::Efforts(vec![Effort::Free; 3]));
    assert_eq!(wrist.passive, vec![Passive::none(); 3]);
    assert_eq!(all_known(&wrist.rest), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(all_known(&wrist.start), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(all_known(&wrist.start_rate), [0.0, 0.1, 0.0]);
    assert_eq!(chain.elements[..2], [Element::Hinge(HingeId(0)), Element::Body(BodyId(0))]);
    assert_eq!((chain.method, chain.results), (None, Results::ALL));
}

#[test]
fn an_arm_with_a_payload() {
    let (chain, _) = chain(
        "chain Arm {
            gravity = [0, 0, -9.81] m/s^2;
            method = riccati;
            results = [energies, z];
            param payload = 0.5 kg;
            body L1 {
                mass = 4.97 kg;
                com = [0, 2, -48] mm;
                inertia = tensor(0.70337, 0.70661, 0.00912, -0.00014, 0.0068, 0.0192) kg*m^2 about com;
                output = [0, 0, 0] m turned rpy(-90, 0, 0) deg;
            }
            body L7 {
                mass = 0.74 kg + payload;
                com = [0, 0, 5 cm];
                inertia = diag(0.0125, 0.01, 0.0048) kg*m^2 about com;
            }
            ground at [0, 0, 333] mm -> pin(z) j1 -> L1 -> pin(-x) j2 -> L7;
            hinge j1, j2 { torque = input; }
            hinge j2 { start = -90 deg; start_rate = 2 rpm; }
        }",
    );
    assert_eq!(chain.method, Some(SolutionMethod::Riccati));
    assert_eq!(chain.results, Results { z: true, energies: true, ..Results::NONE });
    assert_eq!(chain.bodies[BodyId(0)].name, "l1");
    assert_eq!(known(&chain.bodies[BodyId(0)].com), [0.0, 0.002, -0.048]);
    let about_x = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]];
    assert_eq!(chain.bodies[BodyId(0)].output.rotation.each_ref().map(known), about_x);
    let payload = Value::Symbol(Symbol::Parameter(ParameterId(0)));
    assert_eq!(chain.bodies[BodyId(1)].mass, Value::number(0.74).plus(payload));
    assert_eq!(known(&chain.bodies[BodyId(1)].com), [0.0, 0.0, 0.05]);
    assert_eq!(chain.parameters[ParameterId(0)].unit, "kg");
    assert_eq!(chain.parameters[ParameterId(0)].default.known(), Some(0.5));
    let Attachment::Ground(frame) = &chain.hinges[HingeId(0)].inboard else {
        panic!("on the ground")
    };
    assert_eq!(known(&frame.position), [0.0, 0.0, 0.333]);
    let HingeKind::Pin { axis } = &chain.hinges[HingeId(1)].kind else { panic!("a pin") };
    assert_eq!(known(axis), [-1.0, 0.0, 0.0]);
    assert_eq!(all_known(&chain.hinges[HingeId(1)].start), [-std::f64::consts::FRAC_PI_2]);
    assert_eq!(all_known(&chain.hinges[HingeId(1)].start_rate), [std::f64::consts::PI / 15.0]);
    let input = Drive::Efforts(vec![Effort::Input]);
    assert!(chain.hinges.iter().all(|hinge| hinge.drive == input));
}

#[test]
fn a_matrix_is_a_tensor_row_by_row() {
    let matrix = chain(
        "chain Top {
            body Rod {
                mass = 1 kg; com = [0, 0, 0] m;
                inertia = matrix([3, 0.1, 0.2], [0.1, 4, 0.3], [0.2, 0.3, 5]) g*m^2 about com;
            }
            ground -> ball joint -> Rod rod;
        }",
    );
    let inertia = &matrix.0.bodies[BodyId(0)].inertia;
    assert_eq!(known(&inertia.tensor), [0.003, 0.004, 0.005, 0.0001, 0.0002, 0.0003]);
}

#[test]
fn a_floating_chain_has_an_implied_hinge() {
    let (chain, _) = chain(&edited(&[
        ("ground -> pin(z) shoulder -> Cube upper", "Cube -> pin shoulder -> Cube upper"),
        (
            "hinge wrist",
            "body cube {
                start = [1, 2, 3] m turned quaternion(0, 0, 3, 4);
                start_velocity = [1, 0, 0] m/s;
                start_rate = [0, 0, 90] deg/s;
            }
            hinge wrist",
        ),
    ]));
    let floating = &chain.hinges[HingeId(0)];
    assert_eq!(floating.name, "cube");
    assert!(matches!(floating.kind, HingeKind::Floating));
    assert!(matches!(
        (&floating.inboard, &floating.outboard),
        (Attachment::Ground(_), Attachment::Input(BodyId(0)))
    ));
    assert_eq!(all_known(&floating.start), [1.0, 2.0, 3.0, 0.0, 0.0, 0.6, 0.8]);
    let quarter = std::f64::consts::FRAC_PI_2;
    assert_eq!(all_known(&floating.start_rate), [1.0, 0.0, 0.0, 0.0, 0.0, quarter]);
    // A pin without an axis turns about z; the implied hinge is not on the route.
    let HingeKind::Pin { axis } = &chain.hinges[HingeId(1)].kind else { panic!("a pin") };
    assert_eq!(known(axis), [0.0, 0.0, 1.0]);
    assert_eq!(chain.elements[..2], [Element::Body(BodyId(0)), Element::Hinge(HingeId(1))]);
    assert_eq!(chain.elements.len(), 5);
}

#[test]
fn a_chain_can_hang_on_its_end() {
    let (chain, _) = chain(&edited(&[
        (
            "ground -> pin(z) shoulder -> Cube upper -> ball wrist -> Rod rod",
            "Cube upper -> ball wrist -> Rod rod -> pin([0, 3, 4]) shoulder -> ground at [0, 1, 0] m turned rpy(0, 0, 180) deg",
        ),
        ("about com;", "about com; output = [1, 0, 0] m;"),
    ]));
    assert_eq!(chain.hinges.len(), 2);
    let last = &chain.hinges[HingeId(1)];
    assert!(matches!(last.inboard, Attachment::Output(BodyId(1))));
    let Attachment::Ground(frame) = &last.outboard else { panic!("on the ground") };
    assert_eq!(known(&frame.position), [0.0, 1.0, 0.0]);
    assert_eq!(known(&frame.rotation[0]), [-1.0, 0.0, 0.0]);
    let HingeKind::Pin { axis } = &last.kind else { panic!("a pin") };
    assert_eq!(known(axis), [0.0, 3.0, 4.0]);
}

#[test]
fn units_scale_add_and_close_products() {
    assert_eq!(known_mass("1"), 1.0);
    assert_eq!(known_mass("250 g"), 0.25);
    assert_eq!(known_mass("1 kg + 250 g - 0"), 1.25);
    assert_eq!(known_mass("0.5kg"), 0.5);
    assert_eq!(known_mass("1/4 kg"), 0.25);
    assert_eq!(known_mass("(2 kg) * 3"), 6.0);
    assert_eq!(known_mass("2 * (3 kg)"), 6.0);
    assert_eq!(known_mass("-(-2) kg"), 2.0);
    assert_eq!(known_mass("(2 N) / (4 m/s^2)"), 0.5);
    assert_eq!(known_mass("(2 N) / (4 m) * (1 s^2)"), 0.5);
    assert_eq!(known_mass("sqrt(9 kg^2)"), 3.0);
    assert_eq!(known_mass("2^3 kg"), 8.0);
    assert_eq!(known_mass("2^-1 kg"), 0.5);
    assert_eq!(known_mass("4 * sin(30 deg) * cos(0) * PI / PI kg"), 4.0 * 30f64.to_radians().sin());
    assert_eq!(known_mass("sin(90 deg) kg"), 1.0);
    assert_eq!(known_mass("1e-3 t"), 1.0);
    assert_eq!(known_mass("1_000. g"), 1.0);
    // One rounding each: the same numbers as their decimals.
    assert_eq!(known_mass("48 g"), 0.048);
    assert_eq!(known_mass("(3 mm) / (1 ms) * (1 kg*s/m)"), 3.0);
}

#[test]
fn paths_and_parameters_stay_formulas() {
    let constant = |index| Value::Symbol(Symbol::Constant(index));
    let parameter = |index| Value::Symbol(Symbol::Parameter(ParameterId(index)));
    let number = Value::number;
    assert_eq!(mass("MASS"), constant(0));
    assert_eq!(mass("MASS + crate::consts::MASS + MASS"), {
        constant(0).plus(constant(1)).plus(constant(0))
    });
    assert_eq!(mass("1 kg + ::std::f64::consts::E"), number(1.0).plus(constant(0)));
    assert_eq!(mass("MASS g"), constant(0).over(number(1000.0)));
    assert_eq!(mass("payload * ratio"), parameter(0).times(parameter(1)));
    assert_eq!(mass("ratio kg"), parameter(1));
    assert_eq!(mass("ratio"), parameter(1));
    let (chain, passthrough) = chain(&edited(&[("mass = 1 kg", "mass = a::B + C * a::B")]));
    assert_eq!(chain.constants, 2);
    let paths: Vec<_> = passthrough.constants.iter().map(|path| path.to_string()).collect();
    assert_eq!(paths, ["a :: B", "C"]);
}

#[test]
fn angles_fit_numbers() {
    let (chain, _) = chain(&edited(&[
        ("start = 30 deg", "start = 0.25 rev"),
        ("torque = input", "torque = (2 N*m/rad) * (0.5 rad)"),
    ]));
    assert_eq!(all_known(&chain.hinges[HingeId(0)].start), [std::f64::consts::FRAC_PI_2]);
    assert_eq!(constants(&chain.hinges[HingeId(0)].drive), [1.0]);
}

#[test]
fn a_ball_starts_turned_and_driven() {
    let (chain, _) = chain(&edited(&[(
        "start_rate = [0, 0.1, 0] rad/s;",
        "start = rpy(0, 0, 180 deg); torque = [0, 0, 5] N*mm;",
    )]));
    assert_eq!(all_known(&chain.hinges[HingeId(1)].start), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(constants(&chain.hinges[HingeId(1)].drive), [0.0, 0.0, 0.005]);
}

#[test]
fn omitted_values_are_zero() {
    let (chain, _) = chain(&edited(&[("gravity = [0, -9.8, 0] m/s^2;", "")]));
    assert_eq!(chain.gravity, Source::Nothing);
    assert_eq!(chain.bodies[BodyId(1)].output, Frame::identity());
}

#[test]
fn one_call_has_several_chains() {
    let twice = format!("{PENDULUM}{}", PENDULUM.replace("chain Pendulum", "chain Other"));
    assert_eq!(super::read(twice.parse().expect("tokens")).expect("good").len(), 2);
}

/// A `macro_rules!` passes an expression on in a group without brackets: it stays one factor.
#[test]
fn an_expression_from_a_macro_is_one_factor() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    fn replace(tokens: TokenStream, expression: &str) -> TokenStream {
        let tree = |tree| match tree {
            TokenTree::Ident(ident) if ident == "EXPR" => {
                let tokens = expression.parse().expect("tokens");
                TokenTree::Group(Group::new(Delimiter::None, tokens))
            }
            TokenTree::Group(group) => {
                let stream = replace(group.stream(), expression);
                TokenTree::Group(Group::new(group.delimiter(), stream))
            }
            other => other,
        };
        tokens.into_iter().map(tree).collect()
    }
    for (mass, expression, expected) in [
        ("2 * EXPR", "1 kg + 2 kg", 6.0),
        ("2 * EXPR kg", "-1.0 + 3.0", 4.0),
        ("(5 - EXPR) kg", "-3.0 - 1.0", 9.0),
        ("-EXPR kg", "-5 + 3", 2.0),
        ("EXPR^2 kg", "-3.0", 9.0),
        ("(EXPR + EXPR)^2 / EXPR^2 kg", "-3.0 + 1", 4.0),
        ("EXPR", "- -2 kg", 2.0),
        ("2^EXPR * 3 kg", "-1", 1.5),
    ] {
        let source = edited(&[("mass = 2 kg", &format!("mass = {mass}"))]);
        let tokens = replace(source.parse().expect("tokens"), expression);
        let chains = super::read(tokens).expect("good");
        assert_eq!(chains[0].0.bodies[BodyId(1)].mass.known(), Some(expected), "{mass}");
    }
    // A group is an operand: its sign is no operator between the group and what is before it.
    let source = edited(&[("mass = 2 kg", "mass = 2 EXPR")]);
    assert!(super::read(replace(source.parse().expect("tokens"), "-1")).is_err());
}
