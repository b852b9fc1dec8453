//! What `Potential` says in constants.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The structure of a potential; nothing is said of the degree of one that is no polynomial.
pub(super) fn of_potential(central: bool, linear: bool, piecewise: bool, degree: Option<u32>) -> TokenStream {
    let piecewise = piecewise.then(|| {
        quote! { const PIECEWISE: bool = true; }
    });
    let degree = degree.map(Literal::u32_unsuffixed).map(|degree| {
        quote! {
            const DEGREE: ::core::option::Option<::core::primitive::u32> = ::core::option::Option::Some(#degree);
        }
    });
    quote! {
        const CENTRAL: bool = #central;
        const LINEAR: bool = #linear;
        #piecewise
        #degree
    }
}
