//! What programs read besides the parameters of the law.

use crate::expression::{Graph, Substitution, Symbol};

/// The variables that programs read besides the parameters of the law.
#[derive(Clone, Debug)]
pub struct Variables {
    /// Position.
    pub q: Vec<Symbol>,
    /// Velocity.
    pub v: Vec<Symbol>,
    /// The coefficient of a kick, h/m.
    pub c: Symbol,
    /// The coefficient of H ∇Φ in a kick, in units of h³/m².
    pub e: Symbol,
    /// The ends of a step.
    pub a: Vec<Symbol>,
    /// The other end.
    pub b: Vec<Symbol>,
    /// The increment q′ − q.
    pub delta: Vec<Symbol>,
    /// The right-hand side of the increment's equation.
    pub rhs: Vec<Symbol>,
    /// The coefficient of the unknown force.
    pub g: Symbol,
    /// h v: the part of the increment that the velocity makes.
    pub drift: Vec<Symbol>,
    /// 2/h, so that the velocity at the end of a step is v + (2/h)(Δ − h v).
    pub rate: Symbol,
    /// The time at the end of a step.
    pub t_end: Symbol,
    /// Squared distances from the centre: of a position, of the two ends.
    pub s: Symbol,
    /// |a|².
    pub s_a: Symbol,
    /// |b|².
    pub s_b: Symbol,
}

impl Variables {
    /// Variables for D coordinates: x, y, z up to three, q0, q1, … above.
    pub fn new(graph: &mut Graph, dimension: usize) -> Self {
        let letter = |i: usize| ["x", "y", "z"][i].to_owned();
        let coordinate_name = |i: usize| if dimension <= 3 { letter(i) } else { format!("q{i}") };
        let end_name = |end: &str, i: usize| if dimension <= 3 { letter(i) + end } else { format!("{end}{i}") };
        let mut list = |name: &dyn Fn(usize) -> String| -> Vec<Symbol> {
            (0..dimension).map(|i| graph.coordinate(&name(i))).collect()
        };
        let q = list(&coordinate_name);
        let v = list(&|i| if dimension <= 3 { format!("v{}", letter(i)) } else { format!("v{i}") });
        let (a, b) = (list(&|i| end_name("a", i)), list(&|i| end_name("b", i)));
        let (delta, rhs) = (list(&|i| format!("delta{i}")), list(&|i| format!("rhs{i}")));
        let drift = list(&|i| format!("drift{i}"));
        let [s, s_a, s_b] = ["s", "sa", "sb"].map(|name| graph.squared_distance(name));
        let [c, e, g, rate, t_end] = ["c", "e", "g", "rate", "t_end"].map(|name| graph.parameter(name));
        Self { q, v, c, e, a, b, delta, rhs, g, drift, rate, t_end, s, s_a, s_b }
    }
}

/// a ↔ b.
pub fn exchange(graph: &mut Graph, variables: &Variables) -> Substitution {
    let mut pairs = vec![];
    for (&a, &b) in variables.a.iter().zip(&variables.b) {
        pairs.push((a, graph.symbol(b)));
        pairs.push((b, graph.symbol(a)));
    }
    Substitution::new(graph, pairs)
}
