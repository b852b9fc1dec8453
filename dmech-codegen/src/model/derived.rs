//! `#[derive(dmech::Law)] #[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])] struct Spring { k: f64 }`

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use syn::{Attribute, Block, Expr, ExprClosure, Fields, Item, ItemStruct, Meta, Pat, PatType, ReturnType, Stmt};
use syn::{parse_quote, token};

use crate::diagnostics::{Mistakes, law};
use crate::role::Role;

use super::{Argument, Formula, Model, Parsed, Quantity, attribute, finish, nesting, options, signature};

/// Reads the struct that the derive stands on.
pub(crate) fn from_derive(item: TokenStream) -> Parsed {
    let mut errors = vec![];
    let model = read(item, &mut errors);
    finish(TokenStream::new(), model, Mistakes { errors, ..Mistakes::default() }, true)
}

fn read(item: TokenStream, errors: &mut Vec<syn::Error>) -> Option<Model> {
    let parsed = nesting::check(&item).and_then(|()| syn::parse2::<Item>(item));
    match parsed {
        Ok(Item::Struct(item)) => Some(model(item, errors)),
        Ok(other) => {
            errors.push(law::not_a_struct(&other));
            Model::of_declared(other, options::default_crate())
        }
        Err(error) => {
            errors.push(error);
            None
        }
    }
}

fn model(item: ItemStruct, errors: &mut Vec<syn::Error>) -> Model {
    let mut krate = options::default_crate();
    let mut potential = None;
    let mut other_role = false;
    for attribute in &item.attrs {
        if attribute.path().is_ident("dmech") {
            match attribute.meta.require_list() {
                Ok(list) => krate = options::parse(list.tokens.clone(), errors),
                Err(_) => errors.push(law::bare_option(attribute)),
            }
        } else if attribute.path().is_ident("potential") {
            if potential.is_some() {
                errors.push(law::second_closure(attribute));
            } else {
                potential = Some((attribute, closure(attribute, errors)));
            }
        } else if let Some(role) = attribute::role(attribute) {
            errors.push(law::role_on_a_struct(attribute, &item.ident, role));
            other_role = true;
        }
    }
    let (_, ty_generics, _) = item.generics.split_for_impl();
    let ident = &item.ident;
    let (self_ty, name) = (parse_quote!(#ident #ty_generics), ident.to_string());
    let Some((attribute, closure)) = potential else {
        if !other_role {
            errors.push(law::no_closure(&item.ident));
        }
        return Model::unread(self_ty, item.generics, krate, name);
    };
    let Some(closure) = closure else { return Model::unread(self_ty, item.generics, krate, name) };
    check_closure(&closure, errors);
    let typed: Vec<PatType> = closure.inputs.iter().filter_map(|input| typed(input, errors)).collect();
    let mut arguments = signature::arguments(typed.iter(), Role::Potential, &BTreeMap::new(), errors);
    let untyped = closure.inputs.iter().filter(|input| !matches!(input, Pat::Type(_)));
    arguments.list.extend(untyped.map(|pattern| Argument { quantity: Quantity::Refused, pattern: pattern.clone() }));
    if arguments.dimension == 0 && !arguments.names(Quantity::Refused) {
        errors.push(law::no_position(&closure));
    }
    let formula = Formula {
        role: Role::Potential,
        ident: attribute.path().segments[0].ident.clone(),
        arguments: arguments.list,
        closure: Some(Box::new(closure.clone())),
        body: block(*closure.body),
    };
    Model {
        dimension: arguments.dimension,
        potential: Some(formula),
        fields: Some(fields(&item.fields)),
        ..Model::unread(self_ty, item.generics, krate, name)
    }
}

fn closure(attribute: &Attribute, errors: &mut Vec<syn::Error>) -> Option<ExprClosure> {
    let closure = match &attribute.meta {
        Meta::List(list) => syn::parse2::<Expr>(list.tokens.clone()),
        _ => Err(law::not_a_closure(attribute)),
    };
    match closure {
        Ok(Expr::Closure(closure)) => return Some(closure),
        Ok(other) => errors.push(law::not_a_closure(&other)),
        Err(error) => errors.push(error),
    }
    None
}

fn check_closure(closure: &ExprClosure, errors: &mut Vec<syn::Error>) {
    if let Some(asyncness) = &closure.asyncness {
        errors.push(law::keyword(asyncness, "async"));
    }
    if let Some(capture) = &closure.capture {
        errors.push(law::keyword(capture, "move"));
    }
    if let ReturnType::Type(..) = &closure.output {
        signature::returns_number(&closure.output, &closure, errors);
    }
}

fn typed(input: &Pat, errors: &mut Vec<syn::Error>) -> Option<PatType> {
    match input {
        Pat::Type(typed) => Some(typed.clone()),
        other => {
            errors.push(law::untyped_argument(other));
            None
        }
    }
}

fn block(body: Expr) -> Block {
    match body {
        Expr::Block(body) if body.label.is_none() && body.attrs.is_empty() => body.block,
        body => Block { brace_token: token::Brace::default(), stmts: vec![Stmt::Expr(body, None)] },
    }
}

fn fields(fields: &Fields) -> Vec<(String, syn::Type)> {
    fields
        .iter()
        .enumerate()
        .map(|(i, field)| {
            let name = field.ident.as_ref().map_or_else(|| i.to_string(), ToString::to_string);
            (name, field.ty.clone())
        })
        .collect()
}
