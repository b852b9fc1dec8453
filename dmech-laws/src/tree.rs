//! A law as it was written: evaluated as it stands, without any rewriting, it is what the engine is held against.

use dmech_scalar::{Mask, Real};
use dmech_symbolic::expression::{Binary, Condition, Expr, Graph, Relation, Unary};

/// The values of the three parameters: distinct, none of them 1.
pub const PARAMETERS: [f64; 3] = [0.7, 1.9, 3.3];

/// An expression in coordinates and parameters.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Tree {
    Coordinate(usize),
    Parameter(usize),
    Number(f64),
    Add(Box<Tree>, Box<Tree>),
    Sub(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    Powi(Box<Tree>, i32),
    Unary(Unary, Box<Tree>),
    Binary(Binary, Box<Tree>, Box<Tree>),
    Hypot(Box<Tree>, Box<Tree>),
    /// Between two numbers.
    Clamp(Box<Tree>, f64, f64),
    /// `if` … `else`.
    Select(Test, Box<Tree>, Box<Tree>),
}

/// A condition as it was written.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Test {
    Compare(Comparison, Box<Tree>, Box<Tree>),
    Not(Box<Test>),
    And(Box<Test>, Box<Test>),
    Or(Box<Test>, Box<Test>),
}

/// The comparisons that laws may write, `==` apart: a law that is continuous has nothing to ask it for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Comparison {
    Less,
    AtMost,
    Greater,
    AtLeast,
}

impl Comparison {
    /// As Rust writes it.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::Greater => ">",
            Self::AtLeast => ">=",
        }
    }

    /// The relation of the engine, and whether its sides are exchanged.
    fn relation(self) -> (Relation, bool) {
        match self {
            Self::Less => (Relation::Less, false),
            Self::AtMost => (Relation::LessOrEqual, false),
            Self::Greater => (Relation::Less, true),
            Self::AtLeast => (Relation::LessOrEqual, true),
        }
    }

    /// Whether it holds between two numbers.
    pub fn holds<R: Real>(self, left: R, right: R) -> bool {
        let (relation, exchanged) = self.relation();
        let (left, right) = if exchanged { (right, left) } else { (left, right) };
        match relation {
            Relation::Less => left.less(right).all(),
            _ => left.less_or_equal(right).all(),
        }
    }
}

impl Tree {
    /// Its value; of a choice only the branch taken is evaluated, as Rust does.
    pub fn value<R: Real>(&self, q: &[R]) -> R {
        let of = |t: &Tree| t.value(q);
        match self {
            Self::Coordinate(i) => q[*i],
            Self::Parameter(i) => R::from_f64(PARAMETERS[*i]),
            Self::Number(x) => R::from_f64(*x),
            Self::Add(u, w) => of(u) + of(w),
            Self::Sub(u, w) => of(u) - of(w),
            Self::Mul(u, w) => of(u) * of(w),
            Self::Div(u, w) => of(u) / of(w),
            Self::Powi(u, n) => of(u).powi(*n),
            Self::Unary(f, u) => f.apply(of(u)),
            Self::Binary(f, u, w) => f.apply(of(u), of(w)),
            Self::Hypot(u, w) => {
                let (u, w) = (of(u), of(w));
                (u * u + w * w).sqrt()
            }
            Self::Clamp(u, low, high) => of(u).max(R::from_f64(*low)).min(R::from_f64(*high)),
            Self::Select(test, yes, no) => of(if test.holds(q) { yes } else { no }),
        }
    }

