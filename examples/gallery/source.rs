//! What the file of an example says: its title, its first sentences, and pieces of its code.

use std::fs;
use std::path::Path;

use crate::list::Example;

/// A paragraph, or lines that stand as they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    Prose(String),
    Formula(String),
}

/// What is shown of an example before it has run.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) title: String,
    pub(crate) words: Vec<Block>,
    pub(crate) code: String,
}

impl Source {
    /// From the files in the folder of the examples.
    ///
    /// # Errors
    /// Names the file that cannot be read, has no head, or does not have a piece exactly once.
    pub(crate) fn of(folder: &Path, (name, pieces): &Example) -> Result<Source, String> {
        let read = |file: &str| fs::read_to_string(folder.join(file)).map_err(|error| format!("{file}: {error}"));
        let text = read(&format!("{name}.rs")).or_else(|_| read(&format!("{name}/main.rs")))?;
        let mut blocks = head(&text).into_iter();
        let Some(Block::Prose(title)) = blocks.next() else { return Err(format!("{name}: no title")) };
        let pieces = pieces.iter().map(|(file, start)| {
            piece(&read(file)?, start)
                .map_err(|problem| format!("{file}: a piece that begins with `{start}` {problem}"))
        });
        // Between pieces of one line there is no empty one.
        let (mut code, mut before) = (String::new(), 1);
        for piece in pieces {
            let piece = piece?;
            let lines = piece.lines().count();
            code += if !code.is_empty() && before.max(lines) > 1 { "\n" } else { "" };
            code += &piece;
            before = lines;
        }
        Ok(Source { title: title.trim_end_matches('.').to_owned(), words: in_short(blocks), code })
    }
}

/// The blocks of the `//!` lines at the head of a file.
fn head(text: &str) -> Vec<Block> {
    let (mut blocks, mut block, mut formula) = (Vec::new(), Vec::new(), false);
    for line in text.lines().map_while(|line| line.strip_prefix("//!")).chain([""]) {
        let line = line.strip_prefix(' ').unwrap_or(line);
        let fence = line.starts_with("```");
        if !fence && (formula || !line.is_empty()) {
            block.push(line);
        } else if !block.is_empty() {
            blocks.push(if formula { Block::Formula(block.join("\n")) } else { Block::Prose(block.join(" ")) });
            block.clear();
        }
        formula ^= fence;
    }
    blocks
}

/// The first two sentences, with the formulas in them; not the commands.
fn in_short(blocks: impl Iterator<Item = Block>) -> Vec<Block> {
    let (mut words, mut sentences) = (Vec::new(), 0);
    for block in blocks {
        match block {
            Block::Formula(formula) if formula.starts_with("cargo ") => {}
            // After a colon.
            Block::Formula(_) => words.push(block),
            Block::Prose(_) if sentences >= 2 => break,
            Block::Prose(prose) => {
                let ends = sentence_ends(&prose);
                if let Some(&end) = ends.get(1 - sentences) {
                    words.push(Block::Prose(prose[..end].to_owned()));
                    break;
                }
                sentences += ends.len() + usize::from(prose.ends_with(':'));
                let whole = prose.ends_with('.');
                words.push(Block::Prose(prose));
                // A paragraph is enough, unless it goes on behind a formula.
                if whole {
                    break;
                }
            }
        }
    }
    words
}

/// Where sentences end: at a full stop that is not in brackets, nor behind an initial, and before a capital, code, or the
/// one name that is written small.
fn sentence_ends(prose: &str) -> Vec<usize> {
    let (mut ends, mut depth) = (Vec::new(), 0);
    for (at, c) in prose.char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        let (before, after) = (&prose[..at], &prose[at + c.len_utf8()..]);
        let initial = before.chars().rev().take_while(|c| c.is_alphanumeric()).count() == 1;
        let begins =
            |next: &str| next.starts_with(|c: char| c.is_uppercase() || c == '`') || next.starts_with("dmech ");
        let capital = after.is_empty() || after.strip_prefix(' ').is_some_and(begins);
        if c == '.' && depth == 0 && !initial && capital {
            ends.push(at + 1);
        }
    }
    ends
}

/// From the one line that begins with the given words to where its brackets are closed, with the comment and the attributes
/// above it, moved to the left.
///
/// # Errors
/// There is no such line, there are several, or the end of the text comes first.
pub(crate) fn piece(text: &str, start: &str) -> Result<String, &'static str> {
    let lines: Vec<_> = text.lines().collect();
    let mut begins = (0..lines.len()).filter(|&i| lines[i].trim_start().starts_with(start));
    let begin = begins.next().ok_or("is not there")?;
    if begins.next().is_some() {
        return Err("is there more than once");
    }
    let mut depth = 0;
    let closes = |line: &&str| {
        depth += line.chars().map(|c| i32::from("([{".contains(c)) - i32::from(")]}".contains(c))).sum::<i32>();
        depth == 0 && line.ends_with(['}', ';'])
    };
    let end = begin + lines[begin..].iter().position(closes).ok_or("does not end")?;
    let is_above = |line: &&&str| ["///", "#["].iter().any(|mark| line.trim_start().starts_with(mark));
    let above = lines[..begin].iter().rev().take_while(is_above).count();
    // Of a comment its first paragraph; `pub(crate)` says something of the file alone.
    let paragraph = |line: &&&str| line.trim() != "///";
    let comment = lines[begin - above..begin].iter().take_while(paragraph);
    let attributes = lines[begin - above..begin].iter().skip_while(paragraph).filter(|line| line.contains("#["));
    let indent = lines[begin].len() - lines[begin].trim_start().len();
    let shown = comment.chain(attributes).chain(&lines[begin..=end]);
    Ok(shown.map(|line| format!("{}\n", line.get(indent..).unwrap_or("").replace("pub(crate) ", ""))).collect())
}
