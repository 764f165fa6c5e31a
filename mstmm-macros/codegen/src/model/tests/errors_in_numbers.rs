//! Errors in numbers, vectors and units.

use super::expect;

/// A mass that is wrong.
#[track_caller]
fn expect_mass(value: &str, errors: &[(&str, &str)]) {
    expect("mass = 2 kg", &format!("mass = {value}"), errors);
}

#[test]
fn a_unit_must_fit() {
    expect_mass("2 kg*m^2", &[("kg*m^2", "expected a mass, found a moment of inertia")]);
    expect_mass("-30 deg", &[("deg", "expected a mass, found an angle")]);
    expect_mass("(1 kg)/(1 kg)", &[("(1 kg)/(1 kg)", "expected a mass, found a plain number")]);
    expect_mass("1 kg*m/s/s/s", &[("kg*m/s/s/s", "expected a mass, found a quantity in kg*m/s^3")]);
    expect(
        "[0, -9.8, 0] m/s^2",
        "[0, -9.8 m, 0]",
        &[("m", "expected an acceleration, found a length")],
    );
    expect("pin(z)", "pin([0, 0, 1] m)", &[("m", "expected a plain number, found a length")]);
}

#[test]
fn pi_is_in_radians() {
    let radians = "`PI` is an angle in radians: remove `deg`, or write the angle in degrees";
    let start = |angle: &str| format!("start = {angle}");
    for angle in ["PI/2 deg", "-2*PI deg", "PI deg"] {
        expect("start = 30 deg", &start(angle), &[("deg", radians)]);
    }
}

#[test]
fn numbers_are_well_formed() {
    let malformed =
        "this is not a number: a number is written as `15`, `1.5` or `1.5e-3`, and then its unit";
    for number in ["1e", "1E", "2x3", "2.5x", "2e"] {
        expect_mass(&format!("{number} kg"), &[(number, malformed)]);
        expect_mass(number, &[(number, malformed)]);
    }
}

#[test]
fn numbers_begin_with_a_digit() {
    expect_mass(".5 kg", &[(".", "write a digit before the point, as in `0.5`")]);
    expect("[0, -9.8, 0] m/s^2", "[0, -.8, 0] m/s^2", &[(".", "write a digit …")]);
}

#[test]
fn terms_have_one_dimension() {
    expect_mass("1 kg + 2 m", &[("m", "expected a mass, found a length")]);
    expect_mass(
        "1 kg + 2",
        &[("2", "this number has no unit, but is in a sum with a mass: write its unit")],
    );
    expect_mass(
        "1 kg + ratio",
        &[("ratio", "this number has no unit, but is in a sum with a mass: write its unit")],
    );
}

#[test]
fn a_unit_closes_its_product() {
    let message = "a unit ends a product: …";
    expect_mass("2 kg * 3", &[("*", message)]);
    let message = "a unit ends a product: write `(… kg) / …` to continue it";
    expect_mass("2 kg / (3 m)", &[("/", message)]);
    let message = "… not `2 m * ratio`";
    expect_mass("2 kg * ratio", &[("ratio", message)]);
    let message = "a unit ends a product: write `(2 m) * MASS`, not `2 m * MASS`";
    expect_mass("2 kg * MASS", &[("MASS", message)]);
    let message = "a unit ends a product: write `(2 m) / ratio`, not `2 m / ratio`";
    expect_mass("2 kg / ratio", &[("ratio", message)]);
    let message = "this expression is a mass already: …";
    expect_mass("(2 kg) g", &[("kg", message)]);
    expect_mass("payload kg", &[("payload", message)]);
    let message = "this expression is a length already: …";
    expect("output = [1, 0, 0] m", "output = [1 mm, 0, 0] m", &[("mm", message)]);
}

#[test]
fn factors_are_no_units() {
    let message =
        |name: &str| format!("`{name}` is not a unit: write `*` before it, as in `2 * {name}`");
    expect_mass("2 ratio", &[("ratio", &message("ratio"))]);
    expect_mass("2 MASS", &[("MASS", &message("MASS"))]);
    expect_mass("2 PI", &[("PI", &message("PI"))]);
    expect_mass("2PI", &[("2PI", &message("PI"))]);
    expect("start = 30 deg", "start = 2 PI rad", &[("PI", &message("PI"))]);
}

