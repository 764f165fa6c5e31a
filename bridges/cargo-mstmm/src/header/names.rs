//! Names in C.

use std::collections::HashSet;

/// Returns a name of Rust in the snake case of C functions, in ASCII.
///
/// `BallPendulum` becomes `ball_pendulum` and `fl.knee[].angle` becomes `fl_knee_angle`. Letters outside of ASCII become
/// their code points, such as `u00e9`. Repeated underscores, which C++ reserves, become one.
#[must_use]
pub fn snake(name: &str) -> String {
    let letters: Vec<char> = name.replace("r#", "").replace("[]", "").chars().collect();
    let mut snake = String::new();
    for (at, &letter) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|before| letters[before]);
        let begins = letter.is_ascii_uppercase()
            && match (before, letters.get(at + 1)) {
                (Some(before), _) if before.is_ascii_lowercase() || before.is_ascii_digit() => true,
                (Some(before), Some(next)) => {
                    before.is_ascii_uppercase() && next.is_ascii_lowercase()
                }
                _ => false,
            };
        match letter {
            _ if letter.is_ascii_alphanumeric() => {
                snake.push_str(if begins { "_" } else { "" });
                snake.push(letter.to_ascii_lowercase());
            }
            '_' | '.' | '[' | ']' => snake.push('_'),
            _ => snake.push_str(&format!("_u{:04x}_", u32::from(letter))),
        }
    }
    snake.split('_').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("_")
}

/// Macros and enumerators of a header, all different.
#[derive(Debug, Default)]
pub struct Constants(HashSet<String>);

impl Constants {
    /// Returns a name that begins with a prefix, in upper case. A name that another path has already is numbered: `_2`.
    pub fn name(&mut self, prefix: &str, path: &str) -> String {
        let base = format!("{prefix}_{}", snake(path)).to_uppercase();
        let mut name = base.clone();
        let mut number = 2;
        while !self.0.insert(name.clone()) {
            name = format!("{base}_{number}");
            number += 1;
        }
        name
    }
}
