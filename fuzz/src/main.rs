//! Arbitrary token streams and damaged laws for the library behind the macros: it may refuse, it must never panic.
//!
//! `cargo run --release -p dmech-fuzz -- [RUNS] [SEED]` prints how many laws were accepted and refused, and the slowest
//! of them. A run that panics prints the law. No toolchain but the stable one is needed.
#![forbid(unsafe_code)]

mod damage;
mod laws;

use std::time::{Duration, Instant};

use proc_macro2::TokenStream;

use damage::{Random, damaged, soup, words_of};

/// Prints the law on the way out of a panic.
struct Witness<'a>(&'a str);

impl Drop for Witness<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("while reading:\n{}", self.0);
        }
    }
}

fn main() {
    let number = |i: usize, otherwise: u64| std::env::args().nth(i).and_then(|a| a.parse().ok()).unwrap_or(otherwise);
    let (runs, seed) = (number(1, 100_000), number(2, 2026));
    let mut random = Random::new(seed);
    let whole: Vec<(bool, Vec<String>)> = laws::LAWS
        .iter()
        .map(|law| (law.starts_with('#'), words_of(law.parse().expect("the laws themselves are Rust"))))
        .collect();
    let (mut accepted, mut refused, mut unreadable) = (0_u64, 0_u64, 0_u64);
    let (mut slowest, mut slow_law) = (Duration::ZERO, String::new());
    for _ in 0..runs {
        let (is_derive, words) = &whole[random.below(whole.len())];
        let text = if random.below(20) == 0 { soup(&mut random) } else { damaged(words, &mut random) };
        let Ok(tokens) = text.parse::<TokenStream>() else {
            unreadable += 1;
            continue;
        };
        let clock = Instant::now();
        let witness = Witness(&text);
        let expanded =
            if *is_derive { dmech_codegen::derive(tokens) } else { dmech_codegen::law(TokenStream::new(), tokens) };
        let is_refused = expanded.to_string().contains("compile_error");
        drop(witness);
        if is_refused {
            refused += 1
        } else {
            accepted += 1
        }
        if clock.elapsed() > slowest {
            (slowest, slow_law) = (clock.elapsed(), text);
        }
    }
    println!(
        "{runs} runs, seed {seed}: {accepted} accepted, {refused} refused, {unreadable} not even tokens, no panic"
    );
    println!("slowest {:.1} ms: {slow_law}", slowest.as_secs_f64() * 1e3);
    assert!(accepted > runs / 100 && refused > runs / 10, "there was little to read");
}
