//! Forces that depend on velocity and time, alone and beside a potential.

use dmech::extend::Field;
use dmech::prelude::*;

use dmech_tests::motion::*;

/// A quartic bowl with air drag and a wind that turns: velocity and time, nonlinear in both.
#[derive(Clone, Copy, Debug)]
struct Wind {
    k: f64,
    drag: f64,
    gust: f64,
    omega: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn bowl(&self, q: [f64; 2]) -> f64 {
        0.25 * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }

    fn wind(&self, t: f64) -> [f64; 2] {
        [self.gust * (self.omega * t).cos(), self.gust * (self.omega * t).sin()]
    }

    #[force]
    fn drag(&self, q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> [f64; 2] {
        let w = self.wind(t);
        let u = [v[0] - w[0], v[1] - w[1]];
        let speed = (0.1 + u[0] * u[0] + u[1] * u[1]).sqrt();
        let c = self.drag * m * (1.0 + q[0] * q[0]) * speed;
        [-c * u[0], -c * u[1]]
    }
}

const WIND: Wind = Wind { k: 1.7, drag: 0.3, gust: 0.8, omega: 2.3 };

/// A pendulum whose pivot is shaken: time and position, no velocity.
#[derive(Clone, Copy, Debug)]
struct Shaken {
    k: f64,
    a: f64,
    omega: f64,
}

#[dmech::law]
impl Shaken {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    #[force]
    fn shake(&self, q: f64, t: f64) -> f64 {
        self.a * q.cos() * (self.omega * t).sin()
    }
}

/// A force of the time alone: where it is not read, the position may be written as Rust writes what is not used.
#[derive(Clone, Copy, Debug)]
struct Pushed {
    a: f64,
    omega: f64,
}

#[dmech::law]
impl Pushed {
    #[force]
    fn push(&self, _q: f64, t: f64) -> f64 {
        self.a * (self.omega * t).cos()
    }
}

#[test]
fn an_argument_that_is_not_used_may_say_so() {
    let law = Pushed { a: 0.6, omega: 1.7 };
    let run =
        Simulation::new(law, State::new([0.3], [-0.2])).scheme(Nystrom::order8()).dt(0.05).run_until(3.0).unwrap();
    let exact = 0.3 - 0.2 * 3.0 + law.a / law.omega.powi(2) * (1.0 - (3.0 * law.omega).cos());
    assert!((run.last().q[0] - exact).abs() < 1e-12, "{} for {exact}", run.last().q[0]);
}

const SHAKEN: Shaken = Shaken { k: 1.4, a: 0.6, omega: 1.7 };

/// A magnetic field that grows with x, and a well beside it.
#[derive(Clone, Copy, Debug)]
struct Bottle {
    b: f64,
    growth: f64,
    k: f64,
}

#[dmech::law]
impl Bottle {
    #[potential]
    fn well(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (q[0] * q[0] + 1.5 * q[1] * q[1]) + 0.1 * q[0].powi(4)
    }
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = self.b * (1.0 + self.growth * q[0] * q[0]);
        [b * v[1], -b * v[0]]
    }
}

const BOTTLE: Bottle = Bottle { b: 1.3, growth: 0.4, k: 0.6 };

#[test]
fn orders_with_velocity_and_time() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    has_its_order(WIND, Explicit, start, 0.03, "wind");
    has_its_order(WIND, Implicit, start, 0.03, "wind");
    has_its_order(WIND, DiscreteGradient, start, 0.03, "wind");
    has_its_order(BOTTLE, Implicit, start, 0.03, "bottle");
    has_its_order(BOTTLE, DiscreteGradient, start, 0.03, "bottle");
    let bob = State::new([1.1], [0.4]);
    has_its_order(SHAKEN, Leapfrog, bob, 0.03, "shaken");
    has_its_order(SHAKEN, Kanatani, bob, 0.03, "shaken");
    has_its_order(SHAKEN, Implicit, bob, 0.03, "shaken");
    has_its_order(SHAKEN, DiscreteGradient, bob, 0.03, "shaken");
}

fn balance<L: Law<D>, S: Scheme<Particle<L, D>>, const D: usize>(law: L, scheme: S, start: State<D>, law_name: &str) {
    let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(0.01).record_every(10).run(100_000);
    work_balances(&run.unwrap_or_else(|interrupted| panic!("{interrupted}")), [MASS; D], law_name);
}

