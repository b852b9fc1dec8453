//! The author's own methods, called as the compiler understands them: what is stepped must give the same.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{ReturnType, parse_quote};

use super::function::on_law;
use super::names::{ident, receiver, runtime, underscored};
use crate::model::{Body, Formula, MAX_INVARIANTS, Model, PairArgument, Quantity, Shape};

/// The items of `Author` or, between two bodies, of `PairAuthor`.
pub(super) fn items(model: &Model, dimension: &TokenStream, data: Option<&TokenStream>) -> TokenStream {
    let (runtime, receiver, place) = (runtime(), receiver(), ident("place"));
    let potential = model.potential.as_ref().map(|potential| call(model, potential));
    let potential = potential.unwrap_or_else(|| quote!(0.0));
    let force = match &model.force {
        None => quote!([0.0; #dimension]),
        Some((force, shape)) => {
            let force = call(model, force);
            match shape {
                Shape::Number => quote!([#force]),
                Shape::Array => force,
                Shape::Vector => quote!(::core::convert::Into::into(#force)),
            }
        }
    };
    let named = |body: Body| {
        let data = Quantity::Pair(PairArgument::Data(body));
        model.formulas().flat_map(|formula| &formula.arguments).any(|argument| argument.quantity == data)
    };
    let bodies = data.into_iter().flat_map(|data| {
        [Body::A, Body::B].map(|body| {
            let name = underscored(&ident(body.name()), named(body));
            quote!(#name: &#data)
        })
    });
    let kept = (!model.invariants.is_empty()).then(|| {
        let values = model.invariants.iter().map(|invariant| call(model, invariant));
        let absent = (model.invariants.len()..MAX_INVARIANTS).map(|_| quote!(0.0));
        let values = values.chain(absent);
        quote! {
            fn invariants(&#receiver, #place: &#runtime::written::Probe<#dimension>) -> #runtime::written::OwnValues {
                [#(#values),*]
            }
        }
    });
    quote! {
        fn own(&#receiver, #place: &#runtime::written::Probe<#dimension>, #(#bodies),*)
            -> #runtime::written::Values<#dimension>
        {
            #runtime::written::Values { potential: #potential, force: #force }
        }
        #kept
    }
}

/// The method, or the closure, with the numbers of a place for its arguments.
fn call(model: &Model, formula: &Formula) -> TokenStream {
    let (self_ty, receiver) = (&model.self_ty, receiver());
    let arguments = formula.arguments.iter().map(|argument| value(argument.quantity));
    match &formula.closure {
        None => {
            let method = &formula.ident;
            quote!(<#self_ty>::#method(#receiver, #(#arguments),*))
        }
        Some(closure) => {
            let mut closure = closure.clone();
            if matches!(closure.output, ReturnType::Default) {
                let body = &closure.body;
                closure.body = parse_quote!({ #body });
                closure.output = parse_quote!(-> ::core::primitive::f64);
            }
            // The receiver of the generated function is meant, wherever the text stands.
            let closure = on_law(closure.into_token_stream(), &quote!(#receiver));
            let law = ident("law");
            quote!({ let #law = #closure; #law(#(#arguments),*) })
        }
    }
}

fn value(quantity: Quantity) -> TokenStream {
    let (runtime, place) = (runtime(), ident("place"));
    let vector = |vector: TokenStream, shape: Shape| match shape {
        Shape::Number => quote!(#vector[0]),
        Shape::Array => vector,
        Shape::Vector => quote!(#runtime::written::arranged(#vector)),
    };
    let of = |body: Body| proc_macro2::Literal::usize_unsuffixed(body as usize);
    match quantity {
        Quantity::Position(shape) => vector(quote!(#place.q), shape),
        Quantity::Velocity(shape) => vector(quote!(#place.v[0]), shape),
        Quantity::Mass => quote!(#place.m[0]),
        Quantity::Time => quote!(#place.t),
        Quantity::Pair(PairArgument::Distance) => quote!(#runtime::radial::square(#place.q).sqrt()),
        Quantity::Pair(PairArgument::Separation(shape)) => vector(quote!(#place.q), shape),
        Quantity::Pair(PairArgument::Velocity(body, shape)) => {
            let body = of(body);
            vector(quote!(#place.v[#body]), shape)
        }
        Quantity::Pair(PairArgument::Mass(body)) => {
            let body = of(body);
            quote!(#place.m[#body])
        }
        Quantity::Pair(PairArgument::Data(body)) => ident(body.name()).into_token_stream(),
        // A law that is refused is not emitted.
        Quantity::Refused => TokenStream::new(),
    }
}
