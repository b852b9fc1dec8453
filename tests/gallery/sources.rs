//! What is read from the files of the examples.

use std::path::Path;

use crate::list::{GROUPS, LONG, names, unlisted};
use crate::source::{Block, Source, piece};

fn examples() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples"))
}

#[test]
fn every_example_is_in_one_group() {
    assert_eq!(unlisted(examples()).unwrap(), Vec::<String>::new());
    for (i, name) in names().enumerate() {
        assert!(names().skip(i + 1).all(|other| other != name), "{name} is there twice");
    }
    assert!(LONG.iter().all(|long| names().any(|name| name == *long)));
}

#[test]
fn every_example_has_a_title_whole_sentences_and_some_lines_of_code() {
    for example in GROUPS.iter().flat_map(|(_, examples)| *examples) {
        let Source { title, words, code } = Source::of(examples(), example).unwrap();
        let name = example.0;
        assert!(!title.is_empty() && !title.contains("```"), "{name}: {title}");
        if let Some(Block::Prose(last)) = words.last() {
            assert!(last.ends_with('.'), "{name}: {last}");
        }
        let open: i32 = code.chars().map(|c| i32::from("([{".contains(c)) - i32::from(")]}".contains(c))).sum();
        assert_eq!(open, 0, "{name}: {code}");
        assert!((3..=26).contains(&code.lines().count()), "{name}: {} lines", code.lines().count());
        assert!(code.lines().any(|line| !line.starts_with(' ')), "{name} is not moved to the left");
    }
}

const TEXT: &str = "\
/// First.
///
/// Second.
#[mark]
pub(crate) fn one() {
    two(&[1, 2]);
}

fn two(
    x: &[u8],
) {
    let y = x
        .len();
}
fn two_again() {
";

#[test]
fn a_piece_goes_to_where_its_brackets_are_closed() {
    assert_eq!(piece(TEXT, "pub(crate) fn one").unwrap(), "/// First.\n#[mark]\nfn one() {\n    two(&[1, 2]);\n}\n");
    assert_eq!(piece(TEXT, "fn two(").unwrap(), "fn two(\n    x: &[u8],\n) {\n    let y = x\n        .len();\n}\n");
    assert_eq!(piece(TEXT, "let y").unwrap(), "let y = x\n    .len();\n");
}

#[test]
fn a_piece_that_is_not_there_once_and_whole_is_an_error() {
    assert_eq!(piece(TEXT, "fn three"), Err("is not there"));
    assert_eq!(piece(TEXT, "fn two"), Err("is there more than once"));
    assert_eq!(piece(TEXT, "fn two_again"), Err("does not end"));
}
