//! A planet about a fixed sun, in the plane and in space, and the [`Elements`] of its orbit.
//!
//! ```
//! use dmech::models::kepler::Elements;
//! use dmech::models::units::{AU, DAY, DEGREE, GM_SUN, JULIAN_YEAR};
//! use dmech::{models::Kepler3, prelude::*};
//!
//! // Halley's comet (JPL Horizons, epoch 1994-Feb-17): time in seconds from its pericentre, 1986-Feb-9.
//! let halley = Elements {
//!     gm: GM_SUN,
//!     pericentre: 0.585_978_111_516_908_6 * AU,
//!     eccentricity: 0.967_142_908_462_304_4,
//!     inclination: 162.262_690_579_160_6 * DEGREE,
//!     node: 58.420_080_976_568_43 * DEGREE,
//!     argument: 111.332_485_104_517_7 * DEGREE,
//!     passage: 0.0,
//! };
//! assert!((halley.period().unwrap() / JULIAN_YEAR - 75.3159).abs() < 1e-4);
//!
//! let start = halley.at(-30.0 * DAY)?;
//! let law = Kepler3 { gm: GM_SUN };
//! let run = Simulation::new(law, start).scheme(Nystrom::order6()).dt(DAY).run_until(30.0 * DAY)?;
//! let back = law.elements(run.last())?;
//! assert!((back.eccentricity - halley.eccentricity).abs() < 1e-11);
//! assert!((back.passage - halley.passage).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod anomaly;
mod conic;
mod elements;
mod error;
mod state;
mod stumpff;

pub use elements::Elements;
pub use error::OrbitError;

use crate::State;

/// Kepler's problem in the plane, Φ(q) = −gm/|q|.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `gm` > 0 | E L | strength; with unit mass the constant of gravity times the mass of the sun |
///
/// # Domain
/// q ≠ 0; orbits without angular momentum reach the singularity.
/// # Invariants
/// Energy, angular momentum about the sun, the Laplace-Runge-Lenz vector (which no scheme here keeps).
/// # Source
/// L. D. Landau, E. M. Lifshitz, *Mechanics*, §15; Greenspan, TR 122 (1971), §5; Kanatani (3.24).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kepler {
    /// Strength.
    pub gm: f64,
}

impl Default for Kepler {
    /// gm = 1.
    fn default() -> Self {
        Kepler { gm: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Kepler {
    /// Φ(q) = −gm/|q|.
    #[potential]
    pub fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        -self.gm / (x * x + y * y).sqrt()
    }
}

impl Kepler {
    /// The period of an ellipse with major half-axis a: 2π √(a³/gm), unit mass (Kepler's third law).
    ///
    /// ```
    /// assert_eq!(dmech::models::Kepler { gm: 4.0 }.period(4.0), 8.0 * core::f64::consts::PI);
    /// ```
    ///
    /// NaN if the half-axis is negative, as that of a hyperbola; [`Elements::period`] says `None` of what does not come back.
    pub fn period(&self, half_axis: f64) -> f64 {
        core::f64::consts::TAU * (half_axis.powi(3) / self.gm).sqrt()
    }

    /// The pericentre of the ellipse with half-axis a and eccentricity 0 ≤ e < 1, on the x axis, at t = 0; unit mass.
    ///
    /// ```
    /// let start = dmech::models::Kepler { gm: 2.0 }.pericentre(2.0, 0.6);
    /// assert_eq!((start.q, start.v), ([0.8, 0.0], [0.0, 2.0]));
    /// ```
    ///
    /// Of what is no ellipse the speed is not finite, and a simulation refuses the start; [`Elements`] has those of parabolas and
    /// hyperbolas.
    pub fn pericentre(&self, half_axis: f64, eccentricity: f64) -> State<2> {
        let speed = (self.gm / half_axis * (1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
        State::new([half_axis * (1.0 - eccentricity), 0.0], [0.0, speed])
    }

    /// The elements of the orbit that goes through a state; unit mass.
    ///
    /// ```
    /// let law = dmech::models::Kepler { gm: 2.0 };
    /// let orbit = law.elements(&law.pericentre(2.0, 0.6))?;
    /// assert!((orbit.half_axis() - 2.0).abs() < 1e-14 && (orbit.eccentricity - 0.6).abs() < 1e-15);
    /// # Ok::<(), dmech::models::kepler::OrbitError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Elements::of_plane`].
    pub fn elements(&self, state: &State<2>) -> Result<Elements, OrbitError> {
        Elements::of_plane(self.gm, state)
    }

    /// The position on the ellipse of [`pericentre`](Kepler::pericentre) at time t, by Newton's method on Kepler's equation M = E − e sin
    /// E, unit mass.
    ///
    /// ```
    /// let law = dmech::models::Kepler { gm: 1.3 };
    /// let far = law.exact(2.0, 0.6, 0.5 * law.period(2.0));
    /// assert!((far[0] + 3.2).abs() < 1e-14 && far[1].abs() < 1e-14);
    /// ```
    pub fn exact(&self, half_axis: f64, eccentricity: f64, t: f64) -> [f64; 2] {
        let e = eccentricity;
        let turns = t / self.period(half_axis);
        let mean = core::f64::consts::TAU * (turns - turns.round());
        // E − e sin E is convex between 0 and π: from π the iteration comes down to the root without overshooting.
        let mut anomaly = core::f64::consts::PI.copysign(mean);
        for _ in 0..64 {
            anomaly -= (anomaly - e * anomaly.sin() - mean) / (1.0 - e * anomaly.cos());
        }
        let (sin, cos) = anomaly.sin_cos();
        [half_axis * (cos - e), half_axis * (1.0 - e * e).sqrt() * sin]
    }
}

/// Kepler's problem in space, Φ(q) = −gm/|q|: as [`Kepler`], with three coordinates.
///
/// ```
/// use dmech::{models::Kepler3, prelude::*};
///
/// let law = Kepler3 { gm: 1.3 };
/// let run = Simulation::new(law, State::new([0.9, 0.1, -0.2], [0.1, 0.9, 0.3])).scheme(DiscreteGradient).dt(0.01).run(1000)?;
/// assert!(run.drift(Invariant::AngularMomentum).unwrap().max_relative() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kepler3 {
    /// Strength.
    pub gm: f64,
}

impl Default for Kepler3 {
    /// gm = 1.
    fn default() -> Self {
        Kepler3 { gm: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Kepler3 {
    /// Φ(q) = −gm/|q|.
    #[potential]
    pub fn energy(&self, q: [f64; 3]) -> f64 {
        let [x, y, z] = q;
        -self.gm / (x * x + y * y + z * z).sqrt()
    }
}

impl Kepler3 {
    /// The period of an ellipse with major half-axis a: 2π √(a³/gm), unit mass.
    ///
    /// ```
    /// assert_eq!(dmech::models::Kepler3 { gm: 4.0 }.period(4.0), 8.0 * core::f64::consts::PI);
    /// ```
    pub fn period(&self, half_axis: f64) -> f64 {
        Kepler { gm: self.gm }.period(half_axis)
    }
    /// The elements of the orbit that goes through a state; unit mass.
    ///
    /// # Errors
    /// Those of [`Elements::of`].
    pub fn elements(&self, state: &State<3>) -> Result<Elements, OrbitError> {
        Elements::of(self.gm, state)
    }
}
