//! `#[dmech::law] impl Kepler { … }`

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use syn::{Attribute, ImplItem, ImplItemFn, Item, ItemImpl, Path, Type};

use crate::diagnostics::{self, Mistakes, law};
use crate::role::Role;

use super::{
    Formula, Model, PairSignature, Parsed, Sibling, attribute, finish, nesting, options, outline, pair, signature,
};

/// How many invariants a run watches for a law: `MAX_OWN` of the core.
pub(crate) const MAX_INVARIANTS: usize = 8;

/// Reads the block that the attribute stands on.
pub(crate) fn from_impl(options: TokenStream, item: TokenStream) -> Parsed {
    let mut mistakes = Mistakes::default();
    let krate = options::parse(options, &mut mistakes.errors);
    let (parsed, has_bodies) = match parse(item.clone()) {
        Ok(item) => (Ok(item), true),
        Err(error) => match parse(outline::without_bodies(item.clone())) {
            Ok(outline @ Item::Impl(_)) => {
                mistakes.errors.push(error);
                (Ok(outline), false)
            }
            _ => (Err(error), true),
        },
    };
    let misspelt = match &parsed {
        Ok(Item::Impl(block)) => Misspelt::of(block),
        _ => None,
    };
    let item = attribute::strip(item, misspelt.as_ref().map(|misspelt| misspelt.name.as_str()));
    let model = match parsed {
        Ok(Item::Impl(block)) => model(block, misspelt, krate, &mut mistakes),
        Ok(other) => {
            mistakes.errors.push(law::not_an_impl(&other));
            Model::of_declared(other, krate)
        }
        Err(error) => {
            mistakes.errors.push(error);
            None
        }
    };
    finish(item, model, mistakes, has_bodies)
}

/// The item, unless it is nested too deeply or no Rust.
fn parse(item: TokenStream) -> Result<Item, syn::Error> {
    nesting::check(&item)?;
    syn::parse2(item).map_err(|error| law::syntax(&error))
}

fn model(block: ItemImpl, misspelt: Option<Misspelt>, krate: Path, mistakes: &mut Mistakes) -> Option<Model> {
    let Mistakes { errors, methods: mistaken } = mistakes;
    let ItemImpl { trait_, generics, self_ty, items, unsafety, .. } = block;
    if let Some((path, _)) = &trait_ {
        errors.push(law::trait_impl(path, &self_ty));
    }
    if let Some(unsafety) = &unsafety {
        errors.push(law::keyword(unsafety, "unsafe"));
    }
    let Some(name) = type_name(&self_ty) else {
        errors.push(law::unnamed_type(&self_ty));
        return None;
    };
    let mut members = Members { misspelt, ..Members::default() };
    for item in items {
        members.take(item, errors);
    }
    let Members { potential, force, invariants, pair: role_is_pair, mut methods, constants, had_role, .. } = members;
    if potential.is_none() && force.is_none() {
        if !had_role || !invariants.is_empty() {
            errors.push(law::no_role(&self_ty));
        }
        return Some(Model::unread(*self_ty, generics, krate, name));
    }
    if !invariants.is_empty() {
        // An energy of one's own is the kinetic energy and `self.energy(q)`.
        for method in potential.iter().chain(&force).chain(&invariants) {
            insert(&mut methods, method.sig.ident.to_string(), method.clone(), false);
        }
    }
    let mut dimension = 0;
    let mut data = None;
    let mut read = |method: ImplItemFn, role: Role, errors: &mut Vec<syn::Error>| {
        let before = errors.len();
        let checked = signature::check(&method, role, &constants, errors);
        if errors.len() > before {
            mistaken.insert(method.sig.ident.to_string());
        }
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
        let formula =
            Formula { role, ident: method.sig.ident, arguments: checked.list, body: method.block, closure: None };
        (formula, checked.result)
    };
    let roles = if role_is_pair { [Role::Pair, Role::PairForce] } else { [Role::Potential, Role::Force] };
    let potential = potential.map(|method| read(method, roles[0], errors).0);
    let force = force.map(|method| read(method, roles[1], errors));
    let invariants: Vec<_> = invariants.into_iter().map(|method| read(method, Role::Invariant, errors).0).collect();
    if let Some(beyond) = invariants.get(MAX_INVARIANTS) {
        errors.push(law::too_many_invariants(&beyond.ident, MAX_INVARIANTS));
    }
    if let (true, Some(first)) = (role_is_pair, invariants.first()) {
        errors.push(diagnostics::pair::invariant_of_two(&first.ident));
    }
    Some(Model {
        dimension,
        pair: role_is_pair.then_some(PairSignature { data }),
        potential,
        force,
        invariants,
        methods,
        constants,
        ..Model::unread(*self_ty, generics, krate, name)
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
    invariants: Vec<ImplItemFn>,
    /// They are a `#[pair]` and a `#[pair_force]`.
    pair: bool,
    methods: BTreeMap<String, Sibling<ImplItemFn>>,
    constants: BTreeMap<String, Sibling<syn::ImplItemConst>>,
    had_role: bool,
    misspelt: Option<Misspelt>,
}

/// An attribute that was meant to give the only role of the block.
struct Misspelt {
    name: String,
    role: Role,
}

impl Misspelt {
    /// A block that has a role leaves other attributes to whoever knows them.
    fn of(block: &ItemImpl) -> Option<Self> {
        let methods = block.items.iter().filter_map(|item| match item {
            ImplItem::Fn(method) => Some(method),
            _ => None,
        });
        let attributes: Vec<_> = methods.flat_map(|method| &method.attrs).collect();
        if attributes.iter().any(|attribute| attribute::role(attribute).is_some()) {
            return None;
        }
        attributes.into_iter().find_map(|attribute| {
            let role = attribute::meant_role(attribute)?;
            Some(Self { name: attribute.path().get_ident()?.to_string(), role })
        })
    }
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
            let misspelt = self.misspelt.as_ref().filter(|misspelt| attribute.path().is_ident(&misspelt.name));
            if let Some(misspelt) = misspelt {
                errors.push(law::misspelt_role(attribute, misspelt.role));
            }
            let Some(role) = attribute::role(attribute).or(misspelt.map(|misspelt| misspelt.role)) else { continue };
            self.had_role = true;
            if attribute.meta.require_path_only().is_err() {
                errors.push(law::role_arguments(attribute));
            }
            match given {
                Some(first) if first != role => errors.push(law::two_roles(attribute, first, role)),
                _ => given = Some(role),
            }
        }
        let Some(role) = given else {
            let conditional = is_conditional(&method.attrs);
            insert(&mut self.methods, method.sig.ident.to_string(), method, conditional);
            return;
        };
        if let Some(cfg) = method.attrs.iter().find(|a| is_cfg(a)) {
            errors.push(law::conditional_potential(cfg));
        }
        if role == Role::Invariant {
            self.invariants.push(method);
            return;
        }
        if role.is_of_two() != self.pair && (self.potential.is_some() || self.force.is_some()) {
            errors.push(diagnostics::pair::one_body_beside(&method.sig.ident));
            return;
        }
        self.pair = role.is_of_two();
        let slot = if role.is_force() { &mut self.force } else { &mut self.potential };
        match slot {
            Some(first) => errors.push(law::second_of_its_role(&method.sig.ident, &first.sig.ident, role)),
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
