//! Breaks lines at a hundred characters.

const WIDTH: usize = 100;
const INDENT: &str = "    ";

/// Breaks a line at an indentation depth into several if it is too long; continuation lines are indented once more.
pub fn broken(text: &str, depth: usize) -> Vec<String> {
    let comment = text.starts_with("//");
    let (first, next) = (INDENT.repeat(depth), if comment { "// " } else { INDENT });
    let next = format!("{first}{next}");
    let (mut lines, mut start, mut rest) = (Vec::new(), &first, text);
    while start.len() + rest.len() > WIDTH {
        let room = WIDTH - start.len().min(WIDTH);
        let Some(index) = best_break(rest, room, comment) else { break };
        lines.push(format!("{start}{}", rest[..index].trim_end()));
        rest = rest[index..].trim_start();
        start = &next;
    }
    lines.push(format!("{start}{rest}"));
    lines
}

/// Returns the position at which to break a text that has this much room: before an operator or after a comma, in as few
/// brackets as possible and as late as possible. A comment breaks at any space.
fn best_break(text: &str, room: usize, comment: bool) -> Option<usize> {
    let mut depth = 0;
    let mut best: Option<(usize, usize)> = None;
    for (index, letter) in text.char_indices().take_while(|&(index, _)| index <= room) {
        match letter {
            '(' | '[' => depth += 2,
            ')' | ']' if depth > 1 => depth -= 2,
            ' ' => {
                let after = &text[index + 1..];
                let level = if comment {
                    Some(0)
                } else if text[..index].ends_with(',')
                    || after.starts_with("+ ")
                    || after.starts_with("- ")
                {
                    Some(depth)
                } else {
                    after.starts_with("* ").then_some(depth + 1)
                };
                if let Some(level) = level
                    && index > 0
                    && best.is_none_or(|(_, lowest)| level <= lowest)
                {
                    best = Some((index, level));
                }
            }
            _ => {}
        }
    }
    best.map(|(index, _)| index)
}

#[cfg(test)]
mod tests {
    use super::broken;

    #[test]
    fn long_lines_break_at_outer_operators_first() {
        let long = "a".repeat(40);
        let lines = broken(&format!("let x = b * (c + {long}) + {long};"), 1);
        let expected = [format!("    let x = b * (c + {long})"), format!("        + {long};")];
        assert_eq!(lines, expected);
        let lines = broken(&format!("x = [{long}, {long}, {long}];"), 0);
        assert_eq!(lines, [format!("x = [{long}, {long},"), format!("    {long}];")]);
        let lines = broken(&format!("// {long} {long} {long}"), 0);
        assert_eq!(lines, [format!("// {long} {long}"), format!("// {long}")]);
    }
}
