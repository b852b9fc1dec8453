//! The equation of the implicit steps: solved to round-off, on the right branch, in the expected work.

use crate::common::{Coupled, Kepler, Pendulum, SUN, SUN_BY_COMPONENTS, Spring, greenspan_orbit};
use approx::abs_diff_eq;
use dmech_core::Field;
use dmech_core::newton::{Correction, Equation, Increment, NotConverged, dense, drive, linear, linear_discrete, once};
use dmech_core::prelude::*;

/// drift − frozen − g G(q + Δ) − Δ, relative to the terms in it.
fn residual<const D: usize>(e: &Equation<D, f64>, found: &Increment<D, f64>, gradient: [f64; D]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..D {
        let terms = [e.drift[i], -e.frozen[i], -e.g * gradient[i], -found.delta[i]];
        let scale = terms.iter().map(|x| x.abs()).sum::<f64>() + e.q[i].abs() * e.g;
        worst = worst.max(terms.iter().sum::<f64>().abs() / scale);
    }
    worst
}

/// An equation as the schemes make it, with a guess that is off by `miss`.
fn equation<const D: usize>(q: [f64; D], a: [f64; D], drift: [f64; D], g: f64, miss: f64) -> Equation<D, f64> {
    let guess = core::array::from_fn(|i| drift[i] + miss * (1.0 - 0.3 * i as f64));
    Equation { a, frozen: drift.map(|x| 0.1 * x), guess, ..Equation::new(q, drift, g) }
}

#[test]
fn solutions_satisfy_the_equation_to_round_off() {
    let law = Coupled { k: [1.1, 2.3, 0.7], lambda: 0.4 };
    let mut tried = 0;
    for g in [1e-6, 1e-3, 0.1, 2.0] {
        for miss in [0.0, 1e-8, 1e-3, 0.1] {
            let e = equation([0.5, -0.3, 0.8], [0.45, -0.32, 0.86], [0.05, 0.02, -0.06], g, miss);
            let found = law.field(1.0, 0.0).implicit_increment(&e).unwrap();
            let gradient = law.gradient(e.end(found.delta));
            assert!(residual(&e, &found, gradient) < 4.0 * f64::EPSILON, "{g} {miss}: {found:?}");
            let found = law.field(1.0, 0.0).discrete_increment(&e).unwrap();
            let gradient = law.discrete_gradient(e.a, e.end(found.delta));
            assert!(residual(&e, &found, gradient) < 4.0 * f64::EPSILON, "{g} {miss}: {found:?}");
            tried += 1;
        }
    }
    assert_eq!(tried, 16);
}

/// One scalar unknown or two components: the same root, with the force to a few ulp.
#[test]
fn one_unknown_gives_what_two_components_give() {
    // Beyond g = 0.038 the trapezoid has no root here.
    for g in [1e-7, 1e-4, 1e-2, 0.03] {
        for miss in [0.0, 1e-9, 1e-5, 1e-2, 0.3] {
            let e = equation([0.5, -0.3], [0.53, -0.42], [0.07, 0.11], g, miss);
            let pairs = [
                (
                    SUN.field(1.0, 0.0).implicit_increment(&e).unwrap(),
                    SUN_BY_COMPONENTS.field(1.0, 0.0).implicit_increment(&e).unwrap(),
                ),
                (
                    SUN.field(1.0, 0.0).discrete_increment(&e).unwrap(),
                    SUN_BY_COMPONENTS.field(1.0, 0.0).discrete_increment(&e).unwrap(),
                ),
            ];
            for (one, two) in pairs {
                let scale = two.gradient[0].hypot(two.gradient[1]);
                for i in 0..2 {
                    let off = (one.gradient[i] - two.gradient[i]).abs() / scale;
                    assert!(off < 8.0 * f64::EPSILON, "g = {g}, miss = {miss}: {off:e}");
                }
            }
        }
    }
}

