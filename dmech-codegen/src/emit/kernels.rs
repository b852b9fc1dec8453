//! The functions of the implementation, one for each kernel.

use dmech_symbolic::expression::{Graph, Symbol};
use dmech_symbolic::kernel::{ForcedKernels, ForcedStep, Kernels, Step, Variables};
use dmech_symbolic::program::Program;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use super::body::{Printed, body};
use super::document::{force_texts, increment, pointwise_texts, step_texts};
use super::names::{Names, ident};
use crate::lower::{Parameter, Read, Source};

/// What all functions share.
pub(super) struct Printer<'a> {
    pub(super) graph: &'a Graph,
    pub(super) names: Names,
    pub(super) variables: &'a Variables,
    pub(super) parameters: &'a [Parameter],
    pub(super) scalar: Ident,
    /// The hidden module of the facade.
    pub(super) runtime: TokenStream,
    /// D, as it is to be printed.
    pub(super) dimension: TokenStream,
    /// The law is one between two bodies.
    pub(super) between: bool,
    /// What is read of a body, in order.
    pub(super) layout: &'a [Read],
    /// The user's methods.
    pub(super) declared: Vec<TokenStream>,
    /// How a method of the implementation reaches the law itself: `self` or `self.law`.
    pub(super) law: TokenStream,
}

