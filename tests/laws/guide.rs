//! The guide: its chapters, its links, the messages that it shows.

use std::collections::BTreeSet;
use std::fs::{read_dir, read_to_string};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files of the guide, SUMMARY.md and its chapters, by name.
fn files() -> Vec<(String, String)> {
    let files = read_dir(root().join("docs/guide")).unwrap().map(|entry| entry.unwrap().path());
    let text =
        |path: PathBuf| (path.file_name().unwrap().to_string_lossy().into_owned(), read_to_string(&path).unwrap());
    let files: Vec<_> = files.filter(|path| path.extension().is_some_and(|end| end == "md")).map(text).collect();
    assert!(files.len() > 11, "the guide has {} files", files.len());
    files
}

/// What stands between two marks, each time.
fn between<'t>(text: &'t str, open: &str, close: &str) -> Vec<&'t str> {
    text.split(open).skip(1).filter_map(|rest| rest.split(close).next()).collect()
}

/// The lines outside of code.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut code = false;
    text.lines().filter(move |line| {
        let fence = line.starts_with("```");
        code ^= fence;
        !code && !fence
    })
}

/// What a heading is called in a link: as mdBook and rustdoc have it, for letters, digits, blanks and hyphens.
fn anchor(heading: &str) -> String {
    let letters = heading.trim_start_matches('#').trim().to_lowercase();
    letters
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}

/// The book and the documentation of the crate have the same chapters in the same order, and no file is left out of them.
#[test]
fn the_book_and_the_crate_have_every_chapter() {
    let summary = read_to_string(root().join("docs/guide/SUMMARY.md")).unwrap();
    let source = read_to_string(root().join("src/guide.rs")).unwrap();
    let listed = between(&summary, "](", ")");
    assert_eq!(listed, between(&source, "include_str!(\"../docs/guide/", "\")"));
    let there: BTreeSet<_> = files().into_iter().map(|(name, _)| name).filter(|name| name != "SUMMARY.md").collect();
    assert_eq!(there, listed.iter().map(ToString::to_string).collect());
    // A title in the summary is that of the chapter, but for the first page.
    for (title, file) in between(&summary, "- [", "]").into_iter().zip(&listed[1..]) {
        assert!(
            read_to_string(root().join("docs/guide").join(file)).unwrap().starts_with(&format!("# {title}\n")),
            "{file}"
        );
    }
}

/// Links lead to chapters and headings that are there, in the book by `[name]: file.md`, in the crate by the same name of an item.
#[test]
fn links_lead_somewhere() {
    let (files, mut seen) = (files(), 0);
    let items = read_to_string(root().join("src/guide/links.md")).unwrap();
    for (name, text) in files.iter().filter(|(name, _)| name != "SUMMARY.md") {
        let mut used = BTreeSet::new();
        for line in prose(text) {
            assert!(!line.contains(".md)"), "{name}: a link by name leads somewhere in rustdoc too: {line}");
            for heading in between(line, "](#", ")") {
                assert!(
                    prose(text).any(|line| line.starts_with('#') && anchor(line) == heading),
                    "{name}: no {heading}"
                );
            }
            used.extend(between(line, "][", "]"));
        }
        let defined: Vec<_> = prose(text).filter_map(|line| line.strip_prefix('[')?.split_once("]: ")).collect();
        assert_eq!(used, defined.iter().map(|&(label, _)| label).collect(), "{name}: links used, and links defined");
        for (label, target) in defined {
            seen += 1;
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let (_, found) =
                files.iter().find(|(other, _)| other == file).unwrap_or_else(|| panic!("{name}: no {file}"));
            let is_there =
                heading.is_empty() || prose(found).any(|line| line.starts_with('#') && anchor(line) == heading);
            assert!(is_there, "{name}: no {heading} in {file}");
            let item = file.trim_end_matches(".md").replace('-', "_");
            assert!(
                items.contains(&format!("[{label}]: crate::guide::{item}\n")),
                "{name}: [{label}] in src/guide/links.md"
            );
        }
    }
    assert!(seen > 20, "{seen} links");
}

/// What the compiler is said to answer is what it answers in the tests of messages.
#[test]
fn messages_are_the_compilers() {
    fn errors(folder: &Path, found: &mut BTreeSet<String>) {
        for path in read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                errors(&path, found);
            } else if path.extension().is_some_and(|end| end == "stderr") {
                found.extend(read_to_string(&path).unwrap().lines().map(str::to_owned));
            }
        }
    }
    let mut known = BTreeSet::new();
    errors(&root().join("tests/messages/fail"), &mut known);
    let mut shown = 0;
    for (name, text) in files() {
        for line in text.lines().filter(|line| line.starts_with("error")) {
            assert!(known.contains(line), "{name}: {line}");
            shown += 1;
        }
    }
    assert!(shown > 20, "{shown} messages");
}

/// What needs an MPI is compiled in the crate that has one: what the guide shows of it is what stands there.
#[test]
fn what_needs_an_mpi_is_compiled_where_there_is_one() {
    let crate_page = read_to_string(root().join("dmech-mpi/src/lib.rs")).unwrap();
    let compiled: BTreeSet<_> =
        between(&crate_page, "//! ```no_run\n", "//! ```\n").into_iter().flat_map(str::lines).collect();
    let compiled: BTreeSet<_> = compiled.into_iter().map(|line| line.trim_start_matches("//!").trim()).collect();
    let mut lines = 0;
    for (file, text) in files() {
        for line in between(&text, "```rust,ignore\n", "```").into_iter().flat_map(str::lines) {
            assert!(compiled.contains(line.trim()), "{file}: {line}");
            lines += 1;
        }
    }
    assert!(lines > 3, "{lines}");
}
