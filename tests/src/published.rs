//! Motions whose ends are in print, to as many digits as an `f64` has.
//!
//! Printed digits are of motions that start from decimal numbers; the ends given here are of those that start from the nearest
//! `f64`, computed by Taylor series in numbers of 113 to 240 bits, of which two precisions agree to 30 digits.

use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech::scene::{Linked, Pairs};

/// Seven stars of masses 1 … 7 in the plane, g = 1, two pairs of which come as near as 0.034 and 0.056.
///
/// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.10, (10.3); F. Mazzia,
/// C. Magherini, *Test Set for Initial Value Problem Solvers*, problem "plei", whose printed end at t = 3 agrees with
/// [`PLEIADES_END`] to 2·10⁻¹⁵ in all 28 numbers.
pub fn pleiades() -> Scene<2, (), ((), Linked<Gravity, Pairs>)> {
    let x = [3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0];
    let y = [3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0];
    let u = [0.0, 0.0, 0.0, 0.0, 0.0, 1.75, -1.5];
    let v = [0.0, 0.0, 0.0, -1.25, 1.0, 0.0, 0.0];
    let mut scene = Scene::new();
    for i in 0..7 {
        scene = scene.body((i + 1) as f64, [x[i], y[i]], [u[i], v[i]]);
    }
    scene.pairs(Gravity { g: 1.0 })
}

/// Positions and velocities of the seven stars at t = 3.
pub const PLEIADES_END: [([f64; 2], [f64; 2]); 7] = [
    ([0.37061391439705127, -3.943437585517392], [3.4170038063143147, -3.7412449612340084]),
    ([3.237284092057233, -3.27138097397255], [1.3545845016255011, 0.3773459685750629]),
    ([-3.2225590324183235, 5.225081843456544], [-2.5900655978107756, 0.9386858869551079]),
    ([0.6597091455775308, -2.5906124349774693], [2.025053734714241, 0.36679222272005696]),
    ([0.342558170715658, 1.1982136933922747], [-1.155815100160449, -0.3474046353808494]),
    ([1.5621721014006311, -0.24296823449358235], [-0.8072988170223022, 2.344915448180937]),
    ([-0.7003092922212495, 1.0914492404289797], [0.5952396354208719, -1.947020434263292]),
];

/// A satellite in the frame that turns with the earth and the moon, which have masses 1 − μ and μ and rest at (−μ, 0) and
/// (1 − μ, 0): x″ = x + 2 y′ − ∂/∂x, y″ = y − 2 x′ − ∂/∂y of the attraction of both. Its energy is Jacobi's constant halved.
#[derive(Clone, Copy, Debug)]
pub struct EarthAndMoon {
    /// Mass of the moon, as a part of both.
    pub mu: f64,
}

#[dmech::law]
impl EarthAndMoon {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let (to_earth, to_moon) = (x + self.mu, x - (1.0 - self.mu));
        let earth = (1.0 - self.mu) / (to_earth * to_earth + y * y).sqrt();
        let moon = self.mu / (to_moon * to_moon + y * y).sqrt();
        -0.5 * (x * x + y * y) - earth - moon
    }
    #[force]
    fn coriolis(&self, v: [f64; 2]) -> [f64; 2] {
        [2.0 * v[1], -2.0 * v[0]]
    }
}

/// R. F. Arenstorf's closed orbits, from a place near the moon: the law, the start, the period, and position and velocity then.
///
/// R. F. Arenstorf, Am. J. Math. 85 (1963) 27–35; starts and periods: Hairer, Nørsett, Wanner, II.0, (0.1)–(0.2). With the printed
/// decimals the orbit closes to 4·10⁻²⁷; rounding them to `f64` moves the end by 10⁻¹³ in place and 1.4·10⁻¹¹ in velocity.
pub struct ClosedOrbit {
    pub start: State<2>,
    pub period: f64,
    pub end: State<2>,
}

/// μ of both orbits.
pub const MOON: EarthAndMoon = EarthAndMoon { mu: 0.012277471 };

/// Four loops, T = 17.0652165601579625588917206249.
pub fn four_loops() -> ClosedOrbit {
    ClosedOrbit {
        start: State::new([0.994, 0.0], [0.0, -2.001585106379082]),
        period: 17.065216560157964,
        end: State::new([0.993999999999974, -8.855134620121084e-14], [-1.4388667357318094e-11, -2.001585106383129]),
    }
}

/// Three loops, T = 11.124340337266085134999734047.
pub fn three_loops() -> ClosedOrbit {
    ClosedOrbit {
        start: State::new([0.994, 0.0], [0.0, -2.031_732_629_557_337]),
        period: 11.124340337266085,
        end: State::new([0.9939999999999826, -5.952430331684727e-14], [-9.738285478263268e-12, -2.03173262956001]),
    }
}
