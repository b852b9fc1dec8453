//! No text makes the macro panic: thousands of laws with tokens removed, doubled, swapped and replaced.

use std::collections::HashSet;

use proc_macro2::{TokenStream, TokenTree};

use crate::diagnostics::Mistakes;
use crate::lower;
use crate::model::{Parsed, from_derive, from_impl};

const LAWS: [&str; 4] = [
    "impl<const N: usize> Chain<N> {
        const D: usize = 3; const K: [f64; 2] = [1.0, 2.0];
        #[potential] fn energy(&self, q: [f64; Self::D], m: f64, t: f64) -> f64 {
            let [x, .., z] = q; let mut sum = 0.0; let (s, c) = x.sin_cos();
            for i in 0..Self::D { sum += self.k[i] * q[i].powi(2) - (i as f64) / 3.0; }
            if x < 0.5 && !(z >= t) { sum *= s; } else { sum = sum - c; }
            let parts = (0..2).map(|i| Self::K[i] * q[i + 1] * m).sum::<f64>();
            sum + parts + self.well(x, &q) + q.iter().fold(0.0, f64::max) + x.powf(1.5).clamp(-1.0, 1.0)
        }
        fn well(&self, x: f64, q: &[f64; 3]) -> f64 { return (x - self.a.b).hypot(q[1]) + std::f64::consts::PI; }
    }",
    "impl Law { #[potential] fn energy(&self, q: Vector3<f64>) -> f64 {
            let d = q - self.c; let mut e = -d / 2.0; e.x += q.dot(&d); e[1] *= 3.0;
            let n = Vector3::new(1.0, e.y, self.k).cross(&d).norm(); let Self { g, .. } = *self;
            if n > 1.0 { n } else if n > g { d.norm_squared() } else { q.map(|x| x * x).sum() }
        } }",
    "impl Kepler { #[potential] fn energy(&self, q: f64) -> f64 { -self.gm / (q * q + 1e-3).sqrt() }
        fn drag(&self, v: f64) -> f64 { -v } #[cfg(test)] const MASS: f64 = 1.0; }",
    "#[derive(Clone)] #[dmech(crate = my::dmech)] #[potential(|q: [f64; 2], t: f64| 0.5 * self.k * q[0].cos() + self.w[1] * t)]
        struct Spring { k: f64, w: [f64; 2] }",
];

const WORDS: [&str; 48] = [
    "q", "self", "Self", "x", "0", "1", "2.0", "1e308", "-", "+", "*", "/", "%", ".", "..", "=", "+=", "==", "<", "&",
    "&&", "!", "?", ";", ",", "if", "else", "for", "in", "let", "mut", "return", "fn", "sum", "powi", "norm", "as",
    "f64", "i32", "K", "_", "|", "[0]", "(q)", "{ q }", "{ }", "()", "[]",
];

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

/// The tokens in one line, brackets included, so that they can be damaged.
fn flatten(tokens: TokenStream, words: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let text = group.to_string();
                let (open, close) = (&text[..1], &text[text.len() - 1..]);
                words.push(open.to_owned());
                flatten(group.stream(), words);
                words.push(close.to_owned());
            }
            TokenTree::Punct(p) if p.spacing() == proc_macro2::Spacing::Joint => {
                words.push(format!("{}\u{1}", p.as_char()))
            }
            token => words.push(token.to_string()),
        }
    }
}

fn mutate(words: &[String], random: &mut Random) -> String {
    let mut words = words.to_vec();
    for _ in 0..1 + random.below(3) {
        let (i, j) = (random.below(words.len()), random.below(words.len()));
        // Brackets that do not match never reach a macro.
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
    words.join(" ").replace("\u{1} ", "").replace('\u{1}', "")
}

fn lower_parsed(parsed: Parsed) -> Result<(), Mistakes> {
    let lowered = lower::lower(&parsed.model?)?;
    assert!(lowered.graph.len() > lowered.potential.index());
    Ok(())
}

#[test]
fn damaged_laws_never_panic() {
    let mut random = Random(2026);
    let (mut accepted, mut refused, mut messages) = (0, 0, HashSet::new());
    for law in LAWS {
        let mut words = vec![];
        flatten(law.parse().unwrap(), &mut words);
        for _ in 0..2500 {
            let text = mutate(&words, &mut random);
            let Ok(tokens) = text.parse::<TokenStream>() else { continue };
            let parsed = if law.starts_with('#') { from_derive(tokens) } else { from_impl(TokenStream::new(), tokens) };
            match lower_parsed(parsed) {
                Ok(()) => accepted += 1,
                Err(Mistakes { errors, .. }) => {
                    assert!(!errors.is_empty(), "refused without a word: {text}");
                    messages.extend(
                        errors.iter().map(|error| error.to_string().split('`').next_back().unwrap_or("").to_owned()),
                    );
                    refused += 1;
                }
            }
        }
    }
    // Some damage leaves a law a law, and the rest is not all refused for one reason.
    assert!(accepted > 300 && refused > 3000 && messages.len() > 60, "{accepted} {refused} {}", messages.len());
}
