//! The elements of an orbit, and what follows from them.

use core::f64::consts::TAU;

use super::conic::Conic;
use super::error::OrbitError;

/// An orbit about a fixed sun: a conic section, how it lies in space, and when its planet is at the pericentre.
///
/// Pericentre distance and eccentricity describe every conic, the parabola among them; the half-axis of an ellipse or a
/// hyperbola and what else has a name follow from them. Angles are in radians, units otherwise any consistent set
/// ([`units`](crate::models::units) has SI); the particle has unit mass.
///
/// ```
/// use dmech::models::kepler::Elements;
///
/// let parabola = Elements { gm: 1.0, pericentre: 0.5, eccentricity: 1.0, ..Elements::default() };
/// assert_eq!((parabola.period(), parabola.semi_latus_rectum()), (None, 1.0));
/// // Barker's equation at tan ν/2 = 1: t = √(2 q³/gm) (1 + 1/3).
/// let state = parabola.in_plane(0.5 * 4.0 / 3.0)?;
/// assert!(state.q[0].abs() < 1e-15 && (state.q[1] - 1.0).abs() < 1e-15);
/// # Ok::<(), dmech::models::kepler::OrbitError>(())
/// ```
///
/// # Edges
/// A circle has no pericentre: its `argument` is 0 in what is found from a state, and `passage` is when the planet is at the
/// node. An orbit in the plane of the first two coordinates has no node: its `node` is 0, its `inclination` 0 or, if it
/// runs clockwise, π. Motion along a line through the centre has no elements.
/// # Source
/// J. M. A. Danby, *Fundamentals of Celestial Mechanics* (1988), chapter 6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elements {
    /// Strength gm > 0 of the sun, as in [`Kepler`](super::Kepler).
    pub gm: f64,
    /// Distance of the pericentre q > 0; a (1 − e) where a is the half-axis.
    pub pericentre: f64,
    /// Eccentricity e ≥ 0: an ellipse below 1, the parabola 1, a hyperbola above.
    pub eccentricity: f64,
    /// Inclination i: the angle from the plane of the first two coordinates, 0 … π.
    pub inclination: f64,
    /// Longitude Ω of the ascending node, where the third coordinate becomes positive, from the first axis.
    pub node: f64,
    /// Argument ω of the pericentre: the angle from the node to it, along the motion.
    pub argument: f64,
    /// Time T of a passage through the pericentre.
    pub passage: f64,
}

impl Default for Elements {
    /// A circle of radius 1 under strength 1, anticlockwise in the plane, that is on the first axis at t = 0.
    fn default() -> Self {
        let (gm, pericentre) = (1.0, 1.0);
        Elements { gm, pericentre, eccentricity: 0.0, inclination: 0.0, node: 0.0, argument: 0.0, passage: 0.0 }
    }
}

impl Elements {
    /// p = q (1 + e).
    pub fn semi_latus_rectum(&self) -> f64 {
        self.pericentre * (1.0 + self.eccentricity)
    }

    /// The half-axis a = q/(1 − e): infinite for the parabola, negative for a hyperbola.
    pub fn half_axis(&self) -> f64 {
        self.pericentre / (1.0 - self.eccentricity)
    }

    /// The distance of the apocentre a (1 + e), of an ellipse.
    pub fn apocentre(&self) -> Option<f64> {
        (self.eccentricity < 1.0).then(|| self.half_axis() * (1.0 + self.eccentricity))
    }

    /// The period 2π √(a³/gm), of an ellipse (Kepler's third law).
    pub fn period(&self) -> Option<f64> {
        (self.eccentricity < 1.0).then(|| TAU / self.mean_motion())
    }

    /// The rate of the mean anomaly: √(gm/|a|³), for the parabola √(gm/(2 q³)).
    pub fn mean_motion(&self) -> f64 {
        self.rate() * self.conic().mean_motion()
    }

    /// The energy −gm/(2a), which is negative for an ellipse and 0 for the parabola.
    pub fn energy(&self) -> f64 {
        -0.5 * self.gm * (1.0 - self.eccentricity) / self.pericentre
    }

