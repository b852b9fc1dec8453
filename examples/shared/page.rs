//! A page that collects studies: pictures, the time that each scheme needs, and all rows.

#[path = "html.rs"]
mod html;

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use dmech::StudyReport;
use html::escaped;

use crate::picture::{self, Drawn};

/// A study and its picture.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    pub(crate) words: &'static str,
    pub(crate) picture: PathBuf,
    pub(crate) report: StudyReport,
}

const GOALS: [(f64, &str); 3] = [(1e-3, "10⁻³"), (1e-6, "10⁻⁶"), (1e-9, "10⁻⁹")];

/// Writes the page beside the pictures and tells where it is.
pub(crate) fn save(name: &str, sections: &[Section]) -> Drawn<PathBuf> {
    let mut page = String::new();
    writeln!(page, "<h1>Speed against error</h1>")?;
    writeln!(page, "<p>What each scheme of dmech needs for the final position to be right to an error.</p><ul>")?;
    for (k, section) in sections.iter().enumerate() {
        writeln!(page, "<li><a href=\"#m{k}\">{}</a></li>", escaped(section.title))?;
    }
    writeln!(page, "</ul>")?;
    for (k, section) in sections.iter().enumerate() {
        writeln!(page, "<h2 id=\"m{k}\">{}</h2><p>{}</p>", escaped(section.title), escaped(section.words))?;
        writeln!(page, "{}", html::picture(&section.picture)?)?;
        table(&mut page, &section.report)?;
        writeln!(
            page,
            "<details><summary>All rows</summary><pre>{}</pre></details>",
            escaped(&section.report.to_string())
        )?;
    }
    let path = picture::place(name)?;
    fs::write(&path, html::document("Speed against error", &page))?;
    Ok(path)
}

/// Milliseconds to an error, the least of each column set off.
fn table(page: &mut String, report: &StudyReport) -> std::fmt::Result {
    write!(page, "<div class=\"table\"><table><tr><th>milliseconds to an error of</th>")?;
    GOALS.iter().try_for_each(|(_, goal)| write!(page, "<th>{goal}</th>"))?;
    writeln!(page, "</tr>")?;
    let times = GOALS.map(|(goal, _)| report.time_at(goal));
    let least = times.each_ref().map(|times| times.iter().filter_map(|(_, time)| *time).min());
    for (scheme, (name, _)) in report.schemes().iter().enumerate() {
        write!(page, "<tr><td>{}</td>", escaped(name))?;
        for (times, least) in times.iter().zip(least) {
            let time = times[scheme].1;
            let class = if time.is_some() && time == least { " class=\"best\"" } else { "" };
            let words = time.map_or("–".to_owned(), |time| format!("{:.3}", 1e3 * time.as_secs_f64()));
            write!(page, "<td{class}>{words}</td>")?;
        }
        writeln!(page, "</tr>")?;
    }
    writeln!(page, "</table></div>")
}
