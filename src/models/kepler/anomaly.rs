//! The angles that tell where on a conic a planet is: true, eccentric and mean anomaly, for every eccentricity e ≥ 0.
//!
//! | conic | eccentric anomaly | mean anomaly |
//! |---|---|---|
//! | ellipse, e < 1 | tan E/2 = √((1 − e)/(1 + e)) tan ν/2 | M = E − e sin E |
//! | parabola, e = 1 | D = tan ν/2 | M = D + D³/3 (Barker's equation) |
//! | hyperbola, e > 1 | tanh F/2 = √((e − 1)/(e + 1)) tan ν/2 | M = e sinh F − F |
//!
//! The mean anomaly grows with time, at the rate of [`Elements::mean_motion`](super::Elements::mean_motion). What is found from ν or from
//! M is between −π and π on an ellipse: whole revolutions are dropped. Every function is accurate to a few ulp also near e = 1, where
//! these formulas are not: all go through one equation that has no seam there.
//!
//! ```
//! use dmech::models::kepler::anomaly;
//!
//! for e in [0.0, 0.3, 1.0 - 1e-10, 1.0, 1.0 + 1e-10, 4.0] {
//!     let mean = anomaly::true_to_mean(e, 1.2);
//!     assert!((anomaly::mean_to_true(e, mean) - 1.2).abs() < 1e-15, "{e}");
//! }
//! // Halley's comet a quarter of its period after the pericentre.
//! assert!((anomaly::mean_to_true(0.967, 0.5 * core::f64::consts::PI).to_degrees() - 173.3).abs() < 0.1);
//! ```
//!
//! # Source
//! J. M. A. Danby, *Fundamentals of Celestial Mechanics* (1988), §6.2–6.9.

use super::conic::Conic;

/// E, D or F where the true anomaly is ν; NaN beyond the asymptotes of a hyperbola.
pub fn true_to_eccentric(eccentricity: f64, true_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.rate() * conic.at_true(true_anomaly)
}

/// M where the true anomaly is ν; NaN beyond the asymptotes of a hyperbola.
pub fn true_to_mean(eccentricity: f64, true_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.mean_motion() * conic.time(conic.at_true(true_anomaly))
}

/// M = E − e sin E, D + D³/3 or e sinh F − F.
pub fn eccentric_to_mean(eccentricity: f64, eccentric_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.mean_motion() * conic.time(eccentric_anomaly / conic.rate())
}

/// ν where the eccentric anomaly is E, D or F.
pub fn eccentric_to_true(eccentricity: f64, eccentric_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.place_at(eccentric_anomaly / conic.rate(), 0.0).true_anomaly()
}

/// E, D or F where the mean anomaly is M: the root of Kepler's equation.
pub fn mean_to_eccentric(eccentricity: f64, mean_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.rate() * conic.argument(conic.reduced(mean_anomaly / conic.mean_motion()))
}

/// ν where the mean anomaly is M.
pub fn mean_to_true(eccentricity: f64, mean_anomaly: f64) -> f64 {
    let conic = Conic::new(eccentricity);
    conic.place(conic.reduced(mean_anomaly / conic.mean_motion())).true_anomaly()
}
