//! A page of results: runs all examples and collects what they say, draw and print.
//!
//! ```text
//! cargo run --release --example gallery                    all of them, some minutes
//! cargo run --release --example gallery -- --quick         without those that take a minute or more
//! cargo run --release --example gallery -- planet cloth    these
//! cargo run --release --example gallery -- --docs          all, and the pictures of README.md are copied to docs/
//! ```
//!
//! The page is `dmech/gallery.html` in the build folder, one file with the pictures in it but for large ones, which are beside
//! it. Every example runs as a program of its own. One that fails is shown with its error, and the exit code is 1 in the end.

mod clock;
mod entry;
#[path = "../shared/html.rs"]
mod html;
mod list;
mod machine;
#[path = "../shared/picture.rs"]
mod picture;
mod run;
mod source;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use entry::Entry;
use picture::Drawn;
use source::Source;

fn main() -> Drawn<ExitCode> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let (options, names): (Vec<&str>, Vec<&str>) =
        arguments.iter().map(|word| word.as_str()).partition(|w| w.starts_with("--"));
    if let Some(option) = options.iter().find(|option| !["--quick", "--docs"].contains(option)) {
        return Err(format!("there is no option {option}: there are --quick and --docs").into());
    }
    if let Some(name) = names.iter().find(|name| !list::names().any(|listed| listed == **name)) {
        return Err(format!("there is no example {name}").into());
    }
    let quick = options.contains(&"--quick");
    let wanted = |name: &str| match names.is_empty() {
        true => !(quick && list::LONG.contains(&name)),
        false => names.contains(&name),
    };
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let groups = sources(&here.join("examples"), wanted)?;

    let page = picture::place("gallery.html")?;
    let folder = page.parent().unwrap_or(Path::new(""));
    let groups = run_all(groups, folder)?;
    fs::write(&page, entry::page(&machine::facts(), &groups)?)?;
    println!("Page: {}", page.display());

    let entries = groups.iter().flat_map(|(_, entries)| entries);
    let (failed, complete): (Vec<_>, Vec<_>) = entries.partition(|entry| entry.outcome.failure.is_some());
    for Entry { name, outcome, .. } in &failed {
        eprintln!("{name} failed: {}", outcome.failure.as_deref().unwrap_or_default().trim());
    }
    if options.contains(&"--docs") {
        let pictures: Vec<_> = complete.iter().flat_map(|entry| &entry.outcome.pictures).collect();
        copy_pictures(here, &pictures)?;
    }
    Ok(if failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

type Groups<T> = Vec<(&'static str, Vec<T>)>;

/// What the files say, before minutes are spent: all of them, so that what is wrong with one is found in any case.
fn sources(examples: &Path, wanted: impl Fn(&str) -> bool) -> Drawn<Groups<(&'static str, Source)>> {
    if let [name, ..] = &list::unlisted(examples)?[..] {
        return Err(format!("the example {name} is in no group of the gallery").into());
    }
    let mut groups = Vec::new();
    for (title, examples_of) in list::GROUPS {
        let read = |example| Source::of(examples, example).map(|source| (example.0, source));
        let mut sources = examples_of.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        sources.retain(|(name, _)| wanted(name));
        groups.push((title, sources));
    }
    Ok(groups)
}

fn run_all(groups: Groups<(&'static str, Source)>, folder: &Path) -> Drawn<Groups<Entry>> {
    println!("Building, then running, {} examples", groups.iter().map(|(_, sources)| sources.len()).sum::<usize>());
    run::build_all(groups.iter().flat_map(|(_, sources)| sources).map(|(name, _)| *name))?;
    let mut all = Vec::new();
    for (title, sources) in groups {
        let mut entries = Vec::new();
        for (name, source) in sources {
            print!("{name:<16} ");
            io::stdout().flush()?;
            let outcome = run::run(name, folder);
            let time = outcome.time.filter(|_| outcome.failure.is_none());
            let time = time.map_or("failed".to_owned(), entry::seconds);
            println!("{time:>9}");
            entries.push(Entry { name: name.to_owned(), source, outcome });
        }
        all.push((title, entries));
    }
    Ok(all)
}

/// What README.md shows from `docs/` is replaced by what has been drawn under the same name.
fn copy_pictures(here: &Path, pictures: &[&PathBuf]) -> Drawn {
    let readme = fs::read_to_string(here.join("README.md"))?;
    let shown = readme.split("](docs/").skip(1).filter_map(|rest| rest.split_once(')'));
    for name in shown.map(|(name, _)| name).filter(|name| name.ends_with(".svg")) {
        let drawn = pictures.iter().find(|path| path.file_name().is_some_and(|file| file == name));
        let drawn = drawn
            .ok_or_else(|| format!("README.md shows docs/{name}, which no example that ran to its end has drawn"))?;
        fs::copy(drawn, here.join("docs").join(name))?;
        println!("Copied: docs/{name}");
    }
    Ok(())
}
