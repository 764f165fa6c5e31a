//! Messages for routes, places, repeated parts with branches, and springs between bodies.

use super::expect_all;
use super::trees::ROD;

const TRUNK: &str = "body Trunk { mass = 5 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; \
                     point lf = [1, 0, 0] m; point rf = [1, 1, 0] m; }";

/// Expects errors after a trunk with one branch.
#[track_caller]
fn expect_tree(text: &str, errors: &[(&str, &str)]) {
    let source =
        format!("chain A {{ {ROD} {TRUNK} Trunk trunk; trunk.lf -> pin hip -> Rod leg; {text} }}");
    expect_all(&source, errors);
}

/// Expects errors after a beam with a repeated part.
#[track_caller]
fn expect_repeat(from: &str, branch: &str, rest: &str, errors: &[(&str, &str)]) {
    let source = format!(
        "chain A {{ {ROD} ground -> pin root -> Rod beam \
         -> repeat 20 {from} {{ pin knot -> Rod link; {branch} }}; {rest} }}"
    );
    expect_all(&source, errors);
}

#[test]
fn places_are_on_earlier_bodies() {
    let branch = |place: &str, errors: &[(&str, &str)]| {
        expect_tree(&format!("{place} -> pin a -> Rod x;"), errors);
    };
    branch("Trunk.lf", &[("Trunk", "`Trunk` is a type; its body is `trunk`")]);
    branch("trnk.lf", &[("trnk", "no body `trnk` on a route; did you mean `trunk`?")]);
    branch("x.tip", &[("x", "no route before this one reaches `x`: write the route to it first")]);
    branch("trunk.fl", &[("fl", "`trunk` has no place `fl`; it has `input`, `lf` and `rf`")]);
    branch("trunk.com", &[("com", "nothing is joined at the centre …")]);
    branch("hip.output", &[("hip", "`hip` is a hinge: name a body and a place on it")]);
    branch(
        "last.trunk.lf",
        &[("last", "`last` is the previous repetition: use it inside `repeat` or in a spring …")],
    );
    expect_tree(
        "moving hand -> pin a -> Rod x; hand.output -> pin b -> Rod y;",
        &[("hand", "`hand` is a moving end and has no places")],
    );
    expect_tree(
        "y.tip -> pin a -> Rod x; x.tip -> pin b -> Rod y;",
        &[("y", "no route before this one reaches `y`: …")],
    );
    // A body without an output shows another place.
    expect_tree(
        "trunk -> pin a -> Rod x;",
        &[(
            "trunk",
            "a later route begins at a place: `trunk.lf -> …`; `trunk` has `input`, `lf` and `rf`",
        )],
    );
    expect_tree(
        "hip -> pin a -> Rod x;",
        &[("hip", "`hip` is not a body: a later route begins at a place of a body, as in …")],
    );
    expect_tree("trunk.rf pin a -> Rod x;", &[("pin", "expected `->`, found `pin`")]);
    expect_tree("trunk.rf;", &[(";", "expected `->`, found `;`")]);
    expect_tree("trunk.output -> pin a -> Rod x;", &[("Trunk", "body `Trunk` needs `output`")]);
}

#[test]
fn ends_are_at_the_ends_of_a_route() {
    expect_tree(
        "ground -> pin a -> Rod x -> pin b -> ground -> pin c -> Rod y;",
        &[("ground", "`ground` can only be at an end of the route: …")],
    );
}

#[test]
fn the_transfer_method_is_for_chains() {
    let chain = |routes: &str| format!("chain A {{ {ROD} method = transfer; {routes} }}");
    expect_all(
        &chain("ground -> pin a -> Rod x; x.output -> pin b -> Rod y; x.tip -> pin c -> Rod z;"),
        &[("transfer", "`transfer` is for chains: this one branches at `x`; …")],
    );
    expect_all(
        &chain("ground -> pin a -> Rod x; ground -> pin b -> Rod y;"),
        &[("transfer", "`transfer` is for chains: this one has several routes; …")],
    );
    let spring = "ground -> pin a -> Rod x -> pin b -> Rod y; \
                  spring s { on = y.tip; to = x.input; stiffness = 1; }";
    expect_all(&chain(spring), &[]);
}

