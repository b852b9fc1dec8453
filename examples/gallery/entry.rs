//! The page: what is known of the machine, a list of the examples, and an entry for each.

use std::io;
use std::path::PathBuf;
use std::time::Duration;

use crate::html::{self, escaped, prose};
use crate::source::{Block, Source};

/// How many lines of the numbers are seen at once.
const FIRST: usize = 14;

/// An example that has run.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) source: Source,
    pub(crate) outcome: Outcome,
}

/// What an example left.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outcome {
    /// What it printed.
    pub(crate) numbers: String,
    pub(crate) pictures: Vec<PathBuf>,
    pub(crate) time: Option<Duration>,
    /// Why it did not come to its end.
    pub(crate) failure: Option<String>,
}

/// The page, for a folder that has the pictures in it.
///
/// # Errors
/// Those of reading the pictures.
pub(crate) fn page(facts: &[(&str, String)], groups: &[(&str, Vec<Entry>)]) -> io::Result<String> {
    let mut body = String::from(
        "<h1>dmech: a page of results</h1>\n<p>Every example of dmech: what it shows, some lines of its code, its pictures, \
         and the numbers that it prints. A click on a picture shows it in full size.</p>\n<dl>",
    );
    for (name, fact) in facts {
        body += &format!("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(fact));
    }
    body += "</dl>\n";
    let groups = || groups.iter().filter(|(_, entries)| !entries.is_empty());
    for (title, entries) in groups() {
        body += &format!("<p><strong>{}</strong></p>\n<ul>\n", escaped(title));
        for Entry { name, source, outcome } in entries {
            let failed = if outcome.failure.is_some() { " <span class=\"failed\">failed</span>" } else { "" };
            body += &format!("<li><a href=\"#{name}\">{}</a>{failed}</li>\n", prose(&source.title));
        }
        body += "</ul>\n";
    }
    for (title, entries) in groups() {
        body += &format!("<h2>{}</h2>\n", escaped(title));
        for entry in entries {
            entry.write(&mut body)?;
        }
    }
    Ok(html::document("dmech: a page of results", &body))
}

impl Entry {
    fn write(&self, body: &mut String) -> io::Result<()> {
        let Entry { name, source, outcome } = self;
        *body += &format!("<section id=\"{name}\">\n<h3>{}</h3>\n", prose(&source.title));
        for block in &source.words {
            *body += &match block {
                Block::Prose(words) => format!("<p>{}</p>\n", prose(words)),
                Block::Formula(lines) => format!("<pre class=\"formula\">{}</pre>\n", escaped(lines)),
            };
        }
        *body += &format!("<pre>{}</pre>\n<div class=\"pictures\">", escaped(source.code.trim_end()));
        for path in &outcome.pictures {
            *body += &html::picture(path)?;
        }
        *body += "</div>\n";
        numbers(body, &outcome.numbers);
        if let Some(failure) = &outcome.failure {
            *body += &format!("<p class=\"failed\">It failed.</p><pre>{}</pre>\n", escaped(failure.trim()));
        }
        let time =
            outcome.time.map_or(String::new(), |time| format!(" · <span class=\"time\">{}</span>", seconds(time)));
        *body += &format!("<p><code>cargo run --release --example {name}</code>{time}</p>\n</section>\n");
        Ok(())
    }
}

/// The first lines; all of them take their place when they are unfolded.
fn numbers(body: &mut String, numbers: &str) {
    let lines: Vec<_> = numbers.trim_matches('\n').lines().collect();
    if lines.is_empty() {
        return;
    }
    let first = &lines[..lines.len().min(FIRST)];
    *body += &format!("<div class=\"numbers\"><pre>{}</pre>\n", escaped(&first.join("\n")));
    if first.len() < lines.len() {
        let all = escaped(&lines.join("\n"));
        *body += &format!("<details><summary>All {} lines</summary><pre>{all}</pre></details>", lines.len());
    }
    *body += "</div>\n";
}

/// With three digits.
pub(crate) fn seconds(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        ..0.1 => format!("{:.1} ms", 1e3 * seconds),
        0.1..10.0 => format!("{seconds:.2} s"),
        _ => format!("{seconds:.1} s"),
    }
}
