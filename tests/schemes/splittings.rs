//! Nyström splittings and force-gradient schemes: every set of drifts and kicks. A new set is a new row of `for_each_set`.

use approx::abs_diff_eq;
use std::hint::black_box;

use dmech::extend::Field;
use dmech::prelude::coefficients::*;
use dmech::prelude::*;

use dmech_tests::for_each_law;
use dmech_tests::laws::*;
use dmech_tests::measured::*;
use dmech_tests::memory::allocations;
use dmech_tests::motion::*;

/// A well that is stirred and breathes: the force has a curl, so that its Jacobian is not symmetric, and names the time.
#[derive(Clone, Copy, Debug)]
struct Stirred {
    k: f64,
    curl: f64,
    omega: f64,
}

#[dmech::law]
impl Stirred {
    #[force]
    fn pull(&self, q: [f64; 2], t: f64) -> [f64; 2] {
        let [x, y] = q;
        let k = self.k * (1.2 + (self.omega * t).sin());
        [-k * x.powi(3) - self.curl * y, -2.0 * k * y.powi(3) + self.curl * x * (1.0 + x)]
    }
}

const STIRRED: Stirred = Stirred { k: 1.1, curl: 0.4, omega: 1.6 };

/// Where the leading error of no set nearly cancels.
const STIRRED_START: State<2> = State { t: 0.0, q: [1.2, -0.7], v: [0.4, 0.9] };

/// Where the next term of the error of no set shows: on smaller swings it is a seventh of that of `Blanes8S19` at the
/// steps whose errors are clear of rounding.
const SHAKEN_START: State<1> = State { t: 0.0, q: [2.3], v: [1.3] };

/// Runs a macro for every set of drifts and kicks.
macro_rules! for_each_set {
    ($run:ident, $($rest:tt)*) => {
        $run! { Nystrom, McLachlan4S4, $($rest)* }
        $run! { Nystrom, McLachlan4S5, $($rest)* }
        $run! { Nystrom, BlanesMoan4S6, $($rest)* }
        $run! { Nystrom, OkunborSkeel6S7, $($rest)* }
        $run! { Nystrom, BlanesMoan6S11, $($rest)* }
        $run! { Nystrom, BlanesMoan6S14, $($rest)* }
        $run! { Nystrom, Blanes8S19, $($rest)* }
        $run! { ForceGradient, Chin4A, $($rest)* }
        $run! { ForceGradient, Chin4C, $($rest)* }
        $run! { ForceGradient, Omelyan4S3, $($rest)* }
        $run! { ForceGradient, Omelyan4S4, $($rest)* }
        $run! { ForceGradient, Omelyan4S5, $($rest)* }
        $run! { ForceGradient, Omelyan6S5, $($rest)* }
        $run! { ForceGradient, Omelyan8S11, $($rest)* }
        $run! { ForceGradient, Smooth8S14, $($rest)* }
    };
}

const SETS: usize = 15;

#[test]
fn every_set_has_its_order() {
    let (mut measured, mut wrong) = (0, Vec::new());
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr, $exact:expr) => {{
            let order = measured_order($law, $scheme::new($set), $start, &$exact);
            println!("{:<16} {:<22} {:<20} {order:.3}", stringify!($scheme), stringify!($set), stringify!($law));
            let declared = f64::from(<$scheme<$set, _> as Method>::ORDER);
            if (order - declared).abs() >= 0.1 {
                wrong.push(format!("{} on {}: {order}", stringify!($set), stringify!($law)));
            }
            measured += 1;
        }};
    }
    macro_rules! law {
        ($law:expr, $start:expr) => {{
            let exact = path($law, Composed::order8(DiscreteGradient), $start, 200).expect("small steps");
            for_each_set!(one, $law, $start, exact);
        }};
    }
    law!(HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]));
    law!(BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    law!(SHAKEN, SHAKEN_START);
    law!(STIRRED, STIRRED_START);
    assert_eq!(measured, 4 * SETS);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// With masses of their own the coordinates see M⁻¹ H M⁻¹ ∇Φ: with anything else the order falls to 2.
#[test]
fn orders_hold_for_masses_of_each_coordinate() {
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr, $exact:expr) => {{
            let order = order_of(|steps| heavy($law, $scheme::new($set), $start, steps), &$exact);
            println!("{:<16} {:<22} {:<20} {order:.3}", stringify!($scheme), stringify!($set), stringify!($law));
            let declared = f64::from(<$scheme<$set, _> as Method>::ORDER);
            assert!(
                abs_diff_eq!(order, declared, epsilon = 0.1),
                "{} on {}: {order}",
                stringify!($set),
                stringify!($law)
            );
        }};
    }
    macro_rules! law {
        ($law:expr, $start:expr) => {{
            let exact = heavy($law, Composed::order8(DiscreteGradient), $start, 200).expect("small steps");
            for_each_set!(one, $law, $start, exact);
        }};
    }
    law!(BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    law!(STIRRED, STIRRED_START);
}

