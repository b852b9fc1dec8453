//! A page that collects studies: pictures, the time that each scheme needs, and all rows.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use dmech::StudyReport;

use crate::picture::{self, Drawn};

/// A study and its picture.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    pub(crate) words: &'static str,
    pub(crate) picture: PathBuf,
    pub(crate) report: StudyReport,
}

const GOALS: [(f64, &str); 3] = [(1e-3, "10⁻³"), (1e-6, "10⁻⁶"), (1e-9, "10⁻⁹")];

const STYLE: &str = "body{font:15px/1.5 sans-serif;color:#333;max-width:60rem;margin:2rem auto;padding:0 1rem}\
h1,h2{font-weight:600}figure{margin:1rem 0}svg{max-width:100%;height:auto}table{border-collapse:collapse}\
td,th{padding:.15rem .9rem .15rem 0;text-align:right}td:first-child,th:first-child{text-align:left}\
th{border-bottom:1px solid #ccc;font-weight:600}.best{font-weight:700;color:#228833}\
pre{font-size:12px;overflow-x:auto;background:#f6f6f6;padding:1rem}";

/// Writes the page beside the pictures and tells where it is.
pub(crate) fn save(name: &str, sections: &[Section]) -> Drawn<PathBuf> {
    let mut page = String::new();
    writeln!(page, "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">")?;
    writeln!(page, "<title>Speed against error</title><style>{STYLE}</style></head><body>")?;
    writeln!(page, "<h1>Speed against error</h1>")?;
    writeln!(page, "<p>What each scheme of dmech needs for the final position to be right to an error.</p><ul>")?;
    for (k, section) in sections.iter().enumerate() {
        writeln!(page, "<li><a href=\"#m{k}\">{}</a></li>", escaped(section.title))?;
    }
    writeln!(page, "</ul>")?;
    for (k, section) in sections.iter().enumerate() {
        writeln!(page, "<h2 id=\"m{k}\">{}</h2><p>{}</p>", escaped(section.title), escaped(section.words))?;
        writeln!(page, "<figure>{}</figure>", fs::read_to_string(&section.picture)?)?;
        table(&mut page, &section.report)?;
        writeln!(
            page,
            "<details><summary>All rows</summary><pre>{}</pre></details>",
            escaped(&section.report.to_string())
        )?;
    }
    writeln!(page, "</body></html>")?;
    let path = picture::place(name)?;
    fs::write(&path, page)?;
    Ok(path)
}

/// Milliseconds to an error, the least of each column set off.
fn table(page: &mut String, report: &StudyReport) -> std::fmt::Result {
    write!(page, "<table><tr><th>milliseconds to an error of</th>")?;
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
    writeln!(page, "</table>")
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
