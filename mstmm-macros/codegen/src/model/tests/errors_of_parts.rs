//! Messages for `part`: its definition, and its instances on routes.

use super::expect_all;
use super::trees::ROD;

/// Expects errors in a chain of rods with these parts, on a base.
#[track_caller]
fn expect_parts(parts: &str, routes: &str, errors: &[(&str, &str)]) {
    let source = format!("chain A {{ {ROD} {parts} ground -> pin root -> Rod base; {routes} }}");
    expect_all(&source, errors);
}

const LEG: &str = "part Leg(side, front) { pin haa -> Rod hip -> pin kfe -> Rod shank; \
                   hinge haa { start = side; damping = front; } }";

#[test]
fn arguments_are_numbers() {
    let leg = |arguments: &str, errors: &[(&str, &str)]| {
        expect_parts(LEG, &format!("base.tip -> Leg{arguments} rf;"), errors);
    };
    leg("(1, 1)", &[]);
    leg("(1)", &[("(1)", "`Leg` takes 2 numbers, side and …")]);
    leg("", &[("Leg", "`Leg` takes 2 numbers, side and front; found 0")]);
    leg("(1, [1, 2])", &[("[1, 2]", "an argument of a part is …")]);
    leg("(1, foo)", &[("foo", "unknown name `foo`; for a parameter write `param foo = …`; …")]);
    leg("(1 kg, 1)", &[("side", "expected an angle, found a mass, in `Leg(1 kg, 1) rf`")]);
    leg("(1, -1)", &[("front", "a damping cannot be negative, in `Leg(1, -1) rf`")]);
    leg("(1, -(1 + 1))", &[("front", "a damping cannot be negative, in `Leg(1, …) rf`")]);
    let one = "part Leg(side) { pin haa -> Rod hip; hinge haa { start = side; } }";
    expect_parts(one, "base.tip -> Leg rf;", &[("Leg", "`Leg` takes 1 number, side; found 0")]);
    let none = "part Leg { pin haa -> Rod hip; }";
    expect_parts(
        none,
        "base.tip -> Leg(1) rf;",
        &[("(1)", "part `Leg` has no parameters: remove …")],
    );
}

#[test]
fn an_error_in_a_part_is_reported_once() {
    let legs = "base.tip -> Leg(-1, 1) lf; base.output -> Leg(-1, 1) rf;";
    let body = |fields: &str| {
        format!(
            "part Leg(m, k) {{ body B {{ {fields} }} pin a -> B b; hinge a {{ damping = k; }} }}"
        )
    };
    let rest = "com = [1, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com;";
    expect_parts(
        &body(&format!("mass = m; {rest}")),
        legs,
        &[("m", "a mass must be positive, in `Leg(-1, 1) lf`")],
    );
    expect_parts(&body(&format!("mass = n; {rest}")), legs, &[("n", "unknown name `n`; …")]);
    expect_parts(&body(rest), legs, &[("B", "body `B` needs `mass`")]);
    expect_parts(
        &body(&format!("mass = 1; {rest} heft = m;")),
        legs,
        &[("heft", "body `B` has no field `heft`; …")],
    );
    expect_parts(
        "part Leg { pin a -> Rob b; }",
        "base.tip -> Leg lf; base.tip -> Leg rf;",
        &[("Rob", "unknown body type `Rob`; did you mean `Rod`?")],
    );
}

#[test]
fn parts_are_defined_before_the_first_route() {
    let part = "part Leg { pin a -> Rod b; }";
    expect_parts(
        "",
        &format!("{part} base.tip -> Leg leg;"),
        &[("Leg", "write a `part` before the first route")],
    );
    expect_parts(part, "", &[("Leg", "part `Leg` is never set on a route")]);
    expect_parts(
        &format!("{part} {part}"),
        "base.tip -> Leg leg;",
        &[("Leg", "two parts have the name `Leg`")],
    );
    expect_parts("part Rod { pin a -> Rod b; }", "", &[("Rod", "`Rod` is a part and a …")]);
    expect_parts(
        "part pin { pin a -> Rod b; }",
        "",
        &[("pin", "`pin` is a keyword of this language …")],
    );
    expect_parts(
        "part Leg { }",
        "base.tip -> Leg leg;",
        &[("Leg", "part `Leg` has no route: write its hinges and bodies, as in …")],
    );
    expect_parts(
        "prat Leg() { pin a -> Rod b; }",
        "base.tip -> Leg leg;",
        &[("prat", "unknown item `prat`; did you mean `part`?")],
    );
    expect_parts(
        part,
        "base.tip -> Legg leg;",
        &[("Legg", "unknown body type `Legg`; did you mean `Leg`?")],
    );
    expect_parts(
        part,
        "base.tip -> Legg(1) leg; base.tip -> Leg x;",
        &[("Legg", "unknown part `Legg`; did you mean `Leg`?")],
    );
    let twice = "part Leg(x, x) { pin a -> Rod b; hinge a { start = x; } }";
    expect_parts(
        twice,
        "base.tip -> Leg(1, 1) leg;",
        &[("x", "part `Leg` has two parameters `x`")],
    );
    let hides = "param x = 1; part Leg(x) { pin a -> Rod b; hinge a { start = x; } }";
    expect_parts(
        hides,
        "base.tip -> Leg(1) leg;",
        &[("x", "the parameter `x` of part `Leg` hides the `param` of the chain: rename one")],
    );
    let word = "part Leg(input) { pin a -> Rod b; }";
    expect_parts(word, "base.tip -> Leg(1) leg;", &[("input", "`input` is a keyword …")]);
    expect_parts("part Leg(1) { pin a -> Rod b; }", "", &[("1", "expected a name, found `1`")]);
}

