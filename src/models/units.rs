//! Constants of nature and units, as numbers in SI: metre, kilogram, second, ampere, kelvin.
//!
//! A quantity times a unit is in SI, a quantity in SI over a unit is in that unit. Laws take any consistent set of units, so
//! this is one choice; with lengths in [`AU`] and times in [`DAY`] the strength of the Sun is [`GM_SUN_AU_DAY`].
//!
//! ```
//! use dmech::models::units::{AU, DAY, GM_SUN, JULIAN_YEAR};
//! use dmech::{models::Kepler, prelude::*};
//!
//! let law = Kepler { gm: GM_SUN };
//! assert!((law.period(AU) / JULIAN_YEAR - 1.0).abs() < 1e-4);
//! let run = Simulation::new(law, law.pericentre(AU, 0.0167)).scheme(Leapfrog).dt(DAY).run(365)?;
//! assert!((run.last().q[0] / AU - 0.98).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Sources
//! - Constants of nature: CODATA 2022 (P. J. Mohr et al., Rev. Mod. Phys. 97 (2025) 025002); "exact" is by definition of SI.
//! - Astronomical unit: IAU 2012 Resolution B2; nominal values: IAU 2015 Resolution B3.
//! - Strengths of the Sun and the planets: DE440 (R. S. Park et al., Astron. J. 161 (2021) 105); gm is known to many more
//!   digits than G or a mass by itself.

use core::f64::consts::PI;

/// Speed of light in vacuum c, m/s, exact.
pub const SPEED_OF_LIGHT: f64 = 299_792_458.0;
/// Constant of gravity G, m³/(kg s²), CODATA 2022: relative uncertainty 2.2e−5.
pub const GRAVITY: f64 = 6.674_30e-11;
/// Planck's constant h, J s, exact.
pub const PLANCK: f64 = 6.626_070_15e-34;
/// Planck's constant over 2π, J s.
pub const REDUCED_PLANCK: f64 = PLANCK / (2.0 * PI);
/// Boltzmann's constant k, J/K, exact.
pub const BOLTZMANN: f64 = 1.380_649e-23;
/// Avogadro's constant, 1/mol, exact.
pub const AVOGADRO: f64 = 6.022_140_76e23;
/// Gas constant R, J/(mol K), exact.
pub const GAS: f64 = BOLTZMANN * AVOGADRO;
/// Elementary charge e, C, exact.
pub const ELEMENTARY_CHARGE: f64 = 1.602_176_634e-19;
/// Electric constant ε₀, F/m, CODATA 2022.
pub const ELECTRIC: f64 = 8.854_187_818_8e-12;
/// Magnetic constant μ₀, N/A², CODATA 2022.
pub const MAGNETIC: f64 = 1.256_637_061_27e-6;
/// Coulomb's constant 1/(4π ε₀), N m²/C².
pub const COULOMB: f64 = 1.0 / (4.0 * PI * ELECTRIC);
/// Mass of the electron, kg, CODATA 2022.
pub const ELECTRON_MASS: f64 = 9.109_383_713_9e-31;
/// Mass of the proton, kg, CODATA 2022.
pub const PROTON_MASS: f64 = 1.672_621_925_95e-27;
/// Mass of the neutron, kg, CODATA 2022.
pub const NEUTRON_MASS: f64 = 1.674_927_500_56e-27;
/// Unit of atomic mass u, kg, CODATA 2022.
pub const ATOMIC_MASS: f64 = 1.660_539_068_92e-27;
/// Bohr's radius a₀, m, CODATA 2022.
pub const BOHR_RADIUS: f64 = 5.291_772_105_44e-11;
/// Hartree's energy, J, CODATA 2022.
pub const HARTREE: f64 = 4.359_744_722_206_0e-18;
/// Electron volt, J, exact.
pub const ELECTRON_VOLT: f64 = ELEMENTARY_CHARGE;
/// Ångström, m, exact.
pub const ANGSTROM: f64 = 1e-10;

/// Degree of arc, rad.
pub const DEGREE: f64 = PI / 180.0;
/// Minute, s, exact.
pub const MINUTE: f64 = 60.0;
/// Hour, s, exact.
pub const HOUR: f64 = 3600.0;
/// Day, s, exact.
pub const DAY: f64 = 86_400.0;
/// Julian year of 365.25 days, s, exact.
pub const JULIAN_YEAR: f64 = 365.25 * DAY;
/// Astronomical unit, m, exact (IAU 2012).
pub const AU: f64 = 149_597_870_700.0;
/// Parsec, m: the distance at which 1 au is 1″ of arc, 648000/π au (IAU 2015).
pub const PARSEC: f64 = 648_000.0 / PI * AU;
/// Light year of 365.25 days, m, exact.
pub const LIGHT_YEAR: f64 = SPEED_OF_LIGHT * JULIAN_YEAR;

