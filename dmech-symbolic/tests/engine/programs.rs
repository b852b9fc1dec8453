//! Scheduled programs: they compute their expressions, the same way every time, each operation once; power sharing.

use std::cell::Cell;
use std::collections::HashSet;

use crate::common::algebra::{Big, big, narrow};
use crate::common::evaluate::evaluate;
use crate::common::laws::{Law, cases};
use crate::common::notation::{norm, squared};
use crate::common::tracked::Tracked;
use crate::common::{U, Worst, for_all, ratio};
use dmech_symbolic::expression::{Expr, Symbol, Unary};
use dmech_symbolic::kernel::{Kernels, Step, Way};
use dmech_symbolic::program::{Operation, Program};
use nalgebra::{DMatrix, DVector};

/// The programs whose expressions are known.
fn known(kernels: &Kernels) -> Vec<(&'static str, &Program, Vec<Expr>)> {
    let f = &kernels.formulas;
    vec![
        ("potential", &kernels.pointwise.potential, vec![f.potential]),
        ("gradient", &kernels.pointwise.gradient, f.gradient.clone()),
        ("Hessian", &kernels.pointwise.hessian, f.hessian.concat()),
        ("discrete gradient", &kernels.pointwise.discrete_gradient, f.discrete_gradient.clone()),
        ("its Jacobian", &kernels.pointwise.discrete_gradient_jacobian, f.discrete_gradient_jacobian.concat()),
    ]
}

fn all(kernels: &Kernels) -> Vec<&Program> {
    let mut programs: Vec<_> = known(kernels).into_iter().map(|(_, program, _)| program).collect();
    programs.extend([&kernels.kick, &kernels.gradient_kick]);
    for step in [&kernels.implicit, &kernels.discrete] {
        programs.push(&step.program);
    }
    programs
}

/// In binary64 within the rounding errors of the expressions (`common::tracked`), evaluated with 77 digits.
#[test]
fn programs_compute_their_expressions() {
    let (worst, turns) = (Worst::new(), Worst::new());
    for_all(60, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let kernels = law.kernels();
        let (a, b) = (&case.a, &case.b(0.37));
        let lift = |q: &[f64]| q.iter().map(|&x| big(x)).collect::<Vec<Big>>();
        let track = |q: &[f64]| q.iter().map(|&value| Tracked { value, error: 0.0 }).collect::<Vec<_>>();
        for (name, program, roots) in known(&kernels) {
            let computed = program.run(law.at(a, b));
            let exact = evaluate(&law.graph, &roots, &law.values(big, &lift(a), &lift(a), &lift(b)));
            let number = |value| Tracked { value, error: 0.0 };
            let tracked = evaluate(&law.graph, &roots, &law.values(number, &track(a), &track(a), &track(b)));
            for i in 0..roots.len() {
                let allowed = U * (tracked[i].error + tracked[i].value.abs());
                let place = || format!("{name} of {}", law.graph.display(law.phi));
                worst.see(ratio((computed[i] - narrow(&exact[i])).abs(), allowed), place);
            }
        }
        // A kick is v − c ∇Φ.
        let (c, e, v) = (0.013, 0.0007, 0.7);
        let at = law.at(a, b);
        let at = |s: Symbol| {
            if s == law.variables.c {
                c
            } else if s == law.variables.e {
                e
            } else if law.variables.v.contains(&s) {
                v
            } else {
                at(s)
            }
        };
        let slope = kernels.pointwise.gradient.run(at);
        for (kicked, slope) in kernels.kick.run(at).into_iter().zip(slope) {
            assert!(
                (kicked - (v - c * slope)).abs() <= 8.0 * U * (v + (c * slope).abs()),
                "{}",
                law.graph.display(law.phi)
            );
        }
        // And with the gradient of the force v − c ∇Φ + e H ∇Φ, also where one factor of q is all there is.
        let (slope, hessian) = (kernels.pointwise.gradient.run(at), kernels.pointwise.hessian.run(at));
        let d = slope.len();
        for (i, kicked) in kernels.gradient_kick.run(at).into_iter().enumerate() {
            let row = hessian[d * i..d * (i + 1)].iter().zip(&slope).map(|(h, s)| h * s);
            let turned: f64 = row.clone().sum();
            let size = v + (c * slope[i]).abs() + e * row.map(f64::abs).sum::<f64>();
            let miss = (kicked - (v - c * slope[i] + e * turned)).abs();
            turns.see(ratio(miss, U * size), || law.graph.display(law.phi).to_string());
        }
    });
    turns.at_most(64.0, "kicks with the gradient of the force, roundings");
    worst.at_most(2.0, "programs against their expressions, roundings");
}