#[test]
fn units_are_known() {
    expect_mass("1kq", &[("1kq", "unknown unit `kq`")]);
    let hint = "units multiply with `*`: ";
    expect_mass("1 Nms/rad", &[("Nms", &format!("unknown unit `Nms`; {hint}`N*m*s`"))]);
    expect_mass(
        "1 kg\u{b7}m",
        &[("kg\u{b7}m", &format!("unknown unit `kg\u{b7}m`; {hint}`kg*m`"))],
    );
    expect_mass("1f64", &[("1f64", "a number has no type suffix here: …")]);
    expect_mass("1 kg^99", &[("99", "expected a whole power up to 9")]);
    expect_mass("1 kg^0.5", &[("0.5", "expected a whole power up to 9")]);
}

#[test]
fn names_are_known() {
    expect_mass("paylod", &[("paylod", "unknown name `paylod`; did you mean `payload`?")]);
    let constants = "unknown name `m_rod`; for a parameter write `param m_rod = …`; …";
    expect_mass("m_rod", &[("m_rod", constants)]);
    let other = "`T` is the scalar type of a chain here: name the constant by another path";
    expect_mass("T::M", &[("T::M", other)]);
    expect_mass("Self::M", &[("Self", "`Self` is not known here: …")]);
    expect_mass("data::fn", &[("fn", "expected a name, found `fn`")]);
    expect_mass("dyn::M", &[("dyn", "expected a name, found `dyn`")]);
    // Two signs in Rust, which a path would take with it into the code.
    expect_mass("data: :MASS", &[(":", "expected `;`, found `:`")]);
    expect_mass("a::m(1)", &[("(1)", "Rust functions cannot be called here: …")]);
    expect_mass("2 * srqt(4)", &[("srqt", "unknown function `srqt`; did you mean `sqrt`?")]);
    expect_mass("sqrt(4, 5)", &[("sqrt(4, 5)", "`sqrt` has one argument")]);
    expect_mass("sqrt(4 kg)", &[("kg", "a mass has no square root")]);
    expect(
        "= 0.5 kg",
        "= ratio",
        &[(
            "ratio",
            "the default of a parameter cannot use a parameter: write numbers or Rust \
                     constants",
        )],
    );
}

#[test]
fn numbers_are_finite() {
    expect_mass("1/(1 - 1)", &[("(1 - 1)", "division by zero")]);
    expect_mass("0^-1", &[("0^-1", "division by zero")]);
    expect(
        "com = [0.5, 0, 0] m;\n            output",
        "com = [1e308, 0, 0] km; output",
        &[("1e308", "this is not a finite number")],
    );
}

#[test]
fn parentheses_contain_one_number() {
    expect_mass("(1 2)", &[("2", "expected an operator or `)`, found `2`")]);
}

#[test]
fn adjacent_errors_are_all_reported() {
    expect_mass(
        "(1 mm + paylod) * MASS + 2 KG",
        &[
            ("paylod", "unknown name `paylod`; did you mean `payload`?"),
            ("KG", "unknown unit `KG`; did you mean `kg`?"),
        ],
    );
    expect(
        "output = [1, 0, 0] m",
        "output = [a, b, 1 q]",
        &[("a", "unknown name `a`; …"), ("b", "unknown name `b`; …"), ("q", "unknown unit `q`")],
    );
}

#[test]
fn depth_and_length_have_limits() {
    let nested = |depth: usize| format!("{}1{}", "(".repeat(depth), ")".repeat(depth));
    expect_mass(&nested(28), &[]);
    let too_deep = "more than 32 nested groups";
    expect_mass(&nested(150), &[("(", too_deep)]);
    expect_mass(&format!("{} 1", "-".repeat(10_000)), &[]);
    let error = "more than 256 terms or factors in one formula: write a part of it as a Rust \
                 `const`";
    expect_mass(&vec!["MASS"; 257].join(" + "), &[("MASS", error)]);
    expect_mass(&vec!["MASS"; 257].join(" * "), &[("MASS", error)]);
}

