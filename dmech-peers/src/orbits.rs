//! Many planets of one law: starts, ends, and where each is then.

use dmech::DoubleDouble;
use dmech::extend::Real;
use dmech::models::Kepler;
use dmech::prelude::State;

/// Orbits of an ensemble.
pub const ORBITS: usize = 64;

/// The end of their time.
pub const ORBITS_END: f64 = 100.0;

/// gm, between 0.9 and 1.1; neighbours differ.
pub fn orbit_law(k: usize) -> Kepler {
    Kepler { gm: 0.9 + 0.2 * ((97 * k) % ORBITS) as f64 / ORBITS as f64 }
}

/// The pericentre of an ellipse of major half-axis 1, whose eccentricity goes from 0.1 to 0.6: 14 to 17 revolutions.
pub fn orbit_start(k: usize) -> State<2> {
    let e = 0.1 + 0.5 * k as f64 / (ORBITS - 1) as f64;
    State::new([1.0 - e, 0.0], [0.0, (orbit_law(k).gm * (1.0 + e) / (1.0 - e)).sqrt()])
}

/// Where an orbit ends.
pub fn orbit_end(k: usize) -> [f64; 2] {
    let State { q, v, .. } = orbit_start(k);
    from_pericentre(orbit_law(k).gm, q[0], v[1], ORBITS_END)
}

/// In closed form with 31 digits, from a pericentre on the x axis with velocity along y: Kepler's equation by Newton's method. These numbers
/// are taken as exact.
fn from_pericentre(gm: f64, q: f64, v: f64, t: f64) -> [f64; 2] {
    let [one, two, gm, q, v, t] = [1.0, 2.0, gm, q, v, t].map(DoubleDouble::from);
    let axis = (two / q - v * v / gm).recip();
    let e = one - q / axis;
    let turned = t * (gm / (axis * axis * axis)).sqrt();
    let circle = two * two * two * one.atan();
    let mean = turned - (turned / circle).floor() * circle;
    let mut anomaly = mean;
    for _ in 0..50 {
        anomaly = anomaly - (anomaly - e * anomaly.sin() - mean) / (one - e * anomaly.cos());
    }
    let short = axis * (one - e * e).sqrt();
    [axis * (anomaly.cos() - e), short * anomaly.sin()].map(Real::to_f64)
}

#[cfg(test)]
mod tests {
    use dmech::prelude::*;

    use super::*;

    /// Greenspan's planet, by the digits of `python/ends.py`.
    #[test]
    fn the_closed_form_is_that_of_forty_digits() {
        assert_eq!(from_pericentre(1.0, 0.5, 1.63, 350.0), crate::ends::ORBIT);
    }

    #[test]
    fn orbits_end_where_they_are_moved() {
        for k in [0, ORBITS / 2, ORBITS - 1] {
            let run = Simulation::new(orbit_law(k), orbit_start(k)).scheme(Gauss::order16()).adaptive(1e-12);
            let end = run.run_until(ORBITS_END).unwrap().last().q;
            assert!(crate::distance(&end, &orbit_end(k)) < 1e-11, "{k}: {end:?} and {:?}", orbit_end(k));
        }
    }
}
