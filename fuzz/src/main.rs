//! Random laws for the engine, and damaged tokens for the library behind the macros.
//!
//! ```text
//! cargo run --release -p dmech-fuzz -- laws [SEED] [COUNT] [FIRST]     random laws with choices, each at a dozen pairs of points
//! cargo run --release -p dmech-fuzz -- tokens [RUNS] [SEED]            damaged laws and no laws at all
//! ```
//!
//! `laws` tries every promise that `dmech_laws` states and shows the laws that break one, made smaller; law k of a seed is the
//! same wherever the series begins. `tokens` may be refused, and must never panic; a run that panics prints the law.
//! No toolchain but the stable one is needed.
#![forbid(unsafe_code)]

mod damage;
mod laws;
mod originals;
mod tokens;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, otherwise: u64| arguments.get(i).and_then(|a| a.parse().ok()).unwrap_or(otherwise);
    match arguments.first().map(String::as_str) {
        Some("laws") => laws::run(number(1, 2026), number(2, 100_000), number(3, 0)),
        Some("tokens") => tokens::run(number(1, 100_000), number(2, 2026)),
        _ => {
            laws::run(2026, 100_000, 0);
            tokens::run(20_000, 2026);
        }
    }
}
