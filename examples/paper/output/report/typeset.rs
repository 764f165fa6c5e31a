//! Numbers and powers as in print.

use maud::{Markup, PreEscaped, Render};

/// Sets powers of ten (1.2e-8), other powers (2^-4) and minus signs of a text as in print.
pub fn typeset(text: &str) -> Markup {
    let letters: Vec<char> = text.chars().collect();
    let mut html = String::new();
    let mut k = 0;
    while k < letters.len() {
        let previous = k.checked_sub(1).map(|previous| letters[previous]);
        let follows_digit = previous.is_some_and(|letter| letter.is_ascii_digit());
        let exponent = exponent(&letters[k + 1..]);
        match letters[k] {
            'e' | 'E' if follows_digit && !exponent.is_empty() => {
                if exponent != "0" {
                    html += &format!("·10<sup>{}</sup>", exponent.replace('-', "−"));
                }
                k += exponent.len();
            }
            '^' if !exponent.is_empty() => {
                html += &format!("<sup>{}</sup>", exponent.replace('-', "−"));
                k += exponent.len();
            }
            '-' if !previous.is_some_and(char::is_alphanumeric) => html.push('−'),
            letter => letter.render_to(&mut html),
        }
        k += 1;
    }
    PreEscaped(html)
}

/// The number at the beginning of some letters, with an optional minus sign and decimals.
fn exponent(letters: &[char]) -> String {
    let is_digit = |k: usize| letters.get(k).is_some_and(char::is_ascii_digit);
    let start = usize::from(letters.first() == Some(&'-'));
    let mut end = start;
    while is_digit(end)
        || (end > start && letters[end..].first() == Some(&'.') && is_digit(end + 1))
    {
        end += 1;
    }
    if end > start { letters[..end].iter().collect() } else { String::new() }
}
