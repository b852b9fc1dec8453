//! From expressions to operations.

use crate::expression::{Expr, Graph, Node, Number, Substitution};
use crate::hash::Map;

use super::atom::{Atom, AtomKind, Atoms};
use super::mirror::Mirror;
use super::product::{Product, Products};
use super::{Operation, Program, Value, latency, naming};

pub(super) fn schedule(graph: &mut Graph, outputs: &[Expr], exchange: Option<Substitution>) -> Program {
    let order = graph.reachable(outputs);
    let mut mirror = exchange.map_or_else(Mirror::default, |exchange| Mirror::new(graph, &order, exchange));
    let images: Vec<_> = mirror.images().chain(outputs.iter().copied()).collect();
    let ready = latency::ready(graph, &graph.reachable(&images));
    let mut atoms = Atoms::new();
    let products = Products::new(graph, &order, outputs, &mut atoms, &mut mirror, &ready);
    let of_expr = vec![None; graph.len()];
    let (operations, index) = (vec![], Map::default());
    let mut scheduling = Scheduling { graph, ready, mirror, atoms, products, operations, index, of_expr };
    let outputs: Vec<_> = outputs.iter().map(|&e| scheduling.value(e)).collect();
    let mut program = Program { operations: scheduling.operations, names: vec![], outputs };
    remove_unused(&mut program);
    program.names = naming::names(graph, &program);
    program
}

pub(super) struct Scheduling<'g> {
    pub(super) graph: &'g Graph,
    pub(super) ready: Vec<u32>,
    pub(super) mirror: Mirror,
    atoms: Atoms,
    pub(super) products: Products,
    operations: Vec<Operation>,
    index: Map<Operation, Value>,
    pub(super) of_expr: Vec<Option<Value>>,
}

/// A product on its way into an operation.
pub(super) enum What {
    Value(Value),
    /// A product of two values that nothing else needs.
    Product(Value, Value),
}

