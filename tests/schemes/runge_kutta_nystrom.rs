//! The explicit step of order 12: its order on scenes, what it keeps, and what it costs. Its order on laws is measured with 31 digits
//! among the `stages`.

use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};
use dmech::{Kept, extend::Method};

use dmech_tests::laws::*;
use dmech_tests::measured::BOWL;
use dmech_tests::motion::*;

use super::bodies::{BOND, SPRING, line, stars};

const SCHEME: RungeKuttaNystrom = RungeKuttaNystrom::order12();

/// The slope of ln(error) over ln(step), by least squares over errors between 10⁻³ and 3·10⁻¹³.
fn slope_of(what: &str, ladder: &[u64], error: impl Fn(u64) -> f64) -> f64 {
    let errors = ladder.iter().map(|&steps| (steps as f64, error(steps)));
    let clear: Vec<_> = errors.filter(|(_, error)| (3e-13..1e-3).contains(error)).collect();
    let range = clear.iter().fold([f64::INFINITY, 0.0_f64], |[least, most], &(_, e)| [least.min(e), most.max(e)]);
    println!("{what}: {clear:?}");
    assert!(clear.len() >= 4 && range[1] > 1e3 * range[0], "{what}: {clear:?}");
    let points: Vec<_> = clear.iter().map(|(steps, error)| (steps.ln(), error.ln())).collect();
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let rise: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    -rise / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

#[test]
fn the_order_is_twelve_on_scenes() {
    fn check<L, const D: usize>(what: &str, scene: Scene<D, (), L>, span: f64, ladder: &[u64])
    where
        L: Term<D, ()> + Clone,
        RungeKuttaNystrom: Scheme<SceneSystem<D, L::Ready>>,
        Nystrom<coefficients::Blanes8S19, 19>: Scheme<SceneSystem<D, L::Ready>>,
    {
        let motion = |steps: u64| Simulation::scene(scene.clone()).dt(span / steps as f64);
        let places = |run: Run<SceneState<D>>| run.last().q.concat();
        let exact = places(motion(2000).scheme(Nystrom::order8()).run(2000).expect("smooth"));
        let order = slope_of(what, ladder, |steps| {
            let end = places(motion(steps).scheme(SCHEME).run(steps).expect("smooth"));
            end.iter().zip(&exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
        });
        println!("{order:.2}");
        assert!((order - 12.0).abs() < 1.0, "{order} on {what}");
    }
    check("a chain", line().chain(SPRING), 4.0, &[3, 4, 5, 6, 7, 8, 9, 10]);
    check("pairs in a field", stars().pairs(BOND).field(BOWL), 2.0, &[14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 36]);
    // A body that is driven is where its path is at every stage.
    let driven = line().drive(0, |t: f64| ([0.2 * t.sin()], [0.2 * t.cos()]));
    check("a driven chain", driven.chain(SPRING), 4.0, &[3, 4, 5, 6, 7, 8, 9, 10]);
}

/// Work is that of the mean force, and momentum that of the start; energy and angular momentum are not said to be kept.
#[test]
fn work_and_momentum_are_exact_and_no_more_is_said() {
    let run = Simulation::scene(stars().pairs(BOND)).scheme(SCHEME).dt(0.3).run(3000).unwrap();
    for (invariant, kept) in [
        (Invariant::WorkEnergy, Kept::Exact),
        (Invariant::LinearMomentum, Kept::Exact),
        (Invariant::Energy, Kept::No),
        (Invariant::AngularMomentum, Kept::No),
    ] {
        let moved = run.drift(invariant).unwrap().max_abs();
        println!("{invariant}: {moved:e}");
        assert_eq!(RungeKuttaNystrom::keeps(invariant), kept);
        // Steps as long as this show what is not kept.
        assert_eq!(moved < 1e-12, kept == Kept::Exact, "{invariant}: {moved:e}");
    }
}

/// Forward and back it does not return to where it came from: it is not symmetric.
#[test]
fn the_way_back_is_another() {
    let there = Simulation::new(HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3])).scheme(SCHEME).dt(2.0);
    let end = there.run(10).unwrap().last().reversed();
    let back = Simulation::new(HenonHeiles::new(), end).scheme(SCHEME).dt(2.0).run(10).unwrap().last().q;
    let off = distance(back, [0.2, -0.1]);
    assert!((1e-9..1e-2).contains(&off), "{off:e}");
    const { assert!(!RungeKuttaNystrom::SYMMETRIC) }
}

/// Steps are so long that the next terms of the error show: it falls somewhat faster than the tolerance. Over ten revolutions: the
/// error of the energy is of one sense, and that of the position grows like their square.
#[test]
fn the_error_follows_the_tolerance() {
    let law = dmech::models::Kepler { gm: 1.3 };
    for (e, most) in [(0.7, 0.2), (0.9, 2.5), (0.97, 120.0)] {
        let (start, revolutions) = (law.pericentre(1.0, e), 10.0);
        let motion = Simulation::new(law, start).scheme(SCHEME).record_every(u64::MAX);
        let shares = [1e-7, 1e-8, 1e-9, 1e-10, 1e-11].map(|tolerance| {
            let run = motion.clone().adaptive(tolerance).run_until(revolutions * law.period(1.0)).unwrap();
            distance(run.last().q, start.q) / revolutions / tolerance
        });
        println!("e = {e}: {shares:.3?} tolerances per revolution");
        assert!(shares.iter().all(|share| (0.02..most).contains(share)), "e = {e}: {shares:?}");
        assert!(shares.windows(2).all(|two| two[1] < 1.1 * two[0]), "e = {e}: {shares:?}");
    }
}

/// Greenspan's planet with seventeen forces a step, and fewer forces than Gauss's method for twelve digits.
#[test]
fn twelve_digits_cost_fewer_forces_than_of_gauss() {
    let (law, end) = (Kepler::new(), 50.0);
    let start = State::new([0.8, 0.1], [-0.2, 1.1]);
    let motion = || Simulation::new(law, start).mass(MASS).record_every(u64::MAX);
    let exact = motion().scheme(Gauss::order16()).dt(0.02).run_until(end).unwrap().last().q;
    let cheapest = |of: &dyn Fn(f64) -> Run<State<2>>| {
        let runs = (0..16).map(|k| of(1e-6 * 10_f64.powf(-0.5 * f64::from(k))));
        let good = runs.filter(|run| distance(run.last().q, exact) < 1e-12);
        good.map(|run| run.report().evaluations()).min().expect("one that is so near")
    };
    let explicit = cheapest(&|tolerance| motion().scheme(SCHEME).adaptive(tolerance).run_until(end).unwrap());
    let gauss = cheapest(&|tolerance| motion().scheme(Gauss::order16()).adaptive(tolerance).run_until(end).unwrap());
    println!("{explicit} forces, {gauss} by Gauss's method");
    assert!(10 * explicit < 9 * gauss, "{explicit} and {gauss}");
    let steps = motion().scheme(SCHEME).dt(0.1).run(100).unwrap();
    assert_eq!(steps.report().evaluations(), 1700);
}
