//! The outer Solar System for 10⁴ years, or as many as are asked for: time against the error of energy and angular momentum.
//!
//! ```text
//! cargo bench -p dmech-peers --bench outer_ss -- 1e6
//! ```
//!
//! dmech's schemes on a scene, Gauss's method by hand, and heyoka where a Python has it, all on one core. The time is cut into
//! equal pieces in which all take turns; the errors are relative, the largest at the end of any piece, and the root of
//! the mean square over the earlier and the later half, whose ratio is 1 where the error stays, 1.8 where it grows like the
//! square root of time, 2.6 where it grows with time. Nobody's compilation counts.

#[path = "../shared/heyoka.rs"]
mod process;

use std::cell::RefCell;
use std::env;
use std::rc::Rc;
use std::time::{Duration, Instant};

use dmech::prelude::*;
use dmech_peers::{outer_angular_momentum, outer_energy, outer_gauss, outer_scene, outer_start};
use process::Heyoka;

/// Pieces of the time.
const PIECES: u32 = 64;

/// Moves by a piece: the state then, and how long that took.
type Piece = Box<dyn FnMut() -> Result<(State<18>, Duration), String>>;

struct Row {
    name: String,
    next: Piece,
    time: Duration,
    errors: Vec<[f64; 2]>,
    failure: Option<String>,
}

impl Row {
    fn new(name: String, next: impl FnMut() -> Result<(State<18>, Duration), String> + 'static) -> Row {
        Row { name, next: Box::new(next), time: Duration::ZERO, errors: Vec::new(), failure: None }
    }

    fn advance(&mut self, start: &State<18>) {
        if self.failure.is_some() {
            return;
        }
        match (self.next)() {
            Ok((state, time)) => {
                self.time += time;
                self.errors.push(errors(start, &state));
            }
            Err(cause) => self.failure = Some(cause),
        }
    }

    fn print(&self) {
        print!("{:<46} {:>10.3}", self.name, self.time.as_secs_f64());
        if let Some(cause) = &self.failure {
            println!("  {cause}");
            return;
        }
        for which in 0..2 {
            let largest = self.errors.iter().map(|error| error[which]).fold(0.0, f64::max);
            let (early, late) = self.errors.split_at(self.errors.len() / 2);
            let [early, late] = [early, late].map(|half| {
                (half.iter().map(|error| error[which] * error[which]).sum::<f64>() / half.len() as f64).sqrt()
            });
            print!("   {largest:>8.1e} {late:>8.1e} {:>5.1}", late / early);
        }
        println!();
    }
}

/// Of energy and angular momentum, relative.
fn errors(start: &State<18>, state: &State<18>) -> [f64; 2] {
    let (before, now) = (outer_energy(start), outer_energy(state));
    let (l, m) = (outer_angular_momentum(start), outer_angular_momentum(state));
    let length = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    [((now - before) / before).abs(), length([0, 1, 2].map(|k| m[k] - l[k])) / length(l)]
}

/// A scheme on the scene, h years to a step, or a little less so that the steps fill a piece. (A macro, because a scheme is for
/// one type of system, which has a long name.)
macro_rules! scheme {
    ($scheme:expr, $name:literal, $years:expr, $h:expr) => {{
        let steps = ($years / f64::from(PIECES) / $h).ceil();
        let dt = $years / f64::from(PIECES) / steps;
        let mut stepper = Simulation::scene(outer_scene()).scheme($scheme).dt(dt).stepper()?;
        Row::new(format!("dmech {}, {dt:.3} years", $name), move || {
            let clock = Instant::now();
            stepper.advance(steps as u64).map_err(|error| error.to_string())?;
            let time = clock.elapsed();
            let now = stepper.state();
            let of = |x: &[[f64; 3]]| core::array::from_fn(|i| x[i / 3][i % 3]);
            let state = State::new(of(&now.q), of(&now.v));
            Ok((state, time))
        })
    }};
}

fn by_hand(years: f64, h: f64) -> Row {
    let steps = (years / f64::from(PIECES) / h).ceil();
    let dt = years / f64::from(PIECES) / steps;
    let mut state = outer_start();
    Row::new(format!("Gauss of order 16 by hand, {dt:.3} years"), move || {
        let clock = Instant::now();
        state = outer_gauss(&state, dt, steps as u64);
        Ok((state, clock.elapsed()))
    })
}

fn by_heyoka(heyoka: &Rc<RefCell<Heyoka>>, years: f64, tolerance: f64, options: &'static str) -> Row {
    let (heyoka, mut state) = (Rc::clone(heyoka), outer_start());
    // Compiled before anything is timed.
    let _ = heyoka.borrow_mut().propagate("outer_ss", tolerance, options, &state, 1e-3);
    Row::new(format!("heyoka, tolerance {tolerance:.0e} {options}"), move || {
        let end = years / f64::from(PIECES);
        let (next, time) = heyoka.borrow_mut().propagate("outer_ss", tolerance, options, &state, end)?;
        state = next;
        Ok((state, time))
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let years = env::args().find_map(|argument| argument.parse::<f64>().ok()).unwrap_or(1e4);
    let heyoka = Heyoka::found().map(|heyoka| Rc::new(RefCell::new(heyoka)));
    let mut rows = Vec::new();
    for h in [0.5, 0.25, 0.125, 0.0625] {
        rows.push(scheme!(Nystrom::order8(), "Nystrom::order8()", years, h));
    }
    for h in [2.0, 1.4, 1.0, 0.7, 0.5] {
        rows.push(scheme!(Gauss::order16(), "Gauss::order16()", years, h));
    }
    for h in [2.0, 1.4, 1.0, 0.7, 0.5] {
        rows.push(by_hand(years, h));
    }
    if let Some(heyoka) = &heyoka {
        for tolerance in [1e-9, 1e-12, 1e-15, f64::EPSILON] {
            for options in ["-", "fast_math", "high_accuracy"] {
                rows.push(by_heyoka(heyoka, years, tolerance, options));
            }
        }
    }
    let start = outer_start();
    for _ in 0..PIECES {
        rows.iter_mut().for_each(|row| row.advance(&start));
    }
    println!("The outer Solar System, {years:.0} years");
    let heads = ["energy:", "later", "ratio", "ang. mom.:", "later", "ratio"];
    let [a, b, c, d, e, f] = heads;
    println!("{:<46} {:>10}   {a:>8} {b:>8} {c:>5}  {d:>8} {e:>8} {f:>5}", "", "seconds");
    rows.iter().for_each(Row::print);
    Ok(())
}
