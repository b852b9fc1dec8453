//! Straight-line programs: what generated code is printed from.
//!
//! [`Program::schedule`] turns n-ary expressions into binary operations: shared factors of products are found, powers
//! of one base share one root and one division, operands are taken in the order in which they become ready, and
//! products that are added become fused multiply-adds. A program that must be symmetric to the bit in two points is
//! scheduled so that exchanging them exchanges operands of commutative operations only.

mod atom;
mod interpret;
mod latency;
mod mirror;
mod naming;
mod product;
mod scheduling;
mod sharing;
mod sum;

use crate::expression::{Binary, Condition, Expr, Graph, Number, Substitution, Symbol, Unary};

/// A value of a program: an index into its list of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Value(pub(crate) u32);

impl Value {
    /// Its position in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A condition on values.
pub type Test = Condition<Value>;

/// One operation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Operation {
    Number(Number),
    Symbol(Symbol),
    Neg(Value),
    Add(Value, Value),
    Sub(Value, Value),
    Mul(Value, Value),
    Div(Value, Value),
    Recip(Value),
    /// first·second + third
    MulAdd(Value, Value, Value),
    /// third − first·second
    NegMulAdd(Value, Value, Value),
    Unary(Unary, Value),
    Binary(Binary, Value, Value),
    Select(Test, Value, Value),
}

/// A list of operations, each on earlier values, and which values are the results.
#[derive(Clone, Debug)]
pub struct Program {
    /// The operations in order.
    pub operations: Vec<Operation>,
    /// A name for each value that a formula would name (r2, inv_r3, sin_x); unique, none for the others.
    pub names: Vec<Option<String>>,
    /// The results.
    pub outputs: Vec<Value>,
}

/// How many operations of each kind a program has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Cost {
    pub additions: usize,
    pub multiplications: usize,
    pub fused: usize,
    pub divisions: usize,
    pub roots: usize,
    pub functions: usize,
    pub choices: usize,
}

impl Program {
    /// Schedules the evaluation of expressions.
    pub fn schedule(graph: &mut Graph, outputs: &[Expr]) -> Self {
        scheduling::schedule(graph, outputs, None)
    }

    /// The same, symmetric to the bit under the exchange of symbols that the substitution makes (a ↔ b). The outputs
    /// must be symmetric as expressions.
    pub fn schedule_symmetric(graph: &mut Graph, outputs: &[Expr], exchange: Substitution) -> Self {
        scheduling::schedule(graph, outputs, Some(exchange))
    }

    /// All values in order.
    pub fn values(&self) -> impl Iterator<Item = Value> + use<> {
        (0..self.operations.len()).map(|i| Value(i as u32))
    }

    /// The operation behind a value.
    pub fn operation(&self, value: Value) -> &Operation {
        &self.operations[value.index()]
    }

    /// How often each value is used, as an operand or as a result.
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        for operation in &self.operations {
            for operand in operation.operands() {
                uses[operand.index()] += 1;
            }
        }
        for output in &self.outputs {
            uses[output.index()] += 1;
        }
        uses
    }

    /// The symbols that the program reads.
    pub fn symbols(&self) -> Vec<Symbol> {
        self.operations
            .iter()
            .filter_map(|operation| match operation {
                Operation::Symbol(s) => Some(*s),
                _ => None,
            })
            .collect()
    }

    /// What it costs.
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for operation in &self.operations {
            match operation {
                Operation::Number(_) | Operation::Symbol(_) | Operation::Neg(_) => {}
                Operation::Add(..) | Operation::Sub(..) => cost.additions += 1,
                Operation::Mul(..) => cost.multiplications += 1,
                Operation::MulAdd(..) | Operation::NegMulAdd(..) => cost.fused += 1,
                Operation::Div(..) | Operation::Recip(_) => cost.divisions += 1,
                Operation::Unary(Unary::Sqrt, _) => cost.roots += 1,
                Operation::Unary(..) | Operation::Binary(..) => cost.functions += 1,
                Operation::Select(..) => cost.choices += 1,
            }
        }
        cost
    }
}

impl Operation {
    /// The values it reads.
    pub fn operands(&self) -> Vec<Value> {
        let mut operands = vec![];
        self.clone().with(&mut |value| {
            operands.push(value);
            value
        });
        operands
    }

    /// The same operation on what stands for the values.
    fn with(self, f: &mut impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Number(_) | Self::Symbol(_) => self,
            Self::Neg(u) => Self::Neg(f(u)),
            Self::Recip(u) => Self::Recip(f(u)),
            Self::Unary(function, u) => Self::Unary(function, f(u)),
            Self::Add(u, w) => Self::Add(f(u), f(w)),
            Self::Sub(u, w) => Self::Sub(f(u), f(w)),
            Self::Mul(u, w) => Self::Mul(f(u), f(w)),
            Self::Div(u, w) => Self::Div(f(u), f(w)),
            Self::Binary(function, u, w) => Self::Binary(function, f(u), f(w)),
            Self::MulAdd(u, w, x) => Self::MulAdd(f(u), f(w), f(x)),
            Self::NegMulAdd(u, w, x) => Self::NegMulAdd(f(u), f(w), f(x)),
            Self::Select(test, yes, no) => Self::Select(test.with(f), f(yes), f(no)),
        }
    }
}

impl std::fmt::Display for Cost {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            (self.additions, "addition"),
            (self.multiplications, "multiplication"),
            (self.fused, "fused multiply-add"),
            (self.divisions, "division"),
            (self.roots, "root"),
            (self.functions, "function"),
            (self.choices, "choice"),
        ];
        let plural = |n: usize| if n == 1 { "" } else { "s" };
        let shown: Vec<_> =
            parts.iter().filter(|(n, _)| *n > 0).map(|&(n, name)| format!("{n} {name}{}", plural(n))).collect();
        f.write_str(if shown.is_empty() { "nothing".to_owned() } else { shown.join(", ") }.as_str())
    }
}
