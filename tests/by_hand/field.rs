//! A field by hand with a force, and nothing else of its own: the defaults take the force as the macro does.

use approx::assert_abs_diff_eq;
use dmech_core::Field;
use dmech_core::prelude::*;

/// Φ = x²/2 with F = −x³ − c v beside it.
#[derive(Clone, Copy)]
struct Split<const DAMPED: bool>;

struct Acting<const DAMPED: bool>;

const C: f64 = 0.3;

impl<const DAMPED: bool> Potential<1> for Acting<DAMPED> {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.5 * x * x
    }
    fn gradient(&self, q: [f64; 1]) -> [f64; 1] {
        q
    }
    fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.5 * (a + b)]
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.5]]
    }
}

impl<const DAMPED: bool> Field<1> for Acting<DAMPED> {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;

    fn slope(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        [q[0] - self.force(q, v, 0.0)[0]]
    }
    fn half_force(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        [0.5 * self.force(q, v, 0.0)[0]]
    }
    fn force(&self, [x]: [f64; 1], [v]: [f64; 1], _: f64) -> [f64; 1] {
        [-x.powi(3) - if DAMPED { C * v } else { 0.0 }]
    }
    fn force_dq(&self, [x]: [f64; 1], _: [f64; 1], _: f64) -> [[f64; 1]; 1] {
        [[-3.0 * x * x]]
    }
    fn force_dv(&self, _: [f64; 1], _: [f64; 1], _: f64) -> [[f64; 1]; 1] {
        [[if DAMPED { -C } else { 0.0 }]]
    }
}

impl<const DAMPED: bool> Law<1> for Split<DAMPED> {
    type Field<'a> = Acting<DAMPED>;

    fn field(&self, _: f64, _: f64) -> Acting<DAMPED> {
        Acting
    }
}

impl VelocityIndependent for Split<false> {}

/// x(2) of x″ = −x − x³ from rest at 1, by `Nystrom::order8()` in steps of 0.05 and by leap-frog.
const AT_TWO: f64 = -0.859_349_358_1;

#[test]
fn a_force_is_taken_by_every_scheme() {
    fn at_two<S: Scheme<Particle<Split<false>, 1>>>(scheme: S, dt: f64) -> f64 {
        Simulation::new(Split, State::new([1.0], [0.0])).scheme(scheme).dt(dt).run_until(2.0).unwrap().last().q[0]
    }
    assert_abs_diff_eq!(at_two(Nystrom::order8(), 0.05), AT_TWO, epsilon = 1e-9);
    assert_abs_diff_eq!(at_two(ForceGradient::order4(), 0.025), AT_TWO, epsilon = 1e-6);
    assert_abs_diff_eq!(at_two(ForceGradient::order8(), 0.1), AT_TWO, epsilon = 1e-9);
    assert_abs_diff_eq!(at_two(Implicit, 1e-3), AT_TWO, epsilon = 1e-5);
    assert_abs_diff_eq!(at_two(DiscreteGradient, 1e-3), AT_TWO, epsilon = 1e-5);
    assert_abs_diff_eq!(at_two(Kanatani, 1e-3), AT_TWO, epsilon = 1e-5);
    assert_abs_diff_eq!(at_two(Composed::order6(DiscreteGradient), 0.05), AT_TWO, epsilon = 1e-8);
}

/// With friction besides: the schemes that take velocities agree with one another.
#[test]
fn so_is_one_of_the_velocity() {
    fn at_two<S: Scheme<Particle<Split<true>, 1>>>(scheme: S, dt: f64) -> f64 {
        Simulation::new(Split, State::new([1.0], [0.0])).scheme(scheme).dt(dt).run_until(2.0).unwrap().last().q[0]
    }
    let fine = at_two(Composed::order6(Implicit), 0.02);
    assert_abs_diff_eq!(at_two(Composed::order6(DiscreteGradient), 0.02), fine, epsilon = 1e-9);
    assert_abs_diff_eq!(at_two(Explicit, 1e-5), fine, epsilon = 1e-4);
    assert!((fine - AT_TWO).abs() > 0.05);
}

/// The same force with nothing but itself: what is made of it is what was written.
#[derive(Clone, Copy)]
struct Bare<const DAMPED: bool>;

struct BareNow<const DAMPED: bool>;

impl<const DAMPED: bool> Potential<1> for BareNow<DAMPED> {
    fn potential(&self, q: [f64; 1]) -> f64 {
        Acting::<DAMPED>.potential(q)
    }
    fn gradient(&self, q: [f64; 1]) -> [f64; 1] {
        q
    }
    fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn discrete_gradient(&self, a: [f64; 1], b: [f64; 1]) -> [f64; 1] {
        Acting::<DAMPED>.discrete_gradient(a, b)
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.5]]
    }
}

impl<const DAMPED: bool> Field<1> for BareNow<DAMPED> {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;

    fn force(&self, q: [f64; 1], v: [f64; 1], t: f64) -> [f64; 1] {
        Acting::<DAMPED>.force(q, v, t)
    }
}

impl<const DAMPED: bool> Law<1> for Bare<DAMPED> {
    type Field<'a> = BareNow<DAMPED>;

    fn field(&self, _: f64, _: f64) -> BareNow<DAMPED> {
        BareNow
    }
}

impl VelocityIndependent for Bare<false> {}
impl LinearInVelocity for Bare<true> {}
impl LinearInVelocity for Split<true> {}

#[test]
fn a_force_alone_is_enough() {
    macro_rules! agree {
        ($damped:literal: $($scheme:expr),*) => {$(
            let start = State::new([1.0], [0.2]);
            let written = Simulation::new(Split::<$damped>, start).scheme($scheme).dt(0.05).run(40).unwrap().last().to_owned();
            let bare = Simulation::new(Bare::<$damped>, start).scheme($scheme).dt(0.05).run(40).unwrap().last().to_owned();
            assert_abs_diff_eq!(written.q[0], bare.q[0], epsilon = 1e-9);
            assert_abs_diff_eq!(written.v[0], bare.v[0], epsilon = 1e-9);
            assert!((bare.q[0] - start.q[0]).abs() > 0.1);
        )*};
    }
    agree!(false: Explicit, Leapfrog, Nystrom::order8(), ForceGradient::order4(), Implicit, DiscreteGradient, Kanatani);
    agree!(true: Explicit, Boris, Implicit, DiscreteGradient, Composed::order4(DiscreteGradient));
}
