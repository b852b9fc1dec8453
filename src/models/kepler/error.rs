//! Orbits that are none.

use thiserror::Error;

/// Why a state has no [`Elements`](super::Elements), or elements have no state.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OrbitError {
    /// A number is infinite or NaN.
    #[error("the {quantity} must be finite, not {value}")]
    NotFinite {
        /// What it is.
        quantity: &'static str,
        /// The refused value.
        value: f64,
    },
    /// The strength gm, or the distance of the pericentre, is zero or negative.
    #[error("the {quantity} must be positive, not {value:?}")]
    NotPositive {
        /// What it is.
        quantity: &'static str,
        /// The refused value.
        value: f64,
    },
    /// The eccentricity is negative.
    #[error("the eccentricity must not be negative: {eccentricity:?}")]
    Eccentricity {
        /// The refused value.
        eccentricity: f64,
    },
    /// Position and velocity are on one line, to rounding: it goes through the centre, and no pericentre is left.
    #[error(
        "the motion is along a line through the centre: its angular momentum is {angular_momentum:?}, rounding leaves {least:?}"
    )]
    Rectilinear {
        /// |q × v|.
        angular_momentum: f64,
        /// What rounding may leave of it.
        least: f64,
    },
    /// The orbit leaves the plane in which a state is asked for.
    #[error("the orbit leaves the plane: its inclination is {inclination:?}, neither 0 nor π")]
    Inclined {
        /// The inclination.
        inclination: f64,
    },
    /// A parabola or a hyperbola does not come where this true anomaly is.
    #[error("with eccentricity {eccentricity:?} the true anomaly stays below {limit:?}: {anomaly:?} is beyond")]
    Beyond {
        /// The refused true anomaly.
        anomaly: f64,
        /// Where the asymptote is: arccos(−1/e).
        limit: f64,
        /// The eccentricity.
        eccentricity: f64,
    },
}
