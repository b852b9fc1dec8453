//! Laws between two bodies: potentials of the distance through one variable, forces and their Jacobians, and what the
//! engine decides of both: symmetric in the two bodies or not, reciprocal or not.

use crate::common::algebra::{Algebra, Big, Dual, big, narrow};
use crate::common::evaluate::evaluate;
use crate::common::notation::{E, choose, norm, squared, within};
use crate::common::tracked::Tracked;
use crate::common::{U, Worst, ratio};
use dmech_symbolic::expression::{Expr, Graph, Symbol, Unary};
use dmech_symbolic::kernel::{
    PairForce, PairFormulas, PairKernels, PairLaw, PairPotential, PairVariables, Radial, Variables,
};
use dmech_symbolic::program::Program;
use num_dual::Dual64;

/// What the laws read of a and of b, and a parameter.
const NUMBERS: [f64; 5] = [0.7, -1.9, 2.3, 1.1, 0.6];

/// What a law can be written in.
struct Place {
    d: Vec<E>,
    va: Vec<E>,
    vb: Vec<E>,
    r: E,
    /// One number of each body, and another of each.
    a: [E; 2],
    b: [E; 2],
    k: E,
}

struct Law {
    graph: Graph,
    variables: Variables,
    pair: PairVariables,
    numbers: Vec<Symbol>,
    kernels: PairKernels,
}

type AnyPotential<'a> = &'a dyn Fn(&Place) -> E;
type AnyForce<'a> = &'a dyn Fn(&Place) -> Vec<E>;

fn law(dimension: usize, potential: Option<AnyPotential<'_>>, force: Option<AnyForce<'_>>) -> Law {
    let mut graph = Graph::new();
    let variables = Variables::new(&mut graph, dimension);
    let pair = PairVariables::new(&mut graph, dimension);
    let numbers: Vec<_> = ["qa", "qb", "ma", "mb", "k"].iter().map(|name| graph.parameter(name)).collect();
    let r = E(pair.distance(&mut graph));
    let mut list = |names: &[Symbol]| names.iter().map(|&s| E(graph.symbol(s))).collect::<Vec<_>>();
    let n = list(&numbers);
    let (d, va, vb) = (list(&variables.q), list(&pair.va), list(&pair.vb));
    let place = Place { d, va, vb, r, a: [n[0], n[2]], b: [n[1], n[3]], k: n[4] };
    let (potential, force) = within(&mut graph, || {
        let force = force.map(|f| f(&place).into_iter().map(|e| e.0).collect());
        (potential.map(|phi| phi(&place).0), force)
    });
    let exchange = vec![(numbers[0], numbers[1]), (numbers[2], numbers[3])];
    let kernels = PairKernels::new(&mut graph, &PairLaw { potential, force, exchange }, &variables, &pair);
    Law { graph, variables, pair, numbers, kernels }
}

impl Law {
    fn radial(&self) -> (&Radial, &PairPotential) {
        match self.kernels.potential.as_ref().map(|potential| (&potential.formulas, potential)) {
            Some((PairFormulas::Radial(radial), potential)) => (radial, potential),
            other => panic!("not a potential of the distance: {other:?}"),
        }
    }

    fn force(&self) -> &PairForce {
        self.kernels.force.as_ref().expect("a force")
    }

    /// Symbols and their values; the numbers of the bodies besides.
    fn at<T: Algebra>(&self, known: &[(&[Symbol], &[T])]) -> impl Fn(Symbol) -> T + use<T> {
        let numbers = self.numbers.iter().copied().zip(NUMBERS.map(T::number));
        let known = known.iter().flat_map(|(names, values)| names.iter().copied().zip(values.iter().cloned()));
        let all: Vec<(Symbol, T)> = numbers.chain(known).collect();
        move |s| all.iter().find(|(name, _)| *name == s).map_or_else(|| T::number(0.0), |(_, x)| x.clone())
    }

