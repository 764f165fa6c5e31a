//! Numbers of a part as expressions of its parameters.
//!
//! A part is written once for several branches, so each of its numbers has a value for each branch. Equal
//! values are a number. Values of equal size are a number times signs, such as `side*front*0.169`; the signs
//! are parameters. Other values are parameters themselves.

use super::numbers::number;

/// The most parameters that are not signs: with more of them, a part is harder to read than its branches.
const MOST: usize = 6;

/// The numbers of a scope: all bodies that are not in parts, or the bodies of a part.
#[derive(Default)]
pub struct Expressions {
    /// The values that differ, with the name of the first place where they occur.
    seen: Vec<(Vec<f64>, String)>,
    parameters: Parameters,
}

/// The parameters of a part.
#[derive(Clone, Default)]
pub struct Parameters {
    signs: Vec<Parameter>,
    sizes: Vec<Parameter>,
}

/// A parameter, with its value for each branch.
#[derive(Clone)]
pub struct Parameter {
    pub name: String,
    pub values: Vec<f64>,
}

impl Parameters {
    /// Returns all parameters in their order.
    pub fn all(&self) -> impl Iterator<Item = &Parameter> {
        self.signs.iter().chain(&self.sizes)
    }

    /// Returns the names, to be changed.
    pub fn names_mut(&mut self) -> impl Iterator<Item = &mut String> {
        self.signs.iter_mut().chain(&mut self.sizes).map(|parameter| &mut parameter.name)
    }

    /// Returns values as a number times up to two signs.
    fn signed(&self, values: &[f64]) -> Option<String> {
        let first = values.first()?;
        let count = self.signs.len();
        let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| vec![i, j]));
        let products = (0..count).map(|i| vec![i]).chain(pairs);
        products.into_iter().find_map(|factors| {
            let sign = |branch: usize| -> f64 {
                factors.iter().map(|factor| self.signs[*factor].values[branch]).product()
            };
            let size = first * sign(0);
            let fits =
                values.iter().enumerate().all(|(branch, value)| *value == size * sign(branch));
            let names: Vec<&str> =
                factors.iter().map(|factor| &*self.signs[*factor].name).collect();
            fits.then(|| times(&names.join("*"), size))
        })
    }

    fn expression(&self, values: &[f64]) -> Option<String> {
        self.signed(values).or_else(|| {
            let equals = |parameter: &&Parameter| parameter.values == values;
            self.sizes.iter().find(equals).map(|parameter| parameter.name.clone())
        })
    }
}

fn times(signs: &str, size: f64) -> String {
    let minus = if size < 0.0 { "-" } else { "" };
    match size.abs() {
        1.0 => format!("{minus}{signs}"),
        size => format!("{minus}{signs}*{}", number(size)),
    }
}

impl Expressions {
    pub fn with(parameters: Parameters) -> Self {
        Expressions { seen: Vec::new(), parameters }
    }

    /// Returns the text of a number that has a value for each branch. `scale` is the size of the vector or
    /// tensor that the number belongs to: differences in the last digit of it are rounding errors of sums.
    pub fn number(&mut self, values: &[f64], scale: f64, place: &str) -> String {
        let [first, others @ ..] = values else { return String::new() };
        let noise = if others.is_empty() { 0.0 } else { 4.0 * f64::EPSILON * scale };
        if others.iter().all(|value| (value - first).abs() <= noise) {
            return number(*first);
        }
        let is_sign = others.iter().all(|value| (value.abs() - first.abs()).abs() <= noise);
        let sized = |value: &f64| if is_sign { first.abs().copysign(*value) } else { *value };
        let values: Vec<f64> = values.iter().map(sized).collect();
        let text = self.parameters.expression(&values);
        if !self.seen.iter().any(|(seen, _)| *seen == values) {
            self.seen.push((values, place.to_owned()));
        }
        text.unwrap_or_default()
    }

    /// Returns numbers, separated by commas.
    pub fn list(&mut self, values: &[Vec<f64>], scale: f64, place: &str, names: &[&str]) -> String {
        let mut texts = Vec::new();
        for (values, name) in values.iter().zip(names) {
            texts.push(self.number(values, scale, &format!("{place}_{name}")));
        }
        texts.join(", ")
    }

