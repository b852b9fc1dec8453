//! heyoka's batch mode: Taylor series of an order that it chooses by the tolerance. Each planet of a batch has steps of its own, and a
//! batch goes on until all of it are at the end.
//!
//! A batch has as many planets as heyoka recommends for the machine, which fills a register, or twice as many; four times as many
//! took as long or longer. As its manual has it, with `fast_math`, with `high_accuracy`, and with both.

use std::cell::RefCell;
use std::fmt::Write as _;
use std::time::Duration;

use dmech_peers::{Crate, ORBITS, ORBITS_END, orbit_law, orbit_start};

use crate::entrant::{Ends, Entrant};
use crate::python::Process;

/// None where there is no heyoka.
pub(crate) fn entrants(heyoka: Option<&RefCell<Process>>) -> Vec<Entrant<'_>> {
    let Some(heyoka) = heyoka else { return Vec::new() };
    let mut entrants = Vec::new();
    for multiple in [1, 2] {
        for options in ["-", "fast_math", "high_accuracy", "fast_math,high_accuracy"] {
            let run = move |tolerance: f64| all(&mut heyoka.borrow_mut(), multiple, tolerance, options);
            let said = if options == "-" { String::new() } else { format!(", {}", options.replace(',', ", ")) };
            entrants.push(Entrant {
                by: Crate::Heyoka,
                name: format!("batches of {multiple} x recommended{said}"),
                knob: "tolerance",
                knobs: tolerances(),
                run: Box::new(run),
            });
        }
    }
    entrants
}

/// Tolerances of 10⁻² to 10⁻¹⁵ and the least that makes sense.
fn tolerances() -> Vec<f64> {
    let mut tolerances = dmech_peers::tolerances();
    tolerances.push(f64::EPSILON);
    tolerances
}

fn all(heyoka: &mut Process, multiple: u32, tolerance: f64, options: &str) -> Result<Ends, String> {
    let mut request = format!("{multiple} {tolerance:e} {options} {ORBITS_END:e}");
    let starts: [fn(usize) -> f64; 5] = [
        |k| orbit_law(k).gm,
        |k| orbit_start(k).q[0],
        |k| orbit_start(k).q[1],
        |k| orbit_start(k).v[0],
        |k| orbit_start(k).v[1],
    ];
    for of in starts {
        for k in 0..ORBITS {
            let _ = write!(request, " {:e}", of(k));
        }
    }
    let numbers = heyoka.numbers(&request)?;
    let [seconds, _steps, _order, places @ ..] = numbers.as_slice() else { return Err("no numbers".to_owned()) };
    if places.len() != 2 * ORBITS {
        return Err(format!("{} numbers of {}", places.len(), 2 * ORBITS));
    }
    let (x, y) = places.split_at(ORBITS);
    let places = x.iter().zip(y).map(|(&x, &y)| [x, y]).collect();
    let time = Duration::try_from_secs_f64(*seconds).map_err(|error| error.to_string())?;
    Ok(Ends { places, forces: 0, time })
}