    /// At one squared distance, and between two.
    fn at_squares<T: Algebra>(&self, s: &T, s_a: &T, s_b: &T) -> impl Fn(Symbol) -> T + use<T> {
        let names = [self.pair.s, self.pair.s_a, self.pair.s_b];
        self.at(&[(&names, &[s.clone(), s_a.clone(), s_b.clone()])])
    }

    fn value<T: Algebra>(&self, e: Expr, at: &dyn Fn(Symbol) -> T) -> T {
        evaluate(&self.graph, &[e], at).remove(0)
    }
}

type Formula = fn(&Place) -> E;

/// Potentials of the distance: even and odd powers, a shifted spring, exponentials, a logarithm.
const RADIAL: [(&str, Formula); 7] = [
    ("gravity", |p| -p.k * p.a[1] * p.b[1] / p.r),
    ("Lennard-Jones", |p| {
        let x = (p.k / p.r).powi(6);
        4.0 * (x * x - x)
    }),
    ("spring with a length", |p| 0.5 * p.k * (p.r - 1.3).powi(2)),
    ("Morse", |p| p.k * (1.0 - (-1.7 * (p.r - 1.2)).exp()).powi(2)),
    ("Yukawa", |p| p.a[0] * p.b[0] * (-p.r / p.k).exp() / p.r),
    ("vortices", |p| p.a[0] * p.b[0] * p.r.ln()),
    ("oscillator", |p| 0.5 * p.k * p.r.powi(2)),
];

const SQUARES: [f64; 4] = [0.31, 0.97, 2.6, 11.0];
const GAPS: [f64; 9] = [1.4, 0.3, 0.1, 1e-2, 1e-4, 1e-7, 1e-10, 1e-13, 1e-15];

/// C(s_a, s_b) is the divided difference of Φ, computed with 77 digits: as many roundings off as the formula has
/// operations, at any gap; and no bit of it changes with the order of the ends.
#[test]
fn the_discrete_coefficient_is_the_divided_difference() {
    let (roundings, formula, growth) = (Worst::new(), Worst::new(), Worst::new());
    for (name, phi) in RADIAL {
        let law = law(0, Some(&phi), None);
        let (formulas, radial) = law.radial();
        let exact = |s: f64| law.value(formulas.potential, &law.at_squares(&big(s), &big(1.0), &big(1.0)));
        for s_a in SQUARES {
            let mut apart = 0.0_f64;
            for gap in GAPS {
                let s_b = s_a * (1.0 + gap);
                let place = || format!("{name} between {s_a} and {s_b}");
                let computed = radial.pointwise.discrete_gradient.run(law.at_squares(&0.0, &s_a, &s_b))[0];
                let turned = radial.pointwise.discrete_gradient.run(law.at_squares(&0.0, &s_b, &s_a))[0];
                assert_eq!(computed.to_bits(), turned.to_bits(), "{}", place());
                let rise: Big = exact(s_b).minus(&exact(s_a));
                let quotient = rise.over(&big(s_b).minus(&big(s_a)));
                let ends = [0.0, s_a, s_b].map(Tracked::number);
                let tracked = law.value(formulas.discrete_coefficient, &law.at_squares(&ends[0], &ends[1], &ends[2]));
                let error = narrow(&big(computed).minus(&quotient)).abs();
                roundings.see(ratio(error, U * (tracked.error + tracked.value.abs())), place);
                let ends = [0.0, s_a, s_b].map(big);
                let of_formula =
                    law.value(formulas.discrete_coefficient, &law.at_squares(&ends[0], &ends[1], &ends[2]));
                formula.see(narrow(&of_formula.minus(&quotient)).abs() / (tracked.error + 1e-3) * 1e40, place);
                if gap >= 0.1 {
                    apart = apart.max(tracked.error);
                } else {
                    growth.see(ratio(tracked.error, apart), place);
                }
            }
            let limit = radial.pointwise.discrete_gradient.run(law.at_squares(&0.0, &s_a, &s_a))[0];
            let slope = radial.pointwise.gradient.run(law.at_squares(&s_a, &0.0, &0.0))[0];
            let scale = law.value(formulas.discrete_coefficient, &{
                let s = Tracked::number(s_a);
                law.at_squares(&s, &s, &s)
            });
            roundings.see(ratio((limit - slope / 2.0).abs(), 2.0 * U * scale.error), || format!("{name} at {s_a}"));
        }
    }
    roundings.at_most(2.0, "C against the quotient with 77 digits, roundings");
    formula.at_most(1.0, "the formula of C against the quotient, in 1e-40");
    growth.at_most(20.0, "roundings of close ends to those of distant ones");
}

