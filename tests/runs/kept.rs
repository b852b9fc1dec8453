//! What a run says that it must keep.

use dmech::Kept;
use dmech::extend::{Field, Particle, Scheme};
use dmech::models::pairs::LennardJones;
use dmech::models::{DampedPendulum, DrivenPendulum, Kepler, Quartic, Wall};
use dmech::prelude::*;

/// What there is not is not kept, however well the scheme keeps it of other laws: alone, in a scene, before the first step.
#[test]
fn nothing_is_claimed_of_what_there_is_not() -> Result<(), Box<dyn std::error::Error>> {
    fn consistent<X>(run: &Run<X>, energy: Kept) {
        assert_eq!(run.kept(Invariant::Energy), energy, "{run}");
        for invariant in Invariant::ALL {
            assert!(run.drift(invariant).is_some() || run.kept(invariant) == Kept::No, "{invariant}: {run}");
            assert_eq!(run.report().kept(invariant), run.kept(invariant));
        }
    }
    let drag = DampedPendulum { k: 1.7, alpha: 0.2 };
    let driven = DrivenPendulum { k: 1.7, alpha: 0.1, amplitude: 0.2, omega: 2.1 };
    let start = State::new([0.4], [0.3]);
    consistent(&Simulation::new(drag, start).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    consistent(&Simulation::new(driven, start).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    let planet = Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63])).scheme(DiscreteGradient);
    consistent(&planet.clone().dt(0.01).run(10)?, Kept::Exact);
    consistent(&planet.clone().adaptive(1e-3).run(10)?, Kept::Exact);
    consistent(planet.dt(0.0).run(10).unwrap_err().run(), Kept::No);
    let scene = || Scene::<1>::new().body(1.3, [0.4], [0.3]);
    consistent(&Simulation::scene(scene().field(drag)).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    Ok(())
}

/// A motion that leaps over a wall to where there is no potential has not gone well, whoever asks for forces alone: in a row of steps, of a
/// member, in a scene, stopped; and the run is there up to its end.
#[test]
fn a_motion_may_leave_its_potential() {
    #[derive(Clone, Copy, Debug)]
    struct Logarithm {
        f: f64,
        a: f64,
    }
    #[dmech::law]
    impl Logarithm {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            self.f * q - self.a * q.ln()
        }
    }
    const LAW: Logarithm = Logarithm { f: 0.1, a: 0.5 };
    let start = State::new([1.0], [-3.0]);
    macro_rules! leaves {
        ($($scheme:expr),*) => {$(
            let failed = Simulation::new(LAW, start).scheme($scheme).dt(0.5).run(30).unwrap_err();
            assert_eq!(failed.cause(), Error::LeftDomain { time: 15.0 }, "{failed}");
            let run = failed.run();
            assert!(run.states().len() == 31 && run.last().q[0] < 0.0 && run.steps() == 30, "{run}");
            let members = Ensemble::of(3).law(|_| LAW).start(|_| start).scheme($scheme).dt(0.5).run(30).unwrap();
            let causes: Vec<_> = members.members().map(|member| member.unwrap_err().cause()).collect();
            assert_eq!(causes, [Error::LeftDomain { time: 15.0 }; 3]);
        )*};
    }
    leaves!(Explicit, Leapfrog, Nystrom::order6());
    let scene = Scene::<1>::new().body(1.0, [1.0], [-3.0]).field(LAW);
    let failed = Simulation::scene(scene).scheme(Leapfrog).dt(0.5).run(30).unwrap_err();
    assert_eq!(failed.cause(), Error::LeftDomain { time: 15.0 });
    let short = Simulation::new(LAW, start).scheme(Leapfrog).dt(0.05).run(300).unwrap();
    assert!(short.states().iter().all(|state| state.q[0] > 0.0));
}