/// Powers of powers would grow beyond all bounds.
#[test]
fn powers_have_limits() {
    let tower = |base: &str| (0..20).fold(base.to_owned(), |base, _| format!("({base}^9)"));
    expect_mass(&tower("1"), &[]);
    let found = super::errors_in(&super::edited(&[("2 kg", &tower("MASS"))]));
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].1, "this formula is too long: write a part of it as a Rust `const`");
    let found = super::errors_in(&super::edited(&[("2 kg", &tower("(1 m)"))]));
    assert_eq!(found.len(), 1);
}

#[test]
fn values_of_other_kinds_are_named() {
    expect_mass("[1, 2, 3] kg", &[("[1, 2, 3]", "expected a mass as a single number, …")]);
    expect_mass("\"2\"", &[("\"2\"", "write it without quotes")]);
    expect_mass("diag(1, 2, 3) kg", &[("diag(1, 2, 3)", "expected a mass, found `diag(…)`")]);
    expect_mass("1 kg kg", &[("kg", "units multiply with `*`: `kg*kg`")]);
}

#[test]
fn notations_of_other_languages_are_known() {
    expect_mass("1,5 kg", &[(",", "write decimals with a point")]);
    expect_mass("-0,5 kg", &[(",", "write decimals with a point")]);
    expect_mass("2**3 kg", &[("*", "write powers with `^`")]);
    expect_mass("2 kg**2", &[("*", "write powers with `^`")]);
    expect_mass("2 kg.m", &[("m", "units multiply with `*`: `kg*m`")]);
    expect_mass("(1, 2, 3) kg", &[("(", "write vectors as `[x, y, z]`")]);
    expect_mass("let x = 1", &[("let", "expected a number, found `let`")]);
    let inside = "write signs and factors inside the brackets";
    let output = "[1, 0, 0] m;\n            inertia";
    let rest = "inertia";
    expect(output, &format!("-[1, 0, 0] m; {rest}"), &[("[1, 0, 0]", inside)]);
    expect(output, &format!("2*[1, 0, 0] m; {rest}"), &[("[1, 0, 0]", inside)]);
    expect(output, &format!("[1, 0, 0]/3; {rest}"), &[("/", inside)]);
    expect(output, &format!("[1, 0, 0] m * 3; {rest}"), &[("*", inside)]);
    let tensor = "diag(0, 1/6, 1/6) kg*m^2 about com";
    expect(tensor, &format!("2 * {tensor}"), &[("diag", inside)]);
    expect(tensor, "diag(0, 1/6, 1/6) * 2 about com", &[("*", inside)]);
    expect(output, &format!("(1, 0, 0) m; {rest}"), &[("(", "write vectors as `[x, y, z]`")]);
}

#[test]
fn units_have_no_parentheses() {
    let message = |unit: &str| format!("write the unit without parentheses: `{unit}`");
    let gravity = "[0, -9.8, 0] m/s^2";
    expect(gravity, "[0, -9.8, 0] m/(s^2)", &[("(s^2)", &message("m/s^2"))]);
    expect(gravity, "[0, -9.8, 0] (m/s^2)", &[("(m/s^2)", &message("m/s^2"))]);
    expect_mass("1 N*m/(rad/s)^2", &[("(rad/s)", &message("N*m*s^2/rad^2"))]);
    // Not a unit.
    let closes = "a unit ends a product: write `(2 m) / payload`, not …";
    expect_mass("1 kg / (payload)", &[("payload", closes)]);
    let closes = "a unit ends a product: write `(… km/h) / …` to continue it";
    expect_mass("1 km/h / (3 m)", &[("/", closes)]);
}

#[test]
fn symbols_are_known_by_their_names() {
    expect_mass("1 degrees", &[("degrees", "unknown unit `degrees`; did you mean `deg`?")]);
    expect_mass("1 kg*m/s2", &[("s2", "unknown unit `s2`; write `s^2`")]);
    expect_mass("5 \u{b5}g", &[("\u{b5}g", "unknown unit `\u{b5}g`; write `ug`")]);
    expect_mass("1 N m", &[("m", "units multiply with `*`: `N*m`")]);
    expect("= [1, 0, 0] m;", "= [1, 0, 0] N m;", &[("m", "units multiply with `*`: `N*m`")]);
    let gram = "`g` is gram; …";
    expect("[0, -9.8, 0] m/s^2", "-1 g", &[("g", gram)]);
}