/// c = 2Φ′, c′, C and ∂C/∂s_b against dual numbers.
#[test]
fn coefficients_are_derivatives() {
    let (worst, schedules) = (Worst::new(), Worst::new());
    for (name, phi) in RADIAL {
        let law = law(0, Some(&phi), None);
        let (formulas, radial) = law.radial();
        let derivative = |e: Expr, s: f64, s_a: f64, moving: f64| {
            let mut s_b = Dual64::from_re(moving);
            s_b.eps = 1.0;
            let mut at = Dual64::from_re(s);
            at.eps = 1.0;
            law.value(e, &law.at_squares(&Dual(at), &Dual(Dual64::from_re(s_a)), &Dual(s_b))).0.eps
        };
        for s in SQUARES {
            let [c, slope] = radial.pointwise.hessian.run(law.at_squares(&s, &0.0, &0.0))[..] else {
                panic!("c and c′")
            };
            let see = |what: &str, computed: f64, twin: f64, scale: f64| {
                worst.see((computed - twin).abs() / scale, || format!("{what} of {name} at {s}: {computed} {twin}"));
            };
            // Two schedules of one formula: the same but for the order of a few products.
            let alone = radial.pointwise.gradient.run(law.at_squares(&s, &0.0, &0.0))[0];
            schedules.see(ratio((c - alone).abs(), U * (c.abs() + 1.0)), || format!("{name} at {s}: {c} {alone}"));
            see("c", c, 2.0 * derivative(formulas.potential, s, 1.0, 1.0), c.abs() + 1.0);
            see("c′", slope, derivative(formulas.coefficient, s, 1.0, 1.0), slope.abs() + 1.0);
            for gap in GAPS {
                let s_b = s * (1.0 + gap);
                let [_, slope] = radial.pointwise.discrete_gradient_jacobian.run(law.at_squares(&0.0, &s, &s_b))[..]
                else {
                    panic!("C and its derivative")
                };
                see("∂C/∂s_b", slope, derivative(formulas.discrete_coefficient, 0.0, s, s_b), slope.abs() + 1.0);
            }
        }
        let c = law.graph.depends_on(formulas.coefficient, &[law.pair.s]);
        assert_eq!(radial.linear, !c);
        assert_eq!(radial.linear, name == "oscillator", "{name}");
    }
    worst.at_most(1e-13, "relative to dual numbers");
    schedules.at_most(8.0, "one coefficient from two programs, roundings");
}

/// What runs in a loop over all pairs: no more roots and divisions than by hand.
#[test]
fn what_a_gradient_costs() {
    let cost = |name: &str| {
        let (_, phi) = RADIAL.into_iter().find(|(other, _)| *other == name).expect("in the list");
        let law = law(0, Some(&phi), None);
        let costs = [&law.radial().1.pointwise.gradient, &law.radial().1.pointwise.hessian].map(Program::cost);
        costs.map(|cost| (cost.roots, cost.divisions, cost.functions))
    };
    assert_eq!(cost("gravity"), [(1, 1, 0); 2]);
    assert_eq!(cost("Lennard-Jones"), [(0, 1, 0); 2]);
    assert_eq!(cost("oscillator"), [(0, 0, 0); 2]);
    assert_eq!(cost("vortices"), [(0, 1, 0); 2]);
    assert_eq!(cost("Yukawa")[0].2, 1);
}

