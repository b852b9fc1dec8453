//! Where Newton starts, and how long it may take.

use dmech_scalar::Real;

/// Where the iteration of an implicit step starts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Guess {
    /// From the forces of the last three steps, continued by a parabola: off by O(h⁵).
    #[default]
    Predicted,
    /// From the previous position, q′ = q, as in the papers: off by O(h).
    Previous,
}

/// Options of the implicit schemes: `Implicit.with(Newton::from_previous())`.
///
/// They change the work, and the result by round-off only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Newton {
    guess: Guess,
    max_iterations: u32,
}

impl Newton {
    pub(crate) const DEFAULT: Newton = Newton { guess: Guess::Predicted, max_iterations: 500 };

    /// Starts from the force of the last steps (the default).
    pub const fn predicted() -> Self {
        Newton::DEFAULT
    }

    /// Starts from the previous position, as in the papers.
    pub const fn from_previous() -> Self {
        Newton { guess: Guess::Previous, ..Newton::DEFAULT }
    }

    /// Allows n evaluations of the force in a step (default 500).
    ///
    /// A resolved step takes 1 to 4; the rest is for steps that have to be approached gradually. The count is looked at
    /// between attempts, so a failed step may have made up to a dozen more, and where most digits of a force cancel some hundred.
    pub const fn max_iterations(self, n: u32) -> Self {
        Newton { max_iterations: n, ..self }
    }

    /// The allowed number of evaluations.
    pub(crate) const fn limit(&self) -> u32 {
        self.max_iterations
    }

    /// Where the iteration starts.
    #[cfg(feature = "scene")]
    pub(crate) const fn start(&self) -> Guess {
        self.guess
    }

    /// The first Δ: h v − frozen − g G, where G is the force that is expected, as [`Ahead`](crate::system::Ahead) gives it.
    ///
    /// v is the last to be known of a step, so everything else is put together before it.
    #[inline(always)]
    pub(crate) fn guess<const D: usize, R: Real>(
        &self,
        (dt, v): (R, [R; D]),
        frozen: [R; D],
        g: R,
        expected: [R; D],
    ) -> [R; D] {
        match self.guess {
            Guess::Predicted => core::array::from_fn(|i| {
                let fall = g.mul_add(expected[i], frozen[i]);
                dt.mul_add(v[i], -fall)
            }),
            Guess::Previous => [R::ZERO; D],
        }
    }
}

impl Default for Newton {
    fn default() -> Self {
        Newton::DEFAULT
    }
}
