//! Masses per coordinate: every scheme keeps with them what it keeps with one mass.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech::prelude::*;

use dmech_tests::motion::{distance, kinetic, work_balances};

/// Three bodies in the plane in one law of six coordinates: stiffening bonds of distinct lengths, free in space.
#[derive(Clone, Copy, Debug)]
struct Molecule {
    k: [f64; 3],
    length: [f64; 3],
}

#[dmech::law]
impl Molecule {
    fn bond(&self, d: [f64; 2], k: f64, length: f64) -> f64 {
        let s = d[0] * d[0] + d[1] * d[1];
        k * ((s + 0.1).sqrt() - length).powi(2) + 0.1 * k * s * s
    }

    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        self.bond([q[0] - q[2], q[1] - q[3]], self.k[0], self.length[0])
            + self.bond([q[2] - q[4], q[3] - q[5]], self.k[1], self.length[1])
            + self.bond([q[4] - q[0], q[5] - q[1]], self.k[2], self.length[2])
    }
}

const MOLECULE: Molecule = Molecule { k: [1.3, 0.7, 0.9], length: [0.8, 1.1, 1.4] };
const BODIES: [f64; 6] = [0.7, 0.7, 1.9, 1.9, 5.3, 5.3];

/// The centre of mass at rest: far from the origin the differences of positions would lose digits.
fn at_rest(masses: [f64; 6]) -> State<6> {
    let v = [0.3, -0.5, -0.2, 0.4, 0.1, 0.2];
    let mean = |i: usize| {
        let sum = |x: &dyn Fn(usize) -> f64| (i..6).step_by(2).map(x).sum::<f64>();
        sum(&|j| masses[j] * v[j]) / sum(&|j| masses[j])
    };
    State::new([0.0, 0.1, 1.0, -0.2, 0.4, 0.9], core::array::from_fn(|i| v[i] - mean(i % 2)))
}

fn triangle() -> State<6> {
    at_rest(BODIES)
}

/// Three coordinates, all coupled, no two alike.
#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: [f64; 3]| {
    0.5 * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1] + 3.0 * q[2] * q[2]) + self.c * q[0] * q[1] * q[2] + 0.25 * (q[0] + q[1] - q[2]).powi(4)
})]
struct Anharmonic {
    k: f64,
    c: f64,
}

const ANHARMONIC: Anharmonic = Anharmonic { k: 1.1, c: 0.4 };

/// Two springs that pull on each other: linear.
#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: [f64; 2]| 0.5 * self.k * (q[0] * q[0] + 3.0 * q[1] * q[1]) + self.l * q[0] * q[1])]
struct Springs {
    k: f64,
    l: f64,
}

const SPRINGS: Springs = Springs { k: 1.9, l: 0.7 };

/// A quartic bowl that breathes, with drag in a wind that turns: position, velocity and time in both parts.
#[derive(Clone, Copy, Debug)]
struct Wind {
    k: f64,
    drag: f64,
    omega: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn bowl(&self, q: [f64; 2], t: f64) -> f64 {
        0.25 * self.k * (1.3 + (self.omega * t).sin()) * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }
    #[force]
    fn drag(&self, q: [f64; 2], v: [f64; 2], t: f64) -> [f64; 2] {
        let u = [v[0] - 0.8 * (self.omega * t).cos(), v[1] - 0.6 * (self.omega * t).sin()];
        let c = self.drag * (1.0 + q[0] * q[0]) * (0.1 + u[0] * u[0] + u[1] * u[1]).sqrt();
        [-c * u[0], -c * u[1]]
    }
}

const WIND: Wind = Wind { k: 1.7, drag: 0.3, omega: 2.3 };

/// Two coupled springs that stiffen and are shaken: position and time, no velocity. (Pendulums would be turned over and
/// over, and far from the origin the increments of positions lose digits.)
#[derive(Clone, Copy, Debug)]
struct Shaken {
    k: f64,
    a: f64,
    omega: f64,
}

#[dmech::law]
impl Shaken {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.25 * self.k * (q[0].powi(4) + 1.7 * q[1].powi(4)) + 0.4 * (q[0] - q[1]).powi(2)
    }
    #[force]
    fn shake(&self, q: [f64; 2], t: f64) -> [f64; 2] {
        [self.a * q[1].cos() * (self.omega * t).sin(), -self.a * q[0].sin() * (self.omega * t).cos()]
    }
}