/// Trapezoid towards a centre: r + gk/r² = w has two roots. The one wanted is that which grows out of r = w at g = 0,
/// wherever the iteration starts.
#[test]
fn of_several_roots_the_one_continuous_with_a_short_step_is_taken() {
    let (g, w) = (0.1, 1.5);
    // The larger root of r³ − w r² + g = 0, by bisection beyond the fold at r = 2w/3.
    let (mut low, mut high) = (2.0 * w / 3.0, w);
    for _ in 0..200 {
        let r = 0.5 * (low + high);
        if r * r * (w - r) > g { low = r } else { high = r }
    }
    for start in [1.45, 1.2, 0.6, 0.3, 0.28, 0.1, 1e-3, 20.0] {
        let e = Equation { guess: [start - 1.7, 0.0], ..Equation::new([1.7, 0.0], [w - 1.7, 0.0], g) };
        let r = e.end(SUN.field(1.0, 0.0).implicit_increment(&e).unwrap().delta)[0];
        assert!(abs_diff_eq!(r, low, epsilon = 1e-15), "from {start}: {r}, not {low}");
    }
    // By components, from starts off the root by more than the step.
    for start in [1.45, 1.2, 0.1, 1e-3, 20.0] {
        let e = Equation { guess: [start - 1.7, 0.0], ..Equation::new([1.7, 0.0], [w - 1.7, 0.0], g) };
        let r = e.end(SUN_BY_COMPONENTS.field(1.0, 0.0).implicit_increment(&e).unwrap().delta)[0];
        assert!(abs_diff_eq!(r, low, epsilon = 1e-15), "from {start}: {r}, not {low}");
    }
}

/// Beyond the fold, w < 3 (gk/4)^⅓, there is no root: a typed error, within the allowed work.
#[test]
fn where_no_root_exists_the_work_is_bounded() {
    for limit in [1, 7, 50, 200] {
        let e = Equation { max_iterations: limit, ..Equation::new([1.0, 0.0], [-0.2, 0.0], 0.5) };
        for lost in [
            SUN.field(1.0, 0.0).implicit_increment(&e).unwrap_err(),
            SUN_BY_COMPONENTS.field(1.0, 0.0).implicit_increment(&e).unwrap_err(),
        ] {
            assert!(lost.iterations <= u64::from(limit) + 12, "{lost:?} of {limit}");
            assert!(lost.residual > 1e-6, "{lost:?}");
        }
    }
}

#[test]
fn a_linear_step_is_one_correction() {
    let e = equation([0.5, -0.3, 0.1], [0.53, -0.42, 0.0], [0.07, 0.11, -0.2], 0.3, 5.0);
    let mut calls = 0;
    let found = once(&e, |e, delta, b| {
        calls += 1;
        let gradient = b.map(|x| 2.5 * x);
        let pivot = 1.0 + 2.5 * e.g;
        let change = core::array::from_fn(|i| (e.increment(gradient)[i] - delta[i]) / pivot);
        (dmech_core::newton::Correction::in_parts(change, gradient, change.map(|x| 2.5 * x)), [pivot])
    })
    .unwrap();
    assert_eq!((calls, found.evaluations, found.iterations), (1, 1, 0));
    assert!(residual(&e, &found, e.end(found.delta).map(|x| 2.5 * x)) < 4.0 * f64::EPSILON);
    let general = dense(&e, |b| (b.map(|x| 2.5 * x), Potential::<3>::hessian(&Spring { k: 2.5 }, b))).unwrap();
    assert!((0..3).all(|i| (general.delta[i] - found.delta[i]).abs() < 1e-16));
}

