//! A program as the statements of a function body.

use std::collections::{HashMap, HashSet};

use dmech_symbolic::program::{Operation, Program, Test, Value};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use super::names::{Names, ident, runtime};
use super::operation::{self, Fragment};
use super::region::{Branch, Regions};
use super::shared_test::SharedTests;

/// Expressions with more operations than this are cut.
const LONGEST: usize = 5;
/// Branches with no more additions and multiplications than this are computed whether or not they are taken.
const LIGHTEST: usize = 4;

/// So many `let`s one after the other at most: each opens a scope within that of the last, and in builds with debug information the
/// compiler goes down all of them at once, until its stack is used up.
const DEEPEST: usize = 150;

/// Statements, and the expressions of the results.
pub(super) struct Printed {
    pub(super) statements: TokenStream,
    pub(super) outputs: Vec<TokenStream>,
}

/// Prints a program; symbols must be bound under their names.
pub(super) fn body(program: &Program, names: &Names, scalar: &Ident) -> Printed {
    let regions = Regions::new(program);
    let tests = SharedTests::new(program, &regions);
    let mut values: HashMap<Option<Branch>, Vec<Value>> = HashMap::new();
    program.values().for_each(|value| values.entry(regions.of(value)).or_default().push(value));
    let mut writer = Writer {
        program,
        scalar,
        idents: names.values(program),
        unnamed: 0,
        uses: tests.uses(program),
        values,
        tests,
        inline: vec![None; program.operations.len()],
    };
    let statements = writer.region(None);
    let outputs: Vec<_> = program.outputs.iter().map(|&v| writer.fragment(v).tokens).collect();
    Printed { statements: nested(statements, &outputs), outputs }
}

struct Writer<'a> {
    program: &'a Program,
    scalar: &'a Ident,
    idents: Vec<Option<Ident>>,
    /// How many values have been called t0, t1, …
    unnamed: usize,
    uses: Vec<usize>,
    /// The values of each region.
    values: HashMap<Option<Branch>, Vec<Value>>,
    tests: SharedTests,
    /// Values that are printed where they are used, not in a `let`.
    inline: Vec<Option<Fragment>>,
}