/// As [`path`], with a mass for each coordinate.
fn heavy<L, S>(law: L, scheme: S, start: State<2>, steps: u64) -> Option<Vec<State<2>>>
where
    L: Law<2> + MassIndependent,
    S: Scheme<Particle<dmech::extend::Masses<L, 2>, 2>>,
{
    let simulation = Simulation::new(law, start).masses([MASS, 0.7]).scheme(scheme).record_every(steps);
    simulation.dt(SPAN / (LOOKS * steps) as f64).run(LOOKS * steps).ok().map(|run| run.states().to_vec())
}

/// [m; D] is `.mass(m)`, and with masses of their own the work balances too.
#[test]
fn equal_masses_are_one_mass() {
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr) => {{
            let motion = || Simulation::new($law, $start).scheme($scheme::new($set)).dt(0.05);
            let one_mass = motion().mass(MASS).run(200).expect("small steps").last().q;
            let masses = motion().masses([MASS; 2]).run(200).expect("small steps").last().q;
            assert!(distance(masses, one_mass) < 1e-12, "{}", stringify!($set));
            let different = motion().masses([MASS, 0.7]).run(200).expect("small steps");
            assert!(distance(different.last().q, one_mass) > 1e-2, "{}: masses make no difference", stringify!($set));
            work_balances(&different, [MASS, 0.7], stringify!($law));
        }};
    }
    for_each_set!(one, BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    for_each_set!(one, STIRRED, STIRRED_START);
}

#[test]
fn energy_is_bounded_and_angular_momentum_stays_exact() {
    let (law, start) = (Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    macro_rules! one {
        ($scheme:ident, $set:ident,) => {{
            let simulation = Simulation::new(law, start).mass(MASS).scheme($scheme::new($set)).dt(0.1);
            let run = simulation.run(20_000).expect("small steps");
            let [energy, turning] =
                [Invariant::Energy, Invariant::AngularMomentum].map(|i| run.drift(i).expect("a central law"));
            println!(
                "{:<32} energy {:.1e}, angular momentum {:.1e}",
                run.report().scheme(),
                energy.max_relative(),
                turning.max_relative()
            );
            assert!(energy.max_relative() < 2e-2, "{}: {energy:?}", run.report().scheme());
            does_not_drift(&run, Invariant::Energy, run.report().scheme());
            assert!(turning.max_relative() < 1e-13, "{}: {turning:?}", run.report().scheme());
            work_balances(&run, [MASS; 2], "Kepler");
        }};
    }
    for_each_set!(one,);
}

#[test]
fn work_balances_where_the_energy_is_not_kept() {
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr, $d:literal) => {{
            let simulation = Simulation::new($law, $start).mass(MASS).scheme($scheme::new($set)).dt(0.02);
            work_balances(&simulation.run(5000).expect("small steps"), [MASS; $d], stringify!($law));
        }};
    }
    for_each_set!(one, SHAKEN, State::<1>::new([0.9], [0.4]), 1);
    for_each_set!(one, STIRRED, STIRRED_START, 2);
}

