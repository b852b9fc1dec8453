//! How far rounding may move a discrete gradient: first-order error analysis of a law, node by node.
//!
//! The figures belong to the law, not to the formulas that the engine chooses. With u one rounding, every node n
//! carries
//!
//! - its values at the two ends, each known to E u:  E = |n| + Σ |∂n/∂c| E_c over the children c (nothing at symbols);
//! - per coordinate i the sum over all ways from n down to xᵢ of the product of the local secant factors, with
//!   absolute values:  V = Σ |s_c| V_c, a bound of the component of ∇̄n;
//! - the error of that component, ε u:  ε = Σ |s_c| ε_c + [|s_c| + |∂s_c/∂c_a| (E_a + |c_a|) + |∂s_c/∂c_b| (E_b + |c_b|)] V_c:
//!   what came from below; one rounding of the local factor s; its change when the child's two values, which are
//!   rounded independently of one another, move by their errors and one rounding each.
//!
//! ε stays finite as b → a, where s → f′ and ∂s/∂c → f″/2: a formula that meets a fixed multiple of ε u loses nothing at
//! small gaps. The plain quotient (f(b) − f(a))/(b − a) has the error E u/|b − a| instead.
//!
//! The secant identity is then allowed Σ εᵢ |bᵢ − aᵢ| u, which vanishes with the gap.

use dmech_symbolic::expression::{Binary, Unary};
use num_dual::Dual2_64;

use super::algebra::{Algebra, Dual};
use super::tree::{PARAMETERS, Tree};

#[derive(Clone, Debug)]
pub(crate) struct Bound {
    /// The values at the two ends.
    pub(crate) ends: [f64; 2],
    /// Their errors E.
    pub(crate) value_error: [f64; 2],
    /// V.
    pub(crate) variation: Vec<f64>,
    /// ε.
    pub(crate) error: Vec<f64>,
}

impl Bound {
    fn constant(x: f64, dimension: usize) -> Self {
        let nothing = vec![0.0; dimension];
        Self { ends: [x; 2], value_error: [0.0; 2], variation: nothing.clone(), error: nothing }
    }

    /// Σ εᵢ |bᵢ − aᵢ|.
    pub(crate) fn secant_error(&self, a: &[f64], b: &[f64]) -> f64 {
        self.error.iter().zip(a.iter().zip(b)).map(|(e, (a, b))| e * (b - a).abs()).sum()
    }
}

/// A child with its factor s in Δn = Σ s Δc, the error of s apart from its own rounding, and |∂n/∂c| at the ends.
struct Edge<'a> {
    child: &'a Bound,
    factor: f64,
    factor_error: f64,
    slopes: [f64; 2],
}