#[test]
fn arguments_and_parameters_are_plain() {
    let named = "base.tip -> Leg(side = 1, front = 1) rf;";
    let message = "arguments have no names: remove `side =`";
    expect_parts(LEG, named, &[("side", message)]);
    expect_parts(LEG, "base.tip -> Leg[1, 1] rf;", &[("[1, 1]", "write `Leg(1 , 1) rf`")]);
    let message = "a parameter of a part is a number without a default: write its name only";
    for (parameter, at) in [("side = 1", "="), ("side: f64", ":")] {
        let part = format!("part Leg({parameter}) {{ pin a -> Rod b; }}");
        expect_parts(&part, "base.tip -> Leg(1) rf;", &[(at, message)]);
    }
}

#[test]
fn names_in_a_part_have_a_path() {
    let leg = |text: &str, errors: &[(&str, &str)]| {
        expect_parts(LEG, &format!("base.tip -> Leg(1, 1) rf; {text}"), errors);
    };
    leg(
        "hinge kfe { damping = 1; }",
        &[("kfe", "no hinge `kfe` on a route; did you mean `rf.kfe`?")],
    );
    leg(
        "load w { on = rf.shnk; force = input; }",
        &[("shnk", "no body `rf.shnk` on a route; did you mean `rf.shank`?")],
    );
    let part = "part Link { pin k -> Rod link; last.link.tip -> pin a -> Rod x; }";
    let set = |from: &str| format!("base.tip -> repeat 3 {from} {{ Link s }};");
    expect_parts(part, &set("from s.link.tip = base.tip"), &[]);
    expect_parts(
        part,
        &set(""),
        &[("last.link.tip", "… no first value: write `repeat 3 from s.link.tip = body.place …`")],
    );
}

#[test]
fn a_type_in_a_part_is_known_in_it_only() {
    let foot = "part Leg { body Foot { mass = 1 kg; com = [1, 0, 0] m; \
                inertia = diag(1, 1, 1) kg*m^2 about com; } pin a -> Rod b -> pin c -> Foot d; }";
    let message = "only part `Leg` knows the type `Foot`: to use it here, write the type outside \
                   of the part";
    expect_parts(
        foot,
        "base.tip -> Leg leg; base.output -> pin e -> Foot f;",
        &[("Foot", message)],
    );
    expect_parts(
        &format!("{foot} part Arm {{ pin a -> Foot b; }}"),
        "base.tip -> Leg leg; base.output -> Arm arm; base.tip -> Arm other;",
        &[("Foot", message)],
    );
}

#[test]
fn parts_have_no_ends_and_no_settings() {
    let part = |content: &str, errors: &[(&str, &str)]| {
        expect_parts(&format!("part Leg {{ {content} }}"), "base.tip -> Leg leg;", errors);
    };
    part(
        "ground -> pin a -> Rod b;",
        &[("ground", "`ground` is written outside of parts: `ground -> Leg name`")],
    );
    part(
        "pin a -> Rod b; moving m -> pin c -> Rod d;",
        &[("moving", "`moving` is written outside of parts: …")],
    );
    part("-> pin a -> Rod b;", &[("-", "a part begins with a hinge or a body: remove `->`")]);
    part(
        "b.tip -> pin a -> Rod b;",
        &[(
            "b.tip",
            "the first route of a part begins with a hinge or a body, not at a place: remove `b.tip ->`",
        )],
    );
    part("param k = 1; pin a -> Rod b;", &[("param", "write `param` outside of parts, and …")]);
    for setting in ["method = riccati", "method riccati", "method"] {
        part(
            &format!("{setting}; pin a -> Rod b;"),
            &[("method", "write `method` outside of parts: it …")],
        );
    }
    part(
        "part Toe { pin c -> Rod d; } pin a -> Rod b;",
        &[("part", "write a `part` outside of other …")],
    );
    part(
        "pin a -> Rod b; nonsense;",
        &[(
            "nonsense",
            "unknown item `nonsense`; the items are `body`, the routes, `hinge`, `load` and `spring`",
        )],
    );
}