#[test]
fn branches_of_a_repeat_begin_in_it() {
    let outside = "`beam` is not in this `repeat`: a route in a `repeat` begins at a body of the \
                   same repetition, or …";
    expect_repeat("", "beam.tip -> pin a -> Rod x;", "", &[("beam", outside)]);
    expect_repeat(
        "",
        "ground -> pin a -> Rod x;",
        "",
        &[("ground", "`ground` cannot be in a `repeat`: …")],
    );
    expect_repeat(
        "",
        "link -> pin a -> Rod x;",
        "",
        &[("link", "a later route begins at a place: …")],
    );
    expect_repeat("", "link.tip -> pin a;", "", &[("a", "the route has no body: add …")]);
    expect_repeat(
        "",
        "link.tip -> pin a -> Rod x -> pin b;",
        "",
        &[("b", "hinge `b` connects nothing: end the route with a body")],
    );
    expect_repeat("", "link.tip -> pin a -> Rod x", "", &[]);
    expect_repeat(
        "",
        "link.tip -> repeat 3 { pin a -> Rod x }",
        "",
        &[("repeat", "`repeat` blocks cannot be nested")],
    );
    expect_repeat(
        "",
        "link.tip -> pin a Rod x",
        "",
        &[("Rod", "expected `->`, `;` or `}`, found `Rod`")],
    );
}

#[test]
fn the_first_route_of_a_repeat_continues_the_outer_one() {
    for place in ["beam.tip", "nonsense.tip", "last.link.tip"] {
        let message = format!(
            "the first route in a `repeat` continues the route around it: remove `{place} ->`, or write a branch after the first route"
        );
        expect_all(
            &format!(
                "chain A {{ {ROD} ground -> pin root -> Rod beam \
                 -> repeat 3 {{ {place} -> pin knot -> Rod link }}; }}"
            ),
            &[(place, &message)],
        );
    }
}

#[test]
fn a_repeat_contains_routes_only() {
    let block = "a `repeat` contains routes only: write this block after the route; it applies to each repetition";
    expect_repeat("", "hinge knot { damping = 1; }", "", &[("hinge", block)]);
    expect_repeat(
        "",
        "spring s { on = link.tip; to = beam.tip; stiffness = 1; } link.tip -> pin a -> Rod x",
        "",
        &[("spring", block)],
    );
    expect_repeat(
        "",
        "",
        "hinge knot[0] { damping = 1; }",
        &[("[0]", "a block applies to each repetition: remove the index")],
    );
    expect_repeat(
        "",
        "",
        "link[3].tip -> pin a -> Rod x;",
        &[(
            "[3]",
            "a place has no index: in a `repeat` it is that of the same repetition, outside of it that of the last one; write `link.place`",
        )],
    );
    expect_repeat(
        "from beam.tip -> link.tip",
        "last.link.tip -> pin a -> Rod x;",
        "",
        &[("-", "expected `=`, found `-`")],
    );
}

#[test]
fn keywords_are_no_bodies() {
    let ground = "the ground has no named places: write `ground at [x, y, z] m` on a route, and `[x, y, z] m` in a spring";
    expect_tree("ground.left -> pin a -> Rod x;", &[("ground", ground)]);
    expect_tree(
        "spring s { on = leg.tip; to = ground.left; stiffness = 1; }",
        &[("ground", ground)],
    );
    expect_tree(
        "last.tip -> pin a -> Rod x;",
        &[(
            "last",
            "`last` is the previous repetition: name a body and a place in it, as in `last.link.output`",
        )],
    );
    let to = |to: &str| {
        let message = format!(
            "expected a place on a body, as in `to = body.point`, or a vector for a point on the ground; found `{to}`"
        );
        expect_tree(
            &format!("spring s {{ on = leg.tip; to = {to}; stiffness = 1; }}"),
            &[(to, &message)],
        );
    };
    to("world");
    to("trnk");
    expect_tree(
        "spring s { on = [0, 0, 0] m; to = leg.tip; stiffness = 1; }",
        &[(
            "[0, 0, 0]",
            "expected the name of a body on a route, found a vector: write a point on the ground after `to`",
        )],
    );
}