/// Of a hill the one root of a step that is too long is refused, on a ridge and on a round one; a matrix whose rows masses divide,
/// and whose first row is the smaller, is one of a spring.
#[test]
fn a_linear_step_by_hand_is_refused_where_it_does_not_continue_a_shorter_one() {
    let e = |g| Equation::new([0.5, -0.3], [0.07, 0.11], g);
    let tried: [([[f64; 2]; 2], f64); 4] = [
        // The curvature downhill; infinite steps are taken where there is none.
        ([[-2.0, 0.0], [0.0, -2.0]], 2.0),
        ([[1.0, 3.0], [3.0, -0.5]], f64::sqrt(9.5625) - 0.25),
        ([[0.0, -1.5], [-1.5, 0.0]], 1.5),
        ([[1.0 / 7.0, 0.9 / 7.0], [0.9 / 0.01, 1.0 / 0.01]], 0.0),
    ];
    for (jacobian, steepest) in tried {
        for part in [0.5, 0.999, 1.001, 3.0, 1e3] {
            let g = if steepest > 0.0 { part / steepest } else { part };
            let slope = |x: [f64; 2]| jacobian.map(|row| row[0] * x[0] + row[1] * x[1]);
            let taken = part < 1.0 || steepest == 0.0;
            let at_end = linear(&e(g), |b| (slope(b), jacobian));
            let between = linear_discrete(&e(g), |a, b| (slope([b[0] - a[0], b[1] - a[1]]), jacobian));
            for found in [at_end, between] {
                assert_eq!(found.is_ok(), taken, "{jacobian:?} {part}: {found:?}");
                assert!(taken || found.unwrap_err() == NotConverged::NOT_CONTINUED);
            }
        }
    }
}

/// Resolved steps cost one evaluation for one unknown and at most two in general; from the previous position, more.
#[test]
fn a_good_prediction_saves_evaluations() {
    fn per_step<L: Law<2>, S: Scheme<Particle<L, 2>>>(law: L, scheme: S) -> f64 {
        let mut stepper = Simulation::new(law, greenspan_orbit()).scheme(scheme).dt(1e-3).stepper().unwrap();
        for _ in 0..10_000 {
            stepper.step().unwrap();
        }
        stepper.evaluations() as f64 / 10_000.0
    }
    for cost in [per_step(SUN, Implicit), per_step(SUN, DiscreteGradient), per_step(SUN, Kanatani)] {
        assert!(cost < 1.001, "{cost}");
    }
    for cost in [
        per_step(SUN_BY_COMPONENTS, Implicit),
        per_step(SUN_BY_COMPONENTS, DiscreteGradient),
        per_step(SUN_BY_COMPONENTS, Kanatani),
    ] {
        assert!(cost < 2.001, "{cost}");
    }
    let from_previous = per_step(SUN, DiscreteGradient.with(Newton::from_previous()));
    assert!(from_previous > 1.5, "{from_previous}");
}

/// The guess changes the work, not the motion.
#[test]
fn the_papers_guess_gives_the_same_motion() {
    fn end<S: Scheme<Particle<Pendulum, 1>>>(scheme: S) -> f64 {
        Simulation::new(Pendulum { k: 1.3 }, State::new([2.0], [0.4]))
            .scheme(scheme)
            .dt(0.05)
            .run(2000)
            .unwrap()
            .last()
            .q[0]
    }
    let previous = Newton::from_previous();
    for (name, x, y) in [
        ("Implicit", end(Implicit), end(Implicit.with(previous))),
        ("DiscreteGradient", end(DiscreteGradient), end(DiscreteGradient.with(previous))),
        ("Kanatani", end(Kanatani), end(Kanatani.with(previous))),
    ] {
        assert!(abs_diff_eq!(x, y, epsilon = 1e-11), "{name}: {x} {y}");
    }
}

/// A narrower scalar: the same code keeps the energy to its own round-off.
#[test]
fn single_precision_keeps_the_energy_to_its_own_round_off() {
    let start: State<2, f32> = State::of([0.5, 0.0], [0.0, 1.63]);
    for run in [
        Simulation::new(Kepler::<true> { k: 1.0 }, start).scheme(DiscreteGradient).dt(0.02).run(20_000).unwrap(),
        Simulation::new(Kepler::<false> { k: 1.0 }, start).scheme(DiscreteGradient).dt(0.02).run(20_000).unwrap(),
    ] {
        let drift = run.drift(Invariant::Energy).unwrap().max_relative();
        println!("{drift:e}");
        assert!(drift < 1e-5 && drift > 1e-9, "{drift:e}");
    }
}

