//! The README shows the program and the report that the program prints.

use dmech::models::Kepler;
use dmech::prelude::*;

const README: &str = include_str!("../../README.md");
const PROGRAM: &str = include_str!("../../examples/planet.rs");

#[test]
fn the_program_is_the_example() {
    let program = PROGRAM.split_once("use dmech").map(|(_, rest)| format!("use dmech{rest}")).unwrap();
    assert!(README.contains(&program), "README.md and examples/planet.rs differ");
}

/// All but times, and all but the last digits of rounding errors, which differ between processors.
#[test]
fn the_report_is_what_it_prints() {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let run = Simulation::new(Kepler { gm: 1.0 }, start).scheme(DiscreteGradient).dt(0.01).run_until(350.0).unwrap();
    let printed = run.to_string();
    let shown = README.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let stable = |line: &str| -> String {
        let words = line.split_whitespace().filter(|word| !word.contains("e-"));
        words.collect::<Vec<_>>().join(" ")
    };
    assert_eq!(printed.lines().count(), shown.lines().count());
    for (printed, shown) in printed.lines().zip(shown.lines()).filter(|(line, _)| !line.contains("time ")) {
        assert_eq!(stable(printed), stable(shown));
    }
    assert!(shown.contains("must be") && shown.contains("exact"));
}
