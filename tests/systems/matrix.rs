//! Schemes × systems: the order of each is the declared one, and what is exact is kept. A new scheme is a row of `schemes!`,
//! a new system a test.

use dmech::prelude::*;
use dmech::{Kept, Setup};

use super::setups::*;

/// Each scheme with the longest of three steps by which its order is measured.
macro_rules! schemes {
    ($measure:ident, $setup:expr) => {{
        let mut cells = 0;
        for (name, order, measured) in [
            $measure(&$setup, Explicit, 1.0 / 512.0),
            $measure(&$setup, Leapfrog, 1.0 / 32.0),
            $measure(&$setup, CompensatedLeapfrog, 1.0 / 32.0),
            $measure(&$setup, Implicit, 1.0 / 32.0),
            $measure(&$setup, DiscreteGradient, 1.0 / 32.0),
            $measure(&$setup, Kanatani, 1.0 / 32.0),
            $measure(&$setup, Composed::order4(Leapfrog), 1.0 / 12.0),
            $measure(&$setup, Composed::order4(Implicit), 1.0 / 12.0),
            $measure(&$setup, Composed::order4(DiscreteGradient), 1.0 / 12.0),
            $measure(&$setup, Composed::order6(Leapfrog), 1.0 / 6.0),
            $measure(&$setup, Composed::order6(Implicit), 1.0 / 6.0),
            $measure(&$setup, Composed::order6(DiscreteGradient), 1.0 / 6.0),
            $measure(&$setup, Nystrom::order4(), 1.0 / 8.0),
            $measure(&$setup, Nystrom::order6(), 1.0 / 4.0),
            $measure(&$setup, ForceGradient::order4(), 1.0 / 8.0),
            $measure(&$setup, ForceGradient::order6(), 1.0 / 8.0),
        ] {
            println!("{name:<44} {order} {measured:.3}");
            assert!((measured - f64::from(order)).abs() < 0.35, "{name}: order {measured}");
            cells += 1;
        }
        assert_eq!(cells, 16);
    }};
}

/// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p at t = 2; and over a longer run what the scheme keeps exactly.
fn measure<L, X, S>(setup: &dyn Fn() -> Simulation<L, X>, scheme: S, h: f64) -> (&'static str, u32, f64)
where
    X: Setup<L>,
    X::State: Places,
    S: Scheme<X::System>,
{
    let end = |h: f64| setup().scheme(scheme).dt(h).run_until(2.0).map_err(|e| e.to_string()).expect(S::NAME);
    let [one, two, four] = [h, h / 2.0, h / 4.0].map(|h| end(h).last().clone());
    let (coarse, fine) = (apart(&one, &two), apart(&two, &four));
    assert!(fine > 1e-12, "{}: {fine:e}, at the level of rounding there is no order to measure", S::NAME);
    let run = setup().scheme(scheme).dt(h).run(2000).map_err(|e| e.to_string()).expect(S::NAME);
    let mut kept = 0;
    for invariant in Invariant::ALL {
        if let (Kept::Exact, Some(drift)) = (S::keeps(invariant), run.drift(invariant)) {
            let size = drift.start().abs().max(1.0);
            assert!(drift.max_abs() < 2e-12 * size, "{}: {invariant} {:e}", S::NAME, drift.max_abs());
            kept += 1;
        }
    }
    assert!(kept > 0, "{}: nothing to keep", S::NAME);
    (S::NAME, S::ORDER, (coarse / fine).log2())
}

#[test]
fn one_law() {
    schemes!(measure, || Simulation::new(WELL, START).mass(1.7));
}

#[test]
fn a_law_with_masses() {
    schemes!(measure, || Simulation::new(WELL, START).masses([1.7, 0.6]));
}

#[test]
fn pairs_and_a_field() {
    schemes!(measure, || Simulation::scene(cluster().pairs(MORSE).field(WELL)));
}

#[test]
fn a_chain() {
    schemes!(measure, || Simulation::scene(line().chain(SPRING)));
}

#[test]
fn bonds_and_a_pin() {
    schemes!(measure, || Simulation::scene(
        cluster().body(0.8, [1.4, 1.0], [0.0, 0.0]).bonds(MORSE, [(0, 1), (3, 2), (0, 3)]).pin(3)
    ));
}