/// What is bounded is so between steps that eight stages see a jump in, as through the centre of an attraction.
#[test]
fn nothing_is_bounded_over_rough_steps() {
    let fall =
        Simulation::new(Kepler { gm: 1.0 }, State::new([1.0, 0.0], [0.0, 0.0])).scheme(Gauss::order16()).dt(0.01);
    let run = fall.run_until(3.0).unwrap();
    assert!(run.report().rough() > 0 && run.drift(Invariant::Energy).unwrap().max_relative() > 1.0);
    assert_eq!(run.kept(Invariant::Energy), Kept::BetweenSeams);
}

/// Steps over jumps that are small beside the force are seen, but for those at their very ends; and none where nothing jumps.
#[test]
fn rough_steps_are_those_over_jumps() {
    #[derive(Clone, Copy, Debug)]
    struct Switched {
        k: f64,
        on: f64,
        push: f64,
    }
    #[dmech::law]
    impl Switched {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            0.5 * self.k * q * q
        }
        #[force]
        fn thrust(&self, q: f64, t: f64) -> f64 {
            if t > self.on { self.push } else { 0.0 * q }
        }
    }
    fn rough<S: Scheme<Particle<Switched, 1>>>(scheme: S, push: f64) -> usize {
        let seen = (0..50).filter(|&k| {
            let law = Switched { k: 1.0, on: 3.0 + 0.0377 * f64::from(k), push };
            let run = Simulation::new(law, State::new([1.0], [0.0])).scheme(scheme).dt(0.3).run_until(9.0).unwrap();
            assert!(run.report().rough() <= 1);
            run.report().rough() == 1
        });
        seen.count()
    }
    for push in [1.0, 0.1, 1e-2, 1e-3, 1e-4] {
        assert!(rough(Gauss::order16(), push) > 42, "{push}");
        assert!(rough(LineIntegral::order8(), push) > 42, "{push}");
    }
    assert_eq!([rough(Gauss::order16(), 1e-10), rough(Gauss::order16(), 0.0)], [0, 0]);
    let mut smooth = 0;
    for dt in [0.01, 0.03, 0.1, 0.2, 0.3] {
        for e in [0.0, 0.1, 0.3, 0.5_f64] {
            let start = State::new([1.0 + e, 0.0], [0.0, ((1.0 - e) / (1.0 + e)).sqrt()]);
            let orbit = Simulation::new(Kepler { gm: 1.0 }, start).scheme(Gauss::order16()).dt(dt).run_until(30.0);
            let bob = State::new([0.3 + 5.0 * e], [0.1]);
            let swing = Simulation::new(Quartic { beta: 0.3 }, bob).scheme(Gauss::order16()).dt(dt).run_until(30.0);
            for report in [orbit.unwrap().report(), swing.unwrap().report()] {
                assert_eq!(report.rough(), 0, "e = {e}: {report}");
                smooth += report.steps();
            }
        }
    }
    assert!(smooth > 20_000);
    // A smooth force in steps that are far too long: of more than these the polynomials do fall off.
    let start = State::new([1.6, 0.0], [0.0, 0.5]);
    let orbit = Simulation::new(Kepler { gm: 1.0 }, start).scheme(Gauss::order16()).dt(0.8).run_until(60.0).unwrap();
    assert!(orbit.report().rough() >= 8, "{}", orbit.report());
}

