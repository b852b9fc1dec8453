//! Other solvers beside dmech: time against error on five motions.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo bench -p dmech-peers --features solvers
//! ```
//!
//! All get the same force, written by hand and inlined, the tolerances 10⁻² to 10⁻¹⁵ (relative and absolute alike) or
//! their own ladder of steps (for order 16, by hand as generated, one of smaller rungs), and no output but the last state;
//! fixed-size vectors where the crate can use them. What was given to each program is said in its file. dmech gets the
//! declared potential. The time of a run includes the making of the solver (not of heyoka's, which compiles it), and is the shortest of several rounds in which all take turns. heyoka
//! runs in a process of its own, where `DMECH_PYTHON` or `python3` is a Python that has it. The error is the distance of the
//! final position (of all coordinates) from the exact one; the time to an error lies on the line between two runs, in
//! logarithms. A dash says that no run of at most 40 ms reaches it; ≤ that already the coarsest run does.

mod diagram;
mod differential_equations;
mod diffsol;
mod heyoka;
mod ode_solvers;

#[path = "../../../examples/shared/picture.rs"]
mod picture;
#[path = "../shared/heyoka.rs"]
mod process;

use std::cell::RefCell;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::time::Instant;

use dmech::models::{Kepler, Pendulum};
use dmech::prelude::State;
use dmech_peers::{Crate, Entrant, Motion, Problem, Report, chain_schemes, law_schemes, measure, planet_twin, twins};
use picture::Drawn;
use process::Heyoka;

/// Rounds in which all runs are repeated.
const ROUNDS: u32 = 6;

fn main() -> Drawn {
    let clock = Instant::now();
    let heyoka = Heyoka::found().map(RefCell::new);
    let heyoka = heyoka.as_ref();
    let mut reports = Vec::new();
    let problem = dmech_peers::orbit();
    reports.push(study::<_, 2, 4>(&problem, heyoka, law_schemes(Kepler { gm: 1.0 }, &problem))?);
    let problem = dmech_peers::eccentric();
    let mut own = law_schemes(Kepler { gm: 1.0 }, &problem);
    own.push(planet_twin(&problem));
    reports.push(study::<_, 2, 4>(&problem, heyoka, own)?);
    let problem = dmech_peers::pendulum();
    reports.push(study::<_, 1, 2>(&problem, heyoka, law_schemes(Pendulum { k: 1.0 }, &problem))?);
    let problem = dmech_peers::eight();
    reports.push(study::<_, 6, 12>(&problem, heyoka, law_schemes(dmech_peers::three_bodies(), &problem))?);
    let problem = dmech_peers::fput();
    reports.push(study::<_, 64, 128>(&problem, heyoka, chain_schemes(&problem))?);
    compare(&reports);
    let csv = picture::place("peers.csv")?;
    let mut rows = BufWriter::new(File::create(&csv)?);
    writeln!(rows, "{}", Report::COLUMNS)?;
    reports.iter().try_for_each(|report| report.write_csv(&mut rows))?;
    rows.flush()?;
    println!("Rows: {}", csv.display());
    println!("{:.0} seconds", clock.elapsed().as_secs_f64());
    Ok(())
}

/// Measures all on one motion, with its table and its picture.
fn study<'a, M: Motion<D>, const D: usize, const N: usize>(
    problem: &'a Problem<M, D>,
    heyoka: Option<&'a RefCell<Heyoka>>,
    mut entrants: Vec<Entrant<'a>>,
) -> Drawn<Report> {
    entrants.extend(twins(problem));
    entrants.extend(heyoka::entrants(heyoka, problem));
    entrants.extend(ode_solvers::entrants::<M, D, N>(problem));
    entrants.extend(differential_equations::entrants::<M, D, N>(problem));
    entrants.extend(diffsol::entrants::<M, D, N>(problem));
    let lines = measure(&entrants, ROUNDS);
    let Problem { name, title, kind, .. } = *problem;
    let report = Report { name, title, kind, lines };
    println!("{}", report.table());
    println!("Picture: {}\n", diagram::draw(&report)?.display());
    Ok(report)
}

fn compare(reports: &[Report]) {
    println!(
        "Milliseconds of the scheme of dmech that is advised for an error, fixed in advance, and of its best; how many times as\n\
         long as either the best of another program takes; * even the best of dmech is behind"
    );
    print!("  {:<6} {:>9} {:>9}", "error", "advised", "best");
    for by in Crate::PEERS.into_iter().chain([Crate::Hand]) {
        print!(" {:>15}", by.name().replace("differential-equations", "diff.-equations"));
    }
    println!("   advised | best");
    for report in reports {
        println!("{}\n{}", report.title, report.ratios().trim_end());
    }
    let behind: Vec<_> = reports.iter().flat_map(Report::behind).collect();
    if behind.is_empty() {
        println!("\nThe best of dmech is ahead of the other programs everywhere.");
    } else {
        println!("\nThe best of dmech is behind:\n  {}", behind.join("\n  "));
    }
}

/// q and v one behind the other; N = 2 D.
fn joined<const D: usize, const N: usize>(state: &State<D>) -> [f64; N] {
    core::array::from_fn(|i| if i < D { state.q[i] } else { state.v[i - D] })
}

/// The first D numbers.
fn position<const D: usize>(y: &[f64]) -> [f64; D] {
    core::array::from_fn(|i| y[i])
}

/// q′ = v, v′ = a(q).
#[inline(always)]
fn rates<M: Motion<D>, const D: usize>(motion: &M, y: &[f64], dy: &mut [f64]) {
    let (q, v) = halves::<D>(y);
    let (dq, dv) = dy.split_first_chunk_mut::<D>().expect("2 D numbers");
    *dq = *v;
    motion.acceleration(q, dv.first_chunk_mut().expect("2 D numbers"));
}

/// How these change along a direction.
fn rates_along<M: Motion<D>, const D: usize>(motion: &M, y: &[f64], along: &[f64], change: &mut [f64]) {
    let ((q, _), (dq, dv)) = (halves::<D>(y), halves::<D>(along));
    let (first, second) = change.split_first_chunk_mut::<D>().expect("2 D numbers");
    *first = *dv;
    motion.change(q, dq, second.first_chunk_mut().expect("2 D numbers"));
}

#[inline(always)]
fn halves<const D: usize>(y: &[f64]) -> (&[f64; D], &[f64; D]) {
    let (q, v) = y.split_first_chunk::<D>().expect("2 D numbers");
    (q, v.first_chunk().expect("2 D numbers"))
}