    /// The angular momentum √(gm p).
    pub fn angular_momentum(&self) -> f64 {
        (self.gm * self.semi_latus_rectum()).sqrt()
    }

    /// The true anomaly ν at time t: the angle from the pericentre, −π … π.
    pub fn true_anomaly(&self, t: f64) -> f64 {
        self.conic().place(self.since_pericentre(t)).true_anomaly()
    }

    /// The eccentric anomaly at time t: E of an ellipse, D of the parabola, F of a hyperbola (see
    /// [`anomaly`](super::anomaly)).
    pub fn eccentric_anomaly(&self, t: f64) -> f64 {
        self.conic().rate() * self.conic().argument(self.since_pericentre(t))
    }

    /// The mean anomaly at time t, of an ellipse between −π and π.
    pub fn mean_anomaly(&self, t: f64) -> f64 {
        self.conic().mean_motion() * self.since_pericentre(t)
    }

    /// The same orbit with the passage that has the true anomaly ν at time t.
    ///
    /// # Errors
    /// [`OrbitError::Beyond`] where a parabola or a hyperbola does not come; what [`at`](Elements::at) refuses.
    pub fn with_true_anomaly(self, t: f64, anomaly: f64) -> Result<Self, OrbitError> {
        self.check()?;
        finite("true anomaly", anomaly)?;
        let (eccentricity, s) = (self.eccentricity, self.conic().at_true(anomaly));
        let limit = (-1.0 / eccentricity).acos();
        // The tangent of a rounded π/2 is finite.
        if s.is_nan() || (eccentricity >= 1.0 && (anomaly - TAU * (anomaly / TAU).round()).abs() >= limit) {
            return Err(OrbitError::Beyond { anomaly, limit, eccentricity });
        }
        Ok(Elements { passage: t - self.conic().time(s) / self.rate(), ..self })
    }

    /// The same orbit with the passage that has the mean anomaly M at time t.
    ///
    /// ```
    /// use dmech::models::kepler::Elements;
    ///
    /// let mars = Elements { gm: 39.478, pericentre: 1.3814, eccentricity: 0.0934, ..Elements::default() };
    /// let mars = mars.with_mean_anomaly(2.0, 0.3385);
    /// assert!((mars.mean_anomaly(2.0) - 0.3385).abs() < 1e-15);
    /// ```
    pub fn with_mean_anomaly(self, t: f64, anomaly: f64) -> Self {
        Elements { passage: t - anomaly / self.mean_motion(), ..self }
    }

    /// The conic in the unit of its pericentre distance.
    pub(super) fn conic(&self) -> Conic {
        Conic::new(self.eccentricity)
    }

    /// √(gm/q³): what takes a time to the unit of the [`conic`](Elements::conic).
    pub(super) fn rate(&self) -> f64 {
        (self.gm / self.pericentre).sqrt() / self.pericentre
    }

    /// The time since the nearest pericentre, in the unit of the conic.
    pub(super) fn since_pericentre(&self, t: f64) -> f64 {
        self.conic().reduced((t - self.passage) * self.rate())
    }

    /// Whether this is an orbit.
    pub(super) fn check(&self) -> Result<(), OrbitError> {
        let &Elements { gm, pericentre, eccentricity, inclination, node, argument, passage } = self;
        positive("strength gm", gm)?;
        positive("distance of the pericentre", pericentre)?;
        finite("eccentricity", eccentricity)?;
        if eccentricity < 0.0 {
            return Err(OrbitError::Eccentricity { eccentricity });
        }
        finite("inclination", inclination)?;
        finite("longitude of the node", node)?;
        finite("argument of the pericentre", argument)?;
        finite("time of the pericentre", passage)
    }
}

pub(super) fn finite(quantity: &'static str, value: f64) -> Result<(), OrbitError> {
    if value.is_finite() { Ok(()) } else { Err(OrbitError::NotFinite { quantity, value }) }
}

pub(super) fn positive(quantity: &'static str, value: f64) -> Result<(), OrbitError> {
    finite(quantity, value)?;
    if value > 0.0 { Ok(()) } else { Err(OrbitError::NotPositive { quantity, value }) }
}
