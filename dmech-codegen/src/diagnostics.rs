//! Every sentence that a user can be told, in three catalogues: about the [`law`] as a whole, about the [`body`] of its potential, about
//! laws between two bodies ([`pair`]). Each points at the smallest piece of the user's own text and says what to write instead.

/// As the function, with a text to be filled in; above the modules, as they would not see it otherwise.
macro_rules! at {
    ($tokens:expr, $($text:tt)+) => { $crate::diagnostics::at($tokens, format_args!($($text)+)) };
}

pub(crate) mod body;
pub(crate) mod law;
pub(crate) mod pair;

mod nearest;

use std::collections::BTreeSet;

use quote::ToTokens;
use syn::Error;

pub(crate) use nearest::nearest;

/// Everything that is wrong with a law.
#[derive(Debug, Default)]
pub(crate) struct Mistakes {
    /// What its author is told, each with the piece of the text that it is about.
    pub(crate) errors: Vec<Error>,
    /// The methods that the mistakes are in.
    pub(crate) methods: BTreeSet<String>,
}

impl Mistakes {
    pub(crate) fn extend(&mut self, other: Self) {
        self.errors.extend(other.errors);
        self.methods.extend(other.methods);
    }
}

/// The text of a piece of code, on one line and not too long.
fn text(tokens: &impl ToTokens) -> String {
    const LONGEST: usize = 40;
    let text = tidy(&tokens.to_token_stream().to_string());
    if text.chars().count() <= LONGEST { text } else { text.chars().take(LONGEST - 1).chain(['…']).collect() }
}

/// Token streams print with a space between any two tokens; people write fewer.
fn tidy(spaced: &str) -> String {
    let mut text = spaced.split_whitespace().collect::<Vec<_>>().join(" ");
    for (wide, narrow) in [
        (" . ", "."),
        (" ;", ";"),
        (" ,", ","),
        (" :: ", "::"),
        (":: ", "::"),
        (" : ", ": "),
        (" (", "("),
        ("( ", "("),
        (" )", ")"),
        ("[ ", "["),
        (" ]", "]"),
        (" < ", "<"),
        (" >", ">"),
        ("# [", "#["),
        (" !", "!"),
        ("& ", "&"),
    ] {
        text = text.replace(wide, narrow);
    }
    // An index stands close to its array.
    for before in (b'a'..=b'z').chain(b'A'..=b'Z').chain(b'0'..=b'9').chain(*b"_])").map(char::from) {
        text = text.replace(&format!("{before} ["), &format!("{before}["));
    }
    text
}

/// `1 component`, `3 components`
pub(crate) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn at(tokens: &impl ToTokens, message: impl std::fmt::Display) -> Error {
    Error::new_spanned(tokens, message)
}
