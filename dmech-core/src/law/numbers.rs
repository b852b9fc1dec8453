//! What is read of laws and of bodies, as numbers of any scalar.

use core::array::from_fn;

use dmech_scalar::Real;

/// A few numbers of a law or of a body: `[f64; K]`, and `[R; K]` in the scalar in use, where they may be those of several side by side.
pub trait Numbers: Copy + core::fmt::Debug + Send + Sync + 'static {
    /// K.
    const COUNT: usize;
    /// `[R; K]`.
    type Of<R: Real>: Copy + Send + Sync;

    /// The k-th of them.
    fn at(&self, k: usize) -> f64;
    /// All of them.
    fn list(&self) -> Vec<f64> {
        (0..Self::COUNT).map(|k| self.at(k)).collect()
    }
    /// These, by index.
    fn from_list(number: impl FnMut(usize) -> f64) -> Self;
    /// [f(0), …, f(K − 1)].
    fn gather<R: Real>(f: impl FnMut(usize) -> R) -> Self::Of<R>;
}

impl<const K: usize> Numbers for [f64; K] {
    const COUNT: usize = K;
    type Of<R: Real> = [R; K];

    #[inline(always)]
    fn at(&self, k: usize) -> f64 {
        self[k]
    }

    fn from_list(mut number: impl FnMut(usize) -> f64) -> Self {
        let mut all = [0.0; K];
        for k in 0..K {
            all[k] = number(k);
        }
        all
    }

    #[inline(always)]
    fn gather<R: Real>(mut f: impl FnMut(usize) -> R) -> [R; K] {
        let mut all = [R::ZERO; K];
        for k in 0..K {
            all[k] = f(k);
        }
        all
    }
}

/// Those of the one, and then those of the other.
impl<A: Numbers, B: Numbers> Numbers for (A, B) {
    const COUNT: usize = A::COUNT + B::COUNT;
    type Of<R: Real> = (A::Of<R>, B::Of<R>);

    #[inline(always)]
    fn at(&self, k: usize) -> f64 {
        if k < A::COUNT { self.0.at(k) } else { self.1.at(k - A::COUNT) }
    }

    fn from_list(mut number: impl FnMut(usize) -> f64) -> Self {
        (A::from_list(&mut number), B::from_list(|k| number(A::COUNT + k)))
    }

    #[inline(always)]
    fn gather<R: Real>(mut f: impl FnMut(usize) -> R) -> Self::Of<R> {
        (A::gather(&mut f), B::gather(|k| f(A::COUNT + k)))
    }
}

/// Those of one after another.
impl<N: Numbers, const K: usize> Numbers for [N; K] {
    const COUNT: usize = K * N::COUNT;
    type Of<R: Real> = [N::Of<R>; K];

    #[inline(always)]
    fn at(&self, k: usize) -> f64 {
        self[k / N::COUNT].at(k % N::COUNT)
    }

    fn from_list(mut number: impl FnMut(usize) -> f64) -> Self {
        from_fn(|i| N::from_list(|k| number(i * N::COUNT + k)))
    }

    #[inline(always)]
    fn gather<R: Real>(mut f: impl FnMut(usize) -> R) -> Self::Of<R> {
        from_fn(|i| N::gather(|k| f(i * N::COUNT + k)))
    }
}

#[cfg(test)]
mod tests {
    use super::Numbers;

    type Nested = ([f64; 1], [([f64; 2], [f64; 0]); 3]);

    #[test]
    fn nested_numbers_come_in_one_order() {
        let numbers: Nested = ([0.0], [([1.0, 2.0], []), ([3.0, 4.0], []), ([5.0, 6.0], [])]);
        assert_eq!(numbers.list(), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(Nested::from_list(|k| numbers.at(k)), numbers);
        assert_eq!(Nested::gather::<f64>(|k| numbers.at(k)), numbers);
    }
}
