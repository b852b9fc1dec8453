//! What the law says it keeps, as a run watches it.

use dmech_symbolic::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::body::{Printed, body};
use super::names::{ident, receiver, underscored};
use super::printer::Printer;
use crate::lower::Source;
use crate::model::Formula;

impl Printer<'_> {
    /// The names of the invariants, and the value of each; nothing for a law that declares none.
    pub(super) fn invariants(&self, formulas: &[Formula], programs: &[Program]) -> Option<TokenStream> {
        if formulas.is_empty() {
            return None;
        }
        let (scalar, d, receiver) = (&self.scalar, &self.dimension, receiver());
        let names = formulas.iter().map(|formula| formula.ident.to_string());
        let time = self.parameters.iter().find(|p| matches!(p.source, Source::Time)).map(|p| p.symbol);
        let mut named = [false; 3];
        let values: Vec<_> = programs
            .iter()
            .enumerate()
            .map(|(k, program)| {
                let used = program.symbols();
                let arrays = [("q", &self.variables.q[..]), ("v", &self.variables.v[..])];
                for (named, (_, symbols)) in named.iter_mut().zip(&arrays) {
                    *named |= symbols.iter().any(|s| used.contains(s));
                }
                named[2] |= time.is_some_and(|t| used.contains(&t));
                let (_, unpack) = self.unpacked(&arrays, &used);
                let parameters = self.bind_parameters(&used, true);
                let Printed { statements, outputs } = body(program, &self.names, scalar);
                let k = Literal::usize_unsuffixed(k);
                quote!(#k => { #unpack #parameters #statements #(#outputs)* })
            })
            .collect();
        let [q, v] = [("q", named[0]), ("v", named[1])].map(|(name, used)| underscored(&ident(name), used));
        let t = underscored(&time.map_or_else(|| ident("t"), |t| self.names.symbol(t)), named[2]);
        let k = ident("invariant");
        Some(quote! {
            const INVARIANTS: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            fn invariant(
                &#receiver,
                #k: ::core::primitive::usize,
                #q: [#scalar; #d],
                #v: [#scalar; #d],
                #t: #scalar,
            ) -> #scalar {
                match #k {
                    #(#values)*
                    _ => #scalar::ZERO,
                }
            }
        })
    }
}
