//! Motions on which time steps fail, and what every scheme does there.
//!
//! ```text
//! cargo run --release --example hard_cases
//! cargo run --release --example hard_cases -- kepler wall
//! ```
//!
//! For each case the program says what is hard and what must hold, runs every scheme that fits, and prints the error of
//! the energy (relative to the largest kinetic energy of the run or to the energy at the start, whichever is larger: where
//! both are small differences of large numbers, rounding is relative to these), figures of the case, and how the run ended.
//! Some do not reach the end: they return what they have, with the step that failed and why. `tests/long/many_steps/hard_cases.rs` asserts
//! what must hold; here a failure is printed and is the exit code.

mod cases;
mod figure;
#[path = "../shared/picture.rs"]
mod picture;

use std::process::ExitCode;
use std::time::Instant;

use cases::{CASES, Case, Length, label};
use picture::Drawn;

fn main() -> Drawn<ExitCode> {
    let wanted: Vec<_> = std::env::args().skip(1).collect();
    let mut failures = 0;
    for (name, case) in CASES {
        if !wanted.is_empty() && !wanted.iter().any(|word| word == name) {
            continue;
        }
        let clock = Instant::now();
        let case = case(Length::Whole);
        println!("{}", table(&case));
        for check in case.checks.iter().filter(|check| !check.holds()) {
            println!("  does not hold: {}: {:e}, and may be {:e}", check.what, check.value, check.most);
            failures += 1;
        }
        println!("  {} statements checked, {:.1} s", case.checks.len(), clock.elapsed().as_secs_f64());
        for picture in &case.pictures {
            println!("  picture: {}", figure::draw(picture)?.display());
        }
        println!();
    }
    Ok(if failures == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn table(case: &Case) -> String {
    let mut lines = vec![case.title.to_owned(), "─".repeat(case.title.chars().count())];
    lines.extend(wrapped("Hard: ", case.hard));
    lines.extend(wrapped("Holds: ", case.holds));
    lines.push(String::new());
    let [subject, step] = if case.name == "scales" { ["law", "unit"] } else { ["scheme", "dt"] };
    let wide = |cell: &str| format!(" {cell:>11}");
    let heads: String = case.heads.iter().map(|head| wide(head)).collect();
    lines.push(format!("  {subject:<27} {step:>8} {:>8}{heads}  end", "energy"));
    let mut last = f64::NAN;
    for row in &case.rows {
        if row.dt != last && !last.is_nan() {
            lines.push(String::new());
        }
        last = row.dt;
        let energy = if row.energy.is_nan() { "–".to_owned() } else { format!("{:.0e}", row.energy) };
        let cells: String = row.cells.iter().map(|cell| wide(cell)).collect();
        let step = if row.dt.is_nan() {
            "varies".to_owned()
        } else if row.dt < 0.001 || row.dt > 1e3 {
            format!("{:.1e}", row.dt)
        } else {
            format!("{:.4}", row.dt)
        };
        lines.push(format!("  {:<27} {step:>8} {energy:>8}{cells}  {}", label(row.scheme), row.ended));
    }
    lines.join("\n")
}

/// Lines of at most 118 characters.
fn wrapped(head: &str, text: &str) -> Vec<String> {
    let mut lines = vec![format!("  {head}")];
    for word in text.split_whitespace() {
        let line = lines.last_mut().map_or(0, |line| line.chars().count());
        if line + 1 + word.chars().count() > 118 {
            lines.push(" ".repeat(2 + head.len()));
        }
        if let Some(line) = lines.last_mut() {
            if !line.ends_with(' ') {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}
