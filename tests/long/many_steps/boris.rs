//! Forces linear in the velocity, stepped without an equation.

use approx::assert_abs_diff_eq;
use dmech::extend::{Field, MassIndependent};
use dmech::models::Kepler;
use dmech::models::pairs::Morse;
use dmech::prelude::*;
use dmech::scene::{FieldLaw, SceneSystem, Term};

use dmech_tests::motion::*;

use super::gyration::{CROSSED, GRADED, IN_SPACE, IN_THE_PLANE, UNIFORM};

/// A field that grows along its axis, and nothing else.
#[derive(Clone, Copy, Debug)]
struct Bottle {
    b: f64,
    length: f64,
}

#[dmech::law]
impl Bottle {
    #[force]
    fn lorentz(&self, q: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = q;
        let c = self.b / (self.length * self.length);
        let (bx, by, bz) = (-c * x * z, -c * y * z, self.b + c * z * z);
        [v[1] * bz - v[2] * by, v[2] * bx - v[0] * bz, v[0] * by - v[1] * bx]
    }
}

const BOTTLE: Bottle = Bottle { b: 1.4, length: 3.0 };
const IN_THE_BOTTLE: State<3> = State::new([0.8, 0.1, -0.2], [0.3, 0.7, 0.4]);

/// A well, a magnetic field that varies in place and time, friction against a wind that turns: all that is linear in v.
#[derive(Clone, Copy, Debug)]
struct Stream {
    k: f64,
    b: f64,
    c: f64,
    wind: f64,
    omega: f64,
}

