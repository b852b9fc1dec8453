//! Growing random laws, beginning with the edges: choices of every form, roots and powers that vanish, sides of `min` and
//! `max` that are huge, functions that saturate. Every law is continuous; where it bends, and where it is smooth, is not known
//! here.

use dmech_symbolic::expression::{Binary, Unary};

use super::random::Random;
use super::tree::{Comparison, Test, Tree};

/// A law in some coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    /// Its potential.
    pub tree: Tree,
    /// The number of coordinates; not all need stand in the law.
    pub dimension: usize,
}

/// The functions of one argument that a law may call and is made of. The sign function is missing: it is not continuous.
pub const FUNCTIONS: [Unary; 22] = {
    use Unary::*;
    [
        Sqrt, Cbrt, Exp, Exp2, ExpM1, Ln, Ln1p, Log2, Log10, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Asinh,
        Acosh, Atanh, Abs,
    ]
};

fn add(u: Tree, w: Tree) -> Tree {
    Tree::Add(u.into(), w.into())
}

fn sub(u: Tree, w: Tree) -> Tree {
    if w == number(0.0) { u } else { Tree::Sub(u.into(), w.into()) }
}

fn mul(u: Tree, w: Tree) -> Tree {
    Tree::Mul(u.into(), w.into())
}

fn div(u: Tree, w: Tree) -> Tree {
    Tree::Div(u.into(), w.into())
}

fn powi(u: Tree, n: i32) -> Tree {
    Tree::Powi(u.into(), n)
}

fn of(f: Unary, u: Tree) -> Tree {
    Tree::Unary(f, u.into())
}

fn binary(f: Binary, u: Tree, w: Tree) -> Tree {
    Tree::Binary(f, u.into(), w.into())
}

fn number(x: f64) -> Tree {
    Tree::Number(x)
}

fn select(test: Test, yes: Tree, no: Tree) -> Tree {
    Tree::Select(test, yes.into(), no.into())
}

impl Law {
    /// A random law in one to four coordinates. Some coordinates may be spectators: absent from it, or decoupled, in a term
    /// that has no choice in common with the others.
    pub fn random(random: &mut Random) -> Self {
        let dimension = random.pick(&[1, 1, 2, 2, 2, 3, 3, 4]);
        let mut active: Vec<usize> = (0..dimension).collect();
        let mut spectators = vec![];
        while active.len() > 1 && !random.once_in(3) {
            spectators.push(active.swap_remove(random.below(active.len())));
        }
        let mut grower = Grower { random, active };
        let depth = grower.random.pick(&[0, 1, 1, 2]);
        let mut tree = grower.term(depth);
        if grower.random.once_in(3) {
            let other = grower.term(0);
            tree = grower.joined(tree, other);
        }
        for i in spectators {
            if grower.random.once_in(2) {
                grower.active = vec![i];
                let own = if grower.random.once_in(3) { grower.term(0) } else { grower.smooth(0) };
                tree = add(tree, own);
            }
        }
        Self { tree, dimension }
    }
}

struct Grower<'a> {
    random: &'a mut Random,
    /// The coordinates that may be used.
    active: Vec<usize>,
}