/// Strength of the Sun, m³/s², DE440.
pub const GM_SUN: f64 = 1.327_124_400_412_794_2e20;
/// Strength of the Sun with lengths in au and times in days.
pub const GM_SUN_AU_DAY: f64 = GM_SUN * DAY * DAY / (AU * AU * AU);
/// Strength of Mercury, m³/s², DE440.
pub const GM_MERCURY: f64 = 2.203_186_855_140_000_3e13;
/// Strength of Venus, m³/s², DE440.
pub const GM_VENUS: f64 = 3.248_585_92e14;
/// Strength of the Earth without the Moon, m³/s², DE440.
pub const GM_EARTH: f64 = 3.986_004_355_070_227e14;
/// Strength of the Moon, m³/s², DE440.
pub const GM_MOON: f64 = 4.902_800_118_457_55e12;
/// Strength of Mars with its moons, m³/s², DE440.
pub const GM_MARS: f64 = 4.282_837_581_575_61e13;
/// Strength of Jupiter with its moons, m³/s², DE440.
pub const GM_JUPITER: f64 = 1.267_127_641e17;
/// Strength of Saturn with its moons, m³/s², DE440.
pub const GM_SATURN: f64 = 3.794_058_484_18e16;
/// Strength of Uranus with its moons, m³/s², DE440.
pub const GM_URANUS: f64 = 5.794_556_4e15;
/// Strength of Neptune with its moons, m³/s², DE440.
pub const GM_NEPTUNE: f64 = 6.836_527_100_580_399e15;
/// Strength of Pluto with its moons, m³/s², DE440.
pub const GM_PLUTO: f64 = 9.755e11;

/// Nominal strength of the Sun, m³/s², by convention (IAU 2015).
pub const NOMINAL_GM_SUN: f64 = 1.327_124_4e20;
/// Nominal strength of the Earth, m³/s², by convention (IAU 2015).
pub const NOMINAL_GM_EARTH: f64 = 3.986_004e14;
/// Nominal strength of Jupiter, m³/s², by convention (IAU 2015).
pub const NOMINAL_GM_JUPITER: f64 = 1.266_865_3e17;
/// Nominal radius of the Sun, m, by convention (IAU 2015).
pub const SUN_RADIUS: f64 = 6.957e8;
/// Nominal radius of the Earth at the equator, m, by convention (IAU 2015).
pub const EARTH_RADIUS: f64 = 6.3781e6;
/// Nominal radius of Jupiter at the equator, m, by convention (IAU 2015).
pub const JUPITER_RADIUS: f64 = 7.1492e7;
/// Standard acceleration of free fall, m/s², by convention (CGPM 1901).
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// Mass of the Sun, kg: [`GM_SUN`] over [`GRAVITY`], so it has the digits of G.
pub const SUN_MASS: f64 = GM_SUN / GRAVITY;
/// Mass of the Earth, kg: [`GM_EARTH`] over [`GRAVITY`], so it has the digits of G.
pub const EARTH_MASS: f64 = GM_EARTH / GRAVITY;

/// Gauss's constant k, by definition until 2012 the square root of the Sun's strength with lengths in au, times in days
/// and its mass as the unit (IAU 1976); k² = [`GM_SUN_AU_DAY`] to nine digits.
pub const GAUSS_K: f64 = 0.017_202_098_95;

#[cfg(test)]
mod tests {
    use super::*;

    /// Constants that are measured apart belong together: c² ε₀ μ₀ = 1, Kepler's third law of the year, a₀ and Hartree.
    #[test]
    fn they_fit_together() {
        let near = |a: f64, b: f64, relative: f64| assert!((a / b - 1.0).abs() < relative, "{a:e} {b:e}");
        near(SPEED_OF_LIGHT * SPEED_OF_LIGHT * ELECTRIC * MAGNETIC, 1.0, 3e-10);
        near(
            BOHR_RADIUS,
            REDUCED_PLANCK * REDUCED_PLANCK / (ELECTRON_MASS * COULOMB * ELEMENTARY_CHARGE.powi(2)),
            1e-9,
        );
        near(HARTREE, COULOMB * ELEMENTARY_CHARGE.powi(2) / BOHR_RADIUS, 1e-9);
        near(ATOMIC_MASS * AVOGADRO, 1e-3, 1e-8);
        near(GAS, 8.314_462_618_153_24, 1e-15);
        near(GAUSS_K * GAUSS_K, GM_SUN_AU_DAY, 1e-9);
        near(GM_SUN, NOMINAL_GM_SUN, 1e-7);
        near(GM_EARTH, NOMINAL_GM_EARTH, 1e-6);
        near(GM_JUPITER, NOMINAL_GM_JUPITER, 1e-3);
        near(GM_EARTH / EARTH_RADIUS.powi(2), STANDARD_GRAVITY, 2e-3);
        near(PARSEC, 3.085_677_581e16, 1e-9);
        near(SUN_MASS, 1.9884e30, 1e-4);
        near(EARTH_MASS, 5.972e24, 1e-4);
    }
}
