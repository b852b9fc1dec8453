//! Symbolic solution of small linear systems against nalgebra.

use crate::common::{U, Worst};
use dmech_symbolic::expression::{Expr, Graph, Symbol};
use dmech_symbolic::linear::Corrections;
use dmech_symbolic::program::Program;
use nalgebra::{DMatrix, DVector};

/// A symbol with its row and column.
type Entry = (Symbol, usize, usize);

/// A matrix of symbols where `pattern` says so, and zeros elsewhere; mirrored if symmetric.
fn matrix(
    g: &mut Graph,
    n: usize,
    symmetric: bool,
    pattern: impl Fn(usize, usize) -> bool,
) -> (Vec<Vec<Expr>>, Vec<Entry>) {
    let mut entries = vec![vec![g.zero(); n]; n];
    let mut symbols = vec![];
    for i in 0..n {
        for j in 0..n {
            if symmetric && j < i {
                entries[i][j] = entries[j][i];
            } else if pattern(i, j) || i == j {
                let symbol = g.parameter(&format!("a{i}_{j}"));
                symbols.push((symbol, i, j));
                entries[i][j] = g.symbol(symbol);
            }
        }
    }
    (entries, symbols)
}

/// The same with numbers.
fn filled(n: usize, symbols: &[Entry], symmetric: bool, entry: impl Fn(usize, usize) -> f64) -> DMatrix<f64> {
    let mut dense = DMatrix::zeros(n, n);
    for &(_, i, j) in symbols {
        dense[(i, j)] = entry(i, j);
        if symmetric {
            dense[(j, i)] = entry(i, j);
        }
    }
    dense
}

type Pattern = fn(usize, usize) -> bool;

const PATTERNS: [(&str, Pattern); 4] = [
    ("dense", |_, _| true),
    ("diagonal", |i, j| i == j),
    ("banded", |i, j| i.abs_diff(j) <= 1),
    ("arrow", |i, j| i == 0 || j == 0),
];

/// Symmetric or not, solved once or several times.
const KINDS: [(bool, Corrections); 6] = [
    (false, Corrections::One),
    (false, Corrections::Unasked),
    (false, Corrections::Several),
    (true, Corrections::One),
    (true, Corrections::Unasked),
    (true, Corrections::Several),
];

/// Solutions of linear systems for n = 1 … 6, dense, banded and with an arrow of entries, symmetric or not.
#[test]
fn linear_systems() {
    let worst = Worst::new();
    for n in 1..=6 {
        for (name, pattern) in PATTERNS {
            for (symmetric, corrections) in KINDS {
                let mut g = Graph::new();
                let (a, symbols) = matrix(&mut g, n, symmetric, pattern);
                let right: Vec<_> = (0..n).map(|i| g.parameter(&format!("r{i}"))).collect();
                let r: Vec<_> = right.iter().map(|&s| g.symbol(s)).collect();
                let x = dmech_symbolic::linear::solve(&mut g, &a, &r, corrections).x;
                let program = Program::schedule(&mut g, &x);
                for seed in 0..6 {
                    // 1 + g H: the diagonal leads, the rest is smaller and of either sign.
                    let entry = |i: usize, j: usize| {
                        let wave = ((7 * i + 3 * j + 5 * seed + 1) as f64).sin();
                        if i == j { 1.0 + 0.4 * wave } else { 0.3 * wave }
                    };
                    let dense = filled(n, &symbols, symmetric, entry);
                    let value = |s: Symbol| match symbols.iter().find(|entry| entry.0 == s) {
                        Some(&(_, i, j)) => entry(i, j),
                        None => 0.7 - 0.4 * right.iter().position(|&t| t == s).expect("known") as f64,
                    };
                    let exact = dense
                        .clone()
                        .full_piv_lu()
                        .solve(&DVector::from_fn(n, |i, _| value(right[i])))
                        .expect("regular");
                    let condition = dense.norm() * dense.try_inverse().expect("regular").norm();
                    for (computed, exact) in program.run(value).into_iter().zip(exact.iter()) {
                        let scale = condition * exact.abs().max(1.0);
                        worst.see((computed - exact).abs() / (2.0 * U * scale), || {
                            format!("{name} {n} symmetric: {symmetric}")
                        });
                    }
                }
                let divisions = program.cost().divisions;
                println!("{name:>8} {n} {}: {}", if symmetric { "symmetric" } else { "general  " }, program.cost());
                assert!(divisions <= n, "{name} {n}: {divisions} divisions");
            }
        }
    }
    worst.at_most(16.0, "linear systems, ulp times the condition");
}

