//! Words of the language, and words that are none.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

pub const WORDS: &str = "chain space plane line pub gravity method riccati transfer results poses velocities \
    energies param body hinge load spring point ground moving repeat from last part at turned about input output com pin ball weld slider \
    screw cylindrical universal gimbal planar floating elastic diag tensor matrix rpy quaternion sqrt sin \
    cos box cylinder capsule sphere mesh radius PI x y z kg m s rad deg N";

/// Names that many texts have in common, so that some are given and used.
pub const NAMES: &str = "h0 h1 h2 b0 b1 b2 k tip hand Rod Link K";

pub const FIELDS: &str = "mass inertia com output start rest motion start_rate start_velocity force \
    torque stiffness damping armature friction friction_speed limits limit_stiffness limit_damping \
    turning_stiffness turning_damping turning_armature turning_friction turning_friction_speed \
    turning_limits turning_limit_stiffness turning_limit_damping on at to axes length shape";

pub const NUMBERS: &str = "0 1 2 3 -1 0.5 1e-3 10 100 1_000 10000000 10000001 2147483647 2147483648 \
    18446744073709551616 0x10 0b1 1e308 -1e308 1e-308 1e-320 1e999 1e200 1. 2kg 3e 1f32 1usize \
    340282366920938463463374607431768211456";

const SIGNS: &str = "; , . = -> => - + * / ^ : :: # ! ? < > | & @ $ ~ % .. ** --";

/// What no one would write, separated by two signs.
const STRANGE: &str = "Self @@ self @@ crate @@ super @@ _ @@ fn @@ let @@ r#type @@ r#ground @@ r#x \
    @@ dyn @@ async @@ T @@ State @@ Inputs @@ 'a @@ 'static @@ \"text\" @@ \"\" @@ b\"x\" @@ c\"x\" \
    @@ 'x' @@ b'x' @@ r#\"raw\"# @@ /// text\n @@ //! text\n @@ /** text */ @@ #[doc = \"x\"] \
    @@ #[cfg(x)] @@ #![x] @@ #[derive(Debug)] @@ é @@ 名 @@ ẞ @@ µm @@ () @@ [] @@ {} \
    @@ invisible() @@ invisible(1 + 2) @@ invisible(-1) @@ invisible(x) @@ ((((1)))) \
    @@ [[1, 2], [3]] @@ {{{}}} @@ - - - - 1 @@ ::std::f64::consts::PI @@ <T as Trait>::K \
    @@ crate::K @@ data::MASS @@ data::fn @@ _::K @@ data: :K @@ f::<1>(2) @@ 1..2 @@ if x { 1 } else { 2 }";

/// One of the words of a list, now and then another.
pub fn pick(list: &'static str) -> BoxedStrategy<String> {
    prop_oneof![20 => one_of(list, " "), 1 => word()].boxed()
}

/// One of what stands between the separators.
pub fn one_of(list: &'static str, separator: &str) -> BoxedStrategy<String> {
    let parts = list.split(separator).map(|part| part.trim_matches(' ').to_owned());
    select(parts.collect::<Vec<_>>()).boxed()
}

pub fn word() -> BoxedStrategy<String> {
    prop_oneof![
        2 => one_of(WORDS, " "),
        2 => one_of(NAMES, " "),
        2 => one_of(FIELDS, " "),
        2 => one_of(NUMBERS, " "),
        2 => one_of(SIGNS, " "),
        2 => one_of(STRANGE, "@@"),
    ]
    .boxed()
}

/// Words and groups of words without order.
pub fn soup() -> BoxedStrategy<String> {
    let groups = |inner| {
        let brackets = select(&[("(", ")"), ("[", "]"), ("{", "}"), ("invisible(", ")"), ("", "")]);
        let separator = select(&[" ", ", ", "; ", " -> ", " + "]);
        (brackets, separator, vec(inner, 0..6)).prop_map(|((open, close), separator, parts)| {
            format!("{open}{}{close}", parts.join(separator))
        })
    };
    word().prop_recursive(4, 24, 6, groups).boxed()
}

/// A thing that has no place in a right chain, or perhaps one elsewhere.
pub fn hostile() -> BoxedStrategy<String> {
    let long = |word: &'static str, sign: &'static str| {
        (250..300_usize).prop_map(move |count| vec![word; count].join(sign))
    };
    prop_oneof![
        12 => word(),
        1 => long("", "-").prop_map(|signs| signs + " 1"),
        1 => long("1", " + "),
        1 => long("K", " / "),
        1 => long("h", " -> pin(x) "),
        1 => long("x", "").prop_map(|word| format!("{word} = 1;")),
        1 => long("9", "").prop_map(|digits| format!("{digits}.0")),
        1 => vec(select(&["(", "[", "{", "invisible("]), 30..40).prop_map(nested),
    ]
    .boxed()
}

fn nested(open: Vec<&'static str>) -> String {
    let close = |open: &&str| match open.chars().last() {
        Some('(') => ")",
        Some('[') => "]",
        _ => "}",
    };
    let closing: String = open.iter().rev().map(close).collect();
    format!("{}1{closing}", open.concat())
}
