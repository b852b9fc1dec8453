//! One function of arrays: its arguments, what it reads of the law, its statements, its result.

use dmech_symbolic::expression::Symbol;
use dmech_symbolic::program::Program;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use super::body::{Printed, body};
use super::names::{ident, receiver, underscored};
use super::printer::{Printer, Reached};
use super::rank::Rank;
use crate::lower::Source;

impl Printer<'_> {
    pub(super) fn function(
        &self,
        name: &str,
        arrays: &[(&str, &[Symbol])],
        scalars: &[Symbol],
        rank: Rank,
        program: &Program,
    ) -> TokenStream {
        self.function_of_time(name, arrays, scalars, None, rank, program)
    }

    /// A function of arrays; scalars come before them, the time after.
    pub(super) fn function_of_time(
        &self,
        name: &str,
        arrays: &[(&str, &[Symbol])],
        scalars: &[Symbol],
        time: Option<&Ident>,
        rank: Rank,
        program: &Program,
    ) -> TokenStream {
        let (name, scalar, d) = (ident(name), &self.scalar, &self.dimension);
        let receiver = receiver();
        let used = program.symbols();
        let scalars = scalars.iter().map(|&s| {
            let name = underscored(&self.names.symbol(s), used.contains(&s));
            quote!(#name: #scalar)
        });
        let (signature, unpack) = self.unpacked(arrays, &used);
        let parameters = self.bind_parameters(&used, time.is_some());
        let time = time.map(|t| quote!(, #t: #scalar));
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let value = rank.gather(&outputs, self.variables.q.len());
        let (inline, result) = (self.inline(), rank.array(scalar, d));
        quote! {
            #inline
            fn #name(&#receiver, #(#scalars,)* #(#signature: [#scalar; #d]),* #time) -> #result {
                #unpack
                #parameters
                #statements
                #value
            }
        }
    }

    /// The names of arrays as arguments, and the `let`s of the components that are used.
    pub(super) fn unpacked(&self, arrays: &[(&str, &[Symbol])], used: &[Symbol]) -> (Vec<Ident>, TokenStream) {
        let bound = arrays.iter().map(|(array, symbols)| (ident(array), self.pattern(symbols, used)));
        let unpack = |(array, pattern): (Ident, Option<TokenStream>)| {
            let name = underscored(&array, pattern.is_some());
            (name, pattern.map_or_else(TokenStream::new, |pattern| quote!(let #pattern = #array;)))
        };
        bound.map(unpack).unzip()
    }

    /// A law between two bodies stands in the loop over all pairs, whose registers it must share.
    fn inline(&self) -> TokenStream {
        if self.between { quote!(#[inline(always)]) } else { quote!(#[inline]) }
    }

    /// `let [x, _] = …` with the names of the symbols that are used; none if none is.
    pub(super) fn pattern(&self, symbols: &[Symbol], used: &[Symbol]) -> Option<TokenStream> {
        if !symbols.iter().any(|s| used.contains(s)) {
            return None;
        }
        let names = symbols.iter().map(|s| {
            let name = self.names.symbol(*s);
            if used.contains(s) { quote!(#name) } else { quote!(_) }
        });
        Some(quote!([#(#names),*]))
    }

    pub(super) fn bind_parameters(&self, used: &[Symbol], time_is_given: bool) -> TokenStream {
        let scalar = &self.scalar;
        let numbers = self.parameters.iter().scan(0, |next, parameter| {
            let number = *next;
            *next += usize::from(matches!(parameter.source, Source::Law(_)));
            Some((number, parameter))
        });
        let used = numbers.filter(|(_, p)| used.contains(&p.symbol));
        used.map(|(number, parameter)| {
            let name = self.names.symbol(parameter.symbol);
            match &parameter.source {
                Source::Law(tokens) => match &self.law {
                    Reached::Law(law) => {
                        let value = on_law(tokens.clone(), law);
                        let runtime = &self.runtime;
                        quote!(let #name = #scalar::from_f64(#runtime::written::Number::number(#value));)
                    }
                    Reached::Numbers => {
                        let (receiver, number) = (receiver(), proc_macro2::Literal::usize_unsuffixed(number));
                        quote!(let #name = #receiver.law[#number];)
                    }
                },
                Source::Mass => {
                    let receiver = receiver();
                    quote!(let #name = #receiver.mass;)
                }
                Source::Body(body, read) => {
                    let (receiver, body) = (receiver(), ident(body.name()));
                    let i = self.layout.iter().position(|other| other.is_same(read)).unwrap_or_default();
                    let i = proc_macro2::Literal::usize_unsuffixed(i);
                    quote!(let #name = #receiver.#body[#i];)
                }
                Source::Time if time_is_given => TokenStream::new(),
                Source::Time => {
                    let receiver = receiver();
                    quote!(let #name = #receiver.t;)
                }
            }
        })
        .collect()
    }
}

/// The user's `self.gm` with `self` replaced by what reaches the law.
pub(super) fn on_law(tokens: TokenStream, law: &TokenStream) -> TokenStream {
    tokens
        .into_iter()
        .flat_map(|tree| match tree {
            TokenTree::Ident(ident) if ident == "self" => {
                let span = ident.span();
                quote_spanned!(span=> #law).into_iter().collect::<Vec<_>>()
            }
            TokenTree::Group(group) => {
                let mut inner = proc_macro2::Group::new(group.delimiter(), on_law(group.stream(), law));
                inner.set_span(group.span());
                vec![TokenTree::Group(inner)]
            }
            other => vec![other],
        })
        .collect()
}
