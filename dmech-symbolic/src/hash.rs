//! Hash maps of small keys made of indices.
//!
//! The engine runs inside macros that cargo compiles without optimisation, and looks up indices by the hundred thousand: the
//! hash of the standard library, made to withstand chosen keys, took a third of an expansion.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A map whose keys nobody chooses to collide. Its order of iteration is not for use: what is generated depends on none.
pub(crate) type Map<K, V> = HashMap<K, V, BuildHasherDefault<Multiplied>>;

/// Word by word: turned, joined, multiplied.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Multiplied(u64);

impl Hasher for Multiplied {
    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn write_u8(&mut self, byte: u8) {
        self.write_u64(u64::from(byte));
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u8(byte));
    }

    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 32
    }
}
