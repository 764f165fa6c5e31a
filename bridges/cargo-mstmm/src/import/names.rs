//! Names of the file as names of the language.

use mstmm_codegen::model::RESERVED_NAMES;
use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

/// Names that hinges, bodies, points and parts must not have, in addition to those that the compiler reserves: keywords of
/// Rust, with those of newer editions, keywords of the language, and points of all bodies.
const RESERVED: &str = "
    abstract as async await become box break const continue crate do dyn else enum extern false
    final fn for gen if impl in let loop macro match mod move mut override priv pub ref return self
    static struct super trait true try type typeof unsafe unsized use virtual where while yield
    answers at body chain from gravity ground hinge last load method moving param part repeat
    results shape spring turned weld pin slider screw cylindrical universal gimbal ball planar
    floating elastic com input output
";

/// Names of types that a chain generates in addition to those of its bodies.
const RESERVED_TYPES: &str = "
    T State Inputs Parameters Workspace Kinematics Variation InverseDynamicsDerivatives
    Linearization Self
";

/// Names that are used once.
#[derive(Clone, Default)]
pub struct Names {
    used: HashSet<String>,
    /// The numbers of names that may be free; all lower ones are used. The keys are a prefix and a name.
    numbers: HashMap<(String, String), usize>,
}

impl Names {
    /// Returns a name that is neither used nor reserved: the name itself, or with the suffix, or with a number.
    pub fn unique(&mut self, name: &str, suffix: &str) -> String {
        self.unique_with(name, suffix, "")
    }

    /// Returns a name that is unique after a prefix, which is that of a part.
    pub fn unique_with(&mut self, name: &str, suffix: &str, prefix: &str) -> String {
        let plain = format!("{name}{suffix}");
        let free = [name, &plain].into_iter().find(|name| self.is_free(name, prefix));
        let free = free.map(str::to_owned);
        let found = free.unwrap_or_else(|| self.numbered(plain, prefix));
        self.used.insert(format!("{prefix}{found}"));
        found
    }

    /// Returns a name with the lowest number that makes it free. Used names stay used, so a search goes on where the last
    /// one ended.
    fn numbered(&mut self, plain: String, prefix: &str) -> String {
        let key = (prefix.to_owned(), plain);
        let plain = &key.1;
        let mut number = self.numbers.get(&key).copied().unwrap_or(2);
        while !self.is_free(&format!("{plain}{number}"), prefix) {
            number += 1;
        }
        let found = format!("{plain}{number}");
        self.numbers.insert(key, number);
        found
    }

    fn is_free(&self, candidate: &str, prefix: &str) -> bool {
        let joined = format!("{prefix}{candidate}");
        let is_method = joined.strip_suffix("_mut").is_some_and(|name| self.used.contains(name));
        let made = format!("{joined}_mut");
        let is_reserved = [candidate, &joined].iter().any(|name| is_reserved(name));
        !is_reserved && !is_method && !self.used.contains(&joined) && !self.used.contains(&made)
    }
}

fn is_reserved(name: &str) -> bool {
    static ALL: LazyLock<HashSet<&str>> = LazyLock::new(|| {
        let own = RESERVED.split_whitespace().chain(RESERVED_TYPES.split_whitespace());
        own.chain(RESERVED_NAMES.iter().copied()).collect()
    });
    ALL.contains(name)
}

/// Returns a name in snake case.
pub fn snake(name: &str) -> String {
    let mut snake = String::new();
    let letters: Vec<char> = name.chars().collect();
    for (index, &letter) in letters.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|before| letters.get(before));
        let after = letters.get(index + 1);
        let begins_word = letter.is_ascii_uppercase()
            && before.is_some_and(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
            && after.is_some_and(char::is_ascii_lowercase);
        if begins_word {
            snake.push('_');
        }
        let letter = if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' };
        if letter != '_' || !snake.ends_with('_') {
            snake.push(letter);
        }
    }
    let snake = snake.trim_matches('_');
    match snake.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => snake.to_owned(),
        _ => format!("n{snake}"),
    }
}

/// Returns a name in camel case.
pub fn camel(name: &str) -> String {
    let words = snake(name);
    let capital = |word: &str| {
        let (first, rest) = word.split_at(word.len().min(1));
        first.to_ascii_uppercase() + rest
    };
    words.split('_').map(capital).collect()
}

/// Splits corresponding names of branches into the words that all have, and what distinguishes each:
/// `lf_hip` and `rf_hip` have `hip`, and are `lf` and `rf`.
pub fn common_words(names: &[String]) -> Option<(String, Vec<String>)> {
    let words: Vec<Vec<&str>> = names.iter().map(|name| name.split('_').collect()).collect();
    let (first, others) = words.split_first()?;
    if others.iter().any(|other| other.len() != first.len()) {
        return None;
    }
    let is_common = |index: usize| others.iter().all(|other| other[index] == first[index]);
    let pick = |words: &[&str], common: bool| {
        let picked = (0..words.len()).filter(|index| is_common(*index) == common);
        picked.map(|index| words[index]).collect::<Vec<_>>().join("_")
    };
    let common = pick(first, true);
    let begins_name = common.starts_with(|c: char| c.is_ascii_alphabetic());
    let labels: Vec<String> = words.iter().map(|words| pick(words, false)).collect();
    let named = labels.iter().all(|label| label.starts_with(|c: char| c.is_ascii_alphabetic()));
    (begins_name && named).then_some((common, labels))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_identifiers() {
        let snakes = [
            "LF_HAA",
            "RWristPitch",
            "lf-haa.joint",
            "joint_7.0",
            "7th",
            "",
            "ä",
            "tool0",
            "arm__1_",
        ];
        let expected = [
            "lf_haa",
            "rwrist_pitch",
            "lf_haa_joint",
            "joint_7_0",
            "n7th",
            "n",
            "n",
            "tool0",
            "arm_1",
        ];
        assert_eq!(snakes.map(snake), expected);
        assert_eq!(camel("LF_upper_leg"), "LfUpperLeg");
    }

    #[test]
    fn names_are_used_once() {
        let mut names = Names::default();
        assert_eq!(names.unique("gripper", "_link"), "gripper");
        assert_eq!(names.unique("gripper", "_joint"), "gripper_joint");
        assert_eq!(names.unique("gripper", "_joint"), "gripper_joint2");
        assert_eq!(names.unique("body", "_link"), "body_link");
        assert_eq!(names.unique("gripper_mut", "_link"), "gripper_mut_link");
        assert_eq!(names.unique("rates", "_joint"), "rates_joint");
        assert_eq!(names.unique("q", "_joint"), "q_joint");
        assert_eq!(names.unique("gripper_joint3", ""), "gripper_joint3");
        assert_eq!(names.unique("gripper", "_joint"), "gripper_joint4");
        assert_eq!(names.unique_with("gripper", "_joint", "left_"), "gripper");
    }

    #[test]
    fn branches_have_common_words() {
        let names =
            |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let found = common_words(&names(&["leg_left_1", "leg_right_1"]));
        assert_eq!(found, Some(("leg_1".into(), names(&["left", "right"]))));
        assert_eq!(common_words(&names(&["leftfoot", "rightfoot"])), None);
        assert_eq!(common_words(&names(&["a_1", "a_2"])), None);
    }
}