fn node(ends: [f64; 2], edges: &[Edge<'_>]) -> Bound {
    let dimension = edges[0].child.variation.len();
    let sum = |f: &dyn Fn(&Edge<'_>) -> f64| edges.iter().map(f).sum::<f64>();
    let value_error = [0, 1].map(|k| ends[k].abs() + sum(&|e| e.slopes[k].abs() * e.child.value_error[k]));
    let variation = (0..dimension).map(|i| sum(&|e| e.factor.abs() * e.child.variation[i])).collect();
    let error = (0..dimension)
        .map(|i| sum(&|e| e.factor.abs() * e.child.error[i] + (e.factor.abs() + e.factor_error) * e.child.variation[i]))
        .collect();
    Bound { ends, value_error, variation, error }
}

/// f, f′, f″.
fn jet(f: &dyn Fn(Dual<Dual2_64>) -> Dual<Dual2_64>, x: f64) -> [f64; 3] {
    let y = f(Dual(Dual2_64::from_re(x).derivative())).0;
    [y.re, y.v1, y.v2]
}

/// |f[a, b]| and how much it moves when a and b do.
fn secant(jets: [[f64; 3]; 2], [a, b]: [f64; 2], moves: [f64; 2]) -> (f64, f64) {
    let gap = b - a;
    if gap.abs() <= 1e-3 * (a.abs() + b.abs()) {
        let steepest = jets[0][1].abs().max(jets[1][1].abs());
        let bend = jets[0][2].abs().max(jets[1][2].abs()) / 2.0;
        return (steepest, bend * (moves[0] + moves[1]));
    }
    let s = (jets[1][0] - jets[0][0]) / gap;
    (s.abs(), ((s - jets[0][1]) / gap).abs() * moves[0] + ((s - jets[1][1]) / gap).abs() * moves[1])
}

fn of_function(u: &Bound, f: &dyn Fn(Dual<Dual2_64>) -> Dual<Dual2_64>) -> Bound {
    let jets = u.ends.map(|x| jet(f, x));
    let moves = [0, 1].map(|k| u.value_error[k] + u.ends[k].abs());
    let (factor, factor_error) = secant(jets, u.ends, moves);
    node(jets.map(|j| j[0]), &[Edge { child: u, factor, factor_error, slopes: jets.map(|j| j[1]) }])
}

fn of_product(u: &Bound, w: &Bound) -> Bound {
    // Means of magnitudes: the engine may associate the factors otherwise.
    let mean = |c: &Bound| (c.ends[0].abs() + c.ends[1].abs()) / 2.0;
    let error = |c: &Bound| (c.value_error[0] + c.value_error[1]) / 2.0 + mean(c);
    let edges = [
        Edge { child: u, factor: mean(w), factor_error: error(w), slopes: w.ends },
        Edge { child: w, factor: mean(u), factor_error: error(u), slopes: u.ends },
    ];
    node([0, 1].map(|k| u.ends[k] * w.ends[k]), &edges)
}

fn of_sum(u: &Bound, w: &Bound, sign: f64) -> Bound {
    let edges = [u, w].map(|child| Edge { child, factor: 1.0, factor_error: 0.0, slopes: [1.0; 2] });
    let mut sum = node([0, 1].map(|k| u.ends[k] + sign * w.ends[k]), &edges);
    for k in 0..2 {
        // Sums are added in an order of the engine's own.
        sum.value_error[k] += u.ends[k].abs() + w.ends[k].abs();
    }
    sum
}

/// Δ|g| = σ Δg, σ = (a + b)/(|a| + |b|), for the difference g = u − w or for g = u; the error of σ. Between the signs it is
/// that of a number of the size of 1, from which (1 ± σ)/2 is taken.
fn sign_secant(ends: [f64; 2], errors: [f64; 2]) -> (f64, f64) {
    let total = ends[0].abs() + ends[1].abs();
    if total == 0.0 {
        return (0.0, 1.0);
    }
    let certain = (0..2).all(|k| ends[k].abs() > 8.0 * super::U * errors[k]) && ends[0] * ends[1] > 0.0;
    let sigma = (ends[0] + ends[1]) / total;
    (sigma, if certain { 0.0 } else { 2.0 + (2.0 * (errors[0] + errors[1]) / total).min(2.0 / super::U) })
}

fn of_extremum(u: &Bound, w: &Bound, larger: bool) -> Bound {
    let gaps = [0, 1].map(|k| u.ends[k] - w.ends[k]);
    let errors = [0, 1].map(|k| u.value_error[k] + w.value_error[k]);
    let (sigma, factor_error) = sign_secant(gaps, errors);
    let toward_u = if larger { (1.0 + sigma) / 2.0 } else { (1.0 - sigma) / 2.0 };
    let chosen = gaps.map(|g| if (g > 0.0) == larger { [1.0, 0.0] } else { [0.0, 1.0] });
    let ends = [0, 1].map(|k| if chosen[k][0] == 1.0 { u.ends[k] } else { w.ends[k] });
    let edges = [
        Edge { child: u, factor: toward_u, factor_error, slopes: [chosen[0][0], chosen[1][0]] },
        Edge { child: w, factor: 1.0 - toward_u, factor_error, slopes: [chosen[0][1], chosen[1][1]] },
    ];
    node(ends, &edges)
}

/// The angle of (w, u): Δ = K (w̄ Δu − ū Δw), where K is angle/cross.
fn of_angle(u: &Bound, w: &Bound) -> Bound {
    let ([ua, ub], [wa, wb]) = (u.ends, w.ends);
    let k = |[ua, ub, wa, wb]: [f64; 4]| {
        let (cross, dot) = (wa * ub - ua * wb, wa * wb + ua * ub);
        if cross.abs() < 1e-9 * dot { 1.0 / dot } else { cross.atan2(dot) / cross }
    };
    let at = [ua, ub, wa, wb];
    let errors = [u.value_error[0], u.value_error[1], w.value_error[0], w.value_error[1]];
    let value = k(at);
    let mut wobble = value.abs();
    for i in 0..4 {
        let mut moved = at;
        let step = 1e-6 * (at[i].abs() + 1e-3);
        moved[i] += step;
        wobble += ((k(moved) - value) / step).abs() * (errors[i] + at[i].abs());
    }
    let mean = |c: &Bound| (c.ends[0].abs() + c.ends[1].abs()) / 2.0;
    let error = |c: &Bound| (c.value_error[0] + c.value_error[1]) / 2.0 + mean(c);
    let r2 = [0, 1].map(|i| u.ends[i].powi(2) + w.ends[i].powi(2));
    let edges = [(u, w), (w, u)].map(|(child, other)| Edge {
        child,
        factor: mean(other) * value.abs(),
        factor_error: mean(other) * wobble + error(other) * value.abs(),
        slopes: [0, 1].map(|i| other.ends[i] / r2[i]),
    });
    node([0, 1].map(|i| u.ends[i].atan2(w.ends[i])), &edges)
}

/// The figures of a law between two points.
pub(crate) fn bound(tree: &Tree, a: &[f64], b: &[f64]) -> Bound {
    let of = |t: &Tree| bound(t, a, b);
    let dimension = a.len();
    match tree {
        Tree::Coordinate(i) => {
            let mut leaf = Bound::constant(0.0, dimension);
            leaf.ends = [a[*i], b[*i]];
            leaf.variation[*i] = 1.0;
            leaf
        }
        Tree::Parameter(i) => Bound::constant(PARAMETERS[*i], dimension),
        Tree::Number(x) => Bound::constant(*x, dimension),
        Tree::Add(u, w) => of_sum(&of(u), &of(w), 1.0),
        Tree::Sub(u, w) => of_sum(&of(u), &of(w), -1.0),
        Tree::Mul(u, w) => of_product(&of(u), &of(w)),
        Tree::Div(u, w) => of_product(&of(u), &of_function(&of(w), &|x| Dual::number(1.0).over(&x))),
        Tree::Powi(u, n) => of_function(&of(u), &|x| x.power(*n)),
        Tree::Unary(Unary::Abs, u) => {
            let u = of(u);
            let (factor, factor_error) = sign_secant(u.ends, u.value_error);
            node(u.ends.map(f64::abs), &[Edge { child: &u, factor, factor_error, slopes: [1.0; 2] }])
        }
        Tree::Unary(f, u) => of_function(&of(u), &|x| x.unary(*f)),
        Tree::Binary(Binary::Powf, u, w) => {
            let (u, w) = (of(u), of(w));
            if w.variation.iter().all(|&v| v == 0.0) {
                let mut power = of_function(&u, &|x| x.powf(&Dual::number(w.ends[0])));
                for k in 0..2 {
                    power.value_error[k] += (power.ends[k] * u.ends[k].ln()).abs() * w.value_error[k];
                }
                return power;
            }
            of_function(&of_product(&w, &of_function(&u, &|x| x.unary(Unary::Ln))), &|x| x.unary(Unary::Exp))
        }
        Tree::Binary(Binary::Atan2, u, w) => of_angle(&of(u), &of(w)),
        Tree::Binary(f, u, w) => of_extremum(&of(u), &of(w), *f == Binary::Max),
        Tree::Hypot(u, w) => {
            let [u2, w2] = [u, w].map(|t| of_function(&of(t), &|x| x.times(&x)));
            of_function(&of_sum(&u2, &w2, 1.0), &|x| x.unary(Unary::Sqrt))
        }
    }
}
