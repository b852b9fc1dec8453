//! A program as the statements of a function body.

use dmech_symbolic::program::{Operation, Program, Value};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::names::{Names, ident};
use super::operation::{self, Fragment};
use super::region::{Branch, Regions};

/// Expressions with more operations than this are cut.
const LONGEST: usize = 5;

/// Statements, and the expressions of the results.
pub(super) struct Body {
    pub(super) statements: TokenStream,
    pub(super) outputs: Vec<TokenStream>,
}

/// Prints a program; symbols must be bound under their names.
pub(super) fn body(program: &Program, names: &Names, scalar: &Ident) -> Body {
    let mut printer = Printer {
        program,
        scalar,
        idents: names.values(program),
        unnamed: 0,
        uses: program.uses(),
        regions: Regions::new(program),
        inline: vec![None; program.operations.len()],
    };
    let statements = printer.region(None);
    let outputs = program.outputs.iter().map(|&v| printer.fragment(v).tokens).collect();
    Body { statements, outputs }
}

struct Printer<'a> {
    program: &'a Program,
    scalar: &'a Ident,
    idents: Vec<Option<Ident>>,
    /// How many values have been called t0, t1, …
    unnamed: usize,
    uses: Vec<usize>,
    regions: Regions,
    /// Values that are printed where they are used, not in a `let`.
    inline: Vec<Option<Fragment>>,
}

impl Printer<'_> {
    /// The `let`s of one region, in order.
    fn region(&mut self, region: Option<Branch>) -> TokenStream {
        let mut statements = TokenStream::new();
        let values: Vec<Value> = self.program.values().collect();
        for value in values {
            if self.regions.of(value) != region {
                continue;
            }
            let fragment = match self.program.operation(value) {
                Operation::Symbol(_) => continue,
                Operation::Select(test, yes, no) => {
                    let (test, yes, no) = (test.clone(), *yes, *no);
                    let mask = operation::mask(&test, &mut |v| self.fragment(v));
                    let yes = self.branch(value, true, yes);
                    let no = self.branch(value, false, no);
                    let scalar = self.scalar;
                    Fragment { size: LONGEST, ..Fragment::atom(quote!(#scalar::select(#mask, || #yes, || #no))) }
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
                let (ident, tokens) = (self.ident(value), fragment.tokens);
                statements.extend(quote!(let #ident = #tokens;));
            }
        }
        statements
    }

    fn branch(&mut self, choice: Value, yes: bool, value: Value) -> TokenStream {
        let statements = self.region(Some(Branch { choice, yes }));
        let tokens = self.fragment(value).tokens;
        if statements.is_empty() { tokens } else { quote!({ #statements #tokens }) }
    }

    fn fragment(&mut self, value: Value) -> Fragment {
        match &self.inline[value.index()] {
            Some(fragment) => fragment.clone(),
            None => {
                let ident = self.ident(value);
                Fragment::atom(quote!(#ident))
            }
        }
    }

    fn ident(&mut self, value: Value) -> Ident {
        let unnamed = &mut self.unnamed;
        let named = self.idents[value.index()].get_or_insert_with(|| {
            *unnamed += 1;
            ident(&format!("t{}", *unnamed - 1))
        });
        named.clone()
    }
}