/// A law by hand may be central and rub: the angular momentum is kept by what it is central of, and not by the force beside it.
#[test]
fn a_central_law_with_a_force_keeps_no_angular_momentum() {
    #[derive(Clone, Copy, Debug)]
    struct Rubbed {
        k: f64,
        c: f64,
    }
    impl Law<2> for Rubbed {
        type Field<'a> = Rubbed;
        fn field(&self, _: f64, _: f64) -> Rubbed {
            *self
        }
    }
    impl Potential<2> for Rubbed {
        const CENTRAL: bool = true;
        fn potential(&self, [x, y]: [f64; 2]) -> f64 {
            0.5 * self.k * (x * x + y * y)
        }
        fn gradient(&self, q: [f64; 2]) -> [f64; 2] {
            q.map(|x| self.k * x)
        }
        fn hessian(&self, _: [f64; 2]) -> [[f64; 2]; 2] {
            [[self.k, 0.0], [0.0, self.k]]
        }
        fn discrete_gradient(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
            core::array::from_fn(|i| 0.5 * self.k * (a[i] + b[i]))
        }
        fn discrete_gradient_jacobian(&self, _: [f64; 2], _: [f64; 2]) -> [[f64; 2]; 2] {
            [[0.5 * self.k, 0.0], [0.0, 0.5 * self.k]]
        }
    }
    impl Field<2> for Rubbed {
        const FORCED: bool = true;
        fn force(&self, _: [f64; 2], v: [f64; 2], _: f64) -> [f64; 2] {
            v.map(|v| -self.c * v)
        }
        fn force_dv(&self, _: [f64; 2], _: [f64; 2], _: f64) -> [[f64; 2]; 2] {
            [[-self.c, 0.0], [0.0, -self.c]]
        }
    }
    let (law, start) = (Rubbed { k: 1.3, c: 0.2 }, State::new([1.0, 0.0], [0.0, 0.7]));
    let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(0.1).run(50).unwrap();
    assert_eq!((run.drift(Invariant::AngularMomentum), run.kept(Invariant::AngularMomentum)), (None, Kept::No));
    let scene = Scene::<2>::new().body(1.0, start.q, start.v).field(law);
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.1).run(50).unwrap();
    assert_eq!((run.drift(Invariant::AngularMomentum), run.kept(Invariant::AngularMomentum)), (None, Kept::No));
}

/// Where the law bends or jumps a bounded energy walks, and the report says so: of a choice, of a cut-off, of the images in a box. What is
/// exact is so over seams.
#[test]
fn bounded_is_said_of_smooth_laws_only() {
    macro_rules! said {
        ($simulation:expr) => {{
            let bounded = $simulation.scheme(Leapfrog).dt(0.01).run(1).unwrap();
            let exact = $simulation.scheme(DiscreteGradient).dt(0.01).run(1).unwrap();
            assert_eq!(exact.kept(Invariant::Energy), Kept::Exact);
            assert_eq!(bounded.kept(Invariant::WorkEnergy), Kept::Exact);
            assert_eq!(
                bounded.to_string().contains("bounded between seams"),
                bounded.kept(Invariant::Energy) == Kept::BetweenSeams
            );
            bounded.kept(Invariant::Energy)
        }};
    }
    let start = State::new([1.0], [0.3]);
    let (wall, quartic) = (Wall::default(), Quartic { beta: 1.3 });
    assert_eq!(said!(Simulation::new(wall, start)), Kept::BetweenSeams);
    assert_eq!(said!(Simulation::new(quartic, start)), Kept::Bounded);
    assert_eq!(said!(Simulation::new(Some(wall), start)), Kept::BetweenSeams);
    assert_eq!(said!(Simulation::new(quartic, start).masses([1.3])), Kept::Bounded);
    let scene = || Scene::<1>::new().body(1.3, [0.4], [0.3]).body(0.7, [1.6], [0.1]);
    let pairs = LennardJones { epsilon: 0.3, sigma: 1.0 };
    assert_eq!(said!(Simulation::scene(scene().field(quartic))), Kept::Bounded);
    assert_eq!(said!(Simulation::scene(scene().field(quartic).field(wall))), Kept::BetweenSeams);
    assert_eq!(said!(Simulation::scene(scene().pairs(pairs))), Kept::Bounded);
    assert_eq!(said!(Simulation::scene(scene().pairs(pairs).cutoff(2.5))), Kept::BetweenSeams);
    assert_eq!(said!(Simulation::scene(scene().pairs(pairs).periodic([9.0]))), Kept::BetweenSeams);
    // Members of ensembles say the same.
    let run = Ensemble::of(9).law(|_| wall).start(|_| start).scheme(Leapfrog).dt(0.01).run(1).unwrap();
    assert!((0..9).all(|k| run.member(k).unwrap().kept(Invariant::Energy) == Kept::BetweenSeams));
}