/// One Newton correction solves (1 + g J) δ = rhs − g G − Δ and returns G + J δ, of the energy-exact steps as two numbers:
/// against a dense solver.
#[test]
fn corrections_solve_their_equations() {
    let (worst, tried) = (Worst::new(), Cell::new([0; 2]));
    for_all(250, &cases(), |case| {
        let d = case.dimension();
        let mut law = Law::new(&case.tree, d);
        let kernels = law.kernels();
        let (a, b) = (&case.a, &case.b(0.2));
        let steps = [
            (&kernels.implicit, &kernels.pointwise.gradient, &kernels.pointwise.hessian, b),
            (&kernels.discrete, &kernels.pointwise.discrete_gradient, &kernels.pointwise.discrete_gradient_jacobian, a),
        ];
        for (k, (step, force, jacobian, start)) in steps.into_iter().enumerate() {
            let Step { way: Way::Linear | Way::Newton, program, .. } = step else { continue };
            let values = law.values(|x| x, start, a, b);
            // Steps of a size that a simulation takes: g J small, so that no pivot is needed.
            let h = DMatrix::from_row_slice(d, d, &jacobian.run(&values));
            let g = 0.3 / (1.0 + h.norm());
            let v = &law.variables;
            let at = |s: Symbol| {
                let of = |list: &[Symbol]| list.iter().position(|&t| t == s).map(|i| i as f64);
                match (s == v.g, of(&v.rhs), of(&v.delta)) {
                    (true, ..) => g,
                    (_, Some(i), _) => 0.31 - 0.17 * i,
                    (_, _, Some(i)) => 0.05 + 0.04 * i,
                    _ => values(s),
                }
            };
            let computed = program.run(at);
            let force = DVector::from_vec(force.run(&values));
            let residual = DVector::from_fn(d, |i, _| at(v.rhs[i]) - g * force[i] - at(v.delta[i]));
            let matrix = DMatrix::identity(d, d) + g * &h;
            let delta = matrix.lu().solve(&residual).expect("near the unit matrix");
            let after = &force + &h * &delta;
            let size = residual.norm() + g * force.norm();
            for i in 0..d {
                let place = || format!("{k}: {} at {a:?}, {b:?}", law.graph.display(law.phi));
                // The Jacobian's own rounding is bounded elsewhere: here 1e-13 of all that enters.
                worst.see((computed[i] - delta[i]).abs() / (1e-13 * size), place);
                let scale = force.norm() + h.norm() * (size + delta.norm());
                let [slope, last] = [1, 2].map(|vector| computed[vector * d + i]);
                worst.see(ratio((slope - force[i]).abs(), 1e-13 * force.norm()), place);
                // The sum of the implicit step, the other part of the exact one.
                let sum = [last, slope + last][k];
                worst.see(ratio((sum - after[i]).abs(), 1e-13 * scale), place);
            }
            let mut counts = tried.get();
            counts[usize::from(step.way == Way::Linear)] += 1;
            tried.set(counts);
        }
    });
    println!("{:?} corrections (Newton, linear)", tried.get());
    assert!(tried.get().iter().all(|&n| n >= 20));
    worst.at_most(1.0, "corrections against a dense solver, in units of 1e-13");
}

/// No operation twice, none unused, operands before their use, names unique.
#[test]
fn programs_are_lean_and_ordered() {
    for_all(150, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let kernels = law.kernels();
        for program in all(&kernels) {
            let mut seen = HashSet::new();
            let uses = program.uses();
            let mut names = HashSet::new();
            assert_eq!(program.names.len(), program.operations.len());
            for (i, operation) in program.operations.iter().enumerate() {
                // Addition and multiplication commute: u·w and w·u are one operation.
                let key = match operation {
                    Operation::Add(u, w) => Operation::Add(*u.min(w), *u.max(w)),
                    Operation::Mul(u, w) => Operation::Mul(*u.min(w), *u.max(w)),
                    Operation::MulAdd(u, w, x) => Operation::MulAdd(*u.min(w), *u.max(w), *x),
                    other => other.clone(),
                };
                assert!(seen.insert(key), "{operation:?} twice in {}", law.graph.display(law.phi));
                assert!(uses[i] > 0, "{operation:?} unused in {}", law.graph.display(law.phi));
                assert!(operation.operands().iter().all(|v| v.index() < i), "{operation:?}");
                if let Some(name) = &program.names[i] {
                    assert!(names.insert(name.clone()), "two values are called {name}");
                }
            }
        }
    });
}

