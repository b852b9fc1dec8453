//! Many planets at once: dmech's ensembles beside heyoka's batch mode, on one core.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo bench -p dmech-peers --bench batch
//! ```
//!
//! 64 planets, each with its own gm and its own eccentricity between 0.1 and 0.6, from a pericentre at t = 0 to t = 100, 14 to
//! 17 revolutions. heyoka compiles for the widest registers of the machine, and so does dmech with these flags. The time is
//! that of all planets divided by their number, of dmech with the making of the ensemble, of heyoka that of its compiled
//! loops alone; it is the shortest of several rounds in which all runs take turns. The error of a planet is the distance of its last position
//! from Kepler's equation solved with 31 digits; of a run the largest of all planets, or the median. For each error that is asked
//! for stands the fastest run of a program that is no worse, with its step or tolerance.
//!
//! heyoka runs in a process of its own, where `DMECH_PYTHON` or `python3` is a Python that has it; without it the table has
//! dmech alone.

mod dmech_schemes;
mod entrant;
mod heyoka_batches;
#[path = "../shared/python.rs"]
mod python;
mod table;

use std::cell::RefCell;
use std::time::Instant;

use dmech_peers::ORBITS;
use python::Process;

/// Rounds in which all runs are repeated.
const ROUNDS: u32 = 24;

fn main() {
    let clock = Instant::now();
    let wide = if cfg!(target_feature = "avx512f") {
        "AVX-512"
    } else if cfg!(target_feature = "avx2") {
        "AVX2"
    } else {
        "neither AVX2 nor AVX-512"
    };
    println!("{ORBITS} planets on one core; dmech compiled for {wide}.");
    let heyoka = Process::found("heyoka_batch.py").map(RefCell::new);
    let mut entrants = dmech_schemes::entrants();
    entrants.extend(heyoka_batches::entrants(heyoka.as_ref()));
    let lines = entrant::measure(&entrants, ROUNDS);
    table::of_all(&lines);
    table::of_both(&lines);
    println!("\n{:.0} seconds", clock.elapsed().as_secs_f64());
}