#[test]
fn functions_are_known() {
    let unknown =
        |name: &str| format!("unknown function `{name}`; there are `sqrt`, `sin` and `cos`");
    expect_mass("tan(1)", &[("tan", &unknown("tan"))]);
    expect_mass("exp(1) kg", &[("exp", &unknown("exp"))]);
    expect_mass("max(1 kg, 2 kg)", &[("max", &unknown("max"))]);
    expect_mass("foo(1) * 2 kg", &[("foo", &unknown("foo"))]);
    // Names that are close to those of other functions.
    for name in ["asin", "acos", "sinh"] {
        expect_mass(&format!("{name}(1)"), &[(name, &unknown(name))]);
    }
    expect("= 0.5 kg", "= tan(1)", &[("tan", &unknown("tan"))]);
    expect("= 0.5 kg", "= sine(1)", &[("sine", "unknown function `sine`; did you mean `sin`?")]);
    expect("[1, 0, 0] m", "foo(1)", &[("foo", &unknown("foo"))]);
}

#[test]
fn the_expected_kind_decides_which_term_is_wrong() {
    expect_mass("1 m + 1 kg", &[("m", "expected a mass, found a length")]);
    expect_mass("1 m + 2 s", &[("s", "a length and a time cannot be in a sum")]);
}

#[test]
fn input_is_a_whole_value() {
    let torque = "torque = input;";
    expect(torque, "torque = input N*m;", &[("N*m", "`input` has no unit: remove the unit")]);
    let message = "`input` cannot be part of a formula: write it as the whole value of a field";
    expect(torque, "torque = 2 * input;", &[("input", message)]);
    expect(torque, "torque = input + 1;", &[("input", message)]);
    let message =
        "this value cannot be `input`: write a number, or a `param` that a program can change";
    for mass in ["input", "2 * input", "(input) + payload"] {
        expect_mass(mass, &[("input", message)]);
    }
    expect(torque, "stiffness = input; torque = input;", &[("input", message)]);
    expect("start = 30 deg", "start = input", &[("input", message)]);
    let message =
        "the default of a parameter cannot be `input`: write a number, which a program can change";
    expect("= 0.5 kg", "= input", &[("input", message)]);
    expect(
        "[0, -9.8, 0] m/s^2",
        "Input",
        &[("Input", "unknown word `Input`; did you mean `input`?")],
    );
    expect(torque, "torque = INPUT;", &[]);
}

#[test]
fn long_literals_are_refused_before_they_are_read() {
    let number = |digits: usize| "1".repeat(digits);
    expect_mass(&number(100), &[]);
    let long = number(100_000);
    expect_mass(&long, &[(&long, "a number has no more than 100 digits")]);
}

/// The value at the default is finite, but not its derivative.
#[test]
fn a_root_has_derivatives_where_they_are_answers() {
    let source = |answers: &str, defaults: [f64; 2], damping: &str| {
        let [a, b] = defaults;
        format!(
            "chain A {{ {answers} param a = {a}; param b = {b}; body Rod {{ mass = 1; com = [1, 0, 0]; \
             inertia = diag(1, 1, 1) about com; }} ground -> pin(y) h -> Rod rod; hinge h {{ damping = {damping}; stiffness = \
             a + b; }} }}"
        )
    };
    let message = "`linearize`, `push` and `pull` have derivatives by parameters, which are infinite where the argument of \
                   `sqrt` is zero: it must be positive; with its parameters' defaults it is 0";
    for word in ["linearize", "push", "pull"] {
        let answers = format!("answers = [{word}];");
        for damping in ["sqrt(a)", "1 + sqrt(a)", "b*sqrt(a^2)", "sin(sqrt(a*b))"] {
            super::expect_all(&source(&answers, [0.0, 1.0], damping), &[(damping, message)]);
            super::expect_all(&source(&answers, [1.0, 1.0], damping), &[]);
        }
        super::expect_all(&source(&answers, [0.0, 1.0], "sqrt(b) + sqrt(0)"), &[]);
        let undefined = "… with its parameters' defaults it is NaN";
        super::expect_all(&source(&answers, [-1.0, 1.0], "sqrt(a)"), &[("sqrt(a)", undefined)]);
    }
    super::expect_all(&source("answers = [basic, derivatives];", [0.0, 1.0], "sqrt(a)"), &[]);
}
