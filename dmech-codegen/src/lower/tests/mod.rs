//! Lowering is held against the compiler: the same text is compiled as Rust and lowered, and both give one value.
//! Refusals are held to their words and to the piece of the user's text that they point at.

mod consequences;
mod constructs;
mod edges;
mod functions;
mod limits;
mod pairs;
mod parameters;
mod refusals;
mod vectors;

use dmech_symbolic::expression::evaluate;
use proc_macro2::TokenStream;
use quote::ToTokens;

use super::{Lowered, Read, Source};
use crate::model::{Parsed, from_derive, from_impl};

/// Everything from the text of an impl block to the expression.
pub(super) fn lower_text(text: &str) -> Result<Lowered, Vec<syn::Error>> {
    let item: TokenStream = text.parse().expect("tokens");
    lower_parsed(from_impl(TokenStream::new(), item))
}

/// Likewise for a struct with the derive.
pub(super) fn lower_derive(text: &str) -> Result<Lowered, Vec<syn::Error>> {
    lower_parsed(from_derive(text.parse().expect("tokens")))
}

fn lower_parsed(parsed: Parsed) -> Result<Lowered, Vec<syn::Error>> {
    let model = parsed.model.map_err(|refused| crate::with_bodies(refused).mistakes);
    let lowered = model.and_then(|model| super::lower(&model));
    lowered.map_err(|mistakes| mistakes.errors)
}

/// A law of D coordinates with this body: `impl Law { #[potential] fn energy(&self, q: [f64; D]) -> f64 { … } }`.
pub(super) fn body(position: &str, body: &str) -> String {
    format!("impl Law {{ #[potential] fn energy(&self, q: {position}) -> f64 {{ {body} }} }}")
}

/// One error: where it points, from byte to byte, and what it says.
pub(super) type Said = (std::ops::Range<usize>, String);

/// What a refused law is told, in the order of the text.
pub(super) fn said(result: Result<Lowered, Vec<syn::Error>>) -> Vec<Said> {
    let errors = match result {
        Ok(lowered) => panic!("accepted: {}", lowered.graph.display(lowered.potential)),
        Err(errors) => errors,
    };
    let mut said: Vec<Said> = errors.iter().map(|error| (error.span().byte_range(), error.to_string())).collect();
    said.sort_by_key(|(range, _)| (range.start, range.end));
    said
}

/// Takes the marks « » out of a text; the ranges between them, in the order of the text.
pub(super) fn marked(text: &str) -> (String, Vec<std::ops::Range<usize>>) {
    let (mut plain, mut open, mut ranges) = (String::new(), vec![], vec![]);
    for c in text.chars() {
        match c {
            '«' => open.push(plain.len()),
            '»' => ranges.push(open.pop().expect("an opening mark")..plain.len()),
            c => plain.push(c),
        }
    }
    ranges.sort_by_key(|range| (range.start, range.end));
    (plain, ranges)
}

/// The errors point exactly at the marked pieces and begin with these words.
pub(super) fn assert_refused(text: &str, messages: &[&str], read: impl Fn(&str) -> Result<Lowered, Vec<syn::Error>>) {
    let (plain, ranges) = marked(text);
    let said = said(read(&plain));
    let pieces: Vec<_> = said.iter().map(|(range, message)| (&plain[range.clone()], message)).collect();
    assert_eq!(said.len(), messages.len(), "{text}: {pieces:#?}");
    assert_eq!(ranges.len(), messages.len(), "{text}: as many marks as messages");
    for ((range, message), (marked, expected)) in said.iter().zip(ranges.iter().zip(messages)) {
        assert_eq!(range, marked, "{text}: points at `{}`: {message}", &plain[range.clone()]);
        assert_eq!(message, expected, "{text}");
    }
}

/// The value of a lowered law; `source` knows what the tokens of a parameter stand for.
pub(super) fn value(lowered: &Lowered, q: &[f64], m: f64, t: f64, source: &dyn Fn(&str) -> Option<f64>) -> f64 {
    evaluate(&lowered.graph, lowered.potential, |symbol| {
        if let Some(i) = lowered.variables.q.iter().position(|&s| s == symbol) {
            return q[i];
        }
        let parameter = lowered.parameters.iter().find(|p| p.symbol == symbol).expect("only q and parameters");
        match &parameter.source {
            Source::Mass => m,
            Source::Time => t,
            Source::Body(..) => panic!("laws of one body only"),
            Source::Law(tokens) => {
                let text = tokens.to_token_stream().to_string().replace(' ', "");
                source(&text).unwrap_or_else(|| panic!("no value for `{text}`"))
            }
        }
    })
}

