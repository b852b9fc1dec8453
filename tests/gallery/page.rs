//! The page of two made-up examples, one of which failed, with all that could make it too wide.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{env, fs, io, process};

use crate::browser;
use crate::entry::{self, Entry, Outcome};
use crate::source::{Block, Source};

/// A phone and a desk.
const WIDTHS: [u32; 2] = [420, 1400];

/// A picture with so many dots.
fn drawn(folder: &Path, name: &str, dots: usize) -> PathBuf {
    let dots: String =
        (0..dots).map(|x| format!("<circle cx=\"{x}\" cy=\"200\" r=\"1\" fill=\"#000000\"/>\n")).collect();
    let svg = format!(
        "<svg width=\"1600\" height=\"400\" viewBox=\"0 0 1600 400\" xmlns=\"http://www.w3.org/2000/svg\">{dots}</svg>"
    );
    let path = folder.join(name);
    fs::write(&path, svg).unwrap();
    path
}

fn example(name: &str, pictures: Vec<PathBuf>, failure: Option<String>) -> Entry {
    let wide = "0123456789 ".repeat(40);
    let source = Source {
        title: format!("A title with <signs> & {}", "a_very_long_word".repeat(10)),
        words: vec![Block::Prose("Two words, `one` of them code.".to_owned()), Block::Formula(wide.clone())],
        code: format!("fn heart() {{\n    {wide}\n}}\n"),
    };
    let numbers = format!("{wide}\n").repeat(50);
    Entry {
        name: name.to_owned(),
        source,
        outcome: Outcome { numbers, pictures, time: Some(Duration::from_millis(1234)), failure },
    }
}

fn page(folder: &Path) -> String {
    let pictures = vec![drawn(folder, "small.svg", 10), drawn(folder, "large.svg", 20_000)];
    let failed = example("failed", vec![drawn(folder, "other.svg", 10)], Some("an error ".repeat(40)));
    let groups = [("One", vec![example("works", pictures, None)]), ("None", vec![]), ("Two", vec![failed])];
    entry::page(&[("Processor", "long_name".repeat(20)), ("Date", "today".to_owned())], &groups).unwrap()
}

/// For the time of a test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = env::temp_dir().join(format!("dmech-gallery-{name}-{}", process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn the_page_has_what_an_example_left() {
    let folder = Folder::new("text");
    let page = page(&folder.0);
    for part in [
        "&lt;signs&gt; &amp; a_very",
        "<code>one</code>",
        "<a href=\"#works\">",
        "1.23 s",
        "All 50 lines",
        "an error an",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(page.matches("class=\"failed\">failed").count(), 1);
    assert_eq!(page.matches("<svg ").count(), 3);
}

#[test]
fn a_browser_shows_the_page_within_its_width_with_all_pictures() {
    let Some(browser) = browser::find() else {
        // Not by `println`, which would keep it to itself.
        let line = "skipped: the page of the gallery in a browser, as there is none; DMECH_CHROMIUM may name one";
        writeln!(io::stderr(), "{line}").unwrap();
        return;
    };
    let folder = Folder::new("browser");
    let page = page(&folder.0);
    for (facts, width) in browser::facts(&browser, &folder.0, &page, WIDTHS).into_iter().zip(WIDTHS) {
        assert!(facts.client > f64::from(width) - 20.0 && facts.client <= f64::from(width), "{facts:?}");
        assert!(facts.scroll.max(facts.unfolded) <= facts.client, "too wide: {facts:?}");
        assert!(facts.cut <= 0.0, "{facts:?}");
        assert_eq!((facts.pictures, facts.missing, facts.errors), (3.0, 0.0, 0.0), "{facts:?}");
        assert!(facts.letters >= 15.0, "{facts:?}");
    }
    // What is wrong is seen.
    let mut wrong = page.replace("overflow-x:auto", "overflow-x:visible").replace("font-size:15px", "font-size:14px");
    wrong = wrong.replace("max-width:100%", "max-width:200%");
    wrong = wrong.replace("</body>", "<script>nothing.at.all</script><img src=\"nothing.svg\"></body>");
    wrong = wrong.replacen("height=\"400\"", "height=\"400\" style=\"display:none\"", 1);
    for facts in browser::facts(&browser, &folder.0, &wrong, WIDTHS) {
        assert!(facts.scroll > facts.client && facts.cut > 0.0 && facts.letters < 15.0, "{facts:?}");
        assert!(facts.pictures == 2.0 && facts.missing == 2.0 && facts.errors >= 2.0, "{facts:?}");
    }
}