#[test]
fn parts_do_not_contain_themselves() {
    let itself = "part Leg { pin a -> Rod b -> Leg c; }";
    expect_parts(
        itself,
        "base.tip -> Leg leg;",
        &[("Leg", "part `Leg` contains itself: Leg, Leg")],
    );
    let both = "part A { pin a -> Rod b -> B c; } part B { pin d -> Rod e -> A f; }";
    expect_parts(both, "base.tip -> A x;", &[("A", "part `A` contains itself: A, B, A")]);
    let repeat = "part Tail { pin a -> Rod b -> repeat 3 { pin c -> Rod d }; }";
    let message =
        "part `Tail` has a `repeat` and is set in a `repeat`: `repeat` blocks cannot be nested";
    expect_parts(repeat, "base.tip -> repeat 2 { Tail tail };", &[("Tail", message)]);
}

#[test]
fn parts_are_not_too_deep_nor_too_large() {
    let nested = |count: usize, content: fn(usize) -> String| -> String {
        (0..count).map(|index| format!("part P{index}(x) {{ {} }}", content(index + 1))).collect()
    };
    let last =
        |count: usize| format!("part P{count}(x) {{ pin a -> Rod b; hinge a {{ start = x; }} }}");
    let expect = |count: usize, content: fn(usize) -> String, at: &str, message: &str| {
        let parts = nested(count, content) + &last(count);
        expect_parts(&parts, "base.tip -> P0(1) x;", &[(at, message)]);
    };
    expect(
        40,
        |next| format!("pin a -> Rod b -> P{next}(x) p;"),
        "P32",
        "more than 32 parts in parts",
    );
    let size = "with its parts written out this chain has more than 20000 items";
    expect(20, |next| format!("P{next}(x) p -> P{next}(x) q;"), "P20", size);
    let long = "this argument is too long with the arguments in it written out: write a part of it as a \
                `param` or a Rust `const`, in `P7(…) p`";
    expect(20, |next| format!("P{next}(x + x) p;"), "x + x", long);
}

#[test]
fn parts_know_only_their_own_bodies() {
    let own = "part `Leg` knows only its own …";
    for fields in [
        "load l { on = base; force = input; }",
        "spring s { on = base.tip; to = b.tip; stiffness = 1; }",
        "spring s { on = b.tip; to = base.tip; stiffness = 1; }",
        "base.tip -> pin c -> Rod d;",
    ] {
        let part = format!("part Leg {{ pin a -> Rod b; {fields} }}");
        expect_parts(&part, "base.tip -> Leg leg;", &[("base", own)]);
    }
}

#[test]
fn hinges_and_bodies_alternate_across_parts() {
    let leg = "part Leg { pin haa -> Rod hip; } part Beam { Rod near -> pin far; }";
    expect_parts(
        leg,
        "base.tip -> pin a -> Leg l; base.tip -> pin b -> Beam x -> Rod y;",
        &[("l", "`Leg` begins with hinge `haa`: remove …")],
    );
    let expect = |route: &str, errors: &[(&str, &str)]| {
        expect_parts(
            leg,
            &format!("base.tip -> Leg leg; base.tip -> pin b -> Beam beam -> Rod y; {route}"),
            errors,
        );
    };
    expect(
        "base.tip -> pin c -> Beam x -> pin d -> Rod z;",
        &[("d", "`Beam` ends with hinge `far`: remove …")],
    );
    expect("base.tip -> pin c -> Beam x -> Leg m;", &[("m", "`Beam` ends with hinge `far` and …")]);
    expect(
        "base.tip -> Beam x -> Rod z;",
        &[("x", "`base.tip` and body `x.near` have no hinge between them: …")],
    );
    expect(
        "base.tip -> pin c -> Rod z -> Beam x -> Rod w;",
        &[("x", "`Beam` begins with body `near`: add a hinge before it, such as `weld name`")],
    );
    expect(
        "base.tip -> Leg m -> Rod z;",
        &[("z", "`Leg` ends with body `hip`: add a hinge after it, such as `weld name`")],
    );
    expect(
        "base.tip -> pin c -> Beam x;",
        &[("x", "hinge `x.far` connects nothing: end the route with a body")],
    );
}