const SHAKEN: Shaken = Shaken { k: 1.4, a: 0.6, omega: 1.7 };

/// A magnetic field that grows with x, and a well beside it: the force does no work.
#[derive(Clone, Copy, Debug)]
struct Bottle {
    b: f64,
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
        let b = self.b * (1.0 + 0.4 * q[0] * q[0]);
        [b * v[1], -b * v[0]]
    }
}

const BOTTLE: Bottle = Bottle { b: 1.3, k: 0.6 };

const THREE: [f64; 3] = [0.6, 1.7, 4.1];
const TWO: [f64; 2] = [0.6, 2.3];

fn corner() -> State<3> {
    State::new([0.6, -0.3, 0.4], [0.4, 0.5, -0.2])
}

fn plane() -> State<2> {
    State::new([0.7, -0.4], [0.3, 0.9])
}

/// Runs a macro for every law and scheme that fit: law, masses, start, scheme.
macro_rules! for_each_pairing {
    ($run:ident) => {
        for_each_pairing! { @half $run, MOLECULE, BODIES, triangle() }
        for_each_pairing! { @half $run, ANHARMONIC, THREE, corner() }
        for_each_pairing! { @half $run, SPRINGS, TWO, plane() }
        for_each_pairing! { @half $run, SHAKEN, TWO, plane() }
        for_each_pairing! { @whole $run, WIND, TWO, plane() }
        for_each_pairing! { @whole $run, BOTTLE, TWO, plane() }
    };
    (@half $run:ident, $($row:tt)*) => {
        $run! { Leapfrog, $($row)* }
        $run! { Kanatani, $($row)* }
        for_each_pairing! { @whole $run, $($row)* }
    };
    (@whole $run:ident, $($row:tt)*) => {
        $run! { Explicit, $($row)* }
        $run! { Implicit, $($row)* }
        $run! { DiscreteGradient, $($row)* }
    };
}

const PAIRINGS: usize = 4 * 5 + 2 * 3;

/// mᵢ qᵢ″ = −∂Φ/∂qᵢ + Fᵢ by the classical Runge–Kutta method of order 4, at t = 1: none of our code but the slope.
fn reference<L: Law<D>, const D: usize>(law: &L, masses: [f64; D], start: State<D>) -> [f64; D] {
    use dmech::extend::Field;
    const STEPS: u32 = 4000;
    let h = 1.0 / f64::from(STEPS);
    let rates = |t: f64, (q, v): ([f64; D], [f64; D])| {
        let slope = law.field(f64::NAN, t).slope(q, v);
        (v, core::array::from_fn(|i| -slope[i] / masses[i]))
    };
    let ahead = |(q, v): ([f64; D], [f64; D]), c: f64, (dq, dv): ([f64; D], [f64; D])| {
        (core::array::from_fn(|i| q[i] + c * dq[i]), core::array::from_fn(|i| v[i] + c * dv[i]))
    };
    let mut x = (start.q, start.v);
    for k in 0..STEPS {
        let t = f64::from(k) * h;
        let k1 = rates(t, x);
        let k2 = rates(t + 0.5 * h, ahead(x, 0.5 * h, k1));
        let k3 = rates(t + 0.5 * h, ahead(x, 0.5 * h, k2));
        let k4 = rates(t + h, ahead(x, h, k3));
        for (c, k) in [(1.0, k1), (2.0, k2), (2.0, k3), (1.0, k4)] {
            x = ahead(x, c * h / 6.0, k);
        }
    }
    x.0
}

#[test]
fn orders_are_as_declared() {
    let mut measured = 0;
    macro_rules! one {
        ($scheme:ident, $law:expr, $masses:expr, $start:expr) => {{
            let exact = reference(&$law, $masses, $start);
            let error = |steps: u64| {
                let run = Simulation::new($law, $start).masses($masses).scheme($scheme).dt(1.0 / steps as f64);
                distance(run.run(steps).unwrap().last().q, exact)
            };
            let (coarse, fine) = (error(400), error(800));
            let order = (coarse / fine).log2();
            println!("{:<12} {:<18} {order:.3}, error {fine:.1e}", stringify!($law), stringify!($scheme));
            assert!(fine > 1e-10, "at the level of rounding there is no order to measure");
            let declared = f64::from(<$scheme as Method>::ORDER);
            assert!(
                abs_diff_eq!(order, declared, epsilon = 0.05),
                "{} on {}: {order}",
                stringify!($scheme),
                stringify!($law)
            );
            measured += 1;
        }};
    }
    for_each_pairing!(one);
    assert_eq!(measured, PAIRINGS);
}

