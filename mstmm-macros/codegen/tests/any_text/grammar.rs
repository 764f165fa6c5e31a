//! Random chains in the order of the language, more or less.

use super::words::{FIELDS, NAMES, NUMBERS, WORDS, one_of, pick, soup};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

fn number() -> BoxedStrategy<String> {
    let formula = |inner: BoxedStrategy<String>| {
        let unit = one_of("|| kg| m| deg| rad/s| N*m| kg*m^2| m/s^2| mm/rev", "|");
        let function = one_of("sqrt sin cos - invisible", " ");
        prop_oneof![
            (inner.clone(), unit).prop_map(|(number, unit)| format!("{number} {unit}")),
            (inner.clone(), one_of("+ - * /", " "), inner.clone())
                .prop_map(|(a, sign, b)| format!("{a} {sign} {b}")),
            (inner.clone(), 0..20_u8).prop_map(|(a, power)| format!("({a})^{power}")),
            (function, inner).prop_map(|(function, a)| format!("{function}({a})")),
        ]
    };
    pick(NUMBERS).prop_recursive(3, 12, 3, formula).boxed()
}

fn several(parts: BoxedStrategy<String>, most: usize) -> BoxedStrategy<String> {
    vec(parts, 0..=most).prop_map(|parts| parts.join(", ")).boxed()
}

fn value() -> BoxedStrategy<String> {
    let vector = || several(number(), 3).prop_map(|numbers| format!("[{numbers}]")).boxed();
    let turn = || {
        let form = (one_of("rpy quaternion", " "), several(number(), 4));
        form.prop_map(|(form, numbers)| format!("{form}({numbers})")).boxed()
    };
    let axes = prop_oneof![Just(String::new()), turn().prop_map(|turn| format!(" turned {turn}"))];
    let inertia = (one_of("diag tensor", " "), several(number(), 6), pick("com input tip"), axes)
        .prop_map(|(form, numbers, about, axes)| format!("{form}({numbers}) about {about}{axes}"));
    let shape = || {
        let kind = one_of("box cylinder capsule sphere mesh", " ");
        let arguments = vec(
            (one_of("|radius =|length =|r =", "|"), prop_oneof![number(), vector(), soup()]),
            0..3,
        );
        (kind, arguments, option::of(vector()), option::of(turn()))
            .prop_map(|(kind, arguments, at, turn)| {
                let arguments =
                    arguments.into_iter().map(|(name, value)| format!("{name} {value}"));
                let at = at.map_or_else(String::new, |at| format!(" at {at}"));
                let turn = turn.map_or_else(String::new, |turn| format!(" turned {turn}"));
                format!("{kind}({}){at}{turn}", arguments.collect::<Vec<_>>().join(", "))
            })
            .boxed()
    };
    prop_oneof![
        4 => number(),
        4 => vector(),
        1 => shape(),
        1 => several(shape(), 3).prop_map(|shapes| format!("[{shapes}]")),
        2 => (vector(), turn()).prop_map(|(at, turn)| format!("{at} turned {turn}")),
        1 => turn(),
        2 => inertia,
        1 => Just("input".to_owned()),
        1 => soup(),
    ]
    .boxed()
}

/// A block of one of these names, mostly with one of these contents, which are right for some.
fn block(word: &'static str, names: &'static str, right: &'static str) -> BoxedStrategy<String> {
    let field = prop_oneof![
        4 => (pick(FIELDS), value()).prop_map(|(field, value)| format!("{field} = {value};")),
        1 => (pick(NAMES), value()).prop_map(|(name, value)| format!("point {name} = {value};")),
        1 => soup(),
    ];
    let right = one_of(right, "|");
    (pick(names), right, option::weighted(0.1, vec(field, 1..4)))
        .prop_map(move |(name, right, fields)| {
            let fields = fields.map_or(right, |fields| fields.join(" "));
            format!("{word} {name} {{ {fields} }}")
        })
        .boxed()
}

/// What is right in space, in the plane and on a line.
struct Dimension {
    word: &'static str,
    body: &'static str,
    hinges: &'static str,
    starts: &'static str,
    ends: &'static str,
    of_hinges: &'static str,
    of_loads: &'static str,
    of_springs: &'static str,
    gravity: &'static str,
}

const SPACE: Dimension = Dimension {
    word: "|space|pub|pub(crate) space|/// text\n",
    body: "body Rod { mass = 1; com = [1, 0, 0]; output = [2, 0, 0];
        inertia = diag(1, 1, 1) about com; shape = box([1, 2, 3]) turned rpy(1, 0, 0); point tip = [1, 1, 1]; }",
    hinges: "pin(x)|ball|weld|slider([1, 2, 3])|screw(z, 0.1)|elastic|cylindrical(x)|universal(x, y)\
        |gimbal(z, y, x)|planar(z)|floating|pin([1, 0.5, 0])",
    starts: "ground|moving hand|ground at [1, 0, 0] turned rpy(1, 0, 0)|Rod b9",
    ends: "pin(x) h9 -> ground at [3, 0, 0]|elastic h9 -> moving tool|floating h9 -> ground",
    of_hinges: "damping = K;|motion = input;|stiffness = 2;|friction = 1; friction_speed = 1e-3;\
        |start = 0.1;|start = rpy(0, 0, 1);|armature = 0.1;|torque = input;",
    of_loads: "on = b0; force = [1, 0, 0]; torque = input;|force = input; at = tip; on = b0;|on = b1; torque = [1, 0, K];",
    of_springs: "on = b0; to = [1, 0, 0]; stiffness = 2; length = 1;|on = b1; to = [K, 0, 0]; at = tip; damping = 1;|force = input; on = b1; to = b0.tip; force = K;",
    gravity: "input|[0, -9.8, 0]|[0, 0, K]",
};

