//! Tables of what was measured.

use dmech_peers::Crate;

use crate::entrant::{Line, Rung};

/// The errors that are asked for, and how many times as fast as heyoka dmech is to be.
const GOALS: [(f64, f64); 4] = [(1e-3, 1.5), (1e-6, 1.5), (1e-9, 1.5), (1e-12, 1.2)];

/// The scheme of dmech for each of these, chosen before the run.
const FIXED: [&str; 4] = [
    "ForceGradient(Smooth8S14)",
    "RungeKuttaNystrom(12), adaptive",
    "RungeKuttaNystrom(12), adaptive",
    "RungeKuttaNystrom(12), adaptive",
];

/// An error of a run.
#[derive(Clone, Copy, Debug)]
struct Measure {
    name: &'static str,
    of: fn(&Rung) -> f64,
}

const MEASURES: [Measure; 2] =
    [Measure { name: "largest", of: |rung| rung.largest }, Measure { name: "median", of: |rung| rung.median }];

impl Measure {
    /// The fastest run that is no worse.
    fn fastest(self, line: &Line, goal: f64) -> Option<&Rung> {
        let reached = line.rungs.iter().filter(|rung| (self.of)(rung) <= goal);
        reached.min_by(|a, b| a.microseconds.total_cmp(&b.microseconds))
    }

    /// That of all runs of a program.
    fn best(self, lines: &[Line], by: Crate, goal: f64) -> Option<(&Line, &Rung)> {
        let runs = lines.iter().filter(|line| line.by == by).filter_map(|line| Some((line, self.fastest(line, goal)?)));
        runs.min_by(|a, b| a.1.microseconds.total_cmp(&b.1.microseconds))
    }
}

/// Microseconds of a planet to each error, and forces to it; nanoseconds of a force, with all that belongs to it, in the finest run.
pub(crate) fn of_all(lines: &[Line]) {
    let [largest, _] = MEASURES;
    print!("{:<60}", "microseconds a planet to a largest error of");
    GOALS.iter().for_each(|(goal, _)| print!(" {goal:>7.0e}"));
    println!("   {:<31}  {:>7}", "forces a planet", "ns each");
    for line in lines {
        print!("{:<60}", format!("{} {}", line.by.name(), line.name));
        let runs = GOALS.map(|(goal, _)| largest.fastest(line, goal));
        for run in runs {
            print!(" {:>7}", run.map_or("–".to_owned(), |rung| format!("{:.1}", rung.microseconds)));
        }
        if line.by == Crate::Dmech {
            print!("  ");
            for run in runs {
                print!(" {:>7}", run.map_or("–".to_owned(), |rung| format!("{:.0}", rung.forces)));
            }
            if let Some(rung) = line.rungs.last() {
                print!("   {:>7.2}", 1e3 * rung.microseconds / rung.forces);
            }
        }
        println!();
    }
}

/// The best of heyoka and of dmech beside each other, and the scheme of dmech that was fixed in advance.
pub(crate) fn of_both(lines: &[Line]) {
    for measure in MEASURES {
        println!("\nError of all planets: the {}", measure.name);
        println!("  {:<6} {:<7} {:>8} {:>8} {:>9}", "asked", "", "µs", "reached", "ratio");
        for ((goal, wanted), fixed) in GOALS.into_iter().zip(FIXED) {
            let fixed: Vec<_> = lines.iter().filter(|line| line.by == Crate::Dmech && line.name == fixed).collect();
            let peer = measure.best(lines, Crate::Heyoka, goal);
            let own = measure.best(lines, Crate::Dmech, goal);
            let fixed = fixed.first().and_then(|line| Some((*line, measure.fastest(line, goal)?)));
            for (name, run) in [("heyoka", peer), ("dmech", own), ("fixed", fixed)] {
                print!("  {:<6.0e} {name:<7}", goal);
                let Some((line, rung)) = run else {
                    println!(" {:>8} {:>18}", "–", if name == "heyoka" { "  " } else { "– *" });
                    continue;
                };
                print!(" {:>8.2} {:>8.1e}", rung.microseconds, (measure.of)(rung));
                match peer {
                    Some((_, peer)) if name != "heyoka" => {
                        let ratio = peer.microseconds / rung.microseconds;
                        print!(" {ratio:>7.2}{}", if ratio < wanted { " *" } else { "  " });
                    }
                    _ => print!(" {:>9}", ""),
                }
                println!("  {}, {} {:.2e}", line.name, line.knob, rung.knob);
            }
        }
    }
    println!("\nHow many times as long heyoka takes; * less than asked, or not that accurate: {}", asked());
}

fn asked() -> String {
    GOALS.map(|(goal, wanted)| format!("{wanted} at {goal:.0e}")).join(", ")
}
