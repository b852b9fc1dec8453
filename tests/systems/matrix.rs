//! Schemes × systems: the order of each is the declared one, and what is exact is kept. A new scheme is a row of `schemes!`,
//! a new system a test.

use dmech::Kept;
use dmech::extend::Setup;
use dmech::prelude::*;

use super::setups::*;

/// A row for each scheme.
macro_rules! schemes {
    ($setup:expr) => {{
        let mut cells = 0;
        for (name, order, measured) in [
            measure(&$setup, Explicit),
            measure(&$setup, Leapfrog),
            measure(&$setup, Boris),
            measure(&$setup, CompensatedLeapfrog),
            measure(&$setup, Implicit),
            measure(&$setup, DiscreteGradient),
            measure(&$setup, Kanatani),
            measure(&$setup, Composed::order4(Leapfrog)),
            measure(&$setup, Composed::order4(Boris)),
            measure(&$setup, Composed::order4(Implicit)),
            measure(&$setup, Composed::order4(DiscreteGradient)),
            measure(&$setup, Composed::order6(Leapfrog)),
            measure(&$setup, Composed::order6(Implicit)),
            measure(&$setup, Composed::order6(DiscreteGradient)),
            measure(&$setup, Nystrom::order4()),
            measure(&$setup, Nystrom::order6()),
            measure(&$setup, Relaxed::order6()),
            measure(&$setup, ForceGradient::order4()),
            measure(&$setup, ForceGradient::order6()),
            measure(&$setup, LineIntegral::order4()),
            measure(&$setup, LineIntegral::order6()),
        ] {
            println!("{name:<44} {order} {measured:.3}");
            // A high order has few steps between too long ones and rounding.
            assert!((measured - f64::from(order)).abs() < 0.07 * f64::from(order), "{name}: order {measured}");
            cells += 1;
        }
        assert_eq!(cells, 21);
    }};
}

/// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p at t = 2, h being halved as long as differences are clear of rounding and until
/// two powers in a row agree; and over a longer run what the scheme keeps exactly.
fn measure<L, X, S>(setup: &dyn Fn() -> Simulation<L, X>, scheme: S) -> (&'static str, u32, f64)
where
    X: Setup<L>,
    X::State: Places,
    S: Scheme<X::System>,
{
    let end = |h: f64| {
        let run = setup().scheme(scheme).dt(h).record_every(1_000_000).run_until(2.0);
        run.map(|run| run.last().clone()).map_err(|e| e.to_string()).expect(S::NAME)
    };
    let (mut h, mut powers, mut coarse) = (0.5, Vec::new(), f64::NAN);
    let mut last = end(h);
    while powers.len() < 14 {
        h *= 0.5;
        let now = end(h);
        let fine = apart(&last, &now);
        if fine < 2e-13 {
            break;
        }
        powers.push((coarse / fine).log2());
        if let [.., before, newest] = *powers
            && (before - newest).abs() < 0.1
            && (newest - f64::from(S::ORDER)).abs() < 0.03 * f64::from(S::ORDER)
        {
            break;
        }
        (coarse, last) = (fine, now);
    }
    let measured = powers.last().copied().unwrap_or(f64::NAN);
    let run = setup().scheme(scheme).dt(0.02).run(2000).map_err(|e| e.to_string()).expect(S::NAME);
    let mut kept = 0;
    for invariant in Invariant::ALL {
        if let (Kept::Exact, Some(drift)) = (S::keeps(invariant), run.drift(invariant)) {
            let size = drift.start().abs().max(1.0);
            assert!(drift.max_abs() < 1e-13 * size, "{}: {invariant} {:e}", S::NAME, drift.max_abs());
            kept += 1;
        }
    }
    assert!(kept > 0, "{}: nothing to keep", S::NAME);
    (S::NAME, S::ORDER, measured)
}

#[test]
fn one_law() {
    schemes!(|| Simulation::new(WELL, START).mass(1.7));
}

#[test]
fn a_law_with_masses() {
    schemes!(|| Simulation::new(WELL, START).masses([1.7, 0.6]));
}

#[test]
fn pairs_and_a_field() {
    schemes!(|| Simulation::scene(cluster().pairs(MORSE).field(WELL)));
}

#[test]
fn a_chain() {
    schemes!(|| Simulation::scene(line().chain(SPRING)));
}

#[test]
fn bonds_and_a_pin() {
    schemes!(|| Simulation::scene(
        cluster().body(0.8, [1.4, 1.0], [0.0, 0.0]).bonds(MORSE, [(0, 1), (3, 2), (0, 3)]).pin(3)
    ));
}