impl Writer<'_> {
    /// The `let`s of one region, in order.
    fn region(&mut self, region: Option<Branch>) -> Vec<Let> {
        let mut statements = vec![];
        let values = self.values.get(&region).cloned().unwrap_or_default();
        for value in values {
            while let Some(test) = self.tests.due(region, value) {
                let mask = operation::mask(&test, &mut |v| self.fragment(v));
                let name = self.temporary();
                self.tests.name(&test, name.clone());
                statements.push(Let { name, value: mask });
            }
            let fragment = match self.program.operation(value) {
                Operation::Symbol(_) => continue,
                Operation::Select(test, yes, no) => {
                    let (test, yes, no) = (test.clone(), *yes, *no);
                    let chosen = self.choice(value, &test, [yes, no]);
                    Fragment { size: LONGEST, ..Fragment::atom(chosen) }
                }
                other => {
                    let other = other.clone();
                    let scalar = self.scalar.clone();
                    operation::fragment(&other, &scalar, &mut |v| self.fragment(v))
                }
            };
            let number = matches!(self.program.operation(value), Operation::Number(_));
            let named = self.idents[value.index()].is_some();
            if number || (self.uses[value.index()] == 1 && !named && fragment.size <= LONGEST) {
                self.inline[value.index()] = Some(fragment);
            } else {
                statements.push(Let { name: self.ident(value), value: fragment.tokens });
            }
        }
        statements
    }

    fn choice(&mut self, choice: Value, test: &Test, [yes, no]: [Value; 2]) -> TokenStream {
        let scalar = self.scalar;
        let Some(mask) = self.tests.mask(test) else {
            let mask = operation::mask(test, &mut |v| self.fragment(v));
            let [yes, no] = [(true, yes), (false, no)].map(|(yes, value)| {
                let (statements, value) = self.branch(Branch { choice, yes }, value);
                block(statements, value)
            });
            return quote!(#scalar::select(#mask, || #yes, || #no));
        };
        let (runtime, otherwise) = (runtime(), quote!(#scalar::ZERO));
        let [yes, no] = [(true, yes), (false, no)].map(|(yes, value)| {
            let branch = Branch { choice, yes };
            let is_light = self.is_light(branch);
            let (statements, value) = self.branch(branch, value);
            match (is_light, yes) {
                (true, _) => block(statements, value),
                (false, true) => quote!(if #runtime::Mask::any(#mask) { #statements #value } else { #otherwise }),
                (false, false) => quote!(if #runtime::Mask::all(#mask) { #otherwise } else { #statements #value }),
            }
        });
        quote!(#scalar::either(#mask, #yes, #no))
    }

    /// Whether computing a branch in vain costs no more than asking whether it is needed.
    fn is_light(&self, branch: Branch) -> bool {
        use Operation::{Add, Mul, MulAdd, Neg, NegMulAdd, Number, Sub};
        let values = self.values.get(&Some(branch)).map_or(&[][..], Vec::as_slice);
        let operations = || values.iter().map(|&value| self.program.operation(value));
        values.len() <= LIGHTEST
            && operations().all(|operation| {
                matches!(operation, Number(_) | Neg(_) | Add(..) | Sub(..) | Mul(..) | MulAdd(..) | NegMulAdd(..))
            })
    }

    fn branch(&mut self, branch: Branch, value: Value) -> (TokenStream, TokenStream) {
        let statements = self.region(Some(branch));
        let value = self.fragment(value).tokens;
        (nested(statements, core::slice::from_ref(&value)), value)
    }

    fn fragment(&mut self, value: Value) -> Fragment {
        let inline = &mut self.inline[value.index()];
        let number = matches!(self.program.operation(value), Operation::Number(_));
        match if number { inline.clone() } else { inline.take() } {
            Some(fragment) => fragment,
            None => {
                let ident = self.ident(value);
                Fragment::atom(quote!(#ident))
            }
        }
    }

    fn ident(&mut self, value: Value) -> Ident {
        if let Some(named) = &self.idents[value.index()] {
            return named.clone();
        }
        let name = self.temporary();
        self.idents[value.index()].insert(name).clone()
    }

    /// The next of t0, t1, …
    fn temporary(&mut self) -> Ident {
        self.unnamed += 1;
        ident(&format!("t{}", self.unnamed - 1))
    }
}

/// `let name = value;`
struct Let {
    name: Ident,
    value: TokenStream,
}

impl ToTokens for Let {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Self { name, value } = self;
        tokens.extend(quote!(let #name = #value;));
    }
}

/// The statements as they are, or in blocks that give what later ones and the results use, if they are too many.
fn nested(statements: Vec<Let>, outputs: &[TokenStream]) -> TokenStream {
    if statements.len() <= DEEPEST {
        return quote!(#(#statements)*);
    }
    let mut used = HashSet::new();
    outputs.iter().for_each(|output| collect(output.clone(), &mut used));
    let blocks = statements.chunks(DEEPEST).rev().map(|block| {
        let out: Vec<_> = block.iter().map(|Let { name, .. }| name).filter(|name| used.contains(*name)).collect();
        let tokens = quote!(let (#(#out,)*) = { #(#block)* (#(#out,)*) };);
        block.iter().for_each(|Let { value, .. }| collect(value.clone(), &mut used));
        tokens
    });
    let blocks: Vec<_> = blocks.collect();
    blocks.into_iter().rev().collect()
}

/// The names in the tokens.
fn collect(tokens: TokenStream, names: &mut HashSet<Ident>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => drop(names.insert(name)),
            TokenTree::Group(group) => collect(group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Statements before a value.
fn block(statements: TokenStream, value: TokenStream) -> TokenStream {
    if statements.is_empty() { value } else { quote!({ #statements #value }) }
}
