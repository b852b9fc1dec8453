//! What keeps the energy exactly keeps it across seams.

use dmech::prelude::*;

use crate::laws::*;

/// Every step of an energy-exact scheme keeps the energy, and every run crosses the seam.
macro_rules! keeps_its_energy {
    ($($test:ident: $law:expr, $d:literal, $power:literal, |$q:ident| $side:expr;)*) => {$(
        #[test]
        fn $test() {
            let law = $law;
            let side = |$q: [f64; $d]| -> bool { $side };
            for start in starts::<$d>(6) {
                for h in [0.013, 0.057] {
                    let simulation = || Simulation::new(law, start).dt(h).record_every(1);
                    let exact = simulation().scheme(DiscreteGradient).run(4000).expect("every step has a root");
                    let composed = simulation().scheme(Composed::order4(DiscreteGradient)).run(800).expect("likewise");
                    for run in [&exact, &composed] {
                        let energy = run.drift(Invariant::Energy).expect("the law is conservative").max_relative();
                        assert!(energy < 1e-13, "{law:?} from {start:?}, h = {h}: {energy:e}");
                    }
                    let kanatani = simulation().scheme(Kanatani).run(4000).expect("likewise");
                    let energy = kanatani.drift(Invariant::DiscreteEnergy).expect("likewise").max_relative();
                    assert!(energy < 1e-13, "{law:?} from {start:?}, h = {h}, Kanatani: {energy:e}");
                    let crossings = crossings(exact.states(), |state| side(state.q));
                    assert!(crossings > 3, "{law:?} from {start:?} crosses its seam {crossings} times");
                }
            }
        }
    )*};
}

for_each_seam!(keeps_its_energy);

/// 10⁵ bounces of a ball on a tent k|q| + m g q.
#[test]
fn a_ball_on_a_tent_keeps_its_energy_over_a_hundred_thousand_steps() {
    let run = Simulation::new(Tent { k: 3.0, g: 1.1 }, State::new([0.8], [0.3]))
        .scheme(DiscreteGradient)
        .dt(0.0137)
        .run(100_000)
        .expect("every step has a root");
    let energy = run.drift(Invariant::Energy).expect("the law is conservative").max_relative();
    assert!(energy < 1e-13, "{energy:e}");
}

/// What these laws are said to be.
#[test]
fn no_law_with_a_choice_is_called_linear() {
    fn says<L: Derivation>(law: &L) -> &'static str {
        law.derivation()
    }
    let kinked = [says(&Tent { k: 3.0, g: 1.1 }), says(&Kinked { k: 0.7 }), says(&Ramps { k: 0.7 })];
    for text in kinked.into_iter().chain([says(&Manhattan { k: 0.8 }), says(&Chord { k: 0.8 })]) {
        assert!(!text.contains("linear:") && text.contains("piecewise:"), "{text}");
    }
    let coupled = says(&Larger { a: 1.0, b: 2.0 });
    assert!(!coupled.contains("do not interact"), "{coupled}");
    assert!(says(&Manhattan { k: 0.8 }).contains("do not interact"));
    const { assert!(!<Tent as Potential<1>>::LINEAR && <Tent as Potential<1>>::PIECEWISE) };
}

/// A contact that is open at both ends is not there.
#[test]
fn an_open_contact_is_exactly_nothing() {
    let (hertz, soft) = (Hertz { k: 50.0, g: 0.0 }, Soft { k: 50.0, g: 0.0 });
    for (a, b) in [(0.3, 1.2), (2.0, 0.1), (1e-300, 5.0), (0.0, 0.7), (0.0, 0.0), (3.0, 3.0)] {
        assert_eq!((hertz.gradient([a]), soft.gradient([a])), ([0.0], [0.0]));
        assert_eq!((hertz.discrete_gradient([a], [b]), soft.discrete_gradient([a], [b])), ([0.0], [0.0]), "{a} {b}");
        assert_eq!(hertz.discrete_gradient_jacobian([a], [b]), [[0.0]], "{a} {b}");
        assert_eq!(soft.discrete_gradient_jacobian([a], [b]), [[0.0]], "{a} {b}");
        assert_eq!((hertz.hessian([a]), soft.hessian([a])), ([[0.0]], [[0.0]]), "{a} {b}");
    }
}

/// In a chain of contacts overlaps fall to the smallest numbers, and squares of them are lost.
#[test]
fn contacts_are_finite_at_any_overlap() {
    let (hertz, soft) = (Hertz { k: 50.0, g: 0.0 }, Soft { k: 50.0, g: 0.0 });
    let sizes = || (0..330).flat_map(|i| [1.0, 1.5, 7.0].map(|f| f * 10f64.powi(-i)));
    for (a, b) in sizes().flat_map(|a| sizes().step_by(3).map(move |b| (a, b))) {
        for (a, b) in [(-a, -b), (a, -b), (-a, b)] {
            let secants = [hertz.discrete_gradient([a], [b]), soft.discrete_gradient([a], [b])];
            let hertz = [hertz.discrete_gradient_jacobian([a], [b]), hertz.hessian([a])];
            let soft = [soft.discrete_gradient_jacobian([a], [b]), soft.hessian([a])];
            let all = secants.into_iter().chain(hertz.into_iter().chain(soft).map(|[row]| row));
            assert!(all.clone().flatten().all(f64::is_finite), "{a:e} {b:e}: {:?}", all.collect::<Vec<_>>());
        }
    }
}

/// Powers that vanish, at rest where they do.
#[test]
fn a_body_rests_in_the_minimum_of_a_power() {
    macro_rules! rests {
        ($($name:ident: $at:ty, |$q:ident| $energy:expr, $d:literal;)*) => {$({
            #[derive(Clone, Copy, Debug)]
            struct $name;
            #[dmech::law]
            impl $name {
                #[potential]
                fn energy(&self, $q: $at) -> f64 {
                    $energy
                }
            }
            let rest = State::new([0.0; $d], [0.0; $d]);
            assert_eq!($name.gradient([0.0; $d]), [0.0; $d]);
            let simulation = || Simulation::new($name, rest).dt(0.01);
            let run = simulation().scheme(DiscreteGradient).run(10).expect("it can start");
            assert_eq!(run.last().q, rest.q);
            assert_eq!(simulation().scheme(Leapfrog).run(10).expect("it can start").last().q, rest.q);
            assert_eq!(simulation().scheme(Implicit).run(10).expect("it can start").last().q, rest.q);
            // And it swings there.
            let start = State::new([0.3; $d], [0.1; $d]);
            let run = Simulation::new($name, start).scheme(DiscreteGradient).dt(0.01).run(1000).expect("it can start");
            assert!(run.drift(Invariant::Energy).expect("conservative").max_relative() < 1e-13);
        })*};
    }
    rests! {
        Abs: f64, |q| q.abs().powf(2.5), 1;
        Squared: f64, |q| (q * q).powf(1.25), 1;
        Cubic: f64, |q| q.cbrt() * q, 1;
        Steep: f64, |q| q.abs().powf(1.5), 1;
        Round: [f64; 2], |q| (q[0] * q[0] + q[1] * q[1]).powf(1.25), 2;
        RoundCube: [f64; 2], |q| q[0].hypot(q[1]).powi(3), 2;
    }
}
