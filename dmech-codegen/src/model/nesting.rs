//! A bound on the nesting of what is handed to the parser, which recurses and would otherwise overflow the stack of
//! the compiler.

use proc_macro2::{Delimiter, Spacing, Span, TokenStream, TokenTree};

use crate::diagnostics::law;

/// How deep the parser may recurse: brackets and operators that stand before their operand.
const MAX_DEPTH: usize = 64;
/// How long a chain of operators, calls and operands may be along one path into the brackets.
const MAX_CHAIN: usize = 6000;

/// An error at the first place that is nested too deeply.
pub(super) fn check(tokens: &TokenStream) -> Result<(), syn::Error> {
    scan(tokens.clone(), 0, 0)
}

fn scan(tokens: TokenStream, depth: usize, chain: usize) -> Result<(), syn::Error> {
    let mut segment = Segment::default();
    let mut after_brace = false;
    for token in tokens {
        if std::mem::take(&mut after_brace) && !continues(&token) {
            segment.close(depth, chain)?;
        }
        match token {
            TokenTree::Punct(p) if matches!(p.as_char(), ';' | ',') => segment.close(depth, chain)?,
            TokenTree::Group(group) => {
                after_brace = group.delimiter() == Delimiter::Brace;
                segment.take(group.span_open());
                // Recursion into brackets happens after the length of the segment around them is known.
                segment.groups.push((group.stream(), segment.depth()));
            }
            TokenTree::Punct(p) => segment.operator(p.as_char(), p.spacing(), p.span()),
            TokenTree::Ident(word) => segment.word(&word.to_string(), word.span()),
            TokenTree::Literal(literal) => segment.operand(literal.span()),
        }
        if depth + segment.depth() > MAX_DEPTH {
            return Err(law::too_deep(segment.last.unwrap_or_else(Span::call_site)));
        }
    }
    segment.close(depth, chain)
}

/// Whether an expression may go on after a closing brace.
fn continues(token: &TokenTree) -> bool {
    match token {
        TokenTree::Punct(p) => p.as_char() != '#',
        TokenTree::Ident(word) => word == "else" || word == "as",
        _ => false,
    }
}

/// Tokens up to the next `;` or `,` on one level of brackets.
#[derive(Default)]
struct Segment {
    groups: Vec<(TokenStream, usize)>,
    length: usize,
    /// Operators in a row before an operand.
    prefix: usize,
    /// Tokens that nest to the right wherever they stand, in quarters of a level: `=`, `|`, `<`, `else` …
    nesting: usize,
    last: Option<Span>,
}

impl Segment {
    fn depth(&self) -> usize {
        1 + self.prefix + self.nesting / 4
    }

    fn take(&mut self, span: Span) {
        self.length += 1;
        self.last = Some(span);
    }

    fn operand(&mut self, span: Span) {
        self.take(span);
        self.prefix = 0;
    }

    fn operator(&mut self, c: char, spacing: Spacing, span: Span) {
        self.take(span);
        match c {
            '-' | '!' | '&' | '*' | '.' | '|' if spacing == Spacing::Alone || c != '.' => self.prefix += 1,
            '=' | '<' | '>' => {}
            _ => self.prefix = 0,
        }
        if matches!(c, '=' | '|' | '<' | '>') {
            self.nesting += 1;
        }
    }

    fn word(&mut self, word: &str, span: Span) {
        match word {
            "return" | "break" | "yield" | "move" | "static" | "async" | "const" | "box" | "raw" | "mut" | "ref" => {
                self.take(span);
                self.prefix += 1;
            }
            "else" | "fn" | "dyn" | "impl" | "let" | "for" => {
                self.operand(span);
                self.nesting += 1;
            }
            _ => self.operand(span),
        }
    }

    fn close(&mut self, depth: usize, chain: usize) -> Result<(), syn::Error> {
        let segment = std::mem::take(self);
        let chain = chain + segment.length;
        if chain > MAX_CHAIN {
            return Err(law::too_long(segment.last.unwrap_or_else(Span::call_site)));
        }
        for (stream, within) in segment.groups {
            scan(stream, depth + within, chain)?;
        }
        Ok(())
    }
}
