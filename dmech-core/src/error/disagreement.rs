//! What is stepped is not what was written.

use core::fmt;

use crate::words::Word;

/// A law that does not step what its author wrote: both values, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Disagreement {
    #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
    pub(crate) quantity: Word,
    pub(crate) written: f64,
    pub(crate) derived: f64,
    pub(crate) panics: bool,
    pub(crate) time: f64,
    /// The first coordinates, and how many there are.
    pub(crate) place: [f64; 3],
    pub(crate) dimension: u32,
    pub(crate) culprit: Culprit,
}

/// Which body or bodies of a scene it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Culprit {
    /// There is only one.
    Alone,
    /// This one.
    #[cfg(feature = "scene")]
    Body(usize),
    /// These two.
    #[cfg(feature = "scene")]
    Link(usize, usize),
}

impl Disagreement {
    /// `potential`, `force` or the name of an invariant of the law's own.
    pub fn quantity(&self) -> Word {
        self.quantity
    }

    /// Whether the author's method panics there, as `clamp` does between ends in the wrong order; a run does not.
    pub fn panics(&self) -> bool {
        self.panics
    }

    /// What the author's method gives; NaN where it [panics](Disagreement::panics).
    pub fn written(&self) -> f64 {
        self.written
    }

    /// What was derived from its text.
    pub fn derived(&self) -> f64 {
        self.derived
    }

    /// The time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The position, or the separation of two bodies: at most the first three coordinates.
    pub fn place(&self) -> &[f64] {
        &self.place[..self.place.len().min(self.dimension as usize)]
    }

    /// The same law, on these bodies of a scene.
    #[cfg(feature = "scene")]
    pub(crate) fn on(self, culprit: Culprit) -> Self {
        Disagreement { culprit, ..self }
    }
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Disagreement { quantity, written, derived, time, .. } = self;
        let place = if matches!(self.culprit, Culprit::Alone) || self.is_on_one() { "q" } else { "d" };
        write!(f, "the law is not stepped as it is written: ")?;
        match self.culprit {
            Culprit::Alone => {}
            #[cfg(feature = "scene")]
            Culprit::Body(body) => write!(f, "on body {body} ")?,
            #[cfg(feature = "scene")]
            Culprit::Link(a, b) => write!(f, "between bodies {a} and {b} ")?,
        }
        write!(f, "at {place} = ")?;
        let more = if self.place().len() < self.dimension as usize { ", …" } else { "" };
        match self.place() {
            [x] => write!(f, "{x:?}")?,
            [x, y] => write!(f, "({x:?}, {y:?})")?,
            [x, y, z, ..] => write!(f, "({x:?}, {y:?}, {z:?}{more})")?,
            [] => {}
        }
        write!(f, ", t = {time:?}")?;
        if self.panics {
            return write!(
                f,
                " a method panics, and what was derived from its text does not; let it return a number wherever the motion may come. \
                 `clamp` panics where its upper end lies below the lower, and an integer where it overflows"
            );
        }
        write!(f, " the method gives the {quantity} {written:?}, and what was derived from its text {derived:?}. ")?;
        if !(written.is_finite() && derived.is_finite()) {
            write!(
                f,
                "The two calculate in another order, and something on the way is larger than any number: take other units, in which \
                 masses and constants are nearer to 1"
            )?;
            // 0·∞ of numbers out of range, or what another function makes of them.
            if !(written.is_nan() || derived.is_nan()) {
                return Ok(());
            }
            write!(f, ". Or, where they are near to 1, a name")?;
        } else {
            write!(f, "A name")?;
        }
        write!(
            f,
            " in it stands \
             for something else than the macro, which sees text only, takes it for: a constant, module or type of your own \
             that is called like one of `std` or nalgebra, or two variables of a `macro_rules!` that are spelt alike; give it \
             another name"
        )
    }
}

impl Disagreement {
    fn is_on_one(&self) -> bool {
        #[cfg(feature = "scene")]
        return matches!(self.culprit, Culprit::Body(_));
        #[cfg(not(feature = "scene"))]
        true
    }
}
