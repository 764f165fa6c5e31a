//! Chains with springs between bodies.

use super::twins::{Numbers, Twin, Twins};
use mstmm_codegen::ids::{BodyId, SpringId};
use mstmm_codegen::model::{BodyPoint, Chain, SpringEnd, Value};
use std::fmt::Write;

/// The types of bodies of all dimensions.
const BODIES: [(&str, &str); 3] = [
    (
        "",
        "gravity = [1, -9.8, 2] m/s^2;
        body Base {
            mass = 2 kg; com = [0.1, 0.2, 0] m; output = [0.2, 0.3, 0.1] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        body Rod {
            mass = 1 kg; com = [0.3, 0.1, 0] m; output = [0.6, 0, 0.1] m;
            inertia = diag(0.02, 0.1, 0.1) kg*m^2 about com;
        }",
    ),
    (
        "plane ",
        "gravity = [1, -9.8] m/s^2;
        body Base {
            mass = 2 kg; com = [0.1, 0.2] m; output = [0.2, 0.3] m turned 20 deg;
            inertia = 0.1 kg*m^2 about com;
        }
        body Rod { mass = 1 kg; com = [0.3, 0.1] m; output = [0.6, 0] m; inertia = 0.1 kg*m^2 about com; }",
    ),
    (
        "line ",
        "gravity = 2 m/s^2; body Base { mass = 2 kg; output = 0.2 m; } body Rod { mass = 1 kg; output = 0.6 m; }",
    ),
];

/// The end of a spring: a body, and the place on it.
pub type End = (&'static str, [f64; 3]);

/// The other end of a spring.
#[derive(Clone, Copy)]
pub enum To {
    Ground([f64; 3]),
    Body(End),
    Previous(End, End),
}

/// A spring.
#[derive(Clone)]
pub struct Cord {
    pub name: String,
    pub on: End,
    pub to: To,
}

/// Returns a spring.
pub fn cord(name: &str, on: End, to: To) -> Cord {
    Cord { name: name.to_owned(), on, to }
}

fn point(chain: &Chain, (name, at): End) -> BodyPoint {
    let body = chain.bodies.position(|body| body.name == name);
    let body: BodyId = body.unwrap_or_else(|| panic!("no body {name}"));
    let along = chain.dimension.translations();
    let component = |k: usize| Value::Number(if along.contains(&k) { at[k] } else { 0.0 });
    BodyPoint { body, at: [0, 1, 2].map(component) }
}

/// Returns the chain of a text with springs; `SPRINGS` in the text stands for them. The stiffness of springs on bodies `d` is
/// a parameter if the text has one. With a parameter `push` all springs have actuators, and the forces of some are inputs.
pub fn with_springs(text: &str, cords: &[Cord]) -> Twin {
    let to = if text.contains("line chain") {
        "0 m"
    } else if text.contains("plane chain") {
        "[0, 0] m"
    } else {
        "[0, 0, 0] m"
    };
    let mut blocks = String::new();
    for Cord { name, on: (on, _), .. } in cords {
        let stiffness = match on.strip_prefix('d') {
            Some(repetition) if text.contains("param hard") => format!("hard{repetition}"),
            _ => "30 N/m".to_owned(),
        };
        let force = match text.contains("param push") {
            true if name.starts_with("to_") || name.starts_with("cord") => "force = input;",
            true => "force = push;",
            false => "",
        };
        let length = if name.starts_with("lower") { "0 m" } else { "0.3 m" };
        write!(
            blocks,
            "spring {name} {{ on = {on}; to = {to}; stiffness = {stiffness}; damping = 2; length = {length}; {force} }}"
        )
        .expect("text can be written");
    }
    let text = text.replace("SPRINGS", &blocks);
    let edit = |chain: &mut Chain| {
        for (index, Cord { on, to, .. }) in cords.iter().enumerate() {
            let to = match *to {
                To::Ground(at) => SpringEnd::Ground(at.map(Value::Number)),
                To::Body(end) => SpringEnd::Body(point(chain, end)),
                To::Previous(end, first) => {
                    SpringEnd::Previous { point: point(chain, end), first: point(chain, first) }
                }
            };
            let on = point(chain, *on);
            let spring = &mut chain.springs[SpringId(index)];
            (spring.on, spring.to) = (on, to);
        }
    };
    Twin::edited(&text, Numbers::Written, edit).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Springs between two bodies, with welds, a long way between the ends, and the ground in between.
pub fn routes(dimension: usize) -> (String, Vec<Cord>) {
    let (word, bodies) = BODIES[dimension];
    let route = match dimension {
        0 => {
            "ground at [1, 2, 3] m -> weld s -> Base still -> ball a -> Base a1 -> pin([1, 2, 3]) b -> Rod b1 -> weld c
            -> Rod c1 -> universal(x, y) d -> Rod d1 -> slider(y) e -> Rod e1 -> pin(z) f -> Rod f1 -> pin(x) g -> Rod g1
            -> pin(y) h -> Rod h1 -> pin(z) i -> Rod i1"
        }
        1 => {
            "ground at [1, 2] m -> weld s -> Base still -> pin a -> Base a1 -> pin b -> Rod b1 -> weld c -> Rod c1
            -> pin d -> Rod d1 -> slider(y) e -> Rod e1 -> pin f -> Rod f1 -> pin g -> Rod g1 -> pin h -> Rod h1
            -> pin i -> Rod i1"
        }
        _ => {
            "ground at 1 m -> weld s -> Base still -> slider a -> Base a1 -> slider b -> Rod b1 -> weld c -> Rod c1
            -> slider d -> Rod d1 -> slider e -> Rod e1 -> slider f -> Rod f1 -> slider g -> Rod g1 -> slider h -> Rod h1
            -> slider i -> Rod i1"
        }
    };
    let text = format!("{word}chain Cords {{ answers = bias_efforts; {bodies} {route}; SPRINGS }}");
    let cords = vec![
        cord("next", ("b1", [0.1, 0.2, 0.3]), To::Body(("a1", [-0.2, 0.5, 0.1]))),
        cord("back", ("a1", [0.4, -0.2, 0.1]), To::Body(("d1", [0.1, 0.3, -0.2]))),
        cord("across", ("c1", [0.5, 0.1, 0.0]), To::Body(("f1", [0.2, 0.0, 0.1]))),
        cord("long", ("i1", [0.6, 0.0, 0.1]), To::Body(("a1", [0.0, 0.4, 0.3]))),
        cord("welded", ("c1", [0.5, 0.1, 0.0]), To::Body(("b1", [0.2, 0.3, 0.1]))),
        cord("held", ("e1", [0.5, 0.1, 0.0]), To::Body(("still", [0.2, 0.3, 0.1]))),
        cord("reversed", ("still", [0.5, 0.1, 0.3]), To::Body(("g1", [0.2, 0.3, 0.1]))),
        cord("at_rest", ("still", [0.5, 0.1, 0.3]), To::Ground([0.7, 0.0, 0.0])),
        cord("grounded", ("h1", [0.5, 0.1, 0.3]), To::Ground([0.7, 0.0, 0.0])),
    ];
    (text, cords)
}

/// The route of a chain with two repeated parts, and the springs of all kinds that such parts may have; `push` may be the
/// parameter of their actuators.
pub fn twins(dimension: usize, method: &str, push: &str) -> Twins {
    let (word, bodies) = BODIES[dimension];
    let [ball, pin, slider] = match dimension {
        0 => ["ball", "pin([1, 2, 3])", "slider(z)"],
        1 => ["pin", "pin", "slider(y)"],
        _ => ["slider"; 3],
    };
    let text = |part: &dyn Fn(&str, usize) -> String, parameters: &str| {
        let first =
            part(&format!("{ball} a% -> Rod b% -> weld w% -> Rod m% -> {pin} c% -> Rod d%"), 3);
        let second = part(&format!("{pin} e% -> Rod f%"), 2);
        format!(
            "{word}chain Cords {{ answers = bias_efforts; method = {method}; {push} {parameters} {bodies}
            ground -> {pin} root -> Base base -> {first} -> {slider} g -> Base middle -> {second} -> {ball} h
            -> Base weight; SPRINGS }}"
        )
    };
    let repeat =
        |part: &str, count: usize| format!("repeat {count} {{ {} }}", part.replace('%', ""));
    let write = |part: &str, count: usize| {
        let all: Vec<String> = (0..count).map(|k| part.replace('%', &format!("_{k}"))).collect();
        all.join(" -> ")
    };
    let [p, q, r] = [[0.1, 0.2, 0.3], [-0.2, 0.5, 0.1], [0.6, 0.0, 0.1]];
    let previous = |point, first| To::Previous((point, q), (first, r));
    let repeated = vec![
        cord("cord", ("d", p), previous("d", "base")),
        cord("to_first", ("d", p), To::Body(("base", q))),
        cord("to_last", ("b", r), To::Body(("weight", p))),
        cord("within", ("m", p), To::Body(("d", r))),
        cord("inside", ("m", p), To::Body(("b", r))),
        cord("grounded", ("b", q), To::Ground(r)),
        cord("lower", ("b", p), previous("d", "weight")),
        cord("from_outside", ("weight", p), To::Body(("d", r))),
        cord("plain", ("middle", p), To::Body(("base", r))),
        cord("over", ("f", p), To::Body(("d", r))),
        cord("second", ("f", p), previous("f", "d")),
        cord("far", ("weight", p), To::Body(("f", r))),
    ];
    let name = |body: &'static str, repetition: usize| -> &'static str {
        let text = match body {
            "b" | "d" | "f" | "m" => format!("{body}_{repetition}"),
            other => other.to_owned(),
        };
        Box::leak(text.into_boxed_str())
    };
    let written = repeated.iter().flat_map(|Cord { name: cord_name, on, to }| {
        let count = match on.0 {
            "b" | "d" | "m" => 3,
            "f" => 2,
            _ => 1,
        };
        let is_in = |body: &str| ["b", "d", "m"].contains(&body) == ["b", "d", "m"].contains(&on.0);
        let outside = move |(body, at): End, k: usize| {
            let last = if body == "f" { 1 } else { 2 };
            let same = is_in(body) && (on.0 == "f") == (body == "f") && count > 1;
            (name(body, if same { k } else { last }), at)
        };
        (0..count).map(move |k| Cord {
            name: format!("{cord_name}_{k}"),
            on: (name(on.0, k), on.1),
            to: match *to {
                To::Ground(at) => To::Ground(at),
                To::Body(end) => To::Body(outside(end, k)),
                To::Previous(_, (first, at)) if k == 0 => {
                    To::Body((name(first, if first == "f" { 1 } else { 2 }), at))
                }
                To::Previous((body, at), _) => To::Body((name(body, k - 1), at)),
            },
        })
    });
    let written: Vec<Cord> = written.collect();
    let parameters = (0..3).map(|k| format!("param hard_{k} = 30 N/m;")).collect::<String>();
    let repeated = with_springs(&text(&repeat, "param hard[3] = 30 N/m;"), &repeated);
    let written = with_springs(&text(&write, &parameters), &written);
    Twins { seed: dimension as u64, repeated, unrolled: written }
}

/// Returns chains of other forms: held at the end only, closed, and with a moving base and a prescribed hinge.
pub fn forms() -> Vec<(String, Vec<Cord>)> {
    let [p, q, r] = [[0.1, 0.2, 0.3], [-0.2, 0.5, 0.1], [0.6, 0.0, 0.1]];
    let cords = vec![
        cord("one", ("a1", p), To::Body(("b1", q))),
        cord("two", ("c1", r), To::Body(("a1", p))),
        cord("three", ("b1", q), To::Ground(r)),
    ];
    let routes = [
        "Base a1 -> pin(z) a -> Rod b1 -> ball b -> Rod c1 -> pin(x) c -> ground at [1, 2, 3] m",
        "ground -> ball a -> Base a1 -> pin(z) b -> Rod b1 -> ball c -> Rod c1 -> pin(x) d -> ground",
        "moving hand -> ball a -> Base a1 -> pin(z) b -> Rod b1 -> slider(x) c -> Rod c1",
        "Base a1 -> weld a -> Rod b1 -> pin(z) c -> Rod c1",
    ];
    let (_, bodies) = BODIES[0];
    let text = |(number, route): (usize, &str)| {
        let driven = if number == 2 { "hinge b { motion = input; }" } else { "" };
        let text = format!("chain Cords {{ {bodies} {route}; {driven} SPRINGS }}");
        (text, cords.clone())
    };
    routes.into_iter().enumerate().map(text).collect()
}

/// Returns a ladder of a rope, rungs on both sides, and cords between neighbouring rungs, with a repeated part and written out.
pub fn ladder() -> Twins {
    let bodies = "gravity = [1, 2, -9.81] m/s^2;
        body Beam {
            mass = 5 kg; com = [0, 0, 0] m; inertia = diag(0.1, 0.01, 0.1) kg*m^2 about com;
            output = [0, 0, 0] m; point left = [0, 0.2, 0] m; point right = [0, -0.2, 0] m;
        }
        body Link {
            mass = 0.5 kg; com = [0, 0, -0.15] m; inertia = diag(0.04, 0.04, 0.01) kg*m^2 about com;
            output = [0, 0, -0.3] m; point left = [0, 0.02, -0.3] m;
            point right = [0, -0.02, -0.3] m turned rpy(0, 0, 180) deg;
        }
        body Rung {
            mass = 0.3 kg; com = [0, 0.09, 0] m; inertia = diag(0.08, 0.03, 0.08) kg*m^2 about com;
            point end = [0, 0.18, 0] m;
        }
        body Weight { mass = 2 kg; com = [0, 0, -0.05] m; inertia = diag(0.5, 0.5, 0.5) kg*m^2 about com; }";
    let law = "stiffness = 50 N/m; damping = 2 N*s/m; length = 0.3 m;";
    let route = "ground at [0, 0, 8] m -> pin(x) lashing -> Beam beam";
    let repeated = format!(
        "chain Ladder {{ {bodies} param person[3] = 50 N/m;
        {route} -> repeat 3 from left.end = beam.left, right.end = beam.right {{
            ball knot -> Link link; link.left -> ball left_joint -> Rung left; link.right -> ball right_joint -> Rung right
        }} -> ball hook -> Weight weight;
        spring left_cord {{ on = left.end; to = last.left.end; {law} }}
        spring right_cord {{ on = right.end; to = last.right.end; {law} }}
        spring cross {{ on = left.com; to = right.end; {law} }}
        spring up {{ on = left.end; to = beam.right; stiffness = person; damping = 2; }}
        spring down {{ on = right.com; to = weight.com; {law} }} }}"
    );
    let mut written = format!(
        "chain Ladder {{ {bodies} param person_0 = 50 N/m; param person_1 = 50 N/m; param person_2 = 50 N/m; {route}"
    );
    let mut cords = [const { String::new() }; 5];
    for k in 0..3 {
        let start = if k == 0 { String::new() } else { format!("link_{}.output", k - 1) };
        write!(
            written,
            "{start} -> ball knot_{k} -> Link link_{k}; link_{k}.left -> ball left_joint_{k} -> Rung left_{k};
            link_{k}.right -> ball right_joint_{k} -> Rung right_{k};"
        )
        .expect("text can be written");
        let last = |side: &str| match k {
            0 => format!("beam.{side}"),
            _ => format!("{side}_{}.end", k - 1),
        };
        let (left, right) = (last("left"), last("right"));
        let lines = [
            format!("spring left_cord_{k} {{ on = left_{k}.end; to = {left}; {law} }}"),
            format!("spring right_cord_{k} {{ on = right_{k}.end; to = {right}; {law} }}"),
            format!("spring cross_{k} {{ on = left_{k}.com; to = right_{k}.end; {law} }}"),
            format!(
                "spring up_{k} {{ on = left_{k}.end; to = beam.right; stiffness = person_{k}; damping = 2; }}"
            ),
            format!("spring down_{k} {{ on = right_{k}.com; to = weight.com; {law} }}"),
        ];
        cords.iter_mut().zip(lines).for_each(|(cords, line)| cords.push_str(&line));
    }
    write!(written, "link_2.output -> ball hook -> Weight weight; {} }}", cords.concat())
        .expect("text can be written");
    let [repeated, unrolled] = [repeated, written].map(|text| {
        Twin::new(&text, Numbers::Written).unwrap_or_else(|error| panic!("{error}\n{text}"))
    });
    Twins { seed: 3, repeated, unrolled }
}
