//! Names and parameters that stand beside those of the user.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;
use syn::{GenericParam, Lifetime};

use super::names::ident;
use crate::model::Model;

/// The generic parameters of the impl blocks of a law between two bodies.
pub(super) struct PairGenerics {
    pub(super) scalar: Ident,
    /// The dimension, where it is any, and the scalar, without the law's own.
    pub(super) foreign: TokenStream,
    /// With the law's own and the data of the bodies, where they are any.
    pub(super) with_data: TokenStream,
    /// The same without the scalar.
    pub(super) author: TokenStream,
    /// The same without the dimension.
    pub(super) reads: TokenStream,
    pub(super) data: TokenStream,
    pub(super) dimension: TokenStream,
}

impl PairGenerics {
    pub(super) fn of(model: &Model) -> Self {
        let runtime = module(model);
        let scalar = scalar_name(model);
        let (dimension, any_dimension) = dimension(model);
        let data = match model.pair.as_ref().and_then(|pair| pair.data.as_ref()) {
            Some(data) => quote!(#data),
            None => {
                let name = generic_name(model, ["P", "Data", "__P", "__Data"], "__DmechData");
                quote!(#name)
            }
        };
        let any_data = model.pair.as_ref().is_none_or(|pair| pair.data.is_none());
        let parameters: Vec<_> = parameters_of(model).collect();
        let last_data = any_data.then(|| quote!(#data));
        let any_data = any_data.then(|| quote!(#data,));
        Self {
            foreign: quote!(<#any_dimension #scalar: #runtime::Real>),
            with_data: quote!(<#(#parameters,)* #any_dimension #any_data #scalar: #runtime::Real>),
            author: quote!(<#(#parameters,)* #any_dimension #any_data>),
            reads: quote!(<#(#parameters,)* #last_data>),
            scalar,
            data,
            dimension,
        }
    }
}

/// The number of coordinates as it is printed, and the parameter that it is where it may be any.
pub(super) fn dimension(model: &Model) -> (TokenStream, Option<TokenStream>) {
    if model.dimension > 0 {
        let d = Literal::usize_unsuffixed(model.dimension);
        return (quote!(#d), None);
    }
    let name = generic_name(model, ["D", "Dim", "__D", "__Dim"], "__DmechDimension");
    // In braces, as an argument without them would be a type of the user's that is called so.
    (quote!({ #name }), Some(quote!(const #name: usize,)))
}

/// The hidden module of the facade that generated code refers to.
pub(super) fn module(model: &Model) -> TokenStream {
    let krate = &model.krate;
    quote!(#krate::__private::v1)
}

/// The generic parameters of the law as an impl block declares them: a struct's may have defaults, a block's not.
pub(super) fn parameters_of(model: &Model) -> impl Iterator<Item = GenericParam> + '_ {
    model.generics.params.iter().cloned().map(|mut parameter| {
        match &mut parameter {
            GenericParam::Type(ty) => ty.default = None,
            GenericParam::Const(constant) => constant.default = None,
            GenericParam::Lifetime(_) => {}
        }
        parameter
    })
}

/// R, unless the user's own type or generics have that name.
pub(super) fn scalar_name(model: &Model) -> Ident {
    generic_name(model, ["R", "Scalar", "__R", "__Scalar"], "__DmechScalar")
}

/// The lifetime of the law in a hidden struct: 'law, unless the user's generics have it.
pub(super) fn hidden_lifetime(model: &Model) -> Lifetime {
    let name = generic_name(model, ["law", "held", "__law", "__held"], "__dmech_law");
    Lifetime::new(&format!("'{name}"), Span::mixed_site())
}

/// The first name that stands nowhere where the user's own text is printed beside it: not in the type of the law, its
/// generics and their bounds, the data of the bodies, or the path of the facade.
pub(super) fn generic_name(model: &Model, candidates: [&str; 4], last_resort: &str) -> Ident {
    let Model { self_ty, generics, krate, .. } = model;
    let (bounds, data) = (&generics.where_clause, model.pair.as_ref().map(|pair| &pair.data));
    let data = data.into_iter().flatten();
    let tokens = quote!(#self_ty #generics #bounds #(#data)* #krate).to_string();
    let words: Vec<&str> = tokens.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let free = candidates.into_iter().find(|name| !words.contains(name));
    ident(free.unwrap_or(last_resort))
}
