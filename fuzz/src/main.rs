//! Arbitrary token streams and damaged laws for the library behind the macros: it may refuse, it must never panic.
//!
//! `cargo run --release -p dmech-fuzz -- [RUNS] [SEED]` prints how many laws were accepted and refused, and the slowest
//! of them. A run that panics prints the law. No toolchain but the stable one is needed.
#![forbid(unsafe_code)]

mod campaign;
mod damage;
mod laws;

use campaign::{Tally, campaign};

fn main() {
    let number = |i: usize, otherwise: u64| std::env::args().nth(i).and_then(|a| a.parse().ok()).unwrap_or(otherwise);
    let (runs, seed) = (number(1, 100_000), number(2, 2026));
    let Tally { accepted, refused, unreadable, messages, slowest, slow_law } = campaign(runs, seed);
    println!(
        "{runs} runs, seed {seed}: {accepted} accepted, {refused} refused with {} messages, {unreadable} not even tokens, no panic",
        messages.len()
    );
    println!("slowest {:.1} ms: {slow_law}", slowest.as_secs_f64() * 1e3);
    assert!(accepted > runs / 100 && refused > runs / 10, "there was little to read");
}
