//! Which Rust identifier stands for which symbol and value.

use std::collections::{HashMap, HashSet};

use dmech_symbolic::expression::{Graph, Symbol};
use dmech_symbolic::kernel::{PairVariables, Variables};
use dmech_symbolic::program::{Operation, Program};
use proc_macro2::{Ident, Span};

use crate::lower::Parameter;

/// An identifier of generated code: it cannot see, nor be seen by, the user's local variables.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The hidden module of the facade, as generated code imports it.
pub(super) fn runtime() -> Ident {
    ident("dmech_v1")
}

/// `self`, as the user's own tokens see it.
pub(super) fn receiver() -> Ident {
    Ident::new("self", Span::call_site())
}

pub(super) fn underscored(name: &Ident, used: bool) -> Ident {
    if used { name.clone() } else { ident(&format!("_{name}")) }
}

/// The identifiers of a law's symbols.
pub(super) struct Names {
    of: HashMap<Symbol, String>,
    /// What the functions call their arguments.
    arguments: Vec<&'static str>,
}

/// What generated functions call their arguments.
const ARGUMENTS: [&str; 5] = ["equation", "delta", "q", "v", "self"];

/// And those of a law between two bodies.
const OF_TWO_BODIES: [&str; 3] = ["d", "va", "vb"];

impl Names {
    pub(super) fn new(
        graph: &Graph,
        variables: &Variables,
        pair: Option<&PairVariables>,
        parameters: &[Parameter],
    ) -> Self {
        let mut of = HashMap::new();
        let mut arguments = ARGUMENTS.to_vec();
        if pair.is_some() {
            arguments.extend(OF_TWO_BODIES);
        }
        let mut taken: HashSet<String> = arguments.iter().map(|&name| name.to_owned()).collect();
        let Variables { q, v, c, e, a, b, delta, rhs, g, drift, rate, t_end, s, s_a, s_b } = variables;
        let fixed = [q, v, a, b, delta, rhs, drift].into_iter().flatten().chain([c, e, g, rate, t_end, s, s_a, s_b]);
        let of_two = pair.into_iter().flat_map(|p| p.va.iter().chain(&p.vb).chain([&p.s, &p.s_a, &p.s_b]));
        for &symbol in fixed.chain(of_two) {
            of.insert(symbol, graph.name(symbol).to_owned());
            taken.insert(graph.name(symbol).to_owned());
        }
        taken.extend(["a", "b"].map(str::to_owned));
        for parameter in parameters {
            let plain = graph.name(parameter.symbol).to_lowercase();
            let candidates = [plain.clone(), format!("law_{plain}")].into_iter();
            let numbered = (0..).map(|i| format!("law_{i}"));
            let name = candidates.chain(numbered).find(|name| usable(name) && taken.insert(name.clone()));
            of.insert(parameter.symbol, name.unwrap_or_default());
        }
        Self { of, arguments }
    }

    pub(super) fn symbol(&self, symbol: Symbol) -> Ident {
        ident(&self.of[&symbol])
    }

    /// The formula's name of every value of a program, where it has one that is free.
    pub(super) fn values(&self, program: &Program) -> Vec<Option<Ident>> {
        let mut taken: HashSet<&str> = self.of.values().map(String::as_str).collect();
        taken.extend(&self.arguments);
        let named = program.operations.iter().zip(&program.names);
        named
            .map(|(operation, name)| match (operation, name) {
                (Operation::Symbol(symbol), _) => Some(self.symbol(*symbol)),
                (_, Some(name)) if !taken.contains(name.as_str()) && usable(name) => Some(ident(name)),
                _ => None,
            })
            .collect()
    }
}

/// A name without capitals that is neither a keyword nor one of the names t0, t1, … of values without a name.
fn usable(name: &str) -> bool {
    let plain = !name.bytes().any(|b| b.is_ascii_uppercase());
    temporary(name).is_none() && plain && syn::parse_str::<Ident>(name).is_ok()
}

/// Which of the names t0, t1, … it is.
pub(super) fn temporary(name: &str) -> Option<&str> {
    name.strip_prefix('t').filter(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
}