#[test]
fn work_is_the_change_of_kinetic_energy_for_every_scheme() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    balance(WIND, Explicit, start, "wind");
    balance(WIND, Implicit, start, "wind");
    balance(WIND, DiscreteGradient, start, "wind");
    balance(BOTTLE, DiscreteGradient, start, "bottle");
    let bob = State::new([1.1], [0.4]);
    balance(SHAKEN, Explicit, bob, "shaken");
    balance(SHAKEN, Leapfrog, bob, "shaken");
    balance(SHAKEN, Implicit, bob, "shaken");
    balance(SHAKEN, DiscreteGradient, bob, "shaken");
    balance(SHAKEN, Kanatani, bob, "shaken");
}

#[test]
fn a_force_that_does_no_work_keeps_the_energy() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    let run =
        Simulation::new(BOTTLE, start).scheme(DiscreteGradient).dt(0.02).record_every(100).run(1_000_000).unwrap();
    let drift = run.drift(Invariant::Energy).expect("v × B does no work").max_relative();
    println!("{drift:.1e} over 10⁶ steps");
    assert!(drift < 1e-13 && drift > 0.0, "{drift:e}");
    // The trapezoid keeps it only nearly.
    let run = Simulation::new(BOTTLE, start).scheme(Implicit).dt(0.02).run(10_000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() > 1e-6);
}

/// The change of energy is the work of the force, exactly, and no invariant is claimed that the law has not.
#[test]
fn what_is_not_kept_is_not_claimed() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    let run = Simulation::new(WIND, start).scheme(DiscreteGradient).dt(0.02).run(100).unwrap();
    assert!(run.drift(Invariant::Energy).is_none() && run.drift(Invariant::AngularMomentum).is_none());
    fn capabilities<L: Law<D>, const D: usize>(_: &L) -> (bool, bool, bool) {
        (L::AUTONOMOUS, L::Field::<'_>::FORCED, L::Field::<'_>::CONSERVES_ENERGY)
    }
    assert_eq!(capabilities(&WIND), (false, true, false));
    assert_eq!(capabilities(&SHAKEN), (false, true, false));
    assert_eq!(capabilities(&BOTTLE), (true, true, true));
    #[derive(Clone, Copy, Debug, dmech::Law)]
    #[potential(|q: f64| 0.5 * self.k * q * q)]
    struct Spring {
        k: f64,
    }
    assert_eq!(capabilities(&Spring { k: 2.0 }), (true, false, true));
}

#[test]
fn jacobians_of_the_force_are_those_of_the_force() {
    let (q, v, t) = ([0.7, -0.4], [0.3, 0.9], 1.3);
    let field = BOTTLE;
    let (dq, dv) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
    let h = 1e-5;
    for j in 0..2 {
        let shifted = |x: [f64; 2], d: f64| core::array::from_fn(|i| x[i] + if i == j { d } else { 0.0 });
        for i in 0..2 {
            let by_q = (field.force(shifted(q, h), v, t)[i] - field.force(shifted(q, -h), v, t)[i]) / (2.0 * h);
            let by_v = (field.force(q, shifted(v, h), t)[i] - field.force(q, shifted(v, -h), t)[i]) / (2.0 * h);
            assert!((dq[i][j] - by_q).abs() < 1e-8 && (dv[i][j] - by_v).abs() < 1e-8, "{i}{j}");
        }
    }
    assert!(dv[0][1] != 0.0 && dq[0][0] != 0.0);
    assert_eq!(field.force(q, v, t), field.lorentz(q, v));
}

/// A magnetic field in a half-plane, and none in the other.
#[derive(Clone, Copy, Debug)]
struct Magnet {
    b: f64,
    edge: f64,
}

#[dmech::law]
impl Magnet {
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        if q[0] > self.edge { [self.b * v[1], -self.b * v[0]] } else { [0.0, 0.0] }
    }
}

/// Where a force acts is for the place to say: it is as linear in the velocity, and does as little work, as without the choice.
#[test]
fn a_field_in_a_half_plane_is_a_field() {
    let magnet =
        || Simulation::new(Magnet { b: 2.3, edge: 0.4 }, State::new([0.0, 0.0], [1.0, 0.3])).mass(1.3).dt(0.05);
    for run in [magnet().scheme(Boris).run(400), magnet().scheme(DiscreteGradient).run(400)] {
        let run = run.unwrap();
        assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
        // In by the front, part of a circle, and out again as from a mirror.
        let [x, y] = run.last().v;
        assert!((x + 1.0).abs() < 0.15 && (y - 0.3).abs() < 0.15, "{x} {y}");
    }
}
