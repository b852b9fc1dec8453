//! Running a program without a compiler.

use dmech_scalar::{Mask, Real};

use crate::expression::{Relation, Symbol};

use super::{Operation, Program, Test, Value};

impl Program {
    /// The results, given the values of the symbols.
    pub fn run<R: Real>(&self, symbol: impl Fn(Symbol) -> R) -> Vec<R> {
        let mut values: Vec<R> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let of = |v: &Value| values[v.index()];
            let value = match operation {
                Operation::Number(n) => R::from_f64(n.value()),
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
                Operation::Select(test, yes, no) => R::select(mask(test, &of), || of(yes), || of(no)),
            };
            values.push(value);
        }
        self.outputs.iter().map(|v| values[v.index()]).collect()
    }
}

fn mask<R: Real>(test: &Test, value: &impl Fn(&Value) -> R) -> R::Mask {
    match test {
        Test::Compare(Relation::Less, left, right) => value(left).less(value(right)),
        Test::Compare(Relation::LessOrEqual, left, right) => value(left).less_or_equal(value(right)),
        Test::Compare(Relation::Equal, left, right) => value(left).equal(value(right)),
        Test::Not(inner) => mask(inner, value).not(),
        Test::And(one, two) => mask(one, value).and(mask(two, value)),
        Test::Or(one, two) => mask(one, value).or(mask(two, value)),
    }
}