/// A potential of the separation that depends on the distance alone is one of the distance.
#[test]
fn the_distance_is_found_in_the_separation() {
    let by_d = law(3, Some(&|p| -p.k * p.a[1] * p.b[1] / norm(&p.d)), None);
    let by_r = law(0, Some(&RADIAL[0].1), None);
    let s = 1.7;
    let run = |law: &Law| law.radial().1.pointwise.gradient.run(law.at_squares(&s, &0.0, &0.0));
    assert_eq!(run(&by_d), run(&by_r));
    let slanted = law(3, Some(&|p| p.k * (squared(&p.d) + p.d[0].powi(2)).powi(2)), None);
    let of_separation =
        slanted.kernels.potential.is_some_and(|phi| matches!(phi.formulas, PairFormulas::Separation(_)));
    assert!(of_separation);
    let alone = law(3, None, Some(&|p| p.d.iter().map(|&d| p.k * d).collect()));
    assert!(alone.kernels.potential.is_none());
}

/// Φ(d; a, b) = Φ(−d; b, a), decided on the expression.
#[test]
fn symmetric_or_not() {
    let cases: [(&str, bool, Formula); 17] = [
        ("the product of charges", true, |p| p.a[0] * p.b[0] / p.r),
        ("one charge only", false, |p| p.a[0] / p.r),
        ("the first mass and the second charge", false, |p| p.a[1] * p.b[0] / p.r),
        ("the mean length", true, |p| 0.5 * p.k * (p.r - 0.5 * (p.a[0] + p.b[0])).powi(2)),
        ("the difference of charges", false, |p| (p.a[0] - p.b[0]) * p.r),
        ("its square", true, |p| (p.a[0] - p.b[0]).powi(2) * p.r),
        ("even in d", true, |p| p.k * p.d[0].powi(2) + 0.3 * p.d[1].powi(4)),
        ("odd in d", false, |p| 0.5 * p.d[0].powi(2) + p.k * p.d[0].powi(3)),
        ("odd in d and in the charges", true, |p| (p.a[0] - p.b[0]) * p.d[0].sin()),
        ("a product of two components", true, |p| p.k * p.d[0] * p.d[1]),
        ("written out on one side", true, |p| {
            (p.a[0] + p.b[0]) * p.d[1].powi(2) - p.a[0] * p.d[1].powi(2) + p.b[0] * p.a[0]
                - p.b[0] * (p.d[1].powi(2) - p.k)
                - p.b[0] * p.k
        }),
        ("the larger charge", true, |p| p.a[0].max(p.b[0]) * p.r),
        ("the larger charge less the smaller one", true, |p| (p.a[0].max(p.b[0]) - p.b[0].min(p.a[0])) * p.r),
        ("their gap times one mass", false, |p| (p.a[0].max(p.b[0]) - p.b[0].min(p.a[0])) * p.a[1] * p.r),
        ("the larger of a charge and a mass", false, |p| p.a[0].max(p.b[1]) * p.r),
        ("a charge up to the other mass", false, |p| p.a[0].min(p.b[0]) * p.a[1].max(p.b[0]) * p.r),
        ("the length of d", true, |p| p.k * (p.d[0].powi(2) + p.d[1].powi(2) + 0.1).sqrt()),
    ];
    let (mut accepted, mut rejected) = (0, 0);
    for (name, expected, phi) in cases {
        assert_eq!(law(2, Some(&phi), None).kernels.symmetric, expected, "{name}");
        *(if expected { &mut accepted } else { &mut rejected }) += 1;
    }
    assert!(accepted > 3 && rejected > 3);
    assert!(law(2, None, Some(&|p| vec![p.a[0] * p.d[0], p.k])).kernels.symmetric, "a force alone has no energy");
}