impl Printer<'_> {
    /// All functions of `Potential` for a conservative law.
    pub(super) fn functions(&self, kernels: &Kernels) -> TokenStream {
        let pointwise = self.pointwise(kernels);
        let [kick_doc, gradient_kick_doc, implicit_doc, exact_doc] = step_texts(kernels);
        let kick = self.kick(&kick_doc, &kernels.kick);
        let gradient_kick = self.gradient_kick(&gradient_kick_doc, &kernels.gradient_kick);
        let implicit = self.step("implicit_increment", &kernels.implicit, false);
        let exact = self.step("discrete_increment", &kernels.discrete, true);
        quote! {
            #pointwise
            #kick
            #gradient_kick
            #[doc = #implicit_doc] #implicit
            #[doc = #exact_doc] #exact
        }
    }

    /// v − c times what acts.
    fn kick(&self, doc: &str, program: &Program) -> TokenStream {
        let function = self.function("kick", &self.motion(), &[self.variables.c], Rank::Vector, program);
        quote!(#[doc = #doc] #function)
    }

    /// v − c times what acts, and e times its change along itself.
    fn gradient_kick(&self, doc: &str, program: &Program) -> TokenStream {
        let coefficients = [self.variables.c, self.variables.e];
        let function = self.function("gradient_kick", &self.motion(), &coefficients, Rank::Vector, program);
        quote!(#[doc = #doc] #function)
    }

    /// Position and velocity.
    fn motion(&self) -> [(&'static str, &[Symbol]); 2] {
        [("q", &self.variables.q), ("v", &self.variables.v)]
    }

    /// The functions of `Potential` that are taken at a point, or between two.
    pub(super) fn pointwise(&self, kernels: &Kernels) -> TokenStream {
        self.pointwise_functions("q", kernels.pointwise(), &pointwise_texts(self.graph, kernels))
    }

    /// The same of the programs, with the name of the point.
    pub(super) fn pointwise_functions(
        &self,
        point: &str,
        programs: [&Program; 5],
        documents: &[Vec<String>; 5],
    ) -> TokenStream {
        let at = [(point, &self.variables.q[..])];
        let ends = [("a", &self.variables.a[..]), ("b", &self.variables.b[..])];
        let list = POINTWISE.iter().zip(programs).zip(documents);
        let functions = list.map(|((&(name, rank), program), text)| {
            let arrays = if name.starts_with("discrete") { &ends[..] } else { &at[..] };
            let function = self.function(name, arrays, &[], rank, program);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// The functions of `Force`: they take the time as an argument.
    pub(super) fn force_functions(&self, forced: &ForcedKernels) -> TokenStream {
        let time = self.parameters.iter().find(|p| matches!(p.source, Source::Time)).map(|p| p.symbol);
        let list = [
            ("force", Rank::Vector, &forced.force),
            ("force_dq", Rank::Matrix, &forced.force_dq),
            ("force_dv", Rank::Matrix, &forced.force_dv),
        ];
        let functions = list.into_iter().zip(force_texts(self.graph, forced)).map(|((name, rank, program), text)| {
            let used = time.is_some_and(|t| program.symbols().contains(&t));
            let t = underscored(&time.map_or_else(|| ident("t"), |t| self.names.symbol(t)), used);
            let function = self.function_of_time(name, &self.motion(), &[], Some(&t), rank, program);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// The functions of `Field` that a law with a force needs.
    pub(super) fn field_functions(&self, kernels: &Kernels, forced: &ForcedKernels) -> TokenStream {
        let slope = self.function("slope", &self.motion(), &[], Rank::Vector, &forced.slope);
        let half = self.function("half_force", &self.motion(), &[], Rank::Vector, &forced.half_force);
        let potential = self.step("potential_increment", &kernels.discrete, true);
        let (half_doc, workless) = match &forced.discrete {
            ForcedStep::Mean(_) => (" F/2, the share of the start of a step in the mean force.", None),
            ForcedStep::Middle { slope, change } => (
                " Nothing: a force that does no work is taken in the middle of the step.",
                Some(self.middle_step(slope, change, forced.discrete_is_linear)),
            ),
        };
        let slope_doc = format!(" ∇Φ − F: minus all that acts. Cost: {}.", forced.slope.cost());
        let potential_doc = increment("the potential alone: Δ + g ∇̄Φ(a, q + Δ) = c", &kernels.discrete);
        quote! {
            #[doc = #slope_doc] #slope
            #[doc = #half_doc] #half
            #[doc = #potential_doc] #potential
            #workless
        }
    }

    /// The steps of a law with a force.
    pub(super) fn forced_steps(&self, forced: &ForcedKernels) -> TokenStream {
        let wrap = |program: &Program, linear: bool| match linear {
            true => Step::Linear(program.clone()),
            false => Step::Newton(program.clone()),
        };
        let exact = match &forced.discrete {
            ForcedStep::Mean(program) => {
                let step = wrap(program, forced.discrete_is_linear);
                let exact_doc =
                    increment("the energy-exact step: Δ + g (∇̄Φ(a, q + Δ) − F′/2) = c, F′ at (q + Δ, v′)", &step);
                let exact = self.step("discrete_increment", &step, true);
                quote!(#[doc = #exact_doc] #exact)
            }
            ForcedStep::Middle { .. } => self.rounded_middle_step(),
        };
        let trapezoid = wrap(&forced.implicit, forced.implicit_is_linear);
        let implicit = self.step("implicit_increment", &trapezoid, false);
        let kick = self.kick(&format!(" v − c (∇Φ − F). Cost: {}.", forced.kick.cost()), &forced.kick);
        let gradient_kick = forced.gradient_kick.as_ref().map(|program| {
            let doc = format!(" v − c s + e (∂s/∂q) s, with s = ∇Φ − F. Cost: {}.", program.cost());
            self.gradient_kick(&doc, program)
        });
        let implicit_doc =
            increment("the trapezoidal step: Δ + g (∇Φ − F)(q + Δ, v′) = c, v′ = v + (2/h)(Δ − h v)", &trapezoid);
        quote! {
            #kick
            #gradient_kick
            #[doc = #implicit_doc] #implicit
            #exact
        }
    }

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
    fn function_of_time(
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
        let bound: Vec<_> = arrays.iter().map(|(_, symbols)| self.pattern(symbols, &used)).collect();
        // A law that is only run counts as used.
        let mention = self.declared.iter().filter(|_| matches!(rank, Rank::Scalar));
        let mention = mention.map(|path| quote!(let _ = #path;));
        let signature = arrays.iter().zip(&bound).map(|(&(array, _), pattern)| {
            let array = underscored(&ident(array), pattern.is_some());
            quote!(#array: [#scalar; #d])
        });
        let unpack = arrays.iter().zip(&bound).filter_map(|(&(array, _), pattern)| {
            let (array, pattern) = (ident(array), pattern.as_ref()?);
            Some(quote!(let #pattern = #array;))
        });
        let parameters = self.bind_parameters(&used, time.is_some());
        let time = time.map(|t| quote!(, #t: #scalar));
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let value = rank.gather(&outputs, self.variables.q.len());
        let (inline, result) = (self.inline(), rank.array(scalar, d));
        quote! {
            #inline
            fn #name(&#receiver, #(#scalars,)* #(#signature),* #time) -> #result {
                #(#mention)*
                #(#unpack)*
                #parameters
                #statements
                #value
            }
        }
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
        let used = self.parameters.iter().filter(|p| used.contains(&p.symbol));
        used.map(|parameter| {
            let name = self.names.symbol(parameter.symbol);
            match &parameter.source {
                Source::Law(tokens) => {
                    let value = on_law(tokens.clone(), &self.law);
                    quote!(let #name = #scalar::from_f64(#value);)
                }
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

    fn step(&self, name: &str, step: &Step, between: bool) -> TokenStream {
        let Self { scalar, runtime, variables, dimension: d, .. } = self;
        let (name, receiver) = (ident(name), receiver());
        let equation = ident("equation");
        let program = match step {
            Step::Linear(program) | Step::Newton(program) | Step::Central(program) => program,
        };
        let used = program.symbols();
        let parameters = self.bind_parameters(&used, false);
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let solution = if let Step::Central(_) = step {
            let solver = ident(if between { "discrete" } else { "implicit" });
            let arguments = if between { vec![variables.s_a, variables.s_b] } else { vec![variables.s] };
            let arguments = arguments.into_iter().map(|s| underscored(&self.names.symbol(s), used.contains(&s)));
            quote! {
                #runtime::newton::central::#solver(#equation, |#(#arguments: #scalar),*| {
                    #statements
                    [#(#outputs),*]
                })
            }
        } else {
            let solver = ident(match (step, between) {
                (Step::Linear(_), false) => "once",
                (Step::Linear(_), true) => "once_discrete",
                (_, false) => "drive",
                (_, true) => "drive_discrete",
            });
            let mut arrays = vec![("delta", &variables.delta), ("b", &variables.b)];
            if between {
                arrays.insert(0, ("a", &variables.a));
            }
            let bound: Vec<_> =
                arrays.iter().map(|(array, symbols)| (ident(array), self.pattern(symbols, &used))).collect();
            let arguments = bound.iter().map(|(array, pattern)| underscored(array, pattern.is_some()));
            let unpack = bound.iter().filter_map(|(array, pattern)| {
                let pattern = pattern.as_ref()?;
                Some(quote!(let #pattern = #array;))
            });
            let known = self.pattern(&variables.rhs, &used).map(|pattern| quote!(let #pattern = #equation.known();));
            let velocities = [("v", &variables.v), ("drift", &variables.drift)].map(|(field, symbols)| {
                let field = ident(field);
                self.pattern(symbols, &used).map(|pattern| quote!(let #pattern = #equation.#field;))
            });
            let scalars = [variables.g, variables.rate, variables.t_end].map(|symbol| {
                let name = self.names.symbol(symbol);
                used.contains(&symbol).then(|| quote!(let #name = #equation.#name;))
            });
            let needs_equation = known.is_some() || velocities.iter().chain(&scalars).any(Option::is_some);
            let closure_equation = underscored(&equation, needs_equation);
            // δ, then G + J δ or both apart.
            let constructor = ident(if between { "in_parts" } else { "rounded" });
            let vectors = outputs.chunks(variables.q.len());
            quote! {
                #runtime::newton::#solver(#equation, |#closure_equation, #(#arguments),*| {
                    #(#unpack)*
                    #known
                    #(#velocities)*
                    #(#scalars)*
                    #statements
                    #runtime::newton::Correction::#constructor(#([#(#vectors),*]),*)
                })
            }
        };
        // Without `always` the equation and its solution go through memory.
        quote! {
            #[inline(always)]
            fn #name(
                &#receiver,
                #equation: &#runtime::newton::Equation<#d, #scalar>,
            ) -> ::core::result::Result<#runtime::newton::Increment<#d, #scalar>, #runtime::newton::NotConverged> {
                #parameters
                #solution
            }
        }
    }
}

/// The functions of `Potential` at a point, or between two.
pub(super) const POINTWISE: [(&str, Rank); 5] = [
    ("potential", Rank::Scalar),
    ("gradient", Rank::Vector),
    ("hessian", Rank::Matrix),
    ("discrete_gradient", Rank::Vector),
    ("discrete_gradient_jacobian", Rank::Matrix),
];

/// What the results of a program are gathered into.
#[derive(Clone, Copy)]
pub(super) enum Rank {
    Scalar,
    Vector,
    Matrix,
    /// Three matrices.
    Matrices,
}

impl Rank {
    /// The type of the whole.
    pub(super) fn array(self, scalar: &Ident, d: &TokenStream) -> TokenStream {
        match self {
            Self::Scalar => quote!(#scalar),
            Self::Vector => quote!([#scalar; #d]),
            Self::Matrix => quote!([[#scalar; #d]; #d]),
            Self::Matrices => quote!([[[#scalar; #d]; #d]; 3]),
        }
    }

    fn gather(self, outputs: &[TokenStream], dimension: usize) -> TokenStream {
        let part = match self {
            Self::Scalar => return outputs[0].clone(),
            Self::Vector => return quote!([#(#outputs),*]),
            Self::Matrix => Self::Vector,
            Self::Matrices => Self::Matrix,
        };
        let parts = outputs.chunks(outputs.len() / if let Self::Matrix = self { dimension } else { 3 });
        let parts = parts.map(|outputs| part.gather(outputs, dimension));
        quote!([#(#parts),*])
    }
}

/// `self`, as the user's own tokens see it.
pub(super) fn receiver() -> Ident {
    Ident::new("self", Span::call_site())
}

pub(super) fn underscored(name: &Ident, used: bool) -> Ident {
    if used { name.clone() } else { ident(&format!("_{name}")) }
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
