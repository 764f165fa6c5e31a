//! Whatever is written, the answer is a chain or a list of errors, never a panic.

use super::{PENDULUM, read};
use crate::model::{Chain, SpringEnd};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// What a slip of the keyboard may leave behind, and what no one would write.
const SLIPS: &[&str] = &[
    "", ";", "->", "-", ",", "=", "::", "^", "*", "/", "#", "'a", "0", "1e999", "2kg", "\"text\"",
    "x", "X", "Self", "_", "r#x", "ground", "moving", "repeat", "turned", "about", "point",
    "input", "load", "( )", "[1]", "{ }", ".", "last", "from", "part", "Leg", "rung.tip",
];

/// All streams in which one token is replaced.
fn replaced(tokens: &TokenStream, by: &TokenStream, each: &mut dyn FnMut(TokenStream)) {
    let trees: Vec<TokenTree> = tokens.clone().into_iter().collect();
    for (index, tree) in trees.iter().enumerate() {
        let with = |new: TokenStream| -> TokenStream {
            let before = trees[..index].iter().cloned();
            before.chain(new).chain(trees[index + 1..].iter().cloned()).collect()
        };
        each(with(by.clone()));
        if let TokenTree::Group(group) = tree {
            replaced(&group.stream(), by, &mut |inside| {
                let group = TokenTree::Group(Group::new(group.delimiter(), inside));
                each(with(group.into()));
            });
        }
    }
}

/// What the example of the documentation leaves out.
const MORE: &str = "
    chain Loop {
        gravity = input;
        param k = 2 N/m;
        body Rod {
            mass = 1 kg; com = [1, 0, 0] m; output = [2, 0, 0] m;
            inertia = matrix([0, 0, 0], [0, 1, 0], [0, 0, 1]) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        moving hand -> screw(x, 5 mm/rev) a -> Rod b -> repeat 3 { universal(x, [0, 1, 0]) c -> Rod d }
            -> elastic e -> Rod f -> planar(y) g -> ground at [1, 0, 0] m;
        hinge a { motion = input; stiffness = 3; }
        hinge c, g { friction = 1; friction_speed = 2; limits = [-1, 2]; limit_stiffness = 3; }
        hinge e { start = [0, 0, 0] m turned rpy(0, 0, 3); rest = [1, 0, 0]; stiffness = [k, k, k]; }
        load push { on = d; at = tip; force = input; torque = [0, 0, 1] N*m; axes = body; }
        spring rope { on = b; at = output; to = [1, 1, 1] m; stiffness = k; length = 1 m; }
    }";

/// The other dimensions.
const FLAT: &str = "
    plane chain Swing {
        gravity = [0, -9.8];
        body Rod { mass = 1 kg; com = [0.5, 0]; output = [1, 0] turned 1; inertia = 1 about com; }
        Rod first -> slider([1, 2]) a -> Rod second -> floating b -> moving hand;
        load push { on = first; force = [1, 2]; torque = 3; }
    }
    line chain Train {
        body Car { mass = 1 kg; output = 1 m; point hook = 1 m; }
        Car first -> repeat 3 { elastic a -> Car next };
        body first { start = 1; start_velocity = 2; }
        load push { on = next; at = hook; force = 3; }
    }";

/// A tree.
const TREE: &str = "
    chain Tree {
        param K = 3;
        body Rod {
            mass = 1 kg; com = [1, 0, 0] m; output = [2, 0, 0] m;
            inertia = diag(1, 1, 1) kg*m^2 about com;
            point tip = [1, 1, 0] m turned rpy(0, 0, 90) deg;
        }
        part Leg(side, front) {
            body Hip { mass = 1 kg; com = [0, side, 0] m; output = [0, 0, front] m; inertia = diag(1, 1, 1) about com; }
            pin([side, 0, 0]) a -> Hip hip -> Foot(2*side) foot;
            hip.output -> weld w -> Rod plate;
            hinge a { start = front*0.1 rad; }
            load push { on = hip.com; force = input; }
        }
        part Foot(size) { pin b -> Rod heel; heel.tip -> pin c -> Rod toe; hinge b { start = size; } }
        Rod trunk -> repeat 3 from rung.tip = trunk.tip {
            ball d -> Rod link; link.tip -> pin e -> Rod rung; last.rung.tip -> pin f -> Rod knob
        } -> weld g -> Rod neck;
        trunk.tip -> Leg(1, -1) lf -> weld h -> Rod claw;
        moving hand -> Leg(-1, 2*K) rf;
        hinge lf.a, rf.foot.b { torque = input; }
        body trunk { start = [0, 0, 1] m; }
        spring s { on = lf.hip; to = trunk.tip; stiffness = 1; }
        spring r { on = rung; to = last.rung.tip; stiffness = 1; }
    }";

#[test]
fn one_token_replaced_by_anything() {
    for source in [PENDULUM, MORE, FLAT, TREE] {
        read(source.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
        replace_each(source);
    }
}

/// The ranges of what a chain refers to lie in what it has.
fn is_closed(chain: &Chain) -> bool {
    let bodies = chain.bodies.len();
    let on_bodies = chain.loads.iter().map(|load| load.body);
    let on_bodies = on_bodies.chain(chain.springs.iter().map(|spring| spring.on.body));
    let on_bodies = on_bodies.chain(chain.springs.iter().flat_map(|spring| match &spring.to {
        SpringEnd::Ground(_) => vec![],
        SpringEnd::Body(point) => vec![point.body],
        SpringEnd::Previous { point, first } => vec![point.body, first.body],
    }));
    let places = chain.hinges.iter().flat_map(|hinge| [&hinge.inboard, &hinge.outboard]);
    on_bodies.chain(places.filter_map(|place| place.body())).all(|body| body.index() < bodies)
        && chain.repeats.iter().all(|repeat| {
            repeat.hinges.last().index() < chain.hinges.len()
                && repeat.bodies.last().index() < bodies
                && repeat.elements.end <= chain.elements.len()
        })
}

/// Every slip in every third place, another third for the next slip.
fn replace_each(source: &str) {
    let tokens: TokenStream = source.parse().expect("tokens");
    for (index, slip) in SLIPS.iter().enumerate() {
        let mut place = index;
        replaced(&tokens, &slip.parse().expect("tokens"), &mut |wrong| {
            place += 1;
            if !place.is_multiple_of(3) {
                return;
            }
            // A chain, or errors with a message each.
            match read(wrong) {
                Ok(chains) => assert!(chains.iter().all(|(chain, _)| is_closed(chain))),
                Err(errors) => {
                    assert!(errors.into_iter().all(|error| !error.to_string().is_empty()));
                }
            }
        });
        assert!(place > 140, "only {place} places");
    }
}

/// Groups within groups are refused before anything walks them by recursion: on the small stack of a
/// test they would overflow it.
#[test]
fn deep_groups_are_refused() {
    let too_deep = "more than 200 nested groups";
    for (depth, message) in
        [(200, "expected `chain`, found `(`"), (201, too_deep), (100_000, too_deep)]
    {
        let mut inside = TokenStream::new();
        for _ in 0..depth {
            inside = TokenTree::Group(Group::new(Delimiter::Parenthesis, inside)).into();
        }
        let right: TokenStream = PENDULUM.parse().expect("tokens");
        let errors = read(right.into_iter().chain(inside).collect()).expect_err("far too deep");
        let messages: Vec<_> = errors.into_iter().map(|error| error.to_string()).collect();
        assert_eq!(messages, [message], "{depth} groups");
    }
}
