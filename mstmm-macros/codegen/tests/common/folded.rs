//! The texts of random chains with repeated parts, and of the same chains written out.

use mstmm_reference::{
    About, Body, Chain, Element, End, Load, Random, Recipe, Spring, random_mechanism,
};
use std::collections::HashMap;
use std::ops::Range;

/// A repeated part of a chain.
struct Part {
    elements: Range<usize>,
    count: usize,
}

/// Returns the text of a random chain with one or two repeated parts, and of the same chain written out, where repeated
/// elements are numbered from zero. Some properties of repeated bodies are parameters with a value per repetition.
pub fn texts(random: &mut Random, name: &str, recipe: &Recipe) -> [String; 2] {
    let short = random_mechanism(random, name, recipe);
    let parts = random_parts(random, &short);
    let method = Some(if random.chance(0.4) { "transfer" } else { "riccati" });
    let unrolled = written_out(&short, &parts).to_macro_text(method);
    let mut texts = [folded(&short.to_macro_text(method), &short, &parts), unrolled];
    for part in &parts {
        for element in &short.elements[part.elements.clone()] {
            if let Element::Body(body) = element {
                with_parameters(random, &mut texts, body, part.count);
            }
        }
    }
    if random.chance(0.5) {
        texts.iter_mut().for_each(|text| add_to_head(text, "answers = bias_efforts;"));
    }
    texts
}

/// Chooses one or two parts, each of a few pairs of a hinge and a body.
fn random_parts(random: &mut Random, chain: &Chain) -> Vec<Part> {
    let is_hinge = |&at: &usize| matches!(chain.elements[at], Element::Hinge(_));
    let starts: Vec<usize> = (0..chain.elements.len() - 1).filter(is_hinge).collect();
    let part = |random: &mut Random, first: usize, pairs: usize| Part {
        elements: starts[first]..starts[first] + 2 * pairs,
        count: 1 + random.below(3),
    };
    let first = random.below(starts.len());
    let pairs = 1 + random.below((starts.len() - first).min(2));
    let mut parts = vec![part(random, first, pairs)];
    if first + pairs < starts.len() && random.chance(0.5) {
        parts.push(part(random, first + pairs, 1));
    }
    parts
}

/// Returns the chain with its parts written out.
fn written_out(short: &Chain, parts: &[Part]) -> Chain {
    let mut elements = Vec::new();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    let mut place = 0;
    for part in parts {
        elements.extend_from_slice(&short.elements[place..part.elements.start]);
        place = part.elements.end;
        for time in 0..part.count {
            for element in &short.elements[part.elements.clone()] {
                let mut element = element.clone();
                let name = match &mut element {
                    Element::Body(body) => &mut body.name,
                    Element::Hinge(hinge) => &mut hinge.name,
                };
                *name = format!("{name}_{time}");
                elements.push(element);
            }
        }
        for element in &short.elements[part.elements.clone()] {
            if let Element::Body(body) = element {
                counts.insert(&body.name, part.count);
            }
        }
    }
    elements.extend_from_slice(&short.elements[place..]);
    let suffixes = |body: &str| match counts.get(body) {
        None => vec![String::new()],
        Some(&count) => (0..count).map(|time| format!("_{time}")).collect(),
    };
    let loads = short.loads.iter().flat_map(|load| {
        suffixes(&load.body).into_iter().map(move |suffix| {
            let [name, body] = [&load.name, &load.body].map(|name| format!("{name}{suffix}"));
            Load { name, body, ..load.clone() }
        })
    });
    let springs = short.springs.iter().flat_map(|spring| {
        suffixes(&spring.body).into_iter().map(move |suffix| {
            let [name, body] = [&spring.name, &spring.body].map(|name| format!("{name}{suffix}"));
            Spring { name, body, ..spring.clone() }
        })
    });
    let (loads, springs) = (loads.collect(), springs.collect());
    Chain { elements, loads, springs, ..short.clone() }
}

/// Returns the text of a chain with `repeat` blocks for its parts.
fn folded(text: &str, chain: &Chain, parts: &[Part]) -> String {
    let route = text.lines().find(|line| line.contains(" -> ")).expect("a route");
    let elements = route.trim_end_matches(';').split(" -> ");
    let mut elements: Vec<String> = elements.map(str::to_owned).collect();
    let ends = usize::from(chain.start != End::Free);
    for Part { elements: Range { start, end }, count } in parts {
        elements[start + ends].insert_str(0, &format!("repeat {count} {{ "));
        elements[end - 1 + ends].push_str(" }");
    }
    text.replace(route, &format!("{};", elements.join(" -> ")))
}

/// Makes some properties of a body with `count` repetitions parameters.
fn with_parameters(random: &mut Random, texts: &mut [String; 2], body: &Body, count: usize) {
    // An inertia about the centre of mass is physical with any mass.
    if body.about == About::Com && random.chance(0.7) {
        parametrise(texts, body, count, ("mass = ", body.mass, " kg"));
    }
    let [x, ..] = body.output.position;
    if x != 0.0 && random.chance(0.5) {
        parametrise(texts, body, count, ("output = [", x, ""));
    }
}

/// Makes the number after a keyword in the type of a body a parameter.
fn parametrise(
    [repeated, unrolled]: &mut [String; 2],
    body: &Body,
    count: usize,
    (word, number, unit): (&str, f64, &str),
) {
    let parameter = format!("{}_{}", word.split(' ').next().expect("a word"), body.name);
    let plain = format!("{word}{number:?}{unit}");
    let replace = |text: &mut String, suffix: &str, size: &str| {
        let own = format!("body {}{} {{", body.name.replace('b', "B"), suffix.replace('_', ""));
        let start = text.find(&own).expect("the body's type");
        // On a line there are no vectors.
        let Some(at) = text[start..].find(&plain) else { return };
        let range = start + at..start + at + plain.len();
        text.replace_range(range, &format!("{word}{parameter}{suffix}"));
        add_to_head(text, &format!("param {parameter}{suffix}{size} = {number:?}{unit};"));
    };
    replace(repeated, "", &format!("[{count}]"));
    (0..count).for_each(|time| replace(unrolled, &format!("_{time}"), ""));
}

fn add_to_head(text: &mut String, line: &str) {
    let head = text.find('{').expect("a chain") + 1;
    text.insert_str(head, &format!("\n    {line}"));
}