    /// The same expression in the engine.
    pub fn build(&self, g: &mut Graph, q: &[Expr], p: &[Expr]) -> Expr {
        let mut of = |t: &Tree| t.build(g, q, p);
        match self {
            Self::Coordinate(i) => q[*i],
            Self::Parameter(i) => p[*i],
            Self::Number(x) => g.number(*x),
            Self::Add(u, w) => {
                let both = [of(u), of(w)];
                g.add(&both)
            }
            Self::Sub(u, w) => {
                let (u, w) = (of(u), of(w));
                g.sub(u, w)
            }
            Self::Mul(u, w) => {
                let both = [of(u), of(w)];
                g.mul(&both)
            }
            Self::Div(u, w) => {
                let (u, w) = (of(u), of(w));
                g.div(u, w)
            }
            Self::Powi(u, n) => {
                let u = of(u);
                g.powi(u, *n)
            }
            Self::Unary(f, u) => {
                let u = of(u);
                g.unary(*f, u)
            }
            Self::Binary(f, u, w) => {
                let (u, w) = (of(u), of(w));
                g.binary(*f, u, w)
            }
            Self::Hypot(u, w) => {
                let (u, w) = (of(u), of(w));
                g.hypot(u, w)
            }
            Self::Clamp(u, low, high) => {
                let u = of(u);
                let (low, high) = (g.number(*low), g.number(*high));
                g.clamp(u, low, high)
            }
            Self::Select(test, yes, no) => {
                let (yes, no) = (of(yes), of(no));
                let condition = test.build(g, q, p);
                g.select(condition, yes, no)
            }
        }
    }

    /// What it is made of, the sides of its conditions included.
    pub fn children(&self) -> Vec<&Tree> {
        match self {
            Self::Coordinate(_) | Self::Parameter(_) | Self::Number(_) => vec![],
            Self::Powi(u, _) | Self::Unary(_, u) | Self::Clamp(u, ..) => vec![u],
            Self::Add(u, w)
            | Self::Sub(u, w)
            | Self::Mul(u, w)
            | Self::Div(u, w)
            | Self::Binary(_, u, w)
            | Self::Hypot(u, w) => vec![u, w],
            Self::Select(test, yes, no) => {
                let mut children = test.sides();
                children.extend([&**yes, &**no]);
                children
            }
        }
    }

    /// The same tree with every child replaced.
    pub fn map(&self, f: &mut dyn FnMut(&Tree) -> Tree) -> Tree {
        let mut of = |t: &Tree| Box::new(f(t));
        match self {
            Self::Coordinate(_) | Self::Parameter(_) | Self::Number(_) => self.clone(),
            Self::Add(u, w) => Self::Add(of(u), of(w)),
            Self::Sub(u, w) => Self::Sub(of(u), of(w)),
            Self::Mul(u, w) => Self::Mul(of(u), of(w)),
            Self::Div(u, w) => Self::Div(of(u), of(w)),
            Self::Powi(u, n) => Self::Powi(of(u), *n),
            Self::Unary(g, u) => Self::Unary(*g, of(u)),
            Self::Binary(g, u, w) => Self::Binary(*g, of(u), of(w)),
            Self::Hypot(u, w) => Self::Hypot(of(u), of(w)),
            Self::Clamp(u, low, high) => Self::Clamp(of(u), *low, *high),
            Self::Select(test, yes, no) => {
                let (yes, no) = (of(yes), of(no));
                Self::Select(test.map(f), yes, no)
            }
        }
    }

    /// How many nodes it has.
    pub fn size(&self) -> usize {
        1 + self.children().into_iter().map(Tree::size).sum::<usize>()
    }

    /// Whether coordinate i stands in it.
    pub fn contains(&self, i: usize) -> bool {
        *self == Self::Coordinate(i) || self.children().into_iter().any(|c| c.contains(i))
    }