#[test]
fn names_of_parts_are_unique() {
    let leg = "part Leg { pin haa -> Rod hip; hinge haa { start = 1; } }";
    let expect = |routes: &str, errors: &[(&str, &str)]| expect_parts(leg, routes, errors);
    expect("base.tip -> Leg l; base.tip -> Leg l;", &[("l", "the name `l` is used twice")]);
    expect(
        "base.tip -> Leg; base.tip -> Leg;",
        &[("Leg", "the name `leg` is used twice; write a name after the part")],
    );
    expect(
        "base.tip -> Leg l; base.tip -> pin l -> Rod x;",
        &[("l", "the name `l` is used twice")],
    );
    expect("base.tip -> Leg last;", &[("last", "an instance of a part cannot …")]);
    expect(
        "base.tip -> Leg l; base.tip -> pin l_haa -> Rod x;",
        &[("l_haa", "`l_haa` and `l.haa` both make the method `l_haa`: rename one")],
    );
    expect(
        "base.tip -> Leg l; hinge l.haa { start = 2; }",
        &[("start", "`start` of `l.haa` is given in part `Leg` already")],
    );
    expect_parts(
        "part Leg { pin haa -> Rod hip -> weld w -> Rod hip; }",
        "base.tip -> Leg l;",
        &[("hip", "the name `hip` is used twice in part `Leg`")],
    );
    expect_parts("part Leg { pin t -> Rod x; }", "base.tip -> Leg se; base.tip -> Leg l;", &[]);
    expect_parts(
        "part Leg { pin hinge -> Rod _; }",
        "base.tip -> Leg l;",
        &[
            ("hinge", "`hinge` is a keyword of this language …"),
            ("_", "`_` is a keyword of Rust …"),
        ],
    );
    let types = "body LegHip { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; } \
                 part Leg { body Hip { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; } pin a -> Hip b; }";
    expect_parts(
        types,
        "base.tip -> Leg l; base.tip -> weld x -> LegHip y;",
        &[("Hip", "the results of this type have …")],
    );
}

#[test]
fn an_instance_is_no_body() {
    let leg = "part Leg { pin haa -> Rod hip; }";
    let expect = |text: &str, errors: &[(&str, &str)]| {
        expect_parts(leg, &format!("base.tip -> Leg l; {text}"), errors);
    };
    let part = "`l` is a part: name the body and the place, `l.hip.output`";
    expect("l -> pin a -> Rod x;", &[("l", part)]);
    expect("l.output -> pin a -> Rod x;", &[("l", part)]);
    expect("load f { on = l; force = input; }", &[("l", part)]);
    expect("l.hip -> pin a -> Rod x;", &[("l.hip", "name the place on `l.hip`: `l.hip.output`")]);
    expect(
        "l.haa -> pin a -> Rod x;",
        &[("l.haa", "`l.haa` is a hinge: name a body and a place on it")],
    );
    expect(
        "l.hop.tip -> pin a -> Rod x;",
        &[("l.hop", "no body `l.hop` on a route; did you mean `l.hip`?")],
    );
    expect("hinge l { start = 1; }", &[("l", "`l` is a part: name a hinge in it, as in `l.name`")]);
    expect(
        "hinge l.hoa { start = 1; }",
        &[("l.hoa", "no hinge `l.hoa` on a route; did you mean `l.haa`?")],
    );
    expect("body l.hip { start = [0, 0, 0]; }", &[("l.hip", "`l.hip` has no start: …")]);
    let floats = "part Rex { Rod r -> pin a -> Rod s; body r { start = [0, 0, 0]; } }";
    expect_all(
        &format!("chain A {{ {ROD} {floats} Rex rex; }}"),
        &[("r", "write the start of a floating body outside of parts: `body rex.r { … }`")],
    );
}

#[test]
fn a_parameter_is_multiplied_before_a_unit() {
    let part = |damping: &str| {
        format!("part Leg(size) {{ pin haa -> Rod hip; hinge haa {{ damping = {damping}; }} }}")
    };
    let unit = "N*m*s/rad";
    let leg = "base.tip -> Leg(2) leg;";
    expect_parts(&part(&format!("(0.2 {unit}) * size")), leg, &[]);
    expect_parts(&part(&format!("0.2 * size {unit}")), leg, &[]);
    let message = "a unit ends a product: write `(2 m) * size`, …";
    expect_parts(&part(&format!("0.2 {unit} * size")), leg, &[("size", message)]);
}
