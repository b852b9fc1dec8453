//! The figures of a law, from its leaves up: see `scale`.

use dmech_symbolic::expression::{Binary, Unary};

use super::branches::{Truth, of_choice, of_mixture};
use super::forms::{self, Power};
use super::grow::Law;
use super::jet::{of_integer_power, of_power, of_unary};
use super::scale::{ROUNDING, Scale, of_angle, of_function, of_product, of_sum, times};
use super::tree::{Comparison, PARAMETERS, Test, Tree};

/// A law between two points.
pub(crate) struct Analysis<'a> {
    pub(crate) a: &'a [f64],
    pub(crate) b: &'a [f64],
    pub(crate) step: &'a [f64],
}

impl Scale {
    /// The figures of a law between a and b.
    pub fn of(tree: &Tree, a: &[f64], b: &[f64], step: &[f64]) -> Self {
        Analysis { a, b, step }.of(tree)
    }

    /// Those of ∂Φ/∂xᵢ.
    pub(crate) fn along(law: &Law, q: &[f64], i: usize) -> Self {
        let mut unit = vec![0.0; q.len()];
        unit[i] = 1.0;
        Scale::of(&law.tree, q, q, &unit)
    }
}

impl Analysis<'_> {
    pub(crate) fn of(&self, tree: &Tree) -> Scale {
        let mut all = self.of_node(tree);
        self.as_rewritten(tree, &mut all);
        let is_choice = matches!(
            tree,
            Tree::Unary(Unary::Abs, _)
                | Tree::Binary(Binary::Min | Binary::Max, ..)
                | Tree::Clamp(..)
                | Tree::Select(..)
        );
        if is_choice && (all.crosses || all.doubtful) {
            let way = self.way(tree);
            all.width += way;
            all.error += 2.0 * way;
        }
        all
    }

    fn of_node(&self, tree: &Tree) -> Scale {
        let of = |t: &Tree| self.of(t);
        match tree {
            Tree::Coordinate(i) => Scale::leaf([self.a[*i], self.b[*i]], self.step[*i].abs()),
            Tree::Parameter(i) => Scale::leaf([PARAMETERS[*i]; 2], 0.0),
            Tree::Number(x) => Scale::leaf([*x; 2], 0.0),
            Tree::Add(u, w) => of_sum(&of(u), &of(w), 1.0),
            Tree::Sub(u, w) => of_sum(&of(u), &of(w), -1.0),
            Tree::Mul(u, w) => of_product(&of(u), &of(w)),
            Tree::Div(u, w) => of_product(&of(u), &of_function(&of(w), &|x| of_integer_power(x, -1))),
            Tree::Powi(u, n) => of_function(&of(u), &|x| of_integer_power(x, *n)),
            Tree::Unary(Unary::Abs, u) => {
                let u = of(u);
                let turned = Scale { ends: u.ends.map(|x| -x), ..u.clone() };
                self.of_extremum(u, turned, true)
            }
            Tree::Unary(f, u) => {
                let u = of(u);
                let mut all = of_function(&u, &|x| of_unary(*f, x));
                let unknown = u.value_error.iter().any(|e| ROUNDING * e > 1e-3);
                all.unsettled |= matches!(f, Unary::Sin | Unary::Cos | Unary::Tan) && unknown;
                if (u.ends[1] - u.ends[0]).abs() > 1.0 {
                    all.error += match f {
                        // Where it saturates, the difference of two values that are nearly 1 is all there is.
                        Unary::Tanh => all.ends[0].abs() + all.ends[1].abs(),
                        // Of the mean of the arguments and of half their gap, both rounded.
                        Unary::Sin | Unary::Cos => u.ends[0].abs() + u.ends[1].abs(),
                        _ => 0.0,
                    };
                }
                all
            }
            Tree::Binary(Binary::Powf, u, w) => {
                let (u, w) = (of(u), of(w));
                if w.width == 0.0 && w.ends[0] == w.ends[1] {
                    let mut power = of_function(&u, &|x| of_power(x, w.ends[0]));
                    power.doubtful |= w.doubtful;
                    power.vertical |= w.vertical;
                    for k in 0..2 {
                        power.value_error[k] += times(times(power.ends[k], u.ends[k].ln()).abs(), w.value_error[k]);
                    }
                    return power;
                }
                let exponent = of_product(&w, &of_function(&u, &|x| of_unary(Unary::Ln, x)));
                of_function(&exponent, &|x| of_unary(Unary::Exp, x))
            }
            Tree::Binary(Binary::Atan2, u, w) => of_angle(&of(u), &of(w)),
            Tree::Binary(f, u, w) => self.of_extremum(of(u), of(w), *f == Binary::Max),
            Tree::Clamp(u, low, high) => {
                let raised = self.of_extremum(of(u), Scale::leaf([*low; 2], 0.0), true);
                self.of_extremum(raised, Scale::leaf([*high; 2], 0.0), false)
            }
            Tree::Hypot(u, w) => {
                let [u2, w2] = [u, w].map(|t| of_function(&of(t), &|x| of_integer_power(x, 2)));
                of_function(&of_sum(&u2, &w2, 1.0), &|x| of_unary(Unary::Sqrt, x))
            }
            Tree::Select(test, yes, no) => {
                let truth = self.truth(test);
                // The branch that neither end takes is not looked at.
                if !truth.apart() || yes == no {
                    return of(if truth.holds[0] { yes } else { no });
                }
                let mut all = of_choice(truth, &of(yes), &of(no));
                let (parts, corner) = self.of_parts(test, yes, no, truth.holds);
                if let Some((width, error)) = parts {
                    all.width += width;
                    all.error += error;
                }
                all.corner |= corner;
                all
            }
        }
    }

    /// On how many seams a point lies, or so near that rounding may put it on either side.
    pub(crate) fn seams_at(tree: &Tree, q: &[f64]) -> usize {
        let point = Analysis { a: q, b: q, step: &vec![0.0; q.len()] };
        let mut seams: Vec<&Tree> = vec![];
        tree.visit(&mut |t| {
            if point.is_doubtful(t) && !seams.contains(&t) {
                seams.push(t);
            }
        });
        seams.len()
    }

    /// Whether a node is a choice and on its seam, but for rounding.
    fn is_doubtful(&self, tree: &Tree) -> bool {
        let truth = |u: &Scale, w: &Scale| Truth::of(Comparison::Less, u, w);
        let number = |x: f64| Scale::leaf([x; 2], 0.0);
        let truths = match tree {
            Tree::Select(test, ..) => vec![self.truth(test)],
            Tree::Unary(Unary::Abs, u) => vec![truth(&self.of(u), &number(0.0))],
            Tree::Binary(Binary::Min | Binary::Max, u, w) => vec![truth(&self.of(u), &self.of(w))],
            Tree::Clamp(u, low, high) => [low, high].map(|&end| truth(&self.of(u), &number(end))).to_vec(),
            _ => vec![],
        };
        truths.iter().any(|truth| truth.certain != [true; 2])
    }

    /// The coarser of the figures, where the engine may write the node in another form: see `forms`.
    fn as_rewritten(&self, tree: &Tree, all: &mut Scale) {
        if forms::is_power(tree) {
            let factors = forms::powers(tree, &|t| self.branch(t));
            if forms::is_regrouped(tree, &factors) {
                let factors: Vec<_> = factors.iter().map(|power| self.of_power(power)).collect();
                all.coarsen(forms::of_factors(&factors));
            }
        }
        if !all.crosses && !all.doubtful {
            return;
        }
        if let Some(other) = forms::within_branches(tree).or_else(|| forms::shared_terms(tree)) {
            let other = self.of(&other);
            all.coarsen((other.width, other.error));
        }
    }

    /// The branch that both ends lie in, if the tree is an `if` and they do.
    fn branch<'t>(&self, tree: &'t Tree) -> Option<&'t Tree> {
        let Tree::Select(test, yes, no) = tree else { return None };
        let truth = self.truth(test);
        (yes == no || !truth.apart()).then_some(if truth.holds[0] { yes } else { no })
    }

    fn of_power(&self, Power { base, exponent }: &Power<'_>) -> Scale {
        let base = self.of(base);
        if *exponent == 1.0 {
            return base;
        }
        if exponent.fract() == 0.0 {
            return of_function(&base, &|x| of_integer_power(x, *exponent as i32));
        }
        let size = Scale { ends: base.ends.map(f64::abs), ..base };
        of_function(&size, &|x| of_power(x, *exponent))
    }

    fn of_extremum(&self, u: Scale, w: Scale, larger: bool) -> Scale {
        let comparison = if larger { Comparison::AtLeast } else { Comparison::AtMost };
        let truth = Truth::of(comparison, &u, &w);
        let mut all = of_choice(truth, &u, &w);
        if truth.apart()
            && let Some((width, error)) = of_mixture(&u, &w, larger)
        {
            all.width += width;
            all.error += error;
        }
        all
    }

    /// The figures of a choice up to its seam and from there on, if they are finite, and whether another seam is met there.
    fn of_parts(&self, test: &Test, yes: &Tree, no: &Tree, holds: [bool; 2]) -> (Option<(f64, f64)>, bool) {
        let seams = [self.a, self.b].map(|q| test.seam(q).abs());
        let total = seams[0] + seams[1];
        let share = if total > 0.0 { seams[0] / total } else { 0.5 };
        let (straight, in_squares) = self.crossings(share);
        let (parts, corner) = self.of_two_parts(&straight, share, yes, no, holds);
        match in_squares.map(|at| self.of_two_parts(&at, share, yes, no, holds).0) {
            Some(Some((width, error))) => {
                let (other_width, other_error) = parts.unwrap_or_default();
                (Some((width.max(other_width), error.max(other_error))), corner)
            }
            _ => (parts, corner),
        }
    }

    /// Where a step crosses a seam that lies at this share of it: on the straight line, and on that which is straight in the
    /// squares of the coordinates, in which choices on distances are made.
    fn crossings(&self, share: f64) -> (Vec<f64>, Option<Vec<f64>>) {
        let ends = || self.a.iter().zip(self.b);
        let straight: Vec<f64> = ends().map(|(a, b)| a + share * (b - a)).collect();
        let root = |(a, b): (&f64, &f64)| (a * a + share * (b * b - a * a)).sqrt();
        let moves = self.step.iter().zip(ends()).all(|(step, (a, b))| *step == b - a);
        let in_squares = || ends().zip(&straight).map(|(ends, at)| root(ends).copysign(*at)).collect();
        (straight.clone(), moves.then(in_squares))
    }

    fn of_two_parts(
        &self,
        at: &[f64],
        share: f64,
        yes: &Tree,
        no: &Tree,
        holds: [bool; 2],
    ) -> (Option<(f64, f64)>, bool) {
        let branch = |k: usize| if holds[k] { yes } else { no };
        let part = |a: &[f64], b: &[f64], share: f64, tree: &Tree| {
            let steps = self.step.iter().zip(a.iter().zip(b));
            // A unit step has no length on the way.
            let step: Vec<f64> = steps.map(|(step, (a, b))| if a == b { share * step } else { b - a }).collect();
            Scale::of(tree, a, b, &step)
        };
        let (up_to, from) = (part(self.a, at, share, branch(0)), part(at, self.b, 1.0 - share, branch(1)));
        let width = up_to.width + from.width;
        let error = up_to.error + from.error + width;
        let corner = [&up_to, &from].iter().any(|part| part.doubtful || part.corner);
        ((width.is_finite() && error.is_finite()).then_some((width, error)), corner)
    }

    /// How far the values on the line from a to b range.
    fn way(&self, tree: &Tree) -> f64 {
        let values = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| {
            let q: Vec<f64> = self.a.iter().zip(self.b).map(|(a, b)| a + share * (b - a)).collect();
            tree.value(&q)
        });
        let way: f64 = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        if way.is_finite() { way } else { 0.0 }
    }

    fn truth(&self, test: &Test) -> Truth {
        match test {
            Test::Compare(comparison, left, right) => Truth::of(*comparison, &self.of(left), &self.of(right)),
            Test::Not(inner) => {
                let Truth { holds, certain } = self.truth(inner);
                Truth { holds: holds.map(|h| !h), certain }
            }
            Test::And(one, two) => self.truth(one).joined(self.truth(two), false),
            Test::Or(one, two) => self.truth(one).joined(self.truth(two), true),
        }
    }
}
