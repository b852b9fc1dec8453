//! Running a program without a compiler.

use dmech_scalar::Real;

use crate::expression::Symbol;

use super::{Operation, Program, Value};

impl Program {
    /// The results, given the values of the symbols.
    pub fn run<R: Real>(&self, symbol: impl Fn(Symbol) -> R) -> Vec<R> {
        let mut values: Vec<R> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let of = |v: &Value| values[v.index()];
            let value = match operation {
                Operation::Number(n) => n.of(),
                Operation::Symbol(s) => symbol(*s),
                Operation::Neg(u) => -of(u),
                Operation::Add(u, w) => of(u) + of(w),
                Operation::Sub(u, w) => of(u) - of(w),
                Operation::Mul(u, w) => of(u) * of(w),
                Operation::Div(u, w) => of(u) / of(w),
                Operation::Recip(u) => of(u).recip(),
                Operation::MulAdd(u, w, x) => of(u).mul_add(of(w), of(x)),
                Operation::NegMulAdd(u, w, x) => (-of(u)).mul_add(of(w), of(x)),
                Operation::Unary(f, u) => f.apply(of(u)),
                Operation::Binary(f, u, w) => f.apply(of(u), of(w)),
                Operation::Select(test, yes, no) => R::select(test.mask(&|v| of(&v)), || of(yes), || of(no)),
            };
            values.push(value);
        }
        self.outputs.iter().map(|v| values[v.index()]).collect()
    }
}