/// Products of many sums are not written out without end: the answer is then no.
#[test]
fn long_products_end() {
    let product: Formula = |p| {
        (0..12).fold(p.k, |product, i| product * (p.d[0] * f64::from(i + 1) + p.a[0] * f64::from(2 * i + 3) + p.d[1]))
    };
    let law = law(2, Some(&product), None);
    assert!(!law.kernels.symmetric);
    assert!(law.graph.len() < 200_000, "{}", law.graph.len());
}

type Force = fn(&Place) -> Vec<E>;

/// A force along c(…) (v_a − v_b) or c(…) d.
fn along(c: E, direction: Vec<E>) -> Vec<E> {
    direction.into_iter().map(|x| c * x).collect()
}

fn relative(p: &Place) -> Vec<E> {
    p.va.iter().zip(&p.vb).map(|(&a, &b)| a - b).collect()
}

const FORCES: [(&str, bool, Force); 12] = [
    ("drag between two", true, |p| along(-p.k, relative(p))),
    ("drag with masses", true, |p| along(-p.k * p.a[1] * p.b[1] * (1.0 + squared(&p.d)), relative(p))),
    ("dissipative particles", true, |p| {
        let u = relative(p);
        let push = u.iter().zip(&p.d).fold(E::from(0.0), |sum, (&u, &d)| sum + u * d);
        along(-p.k * push / squared(&p.d), p.d.clone())
    }),
    ("drag within a distance", true, |p| {
        let near = squared(&p.d).less(1.2);
        relative(p).into_iter().map(|u| choose(near.clone(), -p.k * u, 0.0)).collect()
    }),
    ("drag by the rougher of the two", true, |p| {
        let rough = p.a[0].max(p.b[0]);
        relative(p).into_iter().map(|u| -rough * u).collect()
    }),
    ("drag of one far away", false, |p| {
        let near = squared(&p.d).less(0.5);
        relative(p).into_iter().zip(&p.va).map(|(u, &va)| choose(near.clone(), -p.k * u, -p.k * va)).collect()
    }),
    ("drag on one side", false, |p| {
        let left = p.d[0].less(0.0);
        relative(p).into_iter().map(|u| choose(left.clone(), -p.k * u, -0.5 * p.k * u)).collect()
    }),
    ("gravity", true, |p| along(-p.k * p.a[1] * p.b[1] / norm(&p.d).powi(3), p.d.clone())),
    ("Greenspan's molecules", false, |p| {
        let speed = norm(&p.va);
        let r = norm(&p.d);
        let c = p.a[1] * p.b[1] * (-p.k / r.powi(2) + 1.4 / r.powi(3) - 0.08 * speed) / r;
        along(c, p.d.clone())
    }),
    ("one speed", false, |p| along(-p.k, p.va.clone())),
    ("a pursuer", false, |p| along(-p.a[0], p.d.clone())),
    ("a wind", false, |p| along(p.k, vec![E::from(1.0); p.d.len()])),
];

const D: [f64; 3] = [0.3, -0.8, 0.5];
const VA: [f64; 3] = [1.1, 0.2, -0.6];
const VB: [f64; 3] = [-0.4, 0.7, 0.9];

