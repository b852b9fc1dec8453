//! Many random laws, on all cores.

use std::time::Instant;

use dmech_laws::{Tally, campaign};

/// How many findings of each kind are shown.
const SHOWN: usize = 4;

fn many(seed: u64, count: u64, first: u64) -> Tally {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let mut all = Tally::default();
    std::thread::scope(|scope| {
        let share = count.div_ceil(threads);
        let workers: Vec<_> = (0..threads)
            .map(|i| {
                scope
                    .spawn(move || campaign(seed, first + i * share, share.min(count.saturating_sub(i * share)), SHOWN))
            })
            .collect();
        for worker in workers {
            all.merge(worker.join().expect("a law made the engine panic; it is named above"));
        }
    });
    all
}

/// # Panics
/// Where the engine does, and where a law does not keep what is promised of it.
pub(crate) fn run(seed: u64, count: u64, first: u64) {
    let clock = Instant::now();
    let tally = many(seed, count, first);
    tally.findings.iter().for_each(|finding| println!("{finding}\n"));
    println!("{count} laws from number {first}, seed {seed}: {}", summary(&tally));
    println!(
        "{:.1} s, {:.3} s of one core per 1000 laws",
        clock.elapsed().as_secs_f64(),
        tally.time.as_secs_f64() * 1e3 / count as f64
    );
    println!("slowest {:.1} ms: law {}", tally.slowest.0.as_secs_f64() * 1e3, tally.slowest.1);
    assert!(tally.broken.is_empty(), "broken: {:?}", tally.broken);
}

fn summary(tally: &Tally) -> String {
    let places: Vec<_> = tally
        .places
        .iter()
        .map(|(place, [all, unbounded, crossing])| {
            format!("{place:?} {all} ({unbounded} not finite, {crossing} across a seam)")
        })
        .collect();
    format!(
        "{} with a step across a seam, {} with an absent coordinate, {} derivatives compared\n  nodes: {:?}\n  pairs: {}\n  \
         secant identity: at most {:.2} ulp; broken: {:?}",
        tally.crossed,
        tally.absent,
        tally.slopes,
        tally.kinds,
        places.join(", "),
        tally.worst,
        tally.broken,
    )
}
