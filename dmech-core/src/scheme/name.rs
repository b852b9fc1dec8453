//! Names put together when the program is compiled.

/// Room for a name, and how much of it is used.
#[derive(Clone, Copy)]
pub(in crate::scheme) struct Name {
    bytes: [u8; 96],
    length: usize,
}

impl Name {
    /// The parts one after the other.
    pub(in crate::scheme) const fn of(parts: &[&str]) -> Self {
        let mut name = Name { bytes: [0; 96], length: 0 };
        let mut p = 0;
        while p < parts.len() {
            let part = parts[p].as_bytes();
            let mut i = 0;
            while i < part.len() {
                name.bytes[name.length] = part[i];
                name.length += 1;
                i += 1;
            }
            p += 1;
        }
        name
    }

    /// The name.
    pub(in crate::scheme) const fn text(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.length).0) {
            Ok(text) => text,
            Err(_) => "Composed",
        }
    }
}
