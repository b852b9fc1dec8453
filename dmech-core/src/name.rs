//! Names of schemes, put together when the program is compiled or read from a checkpoint.

use core::fmt;

#[cfg(feature = "serde")]
use crate::words::{Word, word};

/// The name of a scheme: room for its letters, and how much of it is used.
#[derive(Clone, Copy, PartialEq)]
pub struct Name {
    bytes: [u8; Name::ROOM],
    length: u8,
}

impl Name {
    /// Enough for a composition that is adaptive; an error that holds one is still small.
    pub(crate) const ROOM: usize = 79;

    /// The parts one after the other, as far as there is room.
    pub const fn of(parts: &[&str]) -> Self {
        let mut name = Name { bytes: [0; Name::ROOM], length: 0 };
        let mut p = 0;
        while p < parts.len() {
            let part = parts[p].as_bytes();
            let mut i = 0;
            while i < part.len() && (name.length as usize) < Name::ROOM {
                name.bytes[name.length as usize] = part[i];
                name.length += 1;
                i += 1;
            }
            p += 1;
        }
        name
    }

    /// The name.
    pub const fn text(&self) -> &str {
        let bytes = self.bytes.split_at(self.length as usize).0;
        // Where the room has ended within a letter, what is before it.
        let whole = match core::str::from_utf8(bytes) {
            Ok(text) => return text,
            Err(cut) => bytes.split_at(cut.valid_up_to()).0,
        };
        match core::str::from_utf8(whole) {
            Ok(text) => text,
            Err(_) => "",
        }
    }
}

/// The options of a scheme in which two differ, as they show them: `tolerance: 1e-8`.
#[cfg(feature = "serde")]
pub(crate) fn options_apart(one: &str, other: &str) -> (Name, Word) {
    let differs = one.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
    let [one, other] = [one, other].map(|text| {
        let ends = |c: char| "{}(),".contains(c);
        let at = (0..=differs.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0);
        let begins = text[..at].rfind(ends).map_or(0, |before| before + 1);
        let length = text[at..].find(ends).unwrap_or(text.len() - at);
        text[begins..at + length].trim()
    });
    (Name::of(&[one]), word(other))
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text())
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.text(), f)
    }
}

#[cfg(test)]
mod tests {
    use super::Name;

    /// What does not fit is left out by whole letters.
    #[test]
    fn names_end_with_a_whole_letter() {
        for letter in ["a", "θ", "→", "𝛼"] {
            let long = Name::of(&["n", &letter.repeat(Name::ROOM)]);
            let fits = (Name::ROOM - 1) / letter.len();
            assert_eq!(long.text(), format!("n{}", letter.repeat(fits)));
        }
        assert_eq!(Name::of(&["one", "θ"]).text(), "oneθ");
    }
}