impl Scheduling<'_> {
    pub(super) fn push(&mut self, operation: Operation) -> Value {
        // Addition and multiplication commute.
        let key = match &operation {
            Operation::Add(u, w) => Operation::Add(*u.min(w), *u.max(w)),
            Operation::Mul(u, w) => Operation::Mul(*u.min(w), *u.max(w)),
            Operation::MulAdd(u, w, x) => Operation::MulAdd(*u.min(w), *u.max(w), *x),
            Operation::NegMulAdd(u, w, x) => Operation::NegMulAdd(*u.min(w), *u.max(w), *x),
            _ => operation.clone(),
        };
        let next = Value(self.operations.len() as u32);
        let value = *self.index.entry(key).or_insert(next);
        if value == next {
            self.operations.push(operation);
        }
        value
    }

    pub(super) fn number(&mut self, x: f64) -> Value {
        self.push(Operation::Number(Number::new(x)))
    }

    pub(super) fn mul(&mut self, u: Value, w: Value) -> Value {
        self.push(Operation::Mul(u, w))
    }

    /// The value of an expression.
    pub(super) fn value(&mut self, e: Expr) -> Value {
        if let Some(value) = self.of_expr[e.index()] {
            return value;
        }
        let value = match self.graph.node(e).clone() {
            Node::Number(n) => self.push(Operation::Number(n)),
            Node::Symbol(s) => self.push(Operation::Symbol(s)),
            Node::Sum { constant, terms } => self.sum(constant, &terms),
            Node::Product { coefficient, .. } => {
                let magnitude = self.product(Number::ONE, e);
                if coefficient.value() < 0.0 { self.push(Operation::Neg(magnitude)) } else { magnitude }
            }
            Node::Unary(f, u) => {
                let u = self.value(u);
                self.push(Operation::Unary(f, u))
            }
            Node::Binary(f, u, w) => {
                let (u, w) = (self.value(u), self.value(w));
                self.push(Operation::Binary(f, u, w))
            }
            Node::Select(condition, yes, no) => {
                let test = condition.with(&mut |c| self.value(c));
                let (yes, no) = (self.value(yes), self.value(no));
                self.push(Operation::Select(test, yes, no))
            }
        };
        self.of_expr[e.index()] = Some(value);
        value
    }

    /// |c|·|coefficient of t|·t's factors.
    pub(super) fn product(&mut self, c: Number, t: Expr) -> Value {
        let Some(product) = self.products.of_term(c, t) else { return self.value(t) };
        match self.last_factors(product) {
            What::Value(value) => value,
            What::Product(one, two) => self.mul(one, two),
        }
    }

    /// The last multiplication of a product, still to be done: earliest factors first.
    pub(super) fn last_factors(&mut self, product: Product) -> What {
        let atoms = self.products.atoms(product).to_vec();
        let mut heap: Vec<(u32, u32, Atom)> =
            atoms.iter().map(|&a| (self.atom_ready(a), self.atom_key(a), a)).collect();
        while heap.len() > 2 {
            heap.sort_unstable_by(|x, y| y.cmp(x));
            let (one, two) = (heap.pop().expect("more than two"), heap.pop().expect("more than two"));
            let pair = AtomKind::Pair(one.2.min(two.2), one.2.max(two.2));
            let pair = self.atoms.intern(pair, &self.ready);
            heap.push((self.atom_ready(pair), self.atom_key(pair), pair));
        }
        heap.sort_unstable();
        match heap[..] {
            [] => What::Value(self.number(1.0)),
            [(_, _, only)] => What::Value(self.atom(only)),
            [(early, _, one), (late, _, two), ..] => {
                let quotient = self.quotient(one, early, two).or_else(|| self.quotient(two, late, one));
                match quotient {
                    Some(value) => What::Value(value),
                    None => What::Product(self.atom(one), self.atom(two)),
                }
            }
        }
    }

    /// numerator·(1/x) as numerator/x, where 1/x is needed here only and the numerator does not come late.
    fn quotient(&mut self, numerator: Atom, numerator_ready: u32, inverse: Atom) -> Option<Value> {
        if !self.products.single(inverse) || numerator_ready + latency::DIV > self.atom_ready(inverse) {
            return None;
        }
        let below = self.below(inverse)?;
        let numerator = self.atom(numerator);
        Some(self.push(Operation::Div(numerator, below)))
    }

    /// x where the atom is 1/x.
    fn below(&mut self, atom: Atom) -> Option<Value> {
        match self.atoms.kind(atom).clone() {
            AtomKind::Inverse(base, n) if self.products.denominators.single_exponent(base) => Some(self.power(base, n)),
            AtomKind::Inverse(base, 1) => Some(self.value(base)),
            AtomKind::Denominator(below) => Some(self.denominator(&below)),
            _ => None,
        }
    }

    fn atom_ready(&self, atom: Atom) -> u32 {
        self.atoms.ready[atom.index()]
    }

    /// An order of atoms that does not depend on which end is called a.
    fn atom_key(&mut self, atom: Atom) -> u32 {
        atom.0.min(self.mirror.image(&mut self.atoms, atom, &self.ready).0)
    }

    fn atom(&mut self, atom: Atom) -> Value {
        match self.atoms.kind(atom).clone() {
            AtomKind::Base(e) => self.value(e),
            AtomKind::Number(n) => self.push(Operation::Number(n)),
            AtomKind::Power(e, n) => self.power(e, n),
            AtomKind::Inverse(base, n) => {
                if self.products.denominators.single_exponent(base) {
                    let power = self.power(base, n);
                    self.push(Operation::Recip(power))
                } else {
                    let base = self.value(base);
                    let inverse = self.push(Operation::Recip(base));
                    self.power_of_value(inverse, n)
                }
            }
            AtomKind::Denominator(below) => {
                let below = self.denominator(&below);
                self.push(Operation::Recip(below))
            }
            AtomKind::Pair(one, two) => {
                let (ready_one, ready_two) = (self.atom_ready(one), self.atom_ready(two));
                let quotient = self.quotient(one, ready_one, two).or_else(|| self.quotient(two, ready_two, one));
                quotient.unwrap_or_else(|| {
                    let (one, two) = (self.atom(one), self.atom(two));
                    self.mul(one, two)
                })
            }
        }
    }

    /// Π baseᵢ^nᵢ, each factor with its image first, the rest as they become ready.
    fn denominator(&mut self, below: &[(Expr, i32)]) -> Value {
        let mut rest = below.to_vec();
        let mut grouped: Vec<(u32, u32, Value)> = vec![];
        while let Some((f, n)) = rest.pop() {
            let image = self.mirror.of_expr(f);
            let key = f.0.min(image.0);
            let ready = latency::power(self.ready[f.index()], n);
            let mut value = self.power(f, n);
            if image != f
                && let Some(i) = rest.iter().position(|&other| other == (image, n))
            {
                rest.remove(i);
                let twin = self.power(image, n);
                value = self.mul(value.min(twin), value.max(twin));
            }
            grouped.push((ready, key, value));
        }
        grouped.sort_unstable();
        let values: Vec<_> = grouped.into_iter().map(|(_, _, value)| value).collect();
        values.into_iter().reduce(|product, value| self.mul(product, value)).unwrap_or_else(|| self.number(1.0))
    }

    fn power(&mut self, base: Expr, n: i32) -> Value {
        let base = self.value(base);
        self.power_of_value(base, n)
    }

    fn power_of_value(&mut self, base: Value, n: i32) -> Value {
        match n {
            ..=1 => base,
            _ if n % 2 == 0 => {
                let half = self.power_of_value(base, n / 2);
                self.mul(half, half)
            }
            _ => {
                let even = self.power_of_value(base, n - 1);
                self.mul(even, base)
            }
        }
    }
}

/// Drops operations that no result needs; order is kept.
fn remove_unused(program: &mut Program) {
    let mut needed = vec![false; program.operations.len()];
    for output in &program.outputs {
        needed[output.index()] = true;
    }
    for i in (0..needed.len()).rev() {
        if needed[i] {
            for operand in program.operations[i].operands() {
                needed[operand.index()] = true;
            }
        }
    }
    let mut renumbered = vec![Value(0); needed.len()];
    let mut kept = vec![];
    for (i, operation) in program.operations.drain(..).enumerate() {
        if needed[i] {
            renumbered[i] = Value(kept.len() as u32);
            kept.push(operation.with(&mut |value| renumbered[value.index()]));
        }
    }
    program.operations = kept;
    for output in &mut program.outputs {
        *output = renumbered[output.index()];
    }
}