#[test]
fn energy_is_exact() {
    macro_rules! one {
        ($scheme:ident, $invariant:ident, $law:expr, $masses:expr, $start:expr) => {{
            let run = Simulation::new($law, $start).masses($masses).scheme($scheme).dt(0.02).record_every(10);
            let run = run.run(100_000).unwrap();
            let drift = run.drift(Invariant::$invariant).unwrap();
            let largest = run.states().iter().map(|s| kinetic($masses, s.v)).fold(0.0, f64::max);
            let relative = drift.max_abs() / largest;
            println!("{:<12} {:<18} {relative:.1e}", stringify!($law), stringify!($scheme));
            assert!(relative < 1e-13, "{} on {}: {relative:e}", stringify!($scheme), stringify!($law));
            assert!(drift.max_abs() > 0.0, "nothing moved");
        }};
    }
    one!(DiscreteGradient, Energy, MOLECULE, BODIES, triangle());
    one!(DiscreteGradient, Energy, ANHARMONIC, THREE, corner());
    one!(DiscreteGradient, Energy, SPRINGS, TWO, plane());
    one!(DiscreteGradient, Energy, BOTTLE, TWO, plane());
    one!(Kanatani, DiscreteEnergy, MOLECULE, BODIES, triangle());
    one!(Kanatani, DiscreteEnergy, ANHARMONIC, THREE, corner());
    one!(Kanatani, DiscreteEnergy, SPRINGS, TWO, plane());
    // An electron and a nucleus: rows of the equation that differ by a factor of thousands.
    let atom = [1.0, 1.0, 1836.0, 1836.0, 3.1e4, 3.1e4];
    one!(DiscreteGradient, Energy, MOLECULE, atom, at_rest(atom));
    one!(Kanatani, DiscreteEnergy, MOLECULE, atom, at_rest(atom));
}

/// The energy is Σ mᵢ vᵢ²/2 + Φ, with the potential of the law as it is.
#[test]
fn energy_and_momentum_are_those_of_the_bodies() {
    let motion = || Simulation::new(MOLECULE, triangle()).masses(BODIES).dt(0.02);
    fn momentum(state: &State<6>) -> [f64; 2] {
        [0, 1].map(|i| (i..6).step_by(2).map(|j| BODIES[j] * state.v[j]).sum())
    }
    macro_rules! one {
        ($scheme:ident) => {{
            let run = motion().scheme($scheme).run(2000).unwrap();
            let energy = MOLECULE.energy(triangle().q) + kinetic(BODIES, triangle().v);
            assert_abs_diff_eq!(run.drift(Invariant::Energy).unwrap().start() / energy, 1.0, epsilon = 1e-15);
            assert!(run.drift(Invariant::AngularMomentum).is_none());
            // Free in space: the bonds pull equally at both ends.
            let worst = run.states().iter().map(|s| distance(momentum(s), momentum(&triangle()))).fold(0.0, f64::max);
            assert!(worst < 1e-12, "{}: {worst:e}", stringify!($scheme));
            let table = run.to_string();
            assert!(table.contains("energy") && run.report().mass() == 1.0, "{table}");
        }};
    }
    one!(Explicit);
    one!(Leapfrog);
    one!(Implicit);
    one!(DiscreteGradient);
    one!(Kanatani);
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    let mut checked = 0;
    macro_rules! one {
        ($scheme:ident, $law:expr, $masses:expr, $start:expr) => {{
            // The explicit orbits spiral outward, some to infinity.
            let steps = if <$scheme as Method>::ORDER == 1 { 1000 } else { 100_000 };
            let run = Simulation::new($law, $start).masses($masses).scheme($scheme).dt(0.01).record_every(10);
            work_balances(&run.run(steps).unwrap(), $masses, stringify!($law));
            checked += 1;
        }};
    }
    for_each_pairing!(one);
    assert_eq!(checked, PAIRINGS);
}

