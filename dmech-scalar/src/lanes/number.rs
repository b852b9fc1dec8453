//! What the functions need of eight numbers.

use wide::{f64x8, u64x8};

use super::Lanes;
use crate::functions::{Bits, Number};

impl Bits for u64x8 {
    #[inline(always)]
    fn splat(bits: u64) -> Self {
        u64x8::splat(bits)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self - other
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        self ^ other
    }
    #[inline(always)]
    fn shl(self, by: u32) -> Self {
        self << by
    }
    #[inline(always)]
    fn shr(self, by: u32) -> Self {
        self >> by
    }
}

impl Number for Lanes {
    type Bits = u64x8;
    const SINGLE: bool = false;

    #[inline(always)]
    fn bits(self) -> u64x8 {
        self.0.to_bits()
    }
    #[inline(always)]
    fn from_bits(bits: u64x8) -> Self {
        Self(f64x8::from_bits(bits))
    }
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let x = self.to_array();
        Self::from_fn(|i| f(x[i]))
    }
    #[inline(always)]
    fn look_up(table: &[[f64; 3]; 128], row: u64x8) -> [Self; 3] {
        let rows = row.to_array().map(|row| &table[row as usize % 128]);
        core::array::from_fn(|column| Self::from_fn(|i| rows[i][column]))
    }
}