/// Points in the reach of every function: some inside the unit interval, some negative where asked.
pub(super) fn points(dimension: usize, signed: bool) -> Vec<Vec<f64>> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
        let sign = if signed && state & (1 << 10) == 0 { -1.0 } else { 1.0 };
        sign * (0.05 + 0.9 * unit)
    };
    (0..24).map(|_| (0..dimension).map(|_| next()).collect()).collect()
}

/// Both values are the same up to a few roundings, and they are not all one number.
pub(super) fn assert_same(name: &str, pairs: &[(f64, f64)]) {
    for &(lowered, rust) in pairs {
        assert!(rust.is_finite(), "{name}: {rust} tells nothing");
        assert!((lowered - rust).abs() <= 64.0 * f64::EPSILON * (1.0 + rust.abs()), "{name}: {lowered} and {rust}");
    }
    assert!(pairs.iter().any(|p| p.1 != pairs[0].1), "{name}: the value never changes");
}

/// What a parameter stands for, by the rest of its path: `[1]`, `.0`, nothing.
pub(super) trait Lookup {
    fn at(&self, path: &str) -> Option<f64>;
}

impl Lookup for f64 {
    fn at(&self, path: &str) -> Option<f64> {
        path.is_empty().then_some(*self)
    }
}

impl Lookup for i32 {
    fn at(&self, path: &str) -> Option<f64> {
        (path == "asf64").then_some(f64::from(*self))
    }
}

impl<T: Lookup, const N: usize> Lookup for [T; N] {
    fn at(&self, path: &str) -> Option<f64> {
        let (index, rest) = path.strip_prefix('[')?.split_once(']')?;
        self.get(index.parse::<usize>().ok()?)?.at(rest)
    }
}

impl<T: Lookup, U: Lookup> Lookup for (T, U) {
    fn at(&self, path: &str) -> Option<f64> {
        match path.strip_prefix('.')?.split_at(1) {
            ("0", rest) => self.0.at(rest),
            ("1", rest) => self.1.at(rest),
            _ => None,
        }
    }
}

/// Laws that are compiled as they stand and lowered from the same tokens.
macro_rules! laws {
    ($(
        $(#[$doc:meta])*
        $name:ident [$($field:ident : $ty:ty = $value:expr),*] ($q:ty $(, $m:ident : f64)* $(; $signed:ident)?) { $($item:tt)* }
    )*) => { $(
        $(#[$doc])*
        #[test]
        #[allow(unused, clippy::all)]
        fn $name() {
            use crate::lower::tests::{Lookup, Position};
            #[derive(Clone, Copy)]
            struct Law { $($field: $ty),* }
            impl Law { $($item)* }
            let law = Law { $($field: $value),* };
            let source = |path: &str| -> Option<f64> {
                let path = path.trim_start_matches('(').trim_end_matches(')');
                $(
                    let rest = path.strip_prefix(concat!("self.", stringify!($field)));
                    if let Some(found) = rest.and_then(|rest| law.$field.at(rest)) {
                        return Some(found);
                    }
                )*
                None
            };
            let text = stringify!(impl Law { $($item)* }).replacen("fn energy", "#[potential] fn energy", 1);
            let lowered = crate::lower::tests::lower_text(&text).unwrap_or_else(|errors| panic!("{errors:?}"));
            let signed = [$(stringify!($signed))?].contains(&"signed");
            let dimension = <$q as Position>::DIMENSION;
            $( let $m = if stringify!($m) == "m" { 1.7 } else { 0.6 }; )*
            let (mass, time) = (1.7, 0.6);
            let pairs: Vec<_> = crate::lower::tests::points(dimension, signed)
                .into_iter()
                .map(|q| {
                    let rust = law.energy(<$q as Position>::of(&q) $(, $m)*);
                    (crate::lower::tests::value(&lowered, &q, mass, time, &source), rust)
                })
                .collect();
            crate::lower::tests::assert_same(stringify!($name), &pairs);
        }
    )* };
}
use laws;

/// How the points of a test are handed to a law.
pub(super) trait Position {
    const DIMENSION: usize;
    fn of(q: &[f64]) -> Self;
}

impl Position for f64 {
    const DIMENSION: usize = 1;
    fn of(q: &[f64]) -> Self {
        q[0]
    }
}

impl<const D: usize> Position for [f64; D] {
    const DIMENSION: usize = D;
    fn of(q: &[f64]) -> Self {
        std::array::from_fn(|i| q[i])
    }
}