fn end<const D: usize>(run: Result<Run<State<D>>, Interrupted<State<D>>>) -> [f64; D] {
    run.unwrap().last().q
}

/// [m; D] is `.mass(m)`, `.mass` is the unit of `.masses` before and after it, and different masses are not equal ones.
#[test]
fn equal_masses_are_one_mass() {
    let mut compared = 0;
    macro_rules! one {
        ($scheme:ident, $law:expr, $masses:expr, $start:expr) => {{
            let motion = || Simulation::new($law, $start).scheme($scheme).dt(0.01);
            let one_mass = end(motion().mass(1.3).run(500));
            let miss = distance(end(motion().masses($masses.map(|_| 1.3)).run(500)), one_mass);
            assert!(miss < 1e-12, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
            let different = end(motion().masses($masses).run(500));
            assert!(distance(different, one_mass) > 1e-2, "{}: masses make no difference", stringify!($law));
            let halves = $masses.map(|m| 0.5 * m);
            for other in
                [end(motion().mass(2.0).masses(halves).run(500)), end(motion().masses(halves).mass(2.0).run(500))]
            {
                assert!(distance(other, different) < 1e-12, "{} on {}", stringify!($scheme), stringify!($law));
            }
            compared += 1;
        }};
    }
    for_each_pairing!(one);
    assert_eq!(compared, PAIRINGS);
}

#[test]
fn symmetric_schemes_return_when_the_velocity_is_reversed() {
    let mut returned = 0;
    macro_rules! one {
        ($scheme:ident, $law:expr, $masses:expr, $start:expr) => {{
            let motion =
                |start| Simulation::new($law, start).masses($masses).scheme($scheme).dt(0.01).run(500).unwrap();
            let there = *motion($start).last();
            let back = motion(State::new(there.q, there.v).reversed()).last().reversed();
            let miss = distance(back.q, $start.q) + distance(back.v, $start.v);
            assert!(distance(there.q, $start.q) > 0.05, "it did not move");
            assert!(miss < 1e-12, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
            returned += 1;
        }};
    }
    macro_rules! symmetric {
        ($($row:tt)*) => {
            one!(Leapfrog, $($row)*);
            one!(Implicit, $($row)*);
            one!(DiscreteGradient, $($row)*);
        };
    }
    symmetric!(MOLECULE, BODIES, triangle());
    symmetric!(ANHARMONIC, THREE, corner());
    symmetric!(SPRINGS, TWO, plane());
    assert_eq!(returned, 9);
}

#[test]
fn a_mass_that_is_none_is_refused() {
    for bad in [0.0, -0.0, -1.5, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..3 {
            let mut masses = THREE;
            masses[place] = bad;
            let motion = Simulation::new(ANHARMONIC, corner()).masses(masses).scheme(Implicit).dt(0.1);
            let cause = motion.clone().run(10).unwrap_err().cause();
            assert!(matches!(cause, Error::Mass { mass } if mass.to_bits() == bad.to_bits()), "{cause}");
            assert!(cause.to_string().contains(&bad.to_string()) && motion.stepper().is_err());
        }
    }
    // Two negative factors are no mass, nor is a product that is too small.
    let motion = Simulation::new(ANHARMONIC, corner()).scheme(Implicit).dt(0.1);
    assert!(matches!(motion.clone().mass(-1.0).masses([-1.0; 3]).run(1).unwrap_err().cause(), Error::Mass { .. }));
    assert!(matches!(motion.clone().mass(1e-300).masses([1e-300; 3]).run(1).unwrap_err().cause(), Error::Mass { .. }));
    let narrow: State<3, f32> = State::of([0.6, -0.3, 0.4], [0.4, 0.5, -0.2]);
    let motion = Simulation::new(ANHARMONIC, narrow).scheme(Implicit).dt(0.1);
    assert!(matches!(motion.clone().masses([1.0, 1e-60, 2.0]).run(1).unwrap_err().cause(), Error::Mass { .. }));
    assert!(motion.masses(THREE).run(1).is_ok());
}