/// The same law built twice gives the same programs, operation by operation.
#[test]
fn programs_are_deterministic() {
    for_all(60, &cases(), |case| {
        let programs = || {
            let mut law = Law::new(&case.tree, case.dimension());
            let kernels = law.kernels();
            all(&kernels).into_iter().cloned().collect::<Vec<_>>()
        };
        for (one, two) in programs().iter().zip(&programs()) {
            assert_eq!(one.operations, two.operations);
            assert_eq!((&one.outputs, &one.names), (&two.outputs, &two.names));
        }
    });
}

fn kepler(dimension: usize) -> (Law, Kernels) {
    let mut law = Law::build(dimension, |q, p| -p[0] / norm(q));
    let kernels = law.kernels();
    (law, kernels)
}

/// The kick of Kepler: one root and one division, side by side, v − q·(r·((c k)/r⁴)); neither waits for the other.
#[test]
fn the_kepler_kick_shares_its_powers() {
    for dimension in [2, 3] {
        let (law, kernels) = kepler(dimension);
        let program = &kernels.kick;
        let cost = program.cost();
        println!("kick in {dimension}: {cost}");
        assert_eq!((cost.roots, cost.divisions, cost.functions, cost.choices), (1, 1, 0, 0));
        // D squares and D kicks fused where they can be, r⁴, c·k, and r·(…).
        assert_eq!(cost.multiplications + cost.fused + cost.additions, 2 * dimension + 3, "{cost}");
        let position = |wanted: &dyn Fn(&Operation) -> bool| {
            program.operations.iter().position(wanted).expect("the operation is there")
        };
        let root = position(&|o| matches!(o, Operation::Unary(Unary::Sqrt, _)));
        let division = position(&|o| matches!(o, Operation::Div(..) | Operation::Recip(_)));
        assert!(!depends(program, division, root) && !depends(program, root, division), "in series");
        let Operation::Div(above, below) = &program.operations[division] else { panic!("a numerator is divided") };
        let Operation::Mul(c, k) = program.operation(*above) else { panic!("c k") };
        let symbols: HashSet<_> = [c, k].map(|v| program.operation(*v).clone()).into_iter().collect();
        let wanted = [law.variables.c, law.parameters[0]].map(Operation::Symbol);
        assert_eq!(symbols, wanted.into_iter().collect());
        let Operation::Mul(s, t) = program.operation(*below) else { panic!("r⁴ is s·s") };
        let Operation::Unary(_, radicand) = &program.operations[root] else { unreachable!() };
        assert_eq!((s, t), (radicand, radicand));
    }
}

fn depends(program: &Program, value: usize, on: usize) -> bool {
    value == on || program.operations[value].operands().iter().any(|v| depends(program, v.index(), on))
}

/// r⁻¹, r⁻³, r⁻⁵ of one radius: one root and one division in gradient and Hessian, two roots (one for each end) and one
/// division in the discrete gradient.
#[test]
fn powers_of_one_radius_share_root_and_division() {
    for dimension in [2, 3] {
        let (_, kernels) = kepler(dimension);
        for (name, program, roots, divisions) in [
            ("gradient", &kernels.pointwise.gradient, 1, 1),
            ("Hessian", &kernels.pointwise.hessian, 1, 1),
            ("discrete gradient", &kernels.pointwise.discrete_gradient, 2, 1),
        ] {
            let cost = program.cost();
            println!("{name} in {dimension}: {cost}");
            assert_eq!((cost.roots, cost.divisions, cost.functions), (roots, divisions, 0), "{name} in {dimension}");
        }
    }
}

/// A quadratic law steps without functions and with one division; no position is read where none is needed.
#[test]
fn linear_laws_are_solved_in_closed_form() {
    for dimension in 1..=4 {
        let mut law = Law::build(dimension, |q, p| p[0] * squared(q) / 2.0);
        let kernels = law.kernels();
        assert_eq!(kernels.discrete.way, Way::Linear, "a constant Hessian");
        let cost = kernels.discrete.program.cost();
        println!("linear step in {dimension}: {cost}");
        assert_eq!((cost.divisions, cost.roots, cost.functions), (1, 0, 0), "{cost}");
        assert!(kernels.pointwise.hessian.symbols().iter().all(|s| !law.variables.q.contains(s)));
    }
}
