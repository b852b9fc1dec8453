//! Generated code does what the engine says, bit for bit.

use dmech::extend::newton::Equation;
use dmech::extend::{Field, Real};
use dmech::prelude::*;
use dmech_codegen::{Derivation, Source};
use dmech_symbolic::expression::Symbol;
use dmech_symbolic::program::Program;

use dmech_tests::for_each_law;
use dmech_tests::laws::*;

/// Reproducible numbers in (−1, 1).
struct Dice(u64);

impl Dice {
    fn throw(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn near<const D: usize>(&mut self, q: [f64; D], radius: f64) -> [f64; D] {
        q.map(|x| x + radius * self.throw())
    }
}

/// The law read from its source by the library behind the macro, with values for its symbols.
struct Oracle {
    derivation: Derivation,
    parameters: Vec<(Symbol, f64)>,
}

impl Oracle {
    fn new(source: &str, values: &[(&'static str, f64)]) -> Self {
        let derivation = dmech_codegen::derivation_of_impl(source.parse().unwrap()).unwrap_or_else(|e| panic!("{e:?}"));
        let parameters = derivation
            .lowered
            .parameters
            .iter()
            .map(|parameter| {
                let Source::Law(tokens) = &parameter.source else { panic!("only fields here") };
                let field = tokens.to_string().replace("self", "").replace(['.', ' '], "");
                (parameter.symbol, values.iter().find(|(name, _)| *name == field).expect("a field").1)
            })
            .collect();
        Self { derivation, parameters }
    }

    fn run<R: Real>(&self, program: &Program, arrays: &[(&[Symbol], &[R])]) -> Vec<R> {
        program.run(|symbol| {
            let own = self.parameters.iter().find(|(s, _)| *s == symbol).map(|(_, x)| R::from_f64(*x));
            own.or_else(|| arrays.iter().find_map(|(s, x)| Some(x[s.iter().position(|s| *s == symbol)?])))
                .expect("every symbol has a value")
        })
    }
}

fn check<L, R: Real + PartialEq, const D: usize>(law: L, oracle: &Oracle, q: [f64; D])
where
    L: Law<D, R> + Potential<D, R>,
{
    let variables = &oracle.derivation.lowered.variables;
    let kernels = &oracle.derivation.kernels;
    let mut dice = Dice(0x9e37_79b9_7f4a_7c15);
    let mut compared = 0;
    let mut same = |generated: &[R], expected: Vec<R>, what: &str| {
        assert_eq!(generated.len(), expected.len());
        for (g, e) in generated.iter().zip(&expected) {
            assert!(g == e, "{what}: {g:?} generated, {e:?} interpreted");
            assert!(g.to_f64().is_finite(), "{what}: nothing to compare");
            compared += usize::from(g.to_f64() != 0.0);
        }
    };
    for _ in 0..50 {
        let (a, b) = (dice.near(q, 0.3).map(R::from_f64), dice.near(q, 0.3).map(R::from_f64));
        let (v, c) = (dice.near([0.4; D], 0.5).map(R::from_f64), R::from_f64(0.013));
        let ends = [(&variables.a[..], &a[..]), (&variables.b[..], &b[..])];
        same(
            &[law.potential(a)],
            oracle.run(&kernels.pointwise.potential, &[arguments(&variables.q, &a)]),
            "potential",
        );
        same(&law.gradient(a), oracle.run(&kernels.pointwise.gradient, &[arguments(&variables.q, &a)]), "gradient");
        same(
            &law.hessian(a).concat(),
            oracle.run(&kernels.pointwise.hessian, &[arguments(&variables.q, &a)]),
            "hessian",
        );
        let all = [arguments(&variables.q, &a), (&variables.v[..], &v[..]), (&[variables.c][..], &[c][..])];
        same(&law.field(R::ONE, R::ZERO).kick(c, a, v), oracle.run(&kernels.kick, &all), "kick");
        same(
            &law.discrete_gradient(a, b),
            oracle.run(&kernels.pointwise.discrete_gradient, &ends),
            "discrete gradient",
        );
        let jacobian = law.discrete_gradient_jacobian(a, b).concat();
        same(&jacobian, oracle.run(&kernels.pointwise.discrete_gradient_jacobian, &ends), "Jacobian");
    }
    assert!(compared > 100, "{compared} numbers compared");
}

fn arguments<'a, R, const D: usize>(symbols: &'a [Symbol], x: &'a [R; D]) -> (&'a [Symbol], &'a [R]) {
    (symbols, x)
}

/// The specialised increments solve the same equation as the generic Newton iteration on the same law.
fn solves<L: Law<D> + Potential<D>, const D: usize>(law: &L, q: [f64; D], v: [f64; D]) {
    let h = 0.02;
    let drift = v.map(|v| h * v);
    let zero = [0.0; D];
    for (g, frozen) in [(0.25 * h * h, law.gradient(q).map(|x| 0.25 * h * h * x)), (0.5 * h * h, zero)] {
        let equation = Equation { frozen, ..Equation::new(q, drift, g) };
        let (fast, slow) = if frozen != zero {
            let dense = dmech::extend::newton::dense(&equation, |b| (law.gradient(b), law.hessian(b)));
            (law.field(1.0, 0.0).implicit_increment(&equation).unwrap(), dense.unwrap())
        } else {
            let dense = dmech::extend::newton::dense_discrete(&equation, |a, b| {
                (law.discrete_gradient(a, b), law.discrete_gradient_jacobian(a, b))
            });
            (law.field(1.0, 0.0).discrete_increment(&equation).unwrap(), dense.unwrap())
        };
        for i in 0..D {
            let scale = slow.delta.iter().map(|x| x.abs()).fold(0.0, f64::max);
            assert!((fast.delta[i] - slow.delta[i]).abs() < 4.0 * f64::EPSILON * scale, "{fast:?} {slow:?}");
            let scale = slow.gradient.iter().map(|x| x.abs()).fold(1.0, f64::max);
            assert!((fast.gradient[i] - slow.gradient[i]).abs() < 64.0 * f64::EPSILON * scale, "{fast:?} {slow:?}");
        }
        assert_eq!(fast.iterations == 0, L::LINEAR, "{fast:?}");
    }
}

macro_rules! check_law {
    ($law:ident, $d:literal, $q:expr, $v:expr) => {{
        let law = $law::new();
        let oracle = Oracle::new($law::SOURCE, &law.parameters());
        check::<_, f64, $d>(law, &oracle, $q);
        check::<_, f32, $d>(law, &oracle, $q);
        solves::<_, $d>(&law, $q, $v);
    }};
}

#[test]
fn generated_code_equals_the_interpreter_and_solves_the_same_equations() {
    for_each_law!(check_law);
}

#[test]
fn structure_is_what_the_formula_says() {
    fn of<L: Potential<D>, const D: usize>(_: L) -> (bool, bool) {
        (L::CENTRAL, L::LINEAR)
    }
    assert_eq!(of(Kepler::new()), (true, false));
    assert_eq!(of(Plummer::new()), (true, false));
    assert_eq!(of(Morse::new()), (true, false));
    assert_eq!(of(Oscillator::new()), (true, true));
    assert_eq!(of(Coupled::new()), (false, true));
    assert_eq!(of(HenonHeiles::new()), (false, false));
    assert_eq!(of(Pendulum::new()), (false, false));
}