const PLANE: Dimension = Dimension {
    word: "plane",
    body: "body Rod { mass = 1; com = [1, 0]; output = [2, 0] turned 1; inertia = 1 about com;
        point tip = [1, K]; shape = [sphere(radius = 1) at [1, 2], mesh(\"a\") at [1, 2, 3]]; }",
    hinges: "pin|weld|slider(y)|slider([1, 2])|planar|elastic|floating",
    starts: "ground|moving hand|ground at [1, 0] turned 2|Rod b9",
    ends: "pin h9 -> ground at [3, 0]|planar h9 -> moving tool|elastic h9 -> ground",
    of_hinges: "stiffness = 2; rest = 0.5;|armature = 0.1;|torque = input;|force = 3;|motion = input;\
        |limits = [-1, 1]; limit_stiffness = 5;|turning_stiffness = 1e308;|stiffness = 1e-320;",
    of_loads: "on = b0; force = [1, 0]; torque = input;|force = input; at = tip; on = b0;|on = b1; torque = K;",
    of_springs: "on = b0; to = [1, 0]; stiffness = 2; length = 1;|on = b1; to = [K, 0]; at = tip; damping = 1;|force = input; on = b1; to = b0.tip; force = K;",
    gravity: "input|[0, -9.8]|[0, K]",
};

const LINE: Dimension = Dimension {
    word: "line",
    body: "body Rod { mass = 1 + K; output = 1; point tip = 2; }",
    hinges: "slider|weld|elastic|floating",
    starts: "ground|moving hand|ground at 1|Rod b9",
    ends: "slider h9 -> ground at 3|elastic h9 -> moving tool",
    of_hinges: "stiffness = K; rest = 1;|damping = 2;|force = input;|force = 3;|motion = input;\
        |start = 1; start_velocity = K;|limits = [-1, 1]; limit_stiffness = 5;",
    of_loads: "on = b0; force = 1;|force = input; at = tip; on = b0;|on = b1; force = K;",
    of_springs: "on = b0; to = 1; stiffness = 2; length = 1;|on = b1; to = K; at = tip; damping = 1;|force = input; on = b1; to = b0.tip; force = K;",
    gravity: "input|-9.8|K",
};

fn route(dimension: &Dimension) -> BoxedStrategy<String> {
    let hinge = prop_oneof![
        40 => one_of(dimension.hinges, "|"),
        1 => (pick(WORDS), value()).prop_map(|(word, value)| format!("{word}({value})")),
    ];
    let pairs = |first: usize| {
        let pair = (hinge.clone(), option::weighted(0.03, soup()));
        vec(pair, 1..3).prop_map(move |pairs| {
            let pairs = pairs.into_iter().enumerate().map(|(k, (hinge, strange))| {
                let k = first + k;
                let body = strange.unwrap_or_else(|| format!("Rod b{k}"));
                format!("{hinge} h{k} -> {body}")
            });
            pairs.collect::<Vec<_>>().join(" -> ")
        })
    };
    let repeat = (pick("1 2 3 1000 10000000"), pairs(2))
        .prop_map(|(times, stops)| format!(" -> repeat {times} {{ {stops} }}"));
    let start = prop_oneof![
        20 => one_of(dimension.starts, "|"),
        1 => value().prop_map(|value| format!("ground at {value}")),
        1 => soup(),
    ];
    let end = prop_oneof![8 => one_of(dimension.ends, "|"), 1 => soup()];
    (start, pairs(0), option::weighted(0.3, repeat), option::weighted(0.1, end))
        .prop_map(|(start, middle, repeat, end)| {
            let repeat = repeat.unwrap_or_default();
            let end = end.map_or_else(String::new, |end| format!(" -> {end}"));
            format!("{start} -> {middle}{repeat}{end};")
        })
        .boxed()
}

/// A place of a body, mostly of one that exists.
fn place() -> BoxedStrategy<String> {
    prop_oneof![
        12 => (one_of("b0 b1 p0.t0 p0.t1 p1.t0 last.t0", " "), one_of("output tip input", " "))
            .prop_map(|(body, point)| format!("{body}.{point}")),
        1 => (pick(NAMES), pick(NAMES)).prop_map(|(body, point)| format!("{body}.{point}")),
        1 => soup(),
    ]
    .boxed()
}

/// A further route: a branch, or an instance of a part.
fn branch(dimension: &Dimension) -> BoxedStrategy<String> {
    let hinge = || one_of(dimension.hinges, "|");
    let name = || pick("p0 p1 p2 last");
    prop_oneof![
        4 => (place(), hinge(), pick("t2 t3 t4"))
            .prop_map(|(place, hinge, body)| format!("{place} -> {hinge} {body}_h -> Rod {body};")),
        4 => (place(), pick("Leg(2) Leg(K) Leg(-1) Leg(K+2*K) Leg Leg(1,2) Tail"), name())
            .prop_map(|(place, part, name)| format!("{place} -> {part} {name};")),
        2 => (place(), hinge(), place()).prop_map(|(place, hinge, first)| format!(
            "{place} -> repeat 3 from r0.tip = {first} {{ {hinge} r1 -> Rod r0; r0.tip -> {hinge} r2 -> Rod r3; \
             last.r0.tip -> {hinge} r4 -> Rod r5 }};"
        )),
        1 => (place(), place()).prop_map(|(on, to)| format!(
            "spring cord {{ on = {on}; to = {to}; stiffness = 1; }}"
        )),
        1 => soup(),
    ]
    .boxed()
}

/// Parts: one with a parameter and branches, and one that may contain it.
fn parts(dimension: &Dimension) -> BoxedStrategy<String> {
    let hinge = || one_of(dimension.hinges, "|");
    let piece = prop_oneof![
        6 => (place(), hinge()).prop_map(|(place, hinge)| format!("{place} -> {hinge} k3 -> Rod t3;")),
        6 => Just("t0.tip -> weld k4 -> Rod t4;".to_owned()),
        4 => Just("load push { on = t0.tip; force = input; }".to_owned()),
        4 => Just("hinge k0 { damping = size; }".to_owned()),
        2 => Just("hinge k0 { start = size; }".to_owned()),
        1 => soup(),
    ];
    let tail = prop_oneof![
        4 => Just("k9 -> Rod t0 -> Leg(3) inner".to_owned()),
        2 => Just("k9 -> repeat 2 { Leg(3) inner }".to_owned()),
        1 => Just("k9 -> Rod t0 -> Tail tail".to_owned()),
        1 => soup(),
    ];
    (hinge(), vec(piece, 0..3), hinge(), tail)
        .prop_map(|(first, pieces, second, tail)| {
            let pieces = pieces.join(" ");
            format!(
                "part Leg(size) {{ {first} k0 -> Rod t0 -> weld k1 -> Rod t1; {pieces} }}
                 part Tail {{ {second} {tail}; }}"
            )
        })
        .boxed()
}

fn chain(dimension: &'static Dimension) -> BoxedStrategy<String> {
    let before = prop_oneof![
        4 => Just("param K = 2;".to_owned()),
        4 => one_of(dimension.gravity, "|").prop_map(|value| format!("gravity = {value};")),
        2 => pick("riccati transfer").prop_map(|word| format!("method = {word};")),
        1 => vec(pick("poses velocities z energies pose 1"), 0..4)
            .prop_map(|words| format!("results = [{}];", words.join(", "))),
        1 => pick("poses velocities z energies").prop_map(|word| format!("results = {word};")),
        1 => (pick(NAMES), number()).prop_map(|(name, value)| format!("param {name} = {value};")),
        1 => (pick(NAMES), number(), number())
            .prop_map(|(name, count, value)| format!("param {name}[{count}] = {value};")),
        1 => value().prop_map(|value| format!("gravity = {value};")),
        1 => soup(),
    ];
    let behind = prop_oneof![
        12 => block("hinge", "h0 h0 h0 h1 h2", dimension.of_hinges),
        3 => block("load", "push", dimension.of_loads),
        3 => block("spring", "rope", dimension.of_springs),
        1 => block("body", "b9 b0 Link", "start = 1;|start_rate = 1;|mass = 1;|output = 1;"),
        1 => soup(),
    ];
    let word = prop_oneof![20 => one_of(dimension.word, "|"), 1 => soup()];
    let tree = option::weighted(0.5, (parts(dimension), vec(branch(dimension), 0..4)));
    (word, pick("Arm"), vec(before, 0..3), route(dimension), tree, vec(behind, 0..4))
        .prop_map(|(word, name, before, route, tree, behind)| {
            let (before, behind) = (before.join("\n"), behind.join("\n"));
            let (parts, branches) = tree.unwrap_or_default();
            let branches = branches.join("\n");
            let Dimension { body, .. } = dimension;
            format!(
                "{word} chain {name} {{\n{before}\n{body}\n{parts}\n{route}\n{branches}\n{behind}\n}}"
            )
        })
        .boxed()
}

fn any_chain() -> BoxedStrategy<String> {
    prop_oneof![2 => chain(&SPACE), 1 => chain(&PLANE), 1 => chain(&LINE)].boxed()
}

/// Words in the order of the language, more or less, or in none.
pub fn text() -> BoxedStrategy<String> {
    prop_oneof![
        8 => any_chain(),
        1 => vec(soup(), 0..12).prop_map(|parts| parts.join(" ")),
        1 => (any_chain(), any_chain()).prop_map(|(a, b)| a + &b),
    ]
    .boxed()
}
