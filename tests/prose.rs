//! The prose of the repository: phrases that it does not use, with what to write instead.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// Phrases in lower case, with what to write instead.
const PHRASES: &[(&str, &[&str])] = &[
    ("depends on; for weights: hangs from", &["hangs on", "hang on"]),
    ("omitted", &["left away", "leave away", "leaves away", "leaving away"]),
    ("leaves unconstrained", &["lets free", "lets everything free", "lets nothing free"]),
    ("degrees of freedom", &["freedoms"]),
    ("is not part of", &["is no part of", "are no part of"]),
    (
        "separate",
        &[
            "workspace of its own",
            "type of its own",
            "name of its own",
            "file of its own",
            "one of its own",
        ],
    ),
    ("prescribed, specified", &["as it is told", "as they are told", "is told", "are told"]),
    ("specified, properties", &["said of"]),
    ("is, is written, is defined", &["stands there", "stand there", "stands in", "stand in"]),
    ("in addition to, compared with", &["besides"]),
    ("propagates, passes", &["hands on", "handed on"]),
    ("available", &["can be had", "cannot be had", "at hand"]),
    ("without", &["for want of"]),
    ("is unspecified", &["means nothing", "mean nothing"]),
    ("ensures", &["sees to it that", "see to it that"]),
    ("the result", &["what comes out", "what came out"]),
    ("projects onto", &["puts back onto", "put back onto"]),
    ("computes", &["reckon", "reckons", "reckoned"]),
    ("error", &["mistake", "mistakes"]),
];

const ENDINGS: [&str; 8] = ["md", "rs", "py", "c", "h", "toml", "stderr", "chain"];

#[test]
fn texts_use_plain_english() -> io::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    collect(root, &mut files)?;
    assert!(files.len() > 500, "only {} files found", files.len());
    let mut found = Vec::new();
    for file in files.iter().filter(|file| !file.ends_with("tests/prose.rs")) {
        let text = fs::read_to_string(file)?;
        let name = file.strip_prefix(root).unwrap_or(file).display();
        for (line, phrase, instead) in matches(&text) {
            found.push(format!("{name}:{line}: `{phrase}`, write: {instead}"));
        }
    }
    assert!(found.is_empty(), "{} phrases to replace:\n{}", found.len(), found.join("\n"));
    Ok(())
}

#[test]
fn phrases_are_found_across_lines_but_not_across_sentences() {
    let text = "/// It means\n/// nothing, at hand. At last. What is at. Hand in hand: `at hand`.";
    let found: Vec<_> = matches(text).iter().map(|&(line, phrase, _)| (line, phrase)).collect();
    assert_eq!(found, [(1, "means nothing"), (2, "at hand"), (2, "at hand")]);
}

/// Adds the texts of a folder and of those in it, without what builds leave there.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            // Crashes are any text, and what a fuzzer writes is not committed.
            let skipped = ["target", "crashes", "corpus", "artifacts"].contains(&&*name);
            if !name.starts_with('.') && !skipped {
                collect(&path, files)?;
            }
        } else if name == "run"
            || path.extension().is_some_and(|end| ENDINGS.iter().any(|&known| end == known))
        {
            files.push(path);
        }
    }
    Ok(())
}

/// Returns the phrases in a text, each with the number of its first line and the replacement.
fn matches(text: &str) -> Vec<(usize, &'static str, &'static str)> {
    let mut words = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let prose = line.trim_start().trim_start_matches(['/', '!', '*', '#', '>', '|']);
        words.extend(prose.split_whitespace().map(|word| (number + 1, word.to_lowercase())));
    }
    let mut found = Vec::new();
    for (start, (line, _)) in words.iter().enumerate() {
        for &(instead, phrases) in PHRASES {
            for phrase in phrases {
                if begins_with(&words[start..], phrase) {
                    found.push((*line, *phrase, instead));
                }
            }
        }
    }
    found
}

/// Whether the words begin with a phrase; only its last word may have punctuation after it.
fn begins_with(words: &[(usize, String)], phrase: &str) -> bool {
    let punctuation = |letter: char| !letter.is_alphanumeric() && letter != '_';
    let wanted: Vec<&str> = phrase.split(' ').collect();
    let Some(words) = words.get(..wanted.len()) else { return false };
    wanted.iter().zip(words).enumerate().all(|(index, (wanted, (_, word)))| {
        let mut word = word.as_str();
        if index == 0 {
            word = word.trim_start_matches(punctuation);
        }
        if index + 1 == words.len() {
            word = word.trim_end_matches(punctuation);
        }
        word == *wanted
    })
}
