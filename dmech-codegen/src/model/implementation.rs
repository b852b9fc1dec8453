//! `#[dmech::law] impl Kepler { … }`

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use syn::{Attribute, ImplItem, ImplItemFn, Item, ItemImpl, Path, Type};

use crate::diagnostics::{self, law};

use super::roles::{self, Role};
use super::{
    ArgumentRole, Formula, Model, PairSignature, Parsed, Sibling, arguments, finish, nesting, pair, signature,
};

/// Reads the block that the attribute stands on.
pub(crate) fn from_impl(attribute: TokenStream, item: TokenStream) -> Parsed {
    let mut errors = vec![];
    let krate = arguments::parse(attribute, &mut errors);
    let model = read(item.clone(), krate, &mut errors);
    finish(roles::strip(item), model, errors)
}

fn read(item: TokenStream, krate: Path, errors: &mut Vec<syn::Error>) -> Option<Model> {
    let parsed = nesting::check(&item).and_then(|()| syn::parse2::<Item>(item));
    match parsed {
        Ok(Item::Impl(block)) => model(block, krate, errors),
        Ok(other) => {
            errors.push(law::not_an_impl(&other));
            None
        }
        Err(error) => {
            errors.push(error);
            None
        }
    }
}

fn model(block: ItemImpl, krate: Path, errors: &mut Vec<syn::Error>) -> Option<Model> {
    let ItemImpl { trait_, generics, self_ty, items, unsafety, .. } = block;
    if let Some((path, _)) = &trait_ {
        errors.push(law::trait_impl(path));
    }
    if let Some(unsafety) = &unsafety {
        errors.push(law::keyword(unsafety, "unsafe"));
    }
    let Some(name) = type_name(&self_ty) else {
        errors.push(law::unnamed_type(&self_ty));
        return None;
    };
    let mut members = Members::default();
    for item in items {
        members.take(item, errors);
    }
    let Members { potential, force, pair: role_is_pair, methods, constants, had_role } = members;
    if potential.is_none() && force.is_none() {
        if !had_role {
            errors.push(law::no_role(&self_ty));
        }
        return None;
    }
    let docs = potential.iter().chain(&force).flat_map(|method| method.attrs.clone());
    let docs = docs.filter(|a| a.path().is_ident("doc")).collect();
    let mut dimension = 0;
    let mut names = Vec::new();
    let mut data = None;
    let mut read = |method: ImplItemFn, role: Role, errors: &mut Vec<syn::Error>| {
        let checked = signature::check(&method, role, &constants, errors);
        if dimension != 0 && checked.dimension != 0 && checked.dimension != dimension {
            errors.push(law::other_dimension(&method.sig.ident, checked.dimension, dimension));
        }
        dimension = dimension.max(checked.dimension);
        match (&data, checked.data) {
            (Some(one), Some(other)) if !pair::same(one, &other) => {
                errors.push(diagnostics::pair::two_data_types(&other, one));
            }
            (None, other) => data = other,
            _ => {}
        }
        names.extend(checked.list.iter().map(|argument| argument.role));
        let formula = Formula { ident: method.sig.ident, arguments: checked.list, body: method.block };
        (formula, checked.result)
    };
    let roles = if role_is_pair { [Role::Pair, Role::PairForce] } else { [Role::Potential, Role::Force] };
    let potential = potential.map(|method| read(method, roles[0], errors).0);
    let force = force.map(|method| read(method, roles[1], errors));
    Some(Model {
        self_ty: *self_ty,
        generics,
        krate,
        name,
        dimension,
        names_mass: names.contains(&ArgumentRole::Mass),
        names_time: names.contains(&ArgumentRole::Time),
        docs,
        pair: role_is_pair.then_some(PairSignature { data }),
        potential,
        force,
        methods,
        constants,
        fields: None,
    })
}

/// `Kepler` of `physics::Kepler<T>`.
fn type_name(ty: &Type) -> Option<String> {
    match ty {
        Type::Path(path) => path.path.segments.last().map(|segment| segment.ident.to_string()),
        Type::Group(group) => type_name(&group.elem),
        Type::Paren(paren) => type_name(&paren.elem),
        _ => None,
    }
}

/// The members of the block, sorted.
#[derive(Default)]
struct Members {
    potential: Option<ImplItemFn>,
    force: Option<ImplItemFn>,
    /// They are a `#[pair]` and a `#[pair_force]`.
    pair: bool,
    methods: BTreeMap<String, Sibling<ImplItemFn>>,
    constants: BTreeMap<String, Sibling<syn::ImplItemConst>>,
    had_role: bool,
}

impl Members {
    fn take(&mut self, item: ImplItem, errors: &mut Vec<syn::Error>) {
        match item {
            ImplItem::Fn(method) => self.take_method(method, errors),
            ImplItem::Const(constant) => {
                let name = constant.ident.to_string();
                let conditional = is_conditional(&constant.attrs);
                insert(&mut self.constants, name, constant, conditional);
            }
            // Types and macros of the block are the user's own; the body cannot reach them.
            _ => {}
        }
    }

    fn take_method(&mut self, method: ImplItemFn, errors: &mut Vec<syn::Error>) {
        let mut given = None;
        for attribute in &method.attrs {
            let Some(role) = Role::of(attribute) else { continue };
            self.had_role = true;
            if attribute.meta.require_path_only().is_err() {
                errors.push(law::role_arguments(attribute));
            }
            if given.is_some_and(|other| other != role) {
                errors.push(law::two_roles(attribute));
            }
            given = Some(role);
        }
        let Some(role) = given else {
            let conditional = is_conditional(&method.attrs);
            insert(&mut self.methods, method.sig.ident.to_string(), method, conditional);
            return;
        };
        if let Some(cfg) = method.attrs.iter().find(|a| is_cfg(a)) {
            errors.push(law::conditional_potential(cfg));
        }
        let of_two = matches!(role, Role::Pair | Role::PairForce);
        if of_two != self.pair && (self.potential.is_some() || self.force.is_some()) {
            errors.push(diagnostics::pair::one_body_beside(&method.sig.ident));
            return;
        }
        self.pair = of_two;
        let (slot, what) = match role {
            Role::Force => (&mut self.force, "force"),
            Role::PairForce => (&mut self.force, "pair_force"),
            Role::Pair => (&mut self.potential, "pair"),
            Role::Potential => (&mut self.potential, "potential"),
        };
        match slot {
            Some(first) => {
                errors.push(law::second_of_its_role(&method.sig.ident, &first.sig.ident, what));
                errors.push(law::first_of_its_role(&first.sig.ident, what));
            }
            None => *slot = Some(method),
        }
    }
}

fn insert<T>(map: &mut BTreeMap<String, Sibling<T>>, name: String, member: T, conditional: bool) {
    let twice = map.contains_key(&name);
    map.insert(name, if conditional || twice { Sibling::Conditional } else { Sibling::One(Box::new(member)) });
}

fn is_conditional(attributes: &[Attribute]) -> bool {
    attributes.iter().any(is_cfg)
}

fn is_cfg(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg")
}