#[test]
fn the_previous_repetition_has_a_first_value() {
    let branch = "last.link.tip -> pin a -> Rod x;";
    expect_repeat("from link.tip = beam.tip", branch, "", &[]);
    expect_repeat(
        "",
        branch,
        "",
        &[(
            "last.link.tip",
            "`last.link.tip` has no first value: write `repeat 20 from link.tip = body.place { … }`",
        )],
    );
    expect_repeat(
        "from beam.tip = link.tip",
        branch,
        "",
        &[("beam", "`from` maps a place of the repeated part …")],
    );
    expect_repeat(
        "from link.tip = link.output",
        branch,
        "",
        &[("link", "the first value is a place …")],
    );
    let last = "`from` names places without `last`: …";
    expect_repeat("from last.link.tip = beam.tip", branch, "", &[("last", last)]);
    expect_repeat("from link.tip = last.beam.tip", branch, "", &[("last", last)]);
    expect_repeat(
        "from link.tip = beam.tip, link.tip = beam.output",
        branch,
        "",
        &[("link.tip", "`link.tip` is given twice")],
    );
    expect_repeat(
        "from link.tap = beam.tip",
        branch,
        "",
        &[("tap", "`link` has no place `tap`; it has `input`, `output` and `tip`")],
    );
    expect_repeat(
        "from link = beam",
        branch,
        "",
        &[("link", "expected `body.place`, found `link`")],
    );
    expect_repeat("from link.tip beam.tip", branch, "", &[("beam", "expected `=`, found `beam`")]);
    expect_repeat(
        "from link.com = beam.tip",
        "last.link.com -> pin a -> Rod x;",
        "",
        &[("com", "nothing is joined at the centre of mass: …")],
    );
    expect_repeat(
        "from link.tip = beam.tip",
        "last.beam.tip -> pin a -> Rod x;",
        "",
        &[("beam", "`last` is the previous repetition: name …")],
    );
}

#[test]
fn springs_know_repeated_bodies() {
    let spring = |fields: &str, errors: &[(&str, &str)]| {
        let rest = format!(
            "link.output -> weld w -> Rod end -> repeat 2 {{ pin more -> Rod other }}; \
             spring s {{ {fields} stiffness = 1; }}"
        );
        expect_repeat("from link.tip = beam.tip", "", &rest, errors);
    };
    spring("on = link; to = last.link.tip;", &[]);
    spring("on = link; to = end.tip;", &[]);
    spring(
        "on = link; to = last.link.output;",
        &[("last.link.output", "`last.link.output` has no first value: …")],
    );
    spring("on = beam.tip; to = link.tip;", &[("link", "`link` is repeated: write the spring …")]);
    spring(
        "on = other.tip; to = link.tip;",
        &[("link", "`link` is in another `repeat` than `other`: a spring cannot join them")],
    );
    spring(
        "on = beam.tip; to = last.link.tip;",
        &[("last", "`last` is the previous repetition: use …")],
    );
    spring("on = last.link.tip; to = beam.tip;", &[("last", "`on` is a body of each …")]);
    spring(
        "on = link.tap; to = beam.tip;",
        &[("tap", "`link` has no place `tap`; it has `input`, `output` and `tip`")],
    );
    spring(
        "on = links.tip; to = beam.tip;",
        &[("links", "no body `links` on a route; did you mean `link`?")],
    );
    spring("on = knot.tip; to = beam.tip;", &[("knot", "`knot` is a hinge: …")]);
}

#[test]
fn blocks_name_paths() {
    expect_tree(
        "hinge trunk.hip { start = 1; }",
        &[("trunk.hip", "no hinge `trunk.hip` on a route; did you mean `hip`?")],
    );
    expect_tree(
        "load a.b { on = trunk; force = input; }",
        &[("a.b", "the name of a load is a single word: write `load a_… { … }`")],
    );
    expect_tree("hinge hip. { start = 1; }", &[(".", "expected `{`, found `.`")]);
}

#[test]
fn derivatives_are_for_open_chains() {
    let message = |word: &str| {
        format!(
            "a chain that is held at both ends has no `{word}` yet: remove the word, or leave one end free; its \
             derivatives are those by `Dual` numbers as scalars, and its answers are `[basic, momentum, regressor, coriolis_matrix]`"
        )
    };
    let text = format!(
        "chain A {{ answers = [linearize, mass_matrix, pull]; {ROD} \
         ground -> pin a -> Rod x -> pin b -> Rod y -> pin c -> ground; }}"
    );
    expect_all(&text, &[("linearize", &message("linearize")), ("pull", &message("pull"))]);
}