/// Reciprocity is decided on the expression; and what is called reciprocal is, to the last rounding.
#[test]
fn reciprocal_or_not() {
    for (name, expected, force) in FORCES {
        let law = law(3, None, Some(&force));
        let kernels = law.force();
        assert_eq!(kernels.reciprocal, expected, "{name}");
        let names = [&law.variables.q[..], &law.pair.va, &law.pair.vb];
        let there = kernels.force.run(law.at(&[(names[0], &D), (names[1], &VA), (names[2], &VB)]));
        let back = D.map(|x| -x);
        let swapped = [NUMBERS[1], NUMBERS[0], NUMBERS[3], NUMBERS[2]];
        let known = [(&law.numbers[..4], &swapped[..]), (names[0], &back), (names[1], &VB), (names[2], &VA)];
        let values: Vec<(Symbol, f64)> =
            known.iter().flat_map(|(names, values)| names.iter().copied().zip(values.iter().copied())).collect();
        let k = (law.numbers[4], NUMBERS[4]);
        let here = kernels
            .force
            .run(|s| values.iter().chain([&k]).find(|(name, _)| *name == s).map_or(0.0, |&(_, value)| value));
        let sum: f64 = there.iter().zip(&here).map(|(a, b)| (a + b).abs()).sum();
        let size: f64 = there.iter().map(|x| x.abs()).sum();
        assert_eq!(sum <= 8.0 * U * size, expected, "{name}: {sum:e} of {size}");
    }
}

/// The three Jacobians against dual numbers.
#[test]
fn jacobians_of_forces() {
    let worst = Worst::new();
    for (name, _, force) in FORCES {
        let law = law(3, None, Some(&force));
        let kernels = law.force();
        let names = [&law.variables.q[..], &law.pair.va, &law.pair.vb];
        let points = [D, VA, VB];
        let jacobians = kernels.jacobians.run(law.at(&[(names[0], &D), (names[1], &VA), (names[2], &VB)]));
        assert_eq!(jacobians.len(), 27);
        for (block, _) in points.iter().enumerate() {
            for j in 0..3 {
                let mut lifted = points.map(|point| point.map(|x| Dual(Dual64::from_re(x))));
                lifted[block][j].0.eps = 1.0;
                let known = [0, 1, 2].map(|k| (names[k], &lifted[k][..]));
                let column = evaluate(&law.graph, &kernels.formulas, &law.at(&known));
                for i in 0..3 {
                    let computed = jacobians[9 * block + 3 * i + j];
                    let twin = column[i].0.eps;
                    let place = || format!("{block}: {i}{j} of {name}: {computed} {twin}");
                    worst.see((computed - twin).abs() / (U * (twin.abs() + 0.1)), place);
                }
            }
        }
        let moving = points.iter().enumerate().skip(1);
        let velocity: f64 =
            moving.map(|(block, _)| jacobians[9 * block..9 * block + 9].iter().map(|x| x.abs()).sum::<f64>()).sum();
        assert_eq!(kernels.depends_on_velocity, velocity > 0.0, "{name}");
    }
    worst.at_most(64.0, "Jacobians against dual numbers, roundings");
}

/// Two bodies at one place, with a law that is least there: nothing acts, and the Newton matrices are finite.
#[test]
fn bodies_may_be_at_one_place() {
    let laws: [Formula; 9] = [
        |p| p.k * (p.r.exp() - p.r),
        |p| p.r - (1.0 + p.r).ln(),
        |p| p.k * (1.0 - (-p.r).exp()).powi(2),
        |p| p.r * p.r.sin(),
        |p| p.r.of(Unary::Sinh) * p.r.of(Unary::Asinh),
        |p| p.r.powf(1.5),
        |p| p.k * p.r.powf(1.7),
        |p| p.r * p.r.of(Unary::Tanh),
        |p| (p.k * p.r).of(Unary::Tanh).powi(2),
    ];
    for (i, phi) in laws.into_iter().enumerate() {
        let law = law(0, Some(&phi), None);
        let (_, radial) = law.radial();
        for (s_a, s_b) in [(0.0, 0.0), (0.3, 0.0), (0.0, 0.3), (1e-310, 0.0)] {
            for (k, program) in radial.pointwise.each().into_iter().enumerate().skip(1) {
                let found = program.run(law.at_squares(&s_b, &s_a, &s_b));
                assert!(found.iter().all(|x| x.is_finite()), "{i}, {k} from {s_a:e} to {s_b:e}: {found:?}");
            }
        }
    }
}
