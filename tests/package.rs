//! The packages for the registry: what they contain, and that each has its licences, readme and search terms.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// Files outside of `src/` that a package may contain, all in its folder. Cargo adds the first four.
const ALLOWED: &[&str] = &[
    ".cargo_vcs_info.json",
    "Cargo.lock",
    "Cargo.toml",
    "Cargo.toml.orig",
    "CHANGELOG.md",
    "CITATION.cff",
    "EQUATIONS.md",
    "LANGUAGE.md",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.md",
];

/// Lines that the manifest of a published package contains, as they begin.
const FIELDS: &[&str] = &[
    "description = ",
    "version.workspace = true",
    "edition.workspace = true",
    "rust-version.workspace = true",
    "license.workspace = true",
    "readme = \"README.md\"",
    "keywords = [",
    "categories = [",
    "include = [",
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Adds the manifests in a folder and in those below it.
fn manifests(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() && !name.starts_with('.') && name != "target" {
            manifests(&path, found);
        } else if name == "Cargo.toml" {
            found.push(path);
        }
    }
}

/// Returns the folders of the packages that are published, by name.
fn published() -> BTreeMap<String, PathBuf> {
    let mut found = Vec::new();
    manifests(&root(), &mut found);
    let packages = found.iter().filter_map(|path| {
        let text = read(path);
        let (_, package) = text.split_once("[package]\n")?;
        let package = package.split("\n[").next()?;
        let is_private =
            |line: &str| line == "publish = false" || line == "publish.workspace = true";
        let name = package.lines().find_map(|line| line.strip_prefix("name = \""))?;
        let name = name.trim_end_matches('"').to_owned();
        (!package.lines().any(is_private)).then(|| (name, path.with_file_name("")))
    });
    packages.collect()
}

#[test]
fn the_packages_of_the_library_are_published() {
    let published = published();
    for name in ["cargo-mstmm", "mstmm", "mstmm-codegen", "mstmm-macros", "mstmm-runtime"] {
        assert!(published.contains_key(name), "{name} is not among {published:?}");
    }
}

#[test]
fn every_package_has_licences_a_readme_and_search_terms() {
    for (name, folder) in published() {
        let manifest = read(&folder.join("Cargo.toml"));
        for field in FIELDS {
            let is_there = manifest.lines().any(|line| line.starts_with(field));
            assert!(is_there, "{name}: `{field}` is missing");
        }
        // The registry refuses more.
        let keywords = manifest.lines().find(|line| line.starts_with("keywords")).expect("checked");
        assert!(keywords.matches('"').count() <= 10, "{name}: more than five keywords");
        assert!(!manifest.contains("\nrepository"), "{name}: the repository has no address yet");
        for licence in LICENCES {
            let copy = read(&folder.join(licence));
            assert!(
                copy == read(&root().join(licence)),
                "{name}: {licence} differs from the root's"
            );
        }
        assert!(
            read(&folder.join("README.md")).starts_with("# "),
            "{name}: the readme has no title"
        );
    }
}

/// The page of a package in the registry has no files of the repository, and no address to find them at. So a readme names
/// files and links only to its headings and the network. The picture of the root's readme is shown in the documentation,
/// which contains it, and in the repository; the registry shows its text.
#[test]
fn readmes_have_no_links_to_files() {
    for (name, folder) in published() {
        let readme = read(&folder.join("README.md"));
        // Programs have brackets, too.
        let text: Vec<&str> = readme.split("```").step_by(2).collect();
        let text = text.concat();
        let inline = text.match_indices("](").map(|(at, _)| &text[at + 2..]);
        let defined = text.lines().filter(|line| line.starts_with('['));
        let defined = defined.filter_map(|line| line.split_once("]: ")).map(|(_, target)| target);
        let is_page = |target: &&str| target.starts_with('#') || target.starts_with("https://");
        let files: Vec<&str> = inline.chain(defined).filter(|target| !is_page(target)).collect();
        let files: Vec<&str> = files
            .iter()
            .map(|target| target.split([')', '\n']).next().unwrap_or_default())
            .collect();
        let allowed: &[&str] = if name == "mstmm" { &["src/crane.svg"] } else { &[] };
        assert_eq!(files, allowed, "{name}: the readme links to files");
    }
}

#[test]
fn packages_contain_sources_and_texts_only() {
    for (name, folder) in published() {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        // The folder may be a copy without version control, and changes need not be committed.
        command.args(["package", "--list", "--allow-dirty", "--offline", "--package", &name]);
        let run = command.current_dir(root()).output().expect("cargo runs");
        assert!(run.status.success(), "{name}: {}", String::from_utf8_lossy(&run.stderr));
        let list = String::from_utf8_lossy(&run.stdout).replace('\\', "/");
        let files: Vec<&str> = list.lines().collect();
        let (sources, others): (Vec<&str>, Vec<&str>) =
            files.iter().partition(|file| file.starts_with("src/"));
        assert!(!sources.is_empty(), "{name} has no sources");
        let strange: Vec<_> = others.iter().filter(|file| !ALLOWED.contains(file)).collect();
        assert!(strange.is_empty(), "{name} contains {strange:?}");
        for required in LICENCES.iter().chain(&["README.md", "Cargo.toml"]) {
            assert!(files.contains(required), "{name} lacks {required}");
        }
        // Nothing in `src/` is omitted.
        let mut missing = Vec::new();
        collect_missing(&folder, Path::new("src"), &files, &mut missing);
        assert!(missing.is_empty(), "{name} lacks {missing:?}");
    }
}

/// Adds the files of a folder that a list does not contain.
fn collect_missing(package: &Path, folder: &Path, list: &[&str], missing: &mut Vec<String>) {
    for entry in fs::read_dir(package.join(folder)).expect("a folder") {
        let path = folder.join(entry.expect("an entry").file_name());
        if package.join(&path).is_dir() {
            collect_missing(package, &path, list, missing);
        } else if !list.contains(&&*path.to_string_lossy().replace('\\', "/")) {
            missing.push(path.display().to_string());
        }
    }
}
