//! Nothing is reported that only follows from another error; a token has one error, and errors are in
//! the order of the text. What `rustc` would say of code that uses wrong chains, `tests/ui/quiet` shows.

use super::each_error_once::expect_rods;
use super::expect_all;

/// A chain with one body type that has these fields.
fn expect_body(fields: &str, errors: &[(&str, &str)]) {
    let source = format!("chain A {{ body Rod {{ {fields} }} ground -> pin j -> Rod rod; }}");
    expect_all(&source, errors);
}

const REST: &str = "com = [1, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com;";

#[test]
fn an_unknown_field_may_be_the_missing_one() {
    let unknown = |field: &str| {
        format!(
            "body `Rod` has no field `{field}`; it has `mass`, `com`, `inertia`, `output`, `shape` and `point name`"
        )
    };
    expect_body(&format!("heft = 1 kg; {REST}"), &[("heft", &unknown("heft"))]);
    expect_body(&format!("heft = 1; {REST}"), &[("heft", &unknown("heft"))]);
    expect_body("mass = 1; com = [1, 0, 0]; J = diag(1, 1, 1) about com;", &[("J", &unknown("J"))]);
    // A vector may be a point.
    for field in ["middle", "tip"] {
        expect_body(
            &format!("mass = 1; {field} = [1, 0, 0]; inertia = diag(1, 1, 1) about com;"),
            &[(field, &unknown(field).replace("point name", &format!("point {field}")))],
        );
    }
    // What cannot be the missing one hides it not.
    expect_body(
        &format!("colour = 1 m/s; {REST}"),
        &[("Rod", "body `Rod` needs `mass`"), ("colour", &unknown("colour"))],
    );
    expect_rods(
        "ground -> pin j -> Rod rod; spring s { on = rod; k = 3 N/m; to = [0, 0, 0]; }",
        &[(
            "k",
            "spring `s` has no field `k`; \
             it has `on`, `at`, `to`, `stiffness`, `damping`, `length` and `force`",
        )],
    );
}

#[test]
fn misspelt_items_are_read_as_intended() {
    let item = |word: &str, meant: &str| format!("unknown item `{word}`; did you mean `{meant}`?");
    expect_rods(
        "ground -> pin j -> Rod rod; hing j { start = 1 kg; } lod l { on = rod; force = 1 kg; }",
        &[
            ("hing", &item("hing", "hinge")),
            ("kg", "expected an angle, found a mass"),
            ("lod", &item("lod", "load")),
            ("1 kg", "expected a vector …, found a number"),
        ],
    );
    expect_rods(
        "parm p = 1 kg; ground -> pin j -> Rod rod; hinge j { start = p; }",
        &[("parm", &item("parm", "param")), ("p", "expected an angle, found a mass")],
    );
    expect_rods(
        "ground -> repat 3 { pin j -> Rod rod }; hinge j { start = 1; }",
        &[("repat", "unknown route item `repat`; …")],
    );
    expect_rods(
        "ground -> pin z j -> Rod rod; hinge j { start = 1; }",
        &[("z", "write `pin(z) j`")],
    );
}

#[test]
fn route_items_after_an_error_are_known() {
    let rest = "hinge b, c { start = 1; } load l { on = two; force = input; }";
    expect_rods(
        &format!("ground -> pin a -> Rod one pin b -> Rod two -> pin c -> Rod three; {rest}"),
        &[("pin", "expected `->` or `;`, found `pin`")],
    );
    expect_rods(
        &format!("ground -> pin a -> Rod one; -> pin b -> Rod two -> pin c -> Rod three; {rest}"),
        &[("-", "expected an item, found `-`")],
    );
    expect_rods(
        &format!("ground -> pin a -> Rod one -> 7 -> pin b -> Rod two -> pin c -> Rod x; {rest}"),
        &[("7", "expected a hinge, a body or `ground`, found `7`")],
    );
    expect_rods(
        "ground -> repeat many { pin j -> Rod rod } -> pin k -> Rod end; hinge j, k { start = 1; }",
        &[("many", "write a repeat count in digits: …")],
    );
}

