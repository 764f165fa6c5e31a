//! Numbers as text.

/// Returns the shortest decimal that is read back as the same number.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{value:e}");
    }
    // A negative zero is zero.
    format!("{}", value + 0.0)
}

/// Returns the number with the shortest decimal that differs by two roundings at most: `87` for the product of
/// `87*180/PI` and `PI/180`.
pub fn shortest(value: f64) -> f64 {
    let is_close = |other: &f64| (other - value).abs() <= 2.0 * f64::EPSILON * value.abs();
    let decimals = (0..17).filter_map(|digits| format!("{value:.digits$e}").parse().ok());
    decimals.into_iter().find(is_close).unwrap_or(value)
}

/// Breaks a line before an arrow or after a comma.
pub fn wrapped(line: &str, indent: &str, at: &str) -> Vec<String> {
    const WIDTH: usize = 100;
    let is_arrow = at == " -> ";
    let mut lines = Vec::new();
    let mut current = String::new();
    for (index, piece) in line.split(at).enumerate() {
        if index == 0 {
            current.push_str(piece);
        } else if current.len() + at.len() + piece.len() > WIDTH {
            let next =
                if is_arrow { format!("{indent}-> {piece}") } else { format!("{indent}{piece}") };
            let end = if is_arrow { "" } else { at.trim_end() };
            lines.push(std::mem::replace(&mut current, next) + end);
        } else {
            current = current + at + piece;
        }
    }
    lines.push(current);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_exact() {
        assert_eq!(number(0.1), "0.1");
        assert_eq!(number(-0.0), "0");
        assert_eq!(number(1e-6), "1e-6");
        assert_eq!(number(87.0), "87");
        assert_eq!(number(1e10), "1e10");
        for value in [0.1 + 0.2, std::f64::consts::PI, 6.02e-23, -4.9e-324, f64::MAX] {
            assert_eq!(number(value).parse(), Ok(value));
        }
    }

    #[test]
    fn long_lines_are_broken() {
        let line = (0..40).map(|i| format!("name{i}")).collect::<Vec<_>>().join(", ");
        let lines = wrapped(&line, "  ", ", ");
        assert!(lines.len() > 1 && lines.iter().all(|line| line.len() <= 102));
        assert_eq!(lines.join(" ").split_whitespace().collect::<Vec<_>>().join(" "), line);
    }
}