#[dmech::law]
impl Stream {
    #[potential]
    fn well(&self, q: [f64; 2]) -> f64 {
        0.25 * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }
    #[force]
    fn stream(&self, q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> [f64; 2] {
        let b = self.b * (1.0 + 0.3 * q[0] * q[1] + 0.2 * (self.omega * t).sin());
        let c = self.c * m * (1.0 + q[0] * q[0]);
        let (s, w) = (self.omega * t).sin_cos();
        [b * v[1] - c * (v[0] - self.wind * w), -b * v[0] - c * (v[1] - self.wind * s)]
    }
}

const STREAM: Stream = Stream { k: 1.7, b: 1.9, c: 0.3, wind: 0.8, omega: 2.3 };

/// A magnetic field and a friction that is not the same in all directions, in space.
#[derive(Clone, Copy, Debug)]
struct Slurry {
    b: [f64; 3],
    c: [f64; 3],
}

#[dmech::law]
impl Slurry {
    #[potential]
    fn well(&self, q: [f64; 3]) -> f64 {
        0.5 * (q[0] * q[0] + 1.7 * q[1] * q[1] + 0.6 * q[2] * q[2]) + 0.1 * q[0] * q[1] * q[2]
    }
    #[force]
    fn force(&self, v: [f64; 3]) -> [f64; 3] {
        let (b, c) = (self.b, self.c);
        [
            v[1] * b[2] - v[2] * b[1] - c[0] * v[0],
            v[2] * b[0] - v[0] * b[2] - c[1] * v[1],
            v[0] * b[1] - v[1] * b[0] - c[2] * v[2],
        ]
    }
}

const SLURRY: Slurry = Slurry { b: [0.4, -0.9, 1.3], c: [0.1, 0.25, 0.05] };

/// A pendulum in oil.
#[derive(Clone, Copy, Debug)]
struct Oil {
    k: f64,
    c: f64,
}

#[dmech::law]
impl Oil {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    #[force]
    fn drag(&self, v: f64) -> f64 {
        -self.c * v
    }
}

const OIL: Oil = Oil { k: 1.4, c: 0.3 };
const BOB: State<1> = State::new([1.1], [0.4]);

/// Two charges in the plane as one law: more coordinates than have a formula of their own.
#[derive(Clone, Copy, Debug)]
struct Two {
    b: f64,
    k: f64,
}

#[dmech::law]
impl Two {
    #[potential]
    fn between(&self, q: [f64; 4]) -> f64 {
        self.k * ((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) + 1.2).sqrt()
    }
    #[force]
    fn lorentz(&self, v: [f64; 4]) -> [f64; 4] {
        [self.b * v[1], -self.b * v[0], -0.7 * self.b * v[3], 0.7 * self.b * v[2]]
    }
}

const TWO: Two = Two { b: 1.6, k: 0.8 };
const APART: State<4> = State::new([0.5, 0.2, -0.4, -0.3], [0.3, 0.9, -0.2, 0.5]);

/// Another law with the functions of a field that one written by hand must have, and no more.
#[derive(Clone, Copy, Debug)]
struct ByHand<L>(L);

impl<L> LinearInVelocity for ByHand<L> {}

impl<L: Law<D>, const D: usize> Law<D> for ByHand<L> {
    type Field<'a>
        = ByHand<(L::Field<'a>, f64)>
    where
        Self: 'a;
    const AUTONOMOUS: bool = L::AUTONOMOUS;
    fn field(&self, mass: f64, t: f64) -> Self::Field<'_> {
        ByHand((self.0.field(mass, t), t))
    }
}

impl<F: Field<D>, const D: usize> Potential<D> for ByHand<(F, f64)> {
    fn potential(&self, q: [f64; D]) -> f64 {
        self.0.0.potential(q)
    }
    fn gradient(&self, q: [f64; D]) -> [f64; D] {
        self.0.0.gradient(q)
    }
    fn hessian(&self, q: [f64; D]) -> [[f64; D]; D] {
        self.0.0.hessian(q)
    }
    fn discrete_gradient(&self, a: [f64; D], b: [f64; D]) -> [f64; D] {
        self.0.0.discrete_gradient(a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [f64; D], b: [f64; D]) -> [[f64; D]; D] {
        self.0.0.discrete_gradient_jacobian(a, b)
    }
}

impl<F: Field<D>, const D: usize> Field<D> for ByHand<(F, f64)> {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = F::CONSERVES_ENERGY;
    fn slope(&self, q: [f64; D], v: [f64; D]) -> [f64; D] {
        self.0.0.slope(q, v)
    }
    fn force(&self, q: [f64; D], v: [f64; D], t: f64) -> [f64; D] {
        self.0.0.force(q, v, t)
    }
    fn force_dv(&self, q: [f64; D], v: [f64; D], t: f64) -> [[f64; D]; D] {
        self.0.0.force_dv(q, v, t)
    }
    fn time(&self) -> f64 {
        self.0.1
    }
}

/// Runs a macro for every law.
macro_rules! for_each_law {
    ($run:ident) => {
        $run!(BOTTLE, IN_THE_BOTTLE);
        $run!(STREAM, IN_THE_PLANE);
        $run!(SLURRY, IN_THE_BOTTLE);
        $run!(OIL, BOB);
        $run!(TWO, APART);
        $run!(GRADED, IN_THE_PLANE);
        $run!(CROSSED, IN_THE_PLANE);
        $run!(Kepler { gm: 1.7 }, State::new([0.9, -0.3], [0.4, 1.1]));
    };
}

/// |u_h − u_{h/2}|/|u_{h/2} − u_{h/4}| → 2^p at t = 6, h being halved until it shows or rounding does.
fn measured<L: Law<D> + Copy, S: Scheme<Particle<L, D>>, const D: usize>(law: L, scheme: S, start: State<D>) -> f64 {
    let end = |h: f64| {
        let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(h).record_every(1_000_000).run_until(6.0);
        run.unwrap_or_else(|interrupted| panic!("{}: {interrupted}", S::NAME)).last().q
    };
    let (mut h, mut last, mut coarse, mut power) = (0.5, end(1.0), f64::NAN, f64::NAN);
    for _ in 0..12 {
        let now = end(h);
        let fine = distance(last, now);
        if fine < 1e-12 {
            break;
        }
        power = (coarse / fine).log2();
        if (power - f64::from(S::ORDER)).abs() < 0.02 * f64::from(S::ORDER) {
            break;
        }
        (coarse, last, h) = (fine, now, 0.5 * h);
    }
    println!("{:<44} {D} coordinates: {power:.3}", S::NAME);
    power
}

#[test]
fn the_order_is_two_and_compositions_have_four_six_and_eight() {
    fn check<L: Law<D> + LinearInVelocity + Copy, const D: usize>(law: L, start: State<D>) {
        for (order, measured) in [
            (2.0, measured(law, Boris, start)),
            (4.0, measured(law, Composed::order4(Boris), start)),
            (6.0, measured(law, Composed::order6(Boris), start)),
            (8.0, measured(law, Composed::order8(Boris), start)),
        ] {
            assert!((measured - order).abs() < 0.07 * order, "order {order}: {measured}");
        }
    }
    let mut laws = 0;
    macro_rules! one {
        ($law:expr, $start:expr) => {
            check($law, $start);
            laws += 1;
        };
    }
    for_each_law!(one);
    assert_eq!(laws, 8);
}

/// m (v′ − v)/h = −∇Φ + F(q½, (v + v′)/2), whatever made the step.
#[test]
fn a_step_satisfies_its_equation() {
    fn misses<L: Law<D>, M: Law<D> + LinearInVelocity, const D: usize>(
        law: L,
        stepped: M,
        start: State<D>,
        h: f64,
    ) -> f64 {
        let run = Simulation::new(stepped, start).mass(MASS).scheme(Boris).dt(h).run(1).unwrap();
        let end = run.last();
        let middle: [f64; D] = std::array::from_fn(|i| start.q[i] + 0.5 * h * start.v[i]);
        let mean: [f64; D] = std::array::from_fn(|i| 0.5 * (start.v[i] + end.v[i]));
        let slope = law.field(MASS, 0.5 * h).slope(middle, mean);
        let kick = (0..D).map(|i| (MASS * (end.v[i] - start.v[i]) / h + slope[i]).abs());
        let drift = (0..D).map(|i| (end.q[i] - middle[i] - 0.5 * h * end.v[i]).abs());
        kick.chain(drift).fold(0.0, f64::max)
    }
    let mut laws = 0;
    macro_rules! one {
        ($law:expr, $start:expr) => {
            for h in [0.1, 1.0, 7.0] {
                let [generated, by_hand] = [misses($law, $law, $start, h), misses($law, ByHand($law), $start, h)];
                assert!(
                    generated < 1e-13 * (1.0 + h * h) && by_hand < 1e-13 * (1.0 + h * h),
                    "{h}: {generated:e}, {by_hand:e}"
                );
            }
            laws += 1;
        };
    }
    for_each_law!(one);
    assert_eq!(laws, 8);
}

/// In a magnetic field alone, over 10⁶ steps: also where each step rounds as the one before.
#[test]
fn the_speed_is_kept_to_rounding() {
    fn keeps<L: Law<D> + LinearInVelocity + Copy, const D: usize>(law: L, start: State<D>, h: f64, what: &str) {
        let run = Simulation::new(law, start).mass(MASS).scheme(Boris).dt(h).record_every(100).run(1_000_000).unwrap();
        let drift = run.drift(Invariant::Energy).expect("a magnetic field does no work");
        println!("h = {h:<5} {what:<15} {:.1e}", drift.max_relative());
        assert!(drift.max_relative() < 1e-12, "{what}: {:e}", drift.max_relative());
        assert_eq!(run.report().iterations(), 0);
        assert!(drift.max_abs() > 0.0 && run.last().q != start.q, "{what}: nothing moved");
    }
    for h in [0.01, 0.05, 0.3] {
        keeps(BOTTLE, IN_THE_BOTTLE, h, "bottle");
        keeps(GRADED, IN_THE_PLANE, h, "graded field");
        keeps(UNIFORM, IN_SPACE, h, "uniform field");
    }
    keeps(ByHand(BOTTLE), IN_THE_BOTTLE, 0.05, "by hand");
    keeps(ByHand(GRADED), IN_THE_PLANE, 0.05, "by hand");
}

/// Steps of thousands of turns: the Cayley map is a rotation for any, and friction brakes for any.
#[test]
fn huge_steps_are_stable() {
    for h in [3.0, 1e3, 1e8] {
        let run = Simulation::new(UNIFORM, IN_SPACE).mass(MASS).scheme(Boris).dt(h).run(1000).unwrap();
        let drift = run.drift(Invariant::Energy).unwrap().max_relative();
        assert!(drift < 1e-12, "h = {h}: {drift:e}");
    }
    let run = Simulation::new(Oil { k: 0.0, c: 0.3 }, BOB).mass(MASS).scheme(Boris).dt(1e3).run(100).unwrap();
    assert!(run.states().windows(2).all(|pair| pair[1].v[0].abs() < pair[0].v[0].abs()));
}

/// v′ = v (1 − x)/(1 + x) with x = hc/2m; and the exact motion to second order.
#[test]
fn friction_is_damped_as_it_should_be() {
    let (law, h) = (Oil { k: 0.0, c: 0.3 }, 0.1);
    let run = Simulation::new(law, BOB).mass(MASS).scheme(Boris).dt(h).run(200).unwrap();
    let x = 0.5 * h * law.c / MASS;
    for (n, state) in run.states().iter().enumerate() {
        assert_abs_diff_eq!(state.v[0], 0.4 * ((1.0 - x) / (1.0 + x)).powi(n as i32), epsilon = 1e-15);
    }
    // (ω² − γ²)^½ of a damped oscillator.
    #[derive(Clone, Copy, Debug)]
    struct Damped {
        k: f64,
        c: f64,
    }
    #[dmech::law]
    impl Damped {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            0.5 * self.k * q * q
        }
        #[force]
        fn drag(&self, v: f64) -> f64 {
            -self.c * v
        }
    }
    let law = Damped { k: 2.1, c: 0.3 };
    let exact = |t: f64| {
        let gamma = 0.5 * law.c / MASS;
        let omega = (law.k / MASS - gamma * gamma).sqrt();
        (-gamma * t).exp() * (1.1 * (omega * t).cos() + (0.4 + gamma * 1.1) / omega * (omega * t).sin())
    };
    let error = |h: f64| {
        let run = Simulation::new(law, BOB).mass(MASS).scheme(Boris).dt(h).run_until(10.0).unwrap();
        (run.last().q[0] - exact(10.0)).abs()
    };
    let [coarse, fine] = [0.02, 0.01].map(error);
    assert!(fine < 1e-4 && (coarse / fine - 4.0).abs() < 0.05, "{coarse:e}, {fine:e}");
}

/// The way back has the field, or the friction, the other way round.
#[test]
fn the_way_back_is_found() {
    let home = Bottle { b: -BOTTLE.b, ..BOTTLE };
    assert!(miss(BOTTLE, home, Boris, IN_THE_BOTTLE) < 1e-12);
    assert!(miss(BOTTLE, home, Composed::order4(Boris), IN_THE_BOTTLE) < 1e-12);
    assert!(miss(OIL, Oil { c: -OIL.c, ..OIL }, Boris, BOB) < 1e-12);
    let [b, c] = [SLURRY.b, SLURRY.c].map(|x| x.map(|x| -x));
    assert!(miss(SLURRY, Slurry { b, c }, Boris, IN_THE_BOTTLE) < 1e-12);
}

#[test]
fn work_is_the_change_of_the_kinetic_energy() {
    let mut laws = 0;
    macro_rules! one {
        ($law:expr, $start:expr) => {
            let run = Simulation::new($law, $start).mass(MASS).scheme(Boris).dt(0.01).record_every(10).run(20_000);
            work_balances(&run.unwrap(), [MASS; _], "Boris");
            let run = Simulation::new($law, $start).mass(MASS).scheme(Composed::order4(Boris)).dt(0.02).run(2000);
            work_balances(&run.unwrap(), [MASS; _], "of order 4");
            laws += 1;
        };
    }
    for_each_law!(one);
    assert_eq!(laws, 8);
}

/// A potential beside a uniform field: the energy goes to and fro.
#[test]
fn energy_is_bounded_beside_a_potential() {
    let run = Simulation::new(TWO, APART).mass(MASS).scheme(Boris).dt(0.05).run(200_000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-2);
    does_not_drift(&run, Invariant::Energy, "two charges");
    let run = Simulation::new(TWO, APART).mass(MASS).scheme(Composed::order4(Boris)).dt(0.1).run(20_000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-4);
}

/// Without a field, or with one that is off, particles go straight on; without velocities it is leap-frog.
#[test]
fn nothing_turns_what_nothing_acts_on() {
    let start = IN_THE_BOTTLE;
    let run = Simulation::new(Bottle { b: 0.0, length: 1.0 }, start).scheme(Boris).dt(0.1).run(1000).unwrap();
    assert_eq!(run.last().v, start.v);
    // Half a drift on, positions are those of leap-frog from there.
    let (law, h) = (Kepler { gm: 1.7 }, 0.01);
    let planet = State::new([0.9, -0.3], [0.4, 1.1]);
    let run = Simulation::new(law, planet).scheme(Boris).dt(h).run(1000).unwrap();
    let (mut q, mut v) = (planet.q, planet.v);
    for _ in 0..1000 {
        q = [q[0] + 0.5 * h * v[0], q[1] + 0.5 * h * v[1]];
        v = law.field(1.0, 0.0).kick(h, q, v);
        q = [q[0] + 0.5 * h * v[0], q[1] + 0.5 * h * v[1]];
    }
    assert!(distance(run.last().q, q) < 1e-13);
}

#[test]
fn masses_and_scalars_of_other_kinds() {
    fn keeps<L: Law<D> + LinearInVelocity + MassIndependent + Copy, const D: usize>(
        law: L,
        masses: [f64; D],
        start: State<D>,
    ) {
        let run = Simulation::new(law, start).masses(masses).scheme(Boris).dt(0.05).record_every(100).run(100_000);
        let drift = run.unwrap().drift(Invariant::Energy).unwrap().max_relative();
        assert!(drift < 1e-12, "{masses:?}: {drift:e}");
    }
    keeps(UNIFORM, [1.3, 0.7, 2.9], IN_SPACE);
    keeps(BOTTLE, [1.3, 0.7, 2.9], IN_THE_BOTTLE);
    keeps(GRADED, [1.3, 0.7], IN_THE_PLANE);
    let double = end(BOTTLE, Boris, IN_THE_BOTTLE, 100);
    let [q, v] = [IN_THE_BOTTLE.q, IN_THE_BOTTLE.v];
    let narrow = State::<3, f32>::of(q.map(|x| x as f32), v.map(|x| x as f32));
    let single = Simulation::new(BOTTLE, narrow).mass(MASS).scheme(Boris).dt(0.01).run(100).unwrap();
    let miss = distance(single.last().q.map(f64::from), double.q);
    assert!(miss < 1e-5 && miss > 0.0, "{miss:e}");
    let wide = State::<3, DoubleDouble>::of(q.map(DoubleDouble::from_f64), v.map(DoubleDouble::from_f64));
    let run = Simulation::new(BOTTLE, wide).mass(MASS).scheme(Composed::order8(Boris)).dt(0.05).run(100).unwrap();
    let energy = |v: [DoubleDouble; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let change = (energy(run.last().v) - energy(run.states()[0].v)).to_f64();
    assert!(change.abs() < 1e-28, "{change:e}");
}

/// Steps that follow the gyration, to their tolerance.
#[test]
fn adaptive_steps_reach_their_tolerance() {
    let exact = Simulation::new(BOTTLE, IN_THE_BOTTLE).scheme(Composed::order8(Boris)).dt(1e-3).record_every(10_000);
    let exact = exact.run_until(20.0).unwrap().last().q;
    let mut errors = Vec::new();
    for tolerance in [1e-3, 1e-5] {
        let run = Simulation::new(BOTTLE, IN_THE_BOTTLE).scheme(Composed::order4(Boris)).adaptive(tolerance);
        let run = run.run_until(20.0).unwrap();
        let error = distance(run.last().q, exact);
        println!("{tolerance:e}: {error:.1e} in {} steps", run.report().evaluations());
        assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
        assert!(error < 20.0 * tolerance, "{error:e} for {tolerance:e}");
        errors.push(error);
    }
    assert!(errors[1] < 0.1 * errors[0]);
}

fn simulate<const D: usize, L>(scene: Scene<D, (), L>, h: f64, steps: u64) -> Run<SceneState<D>>
where
    L: Term<D, ()>,
    Boris: Scheme<SceneSystem<D, L::Ready>>,
{
    Simulation::scene(scene).scheme(Boris).dt(h).record_every(10).run(steps).unwrap_or_else(|e| panic!("{e}"))
}

/// Bodies in a field that do not see one another move as each would alone.
#[test]
fn bodies_in_a_field_move_as_each_alone() {
    fn check<L: FieldLaw<D> + LinearInVelocity + Copy, const D: usize>(law: L, start: State<D>) {
        let bodies: Vec<_> = (0..11)
            .map(|i| {
                let f = f64::from(i);
                (1.0 + 0.2 * f, start.q.map(|x| x + 0.03 * f), start.v.map(|x| x * (1.0 - 0.05 * f)))
            })
            .collect();
        let scene = bodies.iter().fold(Scene::new(), |scene, &(m, q, v)| scene.body(m, q, v)).field(law);
        let run = simulate(scene, 0.02, 1000);
        for (i, &(m, q, v)) in bodies.iter().enumerate() {
            let alone = Simulation::new(law, State::new(q, v)).mass(m).scheme(Boris).dt(0.02).run(1000).unwrap();
            let miss = distance(run.last().q[i], alone.last().q);
            assert!(miss < 1e-11, "body {i}: {miss:e}");
        }
    }
    check(BOTTLE, IN_THE_BOTTLE);
    check(STREAM, IN_THE_PLANE);
    check(SLURRY, IN_THE_BOTTLE);
    check(OIL, BOB);
    check(TWO, APART);
}

/// Charges that also bind one another, in a magnetic field and a friction: one sum of both in each body's kick.
#[test]
fn fields_add_up_in_a_scene() {
    #[derive(Clone, Copy, Debug)]
    struct Drag {
        c: f64,
    }
    #[dmech::law]
    impl Drag {
        #[force]
        fn drag(&self, v: [f64; 2]) -> [f64; 2] {
            [-self.c * v[0], -2.0 * self.c * v[1]]
        }
    }
    let scene = || {
        let bodies = Scene::new().body(1.3, [0.9, 0.1], [0.1, 0.4]).body(0.7, [-0.8, 0.3], [0.2, -0.3]);
        let bodies = bodies.body(2.1, [0.2, -1.1], [-0.3, 0.1]).body(1.1, [1.4, 1.0], [0.0, 0.0]).pin(3);
        bodies.pairs(Morse { depth: 1.4, width: 0.9, length: 1.2 }).field(GRADED).field(Drag { c: 0.2 })
    };
    let end = |h: f64| simulate(scene(), h, (2.0 / h).round() as u64).last().q.concat();
    let [one, two, four] = [0.02, 0.01, 0.005].map(end);
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let order = (apart(&one, &two) / apart(&two, &four)).log2();
    assert!((order - 2.0).abs() < 0.05, "{order}");
    let run = simulate(scene(), 0.02, 5000);
    assert_eq!(run.last().q[3], [1.4, 1.0]);
    assert!(run.drift(Invariant::WorkEnergy).unwrap().max_abs() < 1e-13);
    // The same equation, solved: both are of second order.
    let solved = Simulation::scene(scene()).scheme(DiscreteGradient).dt(0.005).run(400).unwrap().last().q.concat();
    assert!(apart(&four, &solved) < 1e-3);
    // A pinned body is not turned, and composed steps are of their order.
    let run = Simulation::scene(scene()).scheme(Composed::order6(Boris)).dt(0.05).run(40).unwrap();
    let exact = Simulation::scene(scene()).scheme(Composed::order8(Boris)).dt(0.02).run(100).unwrap();
    assert!(apart(&run.last().q.concat(), &exact.last().q.concat()) < 1e-7);
}