#[test]
fn a_name_that_is_used_twice_may_be_the_unknown_one() {
    let twice = [("a", "the name `a` is used twice")];
    expect_rods("ground -> pin a -> Rod x -> pin a -> Rod y; hinge b { start = 1; }", &twice);
    // A name of a body is another matter.
    expect_rods(
        "ground -> pin a -> Rod x -> pin a -> Rod y; load l { on = z; force = input; }",
        &[twice[0], ("z", "no body `z` on a route")],
    );
    expect_rods(
        "ground -> pin a -> rod Rod; load l { on = rod; force = input; }",
        &[("rod", "the type comes first, then the name: `Rod rod`")],
    );
}

#[test]
fn a_token_has_one_error() {
    // A name that is forbidden and used twice.
    expect_rods(
        "ground -> pin q -> Rod x -> pin q -> Rod y;",
        &[("q", "`q` is reserved …"), ("q", "the name `q` is used twice")],
    );
    expect_rods(
        "param ground = 1; ground -> pin j -> Rod ground;",
        &[("ground", "`ground` is a keyword …"), ("ground", "the name `ground` is used twice")],
    );
}

#[test]
fn a_hinge_without_a_second_body_needs_no_output() {
    let body = |output: &str| {
        format!(
            "body Bar {{ mass = 1; com = [1, 0, 0]; {output} inertia = diag(1, 1, 1) about com; }}"
        )
    };
    let nothing = ("k", "hinge `k` connects nothing: end the route with a body or with `ground`");
    let expect = |output: &str, route: &str, errors: &[(&str, &str)]| {
        expect_all(&format!("chain A {{ {} {route} }}", body(output)), errors);
    };
    expect("", "ground -> pin j -> Bar bar -> pin k;", &[nothing]);
    expect("output = [1, 0, 0];", "ground -> pin j -> Bar bar -> pin k;", &[nothing]);
    // An earlier body of the type has a hinge.
    let missing = ("Bar", "body `Bar` needs `output`");
    expect("", "ground -> pin j -> Bar a -> pin i -> Bar b -> pin k;", &[missing, nothing]);
    expect("", "ground -> repeat 3 { pin j -> Bar bar } -> pin k;", &[missing, nothing]);
}

#[test]
fn a_type_gives_its_bodies_no_further_error() {
    let keyword = ("r#type", "`r#type` is a keyword …");
    let body = "body r#type { mass = 1; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }";
    expect_all(&format!("chain A {{ {body} ground -> pin j -> r#type; }}"), &[keyword]);
    let body = body.replace("r#type", "Type");
    let made = ("Type", "`type` is a keyword of Rust and cannot be a name");
    expect_all(&format!("chain A {{ {body} ground -> pin j -> Type; }}"), &[made]);
}

#[test]
fn a_refused_name_may_be_the_unknown_one() {
    let refused = |name: &'static str| match name {
        "points" => (name, "`points` is reserved …"),
        _ => (name, "`type` is a keyword of Rust and cannot be a name"),
    };
    for name in ["points", "type"] {
        expect_rods(
            &format!("ground -> pin {name} -> Rod rod; hinge shoulder {{ start = 1; }}"),
            &[refused(name)],
        );
        expect_rods(
            &format!("ground -> pin j -> Rod {name}; load l {{ on = rod; force = input; }}"),
            &[refused(name)],
        );
        expect_rods(
            &format!("param {name} = 1; ground -> pin j -> Rod rod; hinge j {{ start = angle; }}"),
            &[refused(name)],
        );
    }
    let point =
        "point type = [1, 0, 0]; mass = 1; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com;";
    expect_all(
        &format!(
            "chain A {{ body Rod {{ {point} }} ground -> pin j -> Rod rod; \
             load l {{ on = rod; at = tip; force = input; }} }}"
        ),
        &[refused("type")],
    );
    let point = point.replace("point type", "lug");
    expect_all(
        &format!(
            "chain A {{ body Rod {{ {point} }} ground -> pin j -> Rod rod; \
             load l {{ on = rod; at = lug; force = input; }} }}"
        ),
        &[(
            "lug",
            "body `Rod` has no field `lug`; it has `mass`, `com`, `inertia`, `output`, `shape` and `point lug`",
        )],
    );
    // A name of another kind is another matter.
    expect_rods(
        "ground -> pin j -> Rod points; hinge k { start = 1; }",
        &[refused("points"), ("k", "no hinge `k` on a route")],
    );
}

