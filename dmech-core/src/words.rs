//! The words of messages and names, which are written in programs.

/// A word that is written in a program.
pub(crate) type Word = &'static str;

#[cfg(feature = "serde")]
pub(crate) use read::word;
#[cfg(feature = "serde")]
pub(crate) use serialized::{deserialize, serialize};

#[cfg(feature = "serde")]
mod read {
    use std::collections::BTreeSet;
    use std::sync::{Mutex, PoisonError};

    use super::Word;

    /// The words that were read: there are a few dozen, and they stay.
    static WORDS: Mutex<BTreeSet<Word>> = Mutex::new(BTreeSet::new());

    /// The word with this text.
    pub(crate) fn word(text: &str) -> Word {
        let mut words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(word) = words.get(text) {
            return word;
        }
        let word: Word = String::leak(text.to_owned());
        words.insert(word);
        word
    }
}

#[cfg(feature = "serde")]
mod serialized {
    use serde::{Deserialize, Deserializer, Serializer};

    use super::Word;

    /// A word as text.
    pub(crate) fn serialize<S: Serializer>(word: &Word, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(word)
    }

    /// The word with this text.
    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Word, D::Error> {
        String::deserialize(deserializer).map(|text| super::word(&text))
    }
}