impl Grower<'_> {
    fn coordinate(&mut self) -> Tree {
        Tree::Coordinate(self.random.pick(&self.active))
    }

    fn constant(&mut self) -> Tree {
        match self.random.below(4) {
            0 => Tree::Parameter(self.random.below(3)),
            _ => number(self.random.pick(&[0.5, 2.0, 3.0, -1.5, 0.3, 1.7])),
        }
    }

    /// Where the seam of a choice on u lies: not where u is least, or one branch would be a point.
    fn seam(&mut self, u: &Tree) -> Tree {
        let has_least = matches!(u, Tree::Powi(..) | Tree::Unary(Unary::Sqrt, _) | Tree::Add(..));
        match self.random.below(6) {
            _ if has_least => number(self.random.pick(&[1.0, 0.25, 0.7, 2.0])),
            0 => Tree::Parameter(0),
            1 | 2 => number(0.0),
            _ => number(self.random.pick(&[1.0, -0.5, 0.25, 0.3, 2.0, 1.1])),
        }
    }

    /// An expression that a choice is made on: a coordinate, a difference, a distance, …
    fn inner(&mut self) -> Tree {
        let x = self.coordinate();
        let y = self.coordinate();
        match self.random.below(14) {
            0..=3 => x,
            4 | 5 if x != y => sub(x, y),
            6 if x != y => add(x, mul(number(2.0), y)),
            7 if x != y => mul(x, y),
            8 | 9 => self.squares(),
            10 | 11 => of(Unary::Sqrt, self.squares()),
            12 => add(x, div(powi(y, 2), number(2.0))),
            13 => of(Unary::Sin, x),
            _ => {
                let c = self.seam(&x);
                sub(x, c)
            }
        }
    }

    /// Σ qᵢ² over one or more coordinates.
    fn squares(&mut self) -> Tree {
        let mut sum = powi(self.coordinate(), 2);
        let first = sum.clone();
        for i in self.active.clone() {
            let square = powi(Tree::Coordinate(i), 2);
            if square != first && !self.random.once_in(3) {
                sum = add(sum, square);
            }
        }
        sum
    }

    fn comparison(&mut self, below: bool) -> Comparison {
        use Comparison::*;
        self.random.pick(if below { &[Less, AtMost] } else { &[Greater, AtLeast] })
    }

    /// u below c, in one of its four forms and perhaps behind a `!`.
    fn below(&mut self, u: &Tree, c: &Tree) -> Test {
        let (u, c) = (Box::new(u.clone()), Box::new(c.clone()));
        match self.random.below(5) {
            0 | 1 => Test::Compare(self.comparison(true), u, c),
            2 => Test::Compare(self.comparison(false), c, u),
            3 => Test::Not(Test::Compare(self.comparison(false), u, c).into()),
            _ => Test::Not(Test::Compare(self.comparison(true), c, u).into()),
        }
    }

    fn function_or_leaf(&mut self, depth: usize) -> Tree {
        if depth == 0 || self.random.once_in(3) { self.smooth(0) } else { self.term(depth - 1) }
    }

    /// `one` and `other` as a sum, a product, a quotient.
    fn joined(&mut self, one: Tree, other: Tree) -> Tree {
        match self.random.below(8) {
            0..=3 => add(one, other),
            4 => sub(one, other),
            5 | 6 => mul(one, other),
            _ => div(one, add(number(1.5), powi(other, 2))),
        }
    }

    /// A term of a law; most have a choice or an edge.
    fn term(&mut self, depth: usize) -> Tree {
        match self.random.below(20) {
            0 | 1 => self.spring(depth),
            2 => self.tent(),
            3 => self.cut_off(),
            4 => self.window(),
            5 => self.corner(),
            6 => self.nested(depth),
            7 => self.settled(depth),
            8 => self.contact(),
            9 => self.root(),
            10 => self.huge_side(),
            11 => self.far_out(),
            12 => {
                let u = self.inner();
                let c = self.seam(&u);
                let distance = of(Unary::Abs, sub(u, c));
                self.sharpened(distance)
            }
            13 | 14 => {
                let (u, w) = (self.function_or_leaf(depth), self.function_or_leaf(depth));
                binary(self.random.pick(&[Binary::Min, Binary::Max]), u, w)
            }
            15 => {
                let u = self.function_or_leaf(depth);
                let (low, high) = self.random.pick(&[(-1.0, 1.0), (0.0, 0.5), (-0.5, 2.0), (0.25, 0.3)]);
                let held = Tree::Clamp(u.into(), low, high);
                self.sharpened(held)
            }
            16 => {
                let (u, w) = (self.function_or_leaf(depth), self.function_or_leaf(depth));
                self.joined(u, w)
            }
            17 if depth > 0 => {
                let u = self.term(depth - 1);
                self.within_a_function(u)
            }
            _ => self.smooth(depth),
        }
    }

    fn sharpened(&mut self, u: Tree) -> Tree {
        match self.random.below(4) {
            0 => powi(u, 2),
            1 => powi(u, 3),
            2 => mul(self.constant(), u),
            _ => u,
        }
    }

    /// `if u <= c { f } else { f + k (u − c)ⁿ }`.
    fn spring(&mut self, depth: usize) -> Tree {
        let u = self.inner();
        let c = self.seam(&u);
        let f = if self.random.once_in(2) { number(0.0) } else { self.function_or_leaf(depth) };
        let n = self.random.pick(&[1, 2, 2, 3]);
        let k = if self.random.once_in(4) { self.smooth(0) } else { self.constant() };
        let beyond = mul(k, powi(sub(u.clone(), c.clone()), n));
        let beyond = if f == number(0.0) { beyond } else { add(f.clone(), beyond) };
        let test = self.below(&u, &c);
        if self.random.once_in(2) { select(test, f, beyond) } else { select(Test::Not(test.into()), beyond, f) }
    }

    /// Two slopes that meet at u = c.
    fn tent(&mut self) -> Tree {
        let u = self.inner();
        let c = self.seam(&u);
        let rise = sub(u.clone(), c.clone());
        let (left, right) = (self.constant(), self.constant());
        let test = self.below(&u, &c);
        select(test, mul(left, rise.clone()), mul(right, rise))
    }

    /// f(u) − f(c) up to c, 0 beyond.
    fn cut_off(&mut self) -> Tree {
        let (u, c) = (self.inner(), Tree::Number(self.random.pick(&[1.0, 0.7, 2.0, 1.3])));
        let kind = self.random.below(4);
        let f = |x: Tree| match kind {
            0 => div(number(1.0), add(number(0.1), powi(x, 2))),
            1 => of(Unary::Exp, mul(number(-1.0), x)),
            2 => of(Unary::Cos, x),
            _ => sub(powi(x.clone(), 4), powi(x, 2)),
        };
        let shifted = sub(f(u.clone()), f(c.clone()));
        let test = self.below(&u, &c);
        select(test, shifted, number(0.0))
    }

    /// A hat over −c < u < c, with `&&` or `||`.
    fn window(&mut self) -> Tree {
        let u = self.inner();
        let c = self.random.pick(&[1.0, 0.5, 0.7]);
        let hat = sub(number(c * c), powi(u.clone(), 2));
        let hat = self.sharpened(hat);
        let (above, below) = (self.below(&number(-c), &u), self.below(&u, &number(c)));
        let outside = number(0.0);
        if self.random.once_in(2) {
            select(Test::And(above.into(), below.into()), hat, outside)
        } else {
            let beyond = Test::Or(Test::Not(above.into()).into(), Test::Not(below.into()).into());
            select(beyond, outside, hat)
        }
    }

    /// (u − c)(w − d) in a corner of the plane, 0 elsewhere.
    fn corner(&mut self) -> Tree {
        let (u, w) = (self.inner(), self.inner());
        let (c, d) = (self.seam(&u), self.seam(&w));
        let inside = mul(sub(u.clone(), c.clone()), sub(w.clone(), d.clone()));
        let (one, two) = (self.below(&u, &c), self.below(&w, &d));
        if self.random.once_in(2) {
            select(Test::And(one.into(), two.into()), inside, number(0.0))
        } else {
            select(Test::Or(one.into(), two.into()), number(0.0), inside)
        }
    }

    /// A choice in a branch of a choice.
    fn nested(&mut self, depth: usize) -> Tree {
        let u = self.inner();
        let c = self.seam(&u);
        let (f, g) = (self.spring(depth.saturating_sub(1)), self.tent());
        let beyond = add(f.clone(), mul(sub(u.clone(), c.clone()), g));
        let test = self.below(&u, &c);
        select(test, f, beyond)
    }

    /// A choice that is settled before the motion begins: it depends on parameters only.
    fn settled(&mut self, depth: usize) -> Tree {
        let (p, x) = (Tree::Parameter(self.random.below(3)), number(self.random.pick(&[0.5, 2.0, 5.0])));
        let test = self.below(&p, &x);
        let (yes, no) = (self.function_or_leaf(depth), self.function_or_leaf(depth));
        select(test, yes, no)
    }

    /// k (u − c)₊ᵖ.
    fn contact(&mut self) -> Tree {
        let u = self.inner();
        let c = self.seam(&u);
        let depth = if self.random.once_in(2) { sub(u, c) } else { sub(c, u) };
        let depth = binary(Binary::Max, depth, number(0.0));
        let power = match self.random.below(8) {
            0 => of(Unary::Sqrt, depth),
            1 => binary(Binary::Powf, depth, Tree::Parameter(1)),
            2 => binary(Binary::Powf, depth, number(self.random.pick(&[1.3, 0.6, 3.1]))),
            3 => binary(Binary::Powf, depth, div(number(4.0), number(3.0))),
            _ => binary(Binary::Powf, depth, number(self.random.pick(&[1.25, 1.5, 2.5, 2.5, 1.5, 0.5]))),
        };
        mul(self.constant(), power)
    }

    /// Roots and powers of what may be 0.
    fn root(&mut self) -> Tree {
        let u = self.inner();
        let p = number(self.random.pick(&[1.25, 1.5, 2.5, 0.5, 0.75]));
        match self.random.below(8) {
            0 | 1 => binary(Binary::Powf, of(Unary::Abs, u), p),
            2 | 3 => binary(Binary::Powf, powi(u, 2), p),
            4 => mul(of(Unary::Cbrt, u.clone()), u),
            5 => of(Unary::Sqrt, of(Unary::Abs, u)),
            6 => of(Unary::Cbrt, u),
            _ => of(Unary::Sqrt, self.squares()),
        }
    }

    /// `min` or `max` with a side that is huge, or infinite, somewhere.
    fn huge_side(&mut self) -> Tree {
        let s = self.squares();
        let u = self.inner();
        let cap = self.random.pick(&[10.0, 1.0, 3.0]);
        let huge = match self.random.below(5) {
            0 => mul(number(4.0), sub(powi(s.clone(), -6), powi(s, -3))),
            1 => powi(u, -2),
            2 => of(Unary::Exp, mul(number(8.0), u)),
            3 => div(number(1.0), of(Unary::Sqrt, s)),
            _ => mul(number(1e9), powi(u, 4)),
        };
        let other = if self.random.once_in(2) { number(cap) } else { self.smooth(0) };
        match self.random.below(3) {
            0 => binary(Binary::Min, other, huge),
            1 => mul(number(-1.0), binary(Binary::Max, mul(number(-1.0), huge), other)),
            _ => binary(Binary::Min, huge, other),
        }
    }

    /// What changes by many orders of magnitude, or not at all, over the coordinates' range.
    fn far_out(&mut self) -> Tree {
        let u = self.inner();
        match self.random.below(7) {
            0 | 1 => of(Unary::Exp, mul(number(self.random.pick(&[-0.5, -2.0, -40.0])), self.squares())),
            2 => of(Unary::Tanh, mul(number(self.random.pick(&[1e3, 30.0])), u)),
            3 => of(Unary::Exp, mul(number(-30.0), of(Unary::Abs, u))),
            4 => of(Unary::Atan, mul(number(1e4), u)),
            5 => of(Unary::Ln1p, mul(number(1e6), powi(u, 2))),
            _ => of(Unary::Exp2, mul(number(-3.0), self.squares())),
        }
    }

    /// A smooth function of what may have choices.
    fn within_a_function(&mut self, u: Tree) -> Tree {
        match self.random.below(6) {
            0 => of(Unary::Sin, u),
            1 => of(Unary::Exp, of(Unary::Sin, u)),
            2 => powi(u, 2),
            3 => of(Unary::Sqrt, add(number(1.0), powi(u, 2))),
            4 => div(number(1.0), add(number(1.0), powi(u, 2))),
            _ => of(Unary::Atan, u),
        }
    }

    /// A function of all that laws may call, of an argument in its domain.
    fn smooth(&mut self, depth: usize) -> Tree {
        use Unary::*;
        let u = if depth > 0 && self.random.once_in(3) { self.smooth(depth - 1) } else { self.inner() };
        let shifted = |c: f64, u: Tree| add(number(c), powi(u, 2));
        match self.random.below(12) {
            0 => return u,
            1 => return mul(self.constant(), powi(u, self.random.pick(&[2, 2, 3, 4]))),
            2 => {
                let w = self.inner();
                return self.joined(u, w);
            }
            3 => {
                let w = self.inner();
                let p = number(self.random.pick(&[0.5, 1.5, -0.5, 2.7, -1.3, 0.75]));
                return match self.random.below(4) {
                    0 => binary(Binary::Atan2, u, shifted(0.4, w)),
                    1 => Tree::Hypot(u.into(), w.into()),
                    2 => binary(Binary::Powf, shifted(0.4, u), w),
                    _ => binary(Binary::Powf, shifted(0.4, u), p),
                };
            }
            _ => {}
        }
        let f = self.random.pick(&FUNCTIONS);
        let argument = match f {
            Ln | Log2 | Log10 => shifted(0.3, u),
            Ln1p => powi(u, 2),
            Acosh => shifted(1.2, u),
            Sqrt if self.random.once_in(2) => powi(u, 2),
            Sqrt => shifted(0.3, u),
            Asin | Acos if self.random.once_in(3) => Tree::Clamp(u.into(), -1.0, 1.0),
            Asin | Acos | Atanh | Tan => mul(number(0.9), of(Sin, u)),
            _ => u,
        };
        of(f, argument)
    }
}