#[test]
fn the_rest_of_a_lost_field_is_not_one() {
    let equals = |found: &str| format!("expected `=`, found `{found}`");
    expect_body(&format!("mass; 1 kg; {REST}"), &[(";", &equals(";"))]);
    expect_body(&format!("mass 1 kg; {REST}"), &[("1", &equals("1"))]);
}

#[test]
fn numbers_of_an_unknown_dimension_are_not_judged() {
    let chain = |word: &str| {
        format!(
            "{word} chain A {{ gravity = [0, -9.8]; \
             body Rod {{ mass = 1; com = [1, 0]; inertia = 1 furlong about com; }} \
             ground -> pin j -> Rod rod; }}"
        )
    };
    let unknown = "expected `space`, `plane`, `line` or nothing before `chain`";
    let meant = format!("{unknown}; did you mean `plane`?");
    let unit = ("furlong", "unknown unit `furlong`");
    expect_all(&chain("plan"), &[("plan", &meant), unit]);
    expect_all(&chain("flat"), &[("flat", unknown)]);
    expect_all(&chain("7"), &[("7", unknown)]);
}

#[test]
fn names_on_unreadable_routes_and_in_parts_are_known() {
    let rest = "hinge lf.a, c { start = 1; } load l { on = lf.b; force = input; } \
                spring s { on = lf.b; to = x.output; stiffness = 1; }";
    let part = "part Leg { pin a -> Rod b; }";
    let expect = |routes: &str, error: (&str, &str)| {
        expect_rods(&format!("{part} {routes} {rest}"), &[error]);
    };
    expect(
        "ground -> pin j -> Rod x; x.output -> Leg lf -> pin c Rod y;",
        ("Rod", "expected `->` or `;`, found `Rod`"),
    );
    expect(
        "ground -> pin j -> Rod x; x.output Leg lf -> pin c -> Rod y;",
        ("Leg", "expected `->`, found `Leg`"),
    );
    expect(
        "ground -> pin j -> Rod x; x.output -> Leg lf; x.output -> pin c -> 7;",
        ("7", "expected a hinge, a body or `ground`, found `7`"),
    );
    expect(
        "ground -> pin j -> Rod x -> repeat 3 { pin c -> Rod u pin d -> Rod w }; x.output -> Leg lf;",
        ("pin", "expected `->`, `;` or `}`, found `pin`"),
    );
    expect_rods(
        "part Leg(x) { pin a -> Rod b; hinge a { start = x; } } \
         ground -> pin j -> Rod x; x.output -> Leg() lf; hinge lf.a { start_rate = 1; }",
        &[("()", "`Leg` takes 1 number, x; found 0")],
    );
    expect_rods(
        "part Leg { pin a -> Rod b } ground -> Leg lf; hinge lf.a { start = 1; }",
        &[("b", "expected `;` after this")],
    );
    // An item of an unknown type may be a part.
    let paths = "lf.b.output -> pin k -> Rod y; hinge lf.c { start = 1; } load l { on = lf.b; force = input; }";
    for (item, message) in [("Leg", "unknown body type `Leg`"), ("Leg(1)", "unknown part `Leg`")] {
        expect_rods(
            &format!("ground -> pin j -> Rod x -> {item} lf; {paths}"),
            &[("Leg", message)],
        );
    }
    // What an unreadable part has is not known.
    expect_rods(
        "part Leg { pin a -> Rod b; 7; } ground -> Leg lf; hinge lf.c { start = k; }",
        &[("7", "expected an item, found `7`")],
    );
}