/// All of `positive` are so exactly where a symmetric matrix is positive definite, by its eigenvalues, and where the determinant
/// of any other matrix is positive; of diagonal ones, symmetric or not, where all eigenvalues are.
#[test]
fn what_is_positive_tells_whether_a_matrix_has_grown_from_the_unit_matrix() {
    // Definite; not so, with a negative determinant and with a positive one.
    let mut seen = [[0; 3]; 2];
    for n in 1..=6 {
        for (name, pattern) in PATTERNS {
            for (symmetric, corrections) in KINDS.into_iter().filter(|kind| kind.1 != Corrections::Unasked) {
                let mut g = Graph::new();
                let (a, symbols) = matrix(&mut g, n, symmetric, pattern);
                let right = vec![g.one(); n];
                let positive = dmech_symbolic::linear::solve(&mut g, &a, &right, corrections).positive;
                let program = Program::schedule(&mut g, &positive);
                for seed in 0..60 {
                    let entry = |i: usize, j: usize| {
                        let wave = ((7 * i + 3 * j + 5 * seed + 1) as f64).sin();
                        if i == j { 0.6 + wave } else { 0.5 * wave }
                    };
                    let dense = filled(n, &symbols, symmetric, entry);
                    let value = |s: Symbol| {
                        let &(_, i, j) = symbols.iter().find(|entry| entry.0 == s).expect("an entry");
                        entry(i, j)
                    };
                    let determinant = dense.determinant();
                    let definite = (symmetric || name == "diagonal").then(|| dense.symmetric_eigenvalues().min() > 0.0);
                    let expected = definite.unwrap_or(determinant > 0.0);
                    let mut found = program.run(value);
                    // Of more numbers than unknowns the first is the determinant.
                    found.truncate(if found.len() > n { 1 } else { n });
                    let found = found.into_iter().all(|x| x > 0.0);
                    assert_eq!(found, expected, "{name} {n} {symmetric} {seed}");
                    let kind = if expected { 0 } else { 1 + usize::from(determinant > 0.0) };
                    seen[usize::from(definite.is_some())][kind] += 1;
                }
            }
        }
    }
    println!("{seen:?}");
    assert!(seen[0][..2].iter().chain(&seen[1]).all(|&n| n >= 50));
}

/// A stiff direction beside soft ones, 1 + k e eᵀ: the residual is rounding of what it is formed of, whatever the condition k is.
/// Cramer's rule leaves k times as much.
#[test]
fn stiff_matrices_are_solved_to_rounding_of_the_residual() {
    let worst = Worst::new();
    for n in 2..=6 {
        let mut g = Graph::new();
        let (a, symbols) = matrix(&mut g, n, true, |_, _| true);
        let right: Vec<_> = (0..n).map(|i| g.parameter(&format!("r{i}"))).collect();
        let r: Vec<_> = right.iter().map(|&s| g.symbol(s)).collect();
        let x = dmech_symbolic::linear::solve(&mut g, &a, &r, Corrections::One).x;
        let program = Program::schedule(&mut g, &x);
        for stiff in [1e1, 1e3, 1e6, 1e9, 1e12] {
            for seed in 0..40 {
                let along: Vec<_> = (0..n).map(|i| ((7 * i + 5 * seed + 1) as f64).sin()).collect();
                let entry = |i: usize, j: usize| f64::from(u8::from(i == j)) + stiff * along[i] * along[j];
                let rhs = |i: usize| 0.7 - 0.4 * i as f64;
                let value = |s: Symbol| match symbols.iter().find(|entry| entry.0 == s) {
                    Some(&(_, i, j)) => entry(i, j),
                    None => right.iter().position(|&t| t == s).map_or(f64::NAN, rhs),
                };
                let x = program.run(value);
                for i in 0..n {
                    let terms = (0..n).map(|j| entry(i, j) * x[j]);
                    let residual = rhs(i) - terms.clone().sum::<f64>();
                    let size: f64 = rhs(i).abs() + (0..n).map(|j| entry(i, j).abs() * x[j].abs()).sum::<f64>();
                    worst.see(residual.abs() / (2.0 * U * size), || format!("{n} {stiff:e} {seed} {i}"));
                }
            }
        }
    }
    worst.at_most(32.0, "residuals of stiff systems, ulp of their terms");
}
