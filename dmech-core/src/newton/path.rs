//! The way of a root from a step of no length, where Δ = 0, to the whole step.
//!
//! θ, the part of the step, advances by as much as Newton accepts and leads to a root that continues the last: by twice as much after
//! a root, by a quarter after none.
//!
//! First the whole step is tried from Δ = 0: a stiff force is nothing to predict by, and there only the curvature of the rest is to be
//! corrected. On top of a hill that leads to where the motion has turned round, which a determinant alone does not tell: that the matrix
//! is positive definite, or that its pivots are positive, does.

/// The shortest progress in θ before the way counts as ended (a fold: beyond it no continuous root exists). Near a singularity the
/// first may have to be as short: forces push bodies out of one another 10⁶ times as far as they are apart.
const SHORTEST: f64 = 1.0 / 16_777_216.0;
/// Corrections in which the whole step is solved from where it starts: so fast only the root of a motion that goes on is near.
pub(crate) const SWIFT: u32 = 4;

/// How far a root has been followed, and how far it is tried next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Path {
    theta: f64,
    advance: f64,
    longest: f64,
}

/// A part of the way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    /// θ at its end.
    pub(crate) end: f64,
    /// How much of θ it is.
    pub(crate) ahead: f64,
}

impl Stretch {
    /// It is the whole step, from Δ = 0.
    pub(crate) fn is_all(self) -> bool {
        self.ahead == 1.0
    }

    /// The whole step is reached with it.
    pub(crate) fn is_last(self) -> bool {
        self.end >= 1.0
    }
}

impl Path {
    /// From a step of no length, by progress in θ of no more than `longest`.
    pub(crate) fn by(longest: f64) -> Self {
        Path { theta: 0.0, advance: longest, longest }
    }

    /// What is tried next; nothing where the way has ended.
    pub(crate) fn next(&self) -> Option<Stretch> {
        let end = f64::min(self.theta + self.advance, 1.0);
        (self.advance >= SHORTEST).then_some(Stretch { end, ahead: end - self.theta })
    }

    /// There is a root at the end of the stretch.
    pub(crate) fn reaches(&mut self, stretch: Stretch) {
        self.theta = stretch.end;
        self.advance = f64::min(2.0 * self.advance, self.longest);
    }

    /// None was found there.
    pub(crate) fn shortens(&mut self) {
        self.advance *= 0.25;
    }
}