    /// Chooses parameters for all values that differ; `None` if there are too many.
    pub fn choose(&self, labels: &[String]) -> Option<Parameters> {
        let mut parameters = Parameters::default();
        let (signs, sizes): (Vec<_>, Vec<_>) = self
            .seen
            .iter()
            .partition(|(values, _)| values.iter().all(|value| value.abs() == values[0].abs()));
        for (name, values) in natural_signs(labels) {
            let is_used = |(seen, _): &&(Vec<f64>, String)| {
                let size = seen[0] * values[0];
                seen.iter().zip(&values).all(|(seen, sign)| *seen == size * sign)
            };
            if signs.iter().any(is_used) {
                parameters.signs.push(Parameter { name: name.to_owned(), values });
            }
        }
        for (values, _) in signs {
            if parameters.signed(values).is_none() {
                let values: Vec<f64> =
                    values.iter().map(|value| (value * values[0]).signum()).collect();
                let name = match parameters
                    .signs
                    .iter()
                    .filter(|sign| sign.name.starts_with("sign"))
                    .count()
                {
                    0 => "sign".to_owned(),
                    others => format!("sign{}", others + 1),
                };
                parameters.signs.push(Parameter { name, values });
            }
        }
        for (values, place) in sizes {
            parameters.sizes.push(Parameter { name: place.clone(), values: values.clone() });
        }
        // Two natural signs may have equal values in these branches: the first of them is written.
        let used: Vec<String> =
            self.seen.iter().filter_map(|(values, _)| parameters.expression(values)).collect();
        let is_used = |sign: &Parameter| {
            used.iter().any(|text| text.split(['*', '-']).any(|factor| factor == sign.name))
        };
        parameters.signs.retain(is_used);
        let few = parameters.sizes.len() <= MOST && parameters.signs.len() <= 3;
        few.then_some(parameters)
    }
}

/// Returns the signs that the names of branches suggest: `side` is 1 left and −1 right, `front` is 1 in front
/// and −1 behind.
fn natural_signs(labels: &[String]) -> Vec<(&'static str, Vec<f64>)> {
    let pairs = [
        ("side", ["left", "l"], ["right", "r"]),
        ("front", ["front", "f"], ["hind", "h"]),
        ("front", ["front", "f"], ["rear", "r"]),
        ("front", ["front", "f"], ["back", "b"]),
    ];
    let mut signs: Vec<(&'static str, Vec<f64>)> = Vec::new();
    for (name, high, low) in pairs {
        let values: Option<Vec<f64>> =
            labels.iter().map(|label| sign_of(label, name, high, low)).collect();
        if let Some(values) = values.filter(|_| signs.iter().all(|(other, _)| *other != name)) {
            signs.push((name, values));
        }
    }
    signs
}

/// Returns the sign of a label such as `lf`, `front_left` or `rl`.
fn sign_of(label: &str, name: &str, high: [&str; 2], low: [&str; 2]) -> Option<f64> {
    let words: Vec<&str> = label.split('_').collect();
    let has = |word: &str| words.contains(&word);
    let letters: Vec<char> = match words[..] {
        [word] if word.len() <= 2 => word.chars().collect(),
        _ => Vec::new(),
    };
    // Of two letters, front and hind is the one that is neither left nor right; `rl` is rear left.
    let letter = |word: &str| -> bool {
        let wanted = word.chars().next();
        match (letters.as_slice(), name) {
            ([only], "side") => Some(*only) == wanted,
            ([first, second], "side") => match (is_side(*first), is_side(*second)) {
                (_, true) => Some(*second) == wanted,
                (true, false) => Some(*first) == wanted,
                _ => false,
            },
            ([first, second], _) if is_side(*second) => Some(*first) == wanted,
            ([_, second], _) => Some(*second) == wanted,
            _ => false,
        }
    };
    match (has(high[0]) || letter(high[1]), has(low[0]) || letter(low[1])) {
        (true, false) => Some(1.0),
        (false, true) => Some(-1.0),
        _ => None,
    }
}

fn is_side(letter: char) -> bool {
    matches!(letter, 'l' | 'r')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(text: &str) -> Vec<String> {
        text.split(' ').map(str::to_owned).collect()
    }

    #[test]
    fn signs_have_natural_names() {
        for text in [
            "lf rf lh rh",
            "fl fr hl hr",
            "fl fr rl rr",
            "front_left front_right rear_left rear_right",
        ] {
            let signs = natural_signs(&labels(text));
            let expected =
                vec![("side", vec![1.0, -1.0, 1.0, -1.0]), ("front", vec![1.0, 1.0, -1.0, -1.0])];
            assert_eq!(signs, expected, "{text}");
        }
        assert_eq!(natural_signs(&labels("left right")), [("side", vec![1.0, -1.0])]);
        assert!(natural_signs(&labels("a b")).is_empty());
    }

    #[test]
    fn expressions_have_the_values_of_each_branch() {
        let values = [vec![0.5, 0.5], vec![0.2, -0.2], vec![-1.0, 1.0], vec![1.0, 2.0]];
        let mut seen = Expressions::default();
        for values in &values {
            seen.number(values, 1.0, "place");
        }
        let parameters = seen.choose(&labels("right left")).expect("there are few");
        let mut written = Expressions::with(parameters);
        let texts = values.map(|values| written.number(&values, 1.0, "place"));
        assert_eq!(texts, ["0.5", "-side*0.2", "side", "place"]);
    }
}