/// One correction is enough where what it neglects, |G| (|δ|/|Δ|)² as far as a force is known to vary, is below ε/64 of the
/// force; with a first correction of twice that size there are two.
#[test]
fn a_single_correction_is_trusted_up_to_a_sixty_fourth_of_rounding() {
    let single = (f64::EPSILON / 64.0).sqrt();
    for (miss, corrections) in [(0.5 * single, 1), (2.0 * single, 2), (8.0 * single, 2), (64.0 * single, 2)] {
        // G = b², from a guess that is off by a part of the step.
        let solved = |guess: f64| {
            let e = Equation { guess: [guess], ..Equation::new([0.0], [1.0], 0.5) };
            drive(&e, |e, [delta], [b]| {
                let change = (e.increment([b * b])[0] - delta) / (1.0 + 2.0 * e.g * b);
                Correction::in_parts([change], [b * b], [2.0 * b * change])
            })
            .unwrap()
        };
        let root = 3.0_f64.sqrt() - 1.0;
        let found = solved(root * (1.0 + miss));
        assert_eq!(found.iterations, corrections, "off by {:.1} of the limit", miss / single);
        assert!((found.gradient[0] / (root * root) - 1.0).abs() < 8.0 * f64::EPSILON);
    }
}

/// Corrections of a force with bends, from a guess: the increment, how many, and G as it comes back.
fn solved(guess: f64, (g, drift): (f64, f64), force: impl Fn(f64) -> [f64; 2]) -> Increment<1, f64> {
    let e = Equation { guess: [guess], piecewise: true, ..Equation::new([0.0], [drift], g) };
    let correct = |e: &Equation<1, f64>, [delta]: [f64; 1], [b]: [f64; 1]| {
        let [slope, turn] = force(b);
        let change = (e.increment([slope])[0] - delta) / (1.0 + e.g * turn);
        Correction::in_parts([change], [slope], [turn * change])
    };
    drive(&e, correct).unwrap()
}

/// Past a bend the second correction may be as large as the first; it is made, and no more than that.
#[test]
fn a_bend_between_guess_and_root_costs_a_correction() {
    let sizes = || (0..14).map(|k| 10f64.powi(-k - 1));
    for (ahead, behind) in sizes().flat_map(|ahead| sizes().map(move |behind| (ahead, behind))) {
        let bend = 1.0 - behind;
        let force = |b: f64| if b > bend { [10.0 * (b - bend), 10.0] } else { [0.0, 0.0] };
        let found = solved(bend - ahead, (0.5, 1.0), force);
        let what = format!("guess {ahead:e} before the bend, root {behind:e}/6 behind: {found:?}");
        let ([delta], [gradient]) = (found.delta, found.gradient);
        assert!((delta + 0.5 * gradient - 1.0).abs() <= f64::EPSILON, "{what}");
        assert!((gradient - force(delta)[0]).abs() <= 10.0 * f64::EPSILON, "{what}");
        assert!(found.iterations <= 5 && found.evaluations == found.iterations, "{what}");
    }
}

/// Over a row of bends, each twice as sharp as the one before, corrections go from bend to bend, none of them much
/// shorter than the last; the step is not approached by shorter ones.
#[test]
fn a_row_of_bends_is_followed_to_its_end() {
    let force = |b: f64| {
        let bends = (0..60).map(f64::from).filter(|&bend| b > bend);
        bends.fold([0.0; 2], |[slope, turn], bend| [slope + bend.exp2() * (b - bend), turn + bend.exp2()])
    };
    for guess in [3.4, 11.4, 27.4] {
        let (mut b, mut corrections) = (guess, 0);
        loop {
            let [slope, turn] = force(b);
            let change = (1.0 - slope - b) / (1.0 + turn);
            (b, corrections) = (b + change, corrections + 1);
            if change.abs() < 1e-12 {
                break;
            }
        }
        let found = solved(guess, (1.0, 1.0), force);
        println!("from {guess}: {corrections} corrections, {found:?}");
        assert!((found.delta[0] - 0.5).abs() <= f64::EPSILON, "{found:?}");
        assert!(found.iterations.abs_diff(corrections) <= 1, "{corrections} corrections from {guess}: {found:?}");
    }
}
