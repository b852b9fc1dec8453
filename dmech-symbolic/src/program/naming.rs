//! Names that a formula would use: r2, r, inv_r2, sin_x.

use std::collections::HashSet;

use crate::expression::{Graph, Unary};

use super::{Operation, Program, Value};

/// A unique name for each value that has an obvious one.
pub(super) fn names(graph: &Graph, program: &Program) -> Vec<Option<String>> {
    let mut names: Vec<Option<String>> = vec![];
    let mut taken: HashSet<String> = program.symbols().into_iter().map(|s| graph.name(s).to_owned()).collect();
    for operation in &program.operations {
        let name = match operation {
            Operation::Symbol(s) => {
                names.push(Some(graph.name(*s).to_owned()));
                continue;
            }
            _ => name(program, operation, &names),
        };
        // Long names explain nothing.
        names.push(name.filter(|n| n.len() <= 20 && taken.insert(n.clone())));
    }
    names
}

fn name(program: &Program, operation: &Operation, names: &[Option<String>]) -> Option<String> {
    let of = |v: &Value| names[v.index()].clone();
    if let Some(radius) = squared_radius(program, operation, names) {
        return Some(radius);
    }
    match operation {
        Operation::Mul(u, w) if u == w => Some(raised(&of(u)?, 2)),
        Operation::Mul(u, w) => {
            let (one, two) = (of(u)?, of(w)?);
            let (base, m) = power(&one);
            let (other, n) = power(&two);
            (base == other && m + n < 20).then(|| format!("{base}{}", m + n))
        }
        Operation::Recip(u) => Some(format!("inv_{}", of(u)?)),
        Operation::Unary(Unary::Sqrt, u) => {
            let inner = of(u)?;
            let (base, n) = power(&inner);
            Some(if n == 2 { base.to_owned() } else { format!("sqrt_{inner}") })
        }
        Operation::Unary(f, u) => Some(format!("{}_{}", f.method(), of(u)?)),
        _ => None,
    }
}

/// "r2" is r to the 2nd, "x" is x to the 1st.
fn power(name: &str) -> (&str, u32) {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    match name[base.len()..].parse() {
        Ok(n) if !base.is_empty() && base != "q" && base != "a" && base != "b" => (base, n),
        _ => (name, 1),
    }
}

fn raised(name: &str, n: u32) -> String {
    let (base, m) = power(name);
    if base.ends_with(|c: char| c.is_ascii_digit()) { format!("{base}_{}", m * n) } else { format!("{base}{}", m * n) }
}

/// x² + y² (+ z²) is r2, and of the two ends ra2 and rb2.
fn squared_radius(program: &Program, operation: &Operation, names: &[Option<String>]) -> Option<String> {
    let mut factors = vec![];
    squares(program, operation, &mut factors)?;
    let names: Option<Vec<&String>> = factors.iter().map(|v| names[v.index()].as_ref()).collect();
    let names = names?;
    let suffixes: HashSet<&str> = names.iter().map(|n| n.trim_start_matches(['x', 'y', 'z'])).collect();
    let coordinates = names.len() >= 2 && names.iter().all(|n| n.starts_with(['x', 'y', 'z']));
    match (coordinates, suffixes.into_iter().collect::<Vec<_>>().as_slice()) {
        (true, [suffix @ ("" | "a" | "b")]) => Some(format!("r{suffix}2")),
        _ => None,
    }
}

fn squares(program: &Program, operation: &Operation, factors: &mut Vec<Value>) -> Option<()> {
    match operation {
        Operation::Mul(u, w) if u == w => factors.push(*u),
        Operation::MulAdd(u, w, rest) if u == w => {
            factors.push(*u);
            squares(program, program.operation(*rest), factors)?;
        }
        Operation::Add(u, w) => {
            squares(program, program.operation(*u), factors)?;
            squares(program, program.operation(*w), factors)?;
        }
        _ => return None,
    }
    Some(())
}