    /// The name of its own node, as statistics count it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Coordinate(_) | Self::Parameter(_) | Self::Number(_) => "leaf",
            Self::Add(..) => "+",
            Self::Sub(..) => "-",
            Self::Mul(..) => "*",
            Self::Div(..) => "/",
            Self::Powi(..) => "powi",
            Self::Unary(f, _) => f.method(),
            Self::Binary(f, ..) => f.method(),
            Self::Hypot(..) => "hypot",
            Self::Clamp(..) => "clamp",
            Self::Select(Test::Compare(..), ..) => "if",
            Self::Select(Test::Not(_), ..) => "if not",
            Self::Select(Test::And(..), ..) => "if and",
            Self::Select(Test::Or(..), ..) => "if or",
        }
    }

    /// Shows the law to `see`, node by node.
    pub fn visit<'a>(&'a self, see: &mut dyn FnMut(&'a Tree)) {
        see(self);
        self.children().into_iter().for_each(|c| c.visit(see));
    }

    /// On which side of each of its choices a point lies (`if`, `abs`, `min`, `max`, `clamp`, in the order of `visit`);
    /// 0 on a seam that is no side's own.
    pub fn sides_taken(&self, q: &[f64]) -> Vec<i8> {
        let mut sides = vec![];
        self.visit(&mut |t| match t {
            Self::Select(test, ..) => sides.push(i8::from(test.holds(q))),
            Self::Unary(Unary::Abs, u) => sides.push(sign(u.value(q))),
            Self::Binary(Binary::Min | Binary::Max, u, w) => sides.push(sign(u.value(q) - w.value(q))),
            Self::Clamp(u, low, high) => {
                let u = u.value(q);
                sides.push(i8::from(u > *high) - i8::from(u < *low));
            }
            _ => {}
        });
        sides
    }

    /// The signs of what stands squared below a root: √(x²) is |x|, and bends as a choice does.
    pub(crate) fn signs_below_roots(&self, q: &[f64]) -> Vec<i8> {
        let mut signs = vec![];
        self.visit(&mut |t| {
            if let Self::Unary(Unary::Sqrt, square) = t
                && let Self::Powi(u, n) = &**square
                && n % 2 == 0
            {
                signs.push(sign(u.value(q)));
            }
        });
        signs
    }
}

fn sign(x: f64) -> i8 {
    i8::from(x > 0.0) - i8::from(x < 0.0)
}

impl Test {
    /// Whether it holds at a point.
    pub fn holds<R: Real>(&self, q: &[R]) -> bool {
        match self {
            Self::Compare(comparison, left, right) => comparison.holds(left.value(q), right.value(q)),
            Self::Not(inner) => !inner.holds(q),
            Self::And(one, two) => one.holds(q) && two.holds(q),
            Self::Or(one, two) => one.holds(q) || two.holds(q),
        }
    }

    /// Negative where it holds, positive where it does not, 0 on the seam between.
    pub(crate) fn seam(&self, q: &[f64]) -> f64 {
        match self {
            Self::Compare(Comparison::Less | Comparison::AtMost, left, right) => left.value(q) - right.value(q),
            Self::Compare(_, left, right) => right.value(q) - left.value(q),
            Self::Not(inner) => -inner.seam(q),
            Self::And(one, two) => one.seam(q).max(two.seam(q)),
            Self::Or(one, two) => one.seam(q).min(two.seam(q)),
        }
    }

    fn build(&self, g: &mut Graph, q: &[Expr], p: &[Expr]) -> Condition {
        match self {
            Self::Compare(comparison, left, right) => {
                let (left, right) = (left.build(g, q, p), right.build(g, q, p));
                let (relation, exchanged) = comparison.relation();
                let (left, right) = if exchanged { (right, left) } else { (left, right) };
                Condition::Compare(relation, left, right)
            }
            Self::Not(inner) => inner.build(g, q, p).negated(),
            Self::And(one, two) => {
                let (one, two) = (one.build(g, q, p), two.build(g, q, p));
                one.and(two)
            }
            Self::Or(one, two) => {
                let (one, two) = (one.build(g, q, p), two.build(g, q, p));
                one.or(two)
            }
        }
    }

    fn sides(&self) -> Vec<&Tree> {
        match self {
            Self::Compare(_, left, right) => vec![left, right],
            Self::Not(inner) => inner.sides(),
            Self::And(one, two) | Self::Or(one, two) => {
                let mut sides = one.sides();
                sides.extend(two.sides());
                sides
            }
        }
    }

    fn map(&self, f: &mut dyn FnMut(&Tree) -> Tree) -> Self {
        match self {
            Self::Compare(comparison, left, right) => Self::Compare(*comparison, Box::new(f(left)), Box::new(f(right))),
            Self::Not(inner) => Self::Not(Box::new(inner.map(f))),
            Self::And(one, two) => {
                let one = one.map(f);
                Self::And(Box::new(one), Box::new(two.map(f)))
            }
            Self::Or(one, two) => {
                let one = one.map(f);
                Self::Or(Box::new(one), Box::new(two.map(f)))
            }
        }
    }
}
