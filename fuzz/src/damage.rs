//! Damaging laws, and streams of tokens that never were one.

use proc_macro2::{Spacing, TokenStream, TokenTree};

use crate::originals::WORDS;

/// A linear congruential generator (Knuth's MMIX): the same runs from the same seed.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

/// The tokens one after the other, brackets as tokens of their own.
pub(crate) fn words_of(tokens: TokenStream) -> Vec<String> {
    let mut words = vec![];
    flatten(tokens, &mut words);
    words
}

/// Marks a sign that belongs to the next one, as the first of `+=`.
const JOINT: char = '\u{1}';

fn flatten(tokens: TokenStream, words: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let text = group.to_string();
                words.push(text[..1].to_owned());
                flatten(group.stream(), words);
                words.push(text[text.len() - 1..].to_owned());
            }
            TokenTree::Punct(p) if p.spacing() == Spacing::Joint => words.push(format!("{}{JOINT}", p.as_char())),
            token => words.push(token.to_string()),
        }
    }
}

/// A law with a few tokens removed, doubled, swapped or replaced. Brackets stay: ones that do not match never reach a
/// macro.
pub(crate) fn damaged(words: &[String], random: &mut Random) -> String {
    let mut words = words.to_vec();
    for _ in 0..1 + random.below(4) {
        let (i, j) = (random.below(words.len()), random.below(words.len()));
        if [i, j].iter().any(|&k| "()[]{}".contains(words[k].as_str())) {
            continue;
        }
        match random.below(6) {
            0 => drop(words.remove(i)),
            1 => words.insert(i, words[j].clone()),
            2 => words.swap(i, j),
            3 => words[i] = words[j].clone(),
            _ => words[i] = WORDS[random.below(WORDS.len())].to_owned(),
        }
    }
    join(&words)
}

/// Any words in any order.
pub(crate) fn soup(random: &mut Random) -> String {
    let words: Vec<_> = (0..random.below(40)).map(|_| WORDS[random.below(WORDS.len())].to_owned()).collect();
    join(&words)
}

fn join(words: &[String]) -> String {
    words.join(" ").replace(&format!("{JOINT} "), "").replace(JOINT, "")
}