#[test]
fn splittings_return_when_the_velocity_is_reversed() {
    let mut returned = 0;
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr) => {{
            let miss = miss($law, $law, $scheme::new($set), $start);
            assert!(miss < 1e-12, "{} of {}: {miss:e}", stringify!($set), stringify!($scheme));
            returned += 1;
        }};
    }
    for_each_set!(one, HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]));
    for_each_set!(one, Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    assert_eq!(returned, 2 * SETS);
}

#[test]
fn no_kick_allocates_and_no_force_is_taken_twice() {
    macro_rules! one {
        ($scheme:ident, $set:ident, $law:expr, $start:expr) => {{
            let simulation = Simulation::new($law, $start).mass(MASS).scheme($scheme::new($set)).dt(0.01);
            let mut stepper = simulation.stepper().unwrap();
            let counted = allocations(|| {
                for _ in 0..50 {
                    stepper.step().unwrap();
                    black_box(stepper.state());
                }
                stepper.advance(50).unwrap();
            });
            assert_eq!(counted, 0, "{}", stringify!($set));
            assert_eq!(stepper.evaluations(), 100 * $set::KICKS.len() as u64, "{}", stringify!($set));
        }};
    }
    for_each_set!(one, Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    for_each_set!(one, SHAKEN, State::<1>::new([0.9], [0.4]));
}

/// The kick that the macro writes, and the one that follows from gradient and Hessian, are the same.
#[test]
fn the_gradient_kick_is_that_of_the_hessian() {
    struct ByHand<P>(P);
    impl<P: Potential<D>, const D: usize> Potential<D> for ByHand<P> {
        fn potential(&self, q: [f64; D]) -> f64 {
            self.0.potential(q)
        }
        fn gradient(&self, q: [f64; D]) -> [f64; D] {
            self.0.gradient(q)
        }
        fn hessian(&self, q: [f64; D]) -> [[f64; D]; D] {
            self.0.hessian(q)
        }
        fn discrete_gradient(&self, a: [f64; D], b: [f64; D]) -> [f64; D] {
            self.0.discrete_gradient(a, b)
        }
        fn discrete_gradient_jacobian(&self, a: [f64; D], b: [f64; D]) -> [[f64; D]; D] {
            self.0.discrete_gradient_jacobian(a, b)
        }
    }
    impl<P> Conservative for ByHand<P> {}
    let mut compared = 0;
    macro_rules! one {
        ($law:ident, $d:literal, $q:expr, $v:expr) => {{
            let (c, e): (f64, f64) = (0.3, 0.02);
            let written: [f64; $d] = $law::new().field(1.0, 0.0).gradient_kick(c, e, $q, $v);
            let derived = ByHand($law::new()).field(1.0, 0.0).gradient_kick(c, e, $q, $v);
            let plain: [f64; $d] = $law::new().field(1.0, 0.0).kick(c, $q, $v);
            for i in 0..$d {
                let size = 1.0 + (written[i] - plain[i]).abs() + plain[i].abs();
                assert!((written[i] - derived[i]).abs() < 1e-14 * size, "{}: {i}", stringify!($law));
            }
            compared += usize::from(distance(written, plain) > 1e-4);
        }};
    }
    for_each_law!(one);
    assert!(compared >= 10, "{compared}: a term that does nothing shows nothing");
}

#[test]
fn reports_name_the_scheme_the_set_and_the_order() {
    let simulation = Simulation::new(Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1])).dt(0.01);
    let run = simulation.clone().scheme(Nystrom::order6()).run(10).unwrap();
    assert_eq!((run.report().scheme(), run.report().order()), ("Nystrom(BlanesMoan6S14)", 6));
    let run = simulation.scheme(ForceGradient::order4()).run(10).unwrap();
    assert!(run.to_string().contains("ForceGradient(Omelyan4S5), order 4, dt = 0.01"), "{run}");
}
