//! Sums and products of twice the precision that a compiler can carry out: what coefficients are made of.

/// hi + lo.
#[derive(Clone, Copy)]
pub(super) struct Digits {
    pub(super) hi: f64,
    pub(super) lo: f64,
}

/// a + b and what its rounding leaves out (Knuth).
const fn two_sum(a: f64, b: f64) -> Digits {
    let hi = a + b;
    let part = hi - a;
    Digits { hi, lo: (a - (hi - part)) + (b - part) }
}

/// x as the sum of two numbers of 26 bits (Veltkamp).
const fn halves(x: f64) -> [f64; 2] {
    let shifted = 134_217_729.0 * x;
    let high = shifted - (shifted - x);
    [high, x - high]
}

/// a·b and what its rounding leaves out (Dekker).
const fn two_product(a: f64, b: f64) -> Digits {
    let hi = a * b;
    let ([a, a_low], [b, b_low]) = (halves(a), halves(b));
    Digits { hi, lo: a_low * b_low - (((hi - a * b) - a_low * b) - a * b_low) }
}

impl Digits {
    pub(super) const ZERO: Digits = Digits::of(0.0);
    pub(super) const ONE: Digits = Digits::of(1.0);

    /// A number of one part.
    pub(super) const fn of(hi: f64) -> Digits {
        Digits { hi, lo: 0.0 }
    }

    pub(super) const fn plus(self, other: Digits) -> Digits {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = two_sum(high.hi, high.lo + low.hi);
        two_sum(sum.hi, sum.lo + low.lo)
    }

    pub(super) const fn minus(self, other: Digits) -> Digits {
        self.plus(Digits { hi: -other.hi, lo: -other.lo })
    }

    pub(super) const fn times(self, other: Digits) -> Digits {
        let product = two_product(self.hi, other.hi);
        two_sum(product.hi, product.lo + (self.hi * other.lo + self.lo * other.hi))
    }

    /// The product with a power of two.
    pub(super) const fn scaled(self, power: f64) -> Digits {
        Digits { hi: power * self.hi, lo: power * self.lo }
    }

    pub(super) const fn over(self, other: Digits) -> Digits {
        let first = Digits::of(self.hi / other.hi);
        let rest = self.minus(first.times(other));
        let second = Digits::of(rest.hi / other.hi);
        let rest = rest.minus(second.times(other));
        first.plus(second).plus(Digits::of(rest.hi / other.hi))
    }

    /// The same number with the multiple of 1/`parts` next to it as the first part, for numbers below 2: sums and differences of
    /// first parts are then exact.
    pub(super) const fn on_grid(self, parts: f64) -> Digits {
        let scaled = parts * self.hi;
        let mut whole = scaled as i64;
        let rest = scaled - whole as f64;
        // The second part decides where the first is half-way.
        if rest > 0.5 || (rest == 0.5 && self.lo >= 0.0) {
            whole += 1;
        } else if rest < -0.5 || (rest == -0.5 && self.lo < 0.0) {
            whole -= 1;
        }
        let hi = whole as f64 / parts;
        Digits { hi, lo: (self.hi - hi) + self.lo }
    }
}
