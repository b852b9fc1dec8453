//! The kick of a force that turns the velocity.

use dmech_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Printed, body};
use super::names::{ident, receiver};
use super::printer::Printer;

impl Printer<'_> {
    /// The rotation, amid two halves of a push if there is one:
    ///
    /// ```text
    /// let a = …;
    /// rotation::amid([p₀, p₁], v, |v| rotation::plane(a, v))
    /// ```
    pub(super) fn rotation(&self, program: &Program) -> TokenStream {
        let Self { scalar, runtime, variables, dimension: d, .. } = self;
        let (receiver, [c, v, angle]) = (receiver(), ["c", "v", "a"].map(ident));
        let used = program.symbols();
        let (arguments, unpack) = self.unpacked(&[("q", &variables.q)], &used);
        let parameters = self.bind_parameters(&used, false);
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let entries = if variables.q.len() == 2 { 1 } else { 3 };
        let (a, push) = outputs.split_at(entries);
        let (a, turned) = match a {
            [a] => (a.clone(), quote!(#runtime::rotation::plane(#angle, #v))),
            a => (quote!([#(#a),*]), quote!(#runtime::rotation::space(#angle, #v))),
        };
        let value = match push {
            [] => turned,
            push => quote!(#runtime::rotation::amid([#(#push),*], #v, |#v| #turned)),
        };
        let doc = format!(" v′ = v − c (∇Φ − F(q, (v + v′)/2)): a rotation. Cost of its angle: {}.", program.cost());
        quote! {
            #[doc = #doc]
            #[inline]
            fn kick_by_mean(&#receiver, #c: #scalar, #(#arguments: [#scalar; #d],)* #v: [#scalar; #d]) -> [#scalar; #d] {
                #unpack
                #parameters
                #statements
                let #angle = #a;
                #value
            }
        }
    }
}
