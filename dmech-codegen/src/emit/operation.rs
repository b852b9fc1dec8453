//! One operation as Rust, with no more parentheses than needed.

use dmech_symbolic::expression::{Number, Relation};
use dmech_symbolic::program::{Operation, Test, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// How tightly an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Precedence {
    Sum,
    Product,
    Prefix,
    Atom,
}

/// An expression on its way into another.
#[derive(Clone, Debug)]
pub(super) struct Fragment {
    pub(super) tokens: TokenStream,
    pub(super) binding: Precedence,
    /// How many operations it has: long expressions are cut into `let`s.
    pub(super) size: usize,
}

impl Fragment {
    pub(super) fn atom(tokens: TokenStream) -> Self {
        Self { tokens, binding: Precedence::Atom, size: 0 }
    }

    /// In parentheses, unless it binds at least as tightly as asked.
    fn at_least(self, binding: Precedence) -> TokenStream {
        let tokens = self.tokens;
        if self.binding >= binding { tokens } else { quote!((#tokens)) }
    }
}

/// A number of the scalar type.
pub(super) fn number(x: f64, scalar: &Ident) -> TokenStream {
    if x == 0.0 {
        quote!(#scalar::ZERO)
    } else if x == 1.0 {
        quote!(#scalar::ONE)
    } else if Number::new(x) == Number::LEAST {
        quote!(#scalar::least())
    } else if Number::new(x) == Number::ROUNDING {
        quote!(#scalar::rounding())
    } else {
        // As it is debugged: with an exponent where it is far from 1.
        let magnitude: Literal =
            format!("{:?}", x.abs()).parse().expect("what is debugged of a finite number is its literal");
        let sign = (x < 0.0).then(|| quote!(-));
        quote!(#scalar::from_f64(#sign #magnitude))
    }
}

/// The operation on fragments; choices are printed elsewhere.
pub(super) fn fragment(operation: &Operation, scalar: &Ident, of: &mut dyn FnMut(Value) -> Fragment) -> Fragment {
    use Precedence::{Prefix, Product, Sum};
    let mut infix = |u: Value, w: Value, sign: TokenStream, left: Precedence, right: Precedence| {
        let (u, w) = (of(u), of(w));
        let size = u.size + w.size + 1;
        let (u, w) = (u.at_least(left), w.at_least(right));
        Fragment { tokens: quote!(#u #sign #w), binding: left, size }
    };
    match operation {
        Operation::Number(n) => Fragment::atom(number(n.value(), scalar)),
        Operation::Add(u, w) => infix(*u, *w, quote!(+), Sum, Product),
        Operation::Sub(u, w) => infix(*u, *w, quote!(-), Sum, Product),
        Operation::Mul(u, w) => infix(*u, *w, quote!(*), Product, Prefix),
        Operation::Div(u, w) => infix(*u, *w, quote!(/), Product, Prefix),
        Operation::Neg(u) => {
            let u = of(*u);
            let size = u.size + 1;
            let u = u.at_least(Prefix);
            Fragment { tokens: quote!(-#u), binding: Prefix, size }
        }
        Operation::Recip(u) => call(of(*u), "recip", vec![]),
        Operation::Unary(f, u) => call(of(*u), f.method(), vec![]),
        Operation::Binary(f, u, w) => call(of(*u), f.method(), vec![of(*w)]),
        Operation::MulAdd(u, w, x) => call(of(*u), "mul_add", vec![of(*w), of(*x)]),
        Operation::NegMulAdd(u, w, x) => {
            let u = of(*u);
            let size = u.size;
            let u = u.at_least(Prefix);
            let negated = Fragment { tokens: quote!(-#u), binding: Prefix, size };
            call(negated, "mul_add", vec![of(*w), of(*x)])
        }
        Operation::Symbol(_) | Operation::Select(..) => unreachable!("printed by the body"),
    }
}

fn call(receiver: Fragment, method: &str, arguments: Vec<Fragment>) -> Fragment {
    let size = 1 + receiver.size + arguments.iter().map(|a| a.size).sum::<usize>();
    let receiver = receiver.at_least(Precedence::Atom);
    let method = super::names::ident(method);
    let arguments = arguments.into_iter().map(|a| a.tokens);
    Fragment { tokens: quote!(#receiver.#method(#(#arguments),*)), binding: Precedence::Atom, size }
}

/// A condition as a mask.
pub(super) fn mask(test: &Test, of: &mut dyn FnMut(Value) -> Fragment) -> TokenStream {
    // By their full path: the trait of masks need not be in scope where the law stands.
    let runtime = super::names::runtime();
    match test {
        Test::Compare(relation, left, right) => {
            let method = match relation {
                Relation::Less => "less",
                Relation::LessOrEqual => "less_or_equal",
                Relation::Equal => "equal",
            };
            call(of(*left), method, vec![of(*right)]).tokens
        }
        Test::Not(inner) => {
            let inner = mask(inner, of);
            quote!(#runtime::Mask::not(#inner))
        }
        Test::And(one, two) => {
            let (one, two) = (mask(one, of), mask(two, of));
            quote!(#runtime::Mask::and(#one, #two))
        }
        Test::Or(one, two) => {
            let (one, two) = (mask(one, of), mask(two, of));
            quote!(#runtime::Mask::or(#one, #two))
        }
    }
}