#[test]
fn a_block_with_a_wrong_name_has_the_fields_that_lack() {
    let blocks =
        |first: &str| format!("ground -> pin j -> Rod rod; {first} hinge j {{ rest = 1; }}");
    let unknown = "no hinge `jj` on a route; did you mean `j`?";
    expect_rods(&blocks("hinge jj { stiffness = 3; }"), &[("jj", unknown)]);
    let needs = "`rest` of hinge `j` needs `stiffness` as well; …";
    expect_rods(&blocks("hinge jj { damping = 3; }"), &[("jj", unknown), ("rest", needs)]);
    expect_rods(&blocks("hinge j, { stiffness = 3; }"), &[("{", "expected a name, found `{`")]);
    expect_rods(&blocks("hinge j j { stiffness = 3; }"), &[("j", "expected `{`, found `j`")]);
}

#[test]
fn fields_without_braces_are_no_items() {
    expect_rods(
        "body Bar mass = 1 kg; com = [0, 0, 0] m; point tip = [1, 0, 0] m; ground -> pin j -> Rod rod -> pin k -> Bar b;",
        &[("mass", "expected `{`, found `mass`")],
    );
    expect_rods(
        "part Leg { pin k -> Rod shin; load push on = shin; force = input; } ground -> pin j -> Rod rod -> Leg leg;",
        &[("on", "expected `{`, found `on`")],
    );
}

#[test]
fn keywords_of_types_and_parts_may_be_missing() {
    let bar = "Bar { mass = 1 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }";
    let keyword = "write the keyword: `body Bar`";
    let route = "ground -> pin j -> Rod rod -> pin k -> Bar b;";
    expect_rods(&format!("{bar} {route}"), &[("Bar", keyword)]);
    let leg = format!("part Leg {{ {bar} pin k -> Bar b; }}");
    expect_rods(&format!("{leg} ground -> pin j -> Rod rod -> Leg leg;"), &[("Bar", keyword)]);
    let legs = "ground -> pin j -> Rod rod -> Leg(1) leg; hinge leg.k { damping = 1; }";
    let part = "write the keyword: `part Leg`";
    expect_rods(&format!("Leg(c) {{ pin k -> Rod b; }} {legs}"), &[("Leg", part)]);
    let form = "write `part Name(parameter, …) { … }`, or `part Name { … }`";
    expect_rods(&format!("part {{ pin k -> Rod b; }} {legs}"), &[("part", form)]);
    expect_rods(&format!("part Leg c {{ pin k -> Rod b; }} {legs}"), &[("part", form)]);
}

#[test]
fn names_in_a_part_that_was_not_readable_may_exist() {
    expect_rods(
        "part Leg(a b) { pin k -> Rod shin; } ground -> pin j -> Rod rod -> Leg(1, 2) leg; \
         hinge leg.k { damping = 1; } spring s { on = leg.shin; to = leg.shin.output; stiffness = 1; }",
        &[("b", "expected `,`, found `b`")],
    );
    let leg = |route: &str| {
        format!(
            "part Leg {{ {route} shin.output -> pin l -> Rod foot; }} \
             ground -> pin j -> Rod rod -> Leg leg;"
        )
    };
    expect_rods(&leg("pin k Rod shin;"), &[("Rod", "expected `->` or `;`, found `Rod`")]);
    expect_rods(&leg("pin k - Rod shin;"), &[("-", "join the items of a route by `->`")]);
}

#[test]
fn one_mistake_in_several_places_is_one_error() {
    let unit = "the numbers have units already: remove `m`";
    let com = "com = [0 m, 0 m, 1 m] m; mass = 1; inertia = diag(1, 1, 1) about com;";
    expect_all(
        &format!("chain A {{ body Rod {{ {com} }} ground -> pin j -> Rod rod; }}"),
        &[("m", unit)],
    );
    let one = "this expression is a length already: …";
    expect_body(&com.replace("0 m, 0 m", "0, 0"), &[("m", one)]);
    let begins = "`repeat` begins with a hinge, not with body `two`: …";
    expect_rods("ground -> repeat 2 { Rod two -> pin b } -> Rod three;", &[("two", begins)]);
}

#[test]
fn a_point_without_a_name_may_be_any() {
    expect_all(
        "chain A { body Rod { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; point = [0, 0, 1] m; } \
         ground -> pin j -> Rod rod; rod.tip -> pin k -> Rod last; }",
        &[("point", "a point needs a name: `point name = …`")],
    );
}
