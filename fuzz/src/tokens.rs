//! Arbitrary token streams and damaged laws for the library behind the macros, one after the other.

use std::collections::HashSet;
use std::time::{Duration, Instant};

use proc_macro2::TokenStream;

use crate::damage::{Random, damaged, soup, words_of};
use crate::originals::LAWS;

/// What became of them.
#[derive(Default)]
struct Tally {
    accepted: u64,
    refused: u64,
    /// Not even tokens.
    unreadable: u64,
    /// What the refused were told, without the names in it.
    messages: HashSet<String>,
    slowest: Duration,
    slow_law: String,
}

/// Prints the law on the way out of a panic.
struct Witness<'a>(&'a str);

impl Drop for Witness<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("while reading:\n{}", self.0);
        }
    }
}

/// What the macro writes for an impl block, or for a struct with `#[derive]`.
fn expansion(is_derive: bool, tokens: TokenStream) -> String {
    if is_derive { dmech_codegen::derive(tokens) } else { dmech_codegen::law(TokenStream::new(), tokens) }.to_string()
}

/// The texts of the errors in an expansion, each from its last quoted name on.
fn messages(expansion: &str) -> impl Iterator<Item = &str> {
    expansion.split("compile_error ! {").skip(1).map(|rest| {
        let message = rest.split('}').next().unwrap_or(rest);
        message.rsplit('`').next().unwrap_or(message)
    })
}

/// # Panics
/// Where the macro does, and where it refuses a law without a word.
fn campaign(runs: u64, seed: u64) -> Tally {
    let mut random = Random::new(seed);
    let whole: Vec<(bool, Vec<String>)> = LAWS
        .iter()
        .map(|law| (law.starts_with('#'), words_of(law.parse().expect("the laws themselves are Rust"))))
        .collect();
    let mut tally = Tally::default();
    for _ in 0..runs {
        let (is_derive, words) = &whole[random.below(whole.len())];
        let text = if random.below(20) == 0 { soup(&mut random) } else { damaged(words, &mut random) };
        let Ok(tokens) = text.parse::<TokenStream>() else {
            tally.unreadable += 1;
            continue;
        };
        let clock = Instant::now();
        let witness = Witness(&text);
        let expansion = expansion(*is_derive, tokens);
        tally.messages.extend(messages(&expansion).map(str::to_owned));
        if expansion.contains("compile_error") {
            tally.refused += 1;
        } else {
            // What stands in for a law with errors cannot be run.
            assert!(expansion.contains("Derivation") && !expansion.contains("unreachable"), "refused without a word");
            tally.accepted += 1;
        }
        drop(witness);
        if clock.elapsed() > tally.slowest {
            (tally.slowest, tally.slow_law) = (clock.elapsed(), text);
        }
    }
    tally
}

/// Prints how many laws were accepted and refused, and the slowest of them.
pub(crate) fn run(runs: u64, seed: u64) {
    let Tally { accepted, refused, unreadable, messages, slowest, slow_law } = campaign(runs, seed);
    println!(
        "{runs} runs, seed {seed}: {accepted} accepted, {refused} refused with {} messages, {unreadable} not even tokens, no panic",
        messages.len()
    );
    println!("slowest {:.1} ms: {slow_law}", slowest.as_secs_f64() * 1e3);
    assert!(accepted > runs / 100 && refused > runs / 10, "there was little to read");
}

/// A short campaign for `cargo test`; some damage leaves a law a law, and the rest is not all refused for one reason.
#[test]
fn damaged_laws_never_panic() {
    for law in LAWS {
        let expansion = expansion(law.starts_with('#'), law.parse().unwrap());
        assert_eq!(messages(&expansion).next(), None, "{law}");
    }
    let Tally { accepted, refused, messages, .. } = campaign(3_000, 2026);
    println!("{accepted} accepted, {refused} refused with {} messages", messages.len());
    assert!(accepted > 180 && refused > 1800 && messages.len() > 60, "{accepted} {refused} {}", messages.len());
}
