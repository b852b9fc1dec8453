//! The macros of dmech. All work is done by `dmech-codegen`, where it can be tested as a library.
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

use proc_macro::TokenStream;

/// Turns a declared potential or force into gradients, discrete gradients and time steps made for it.
///
/// It stands on an inherent `impl` block. The methods stay as they are written, and traits are implemented beside them:
///
/// | method of the block | arguments, known by name | gives | the law acts on |
/// |---|---|---|---|
/// | `#[potential]` | `q`; `m`, `t` | the energy of one body | a particle, each body of a scene |
/// | `#[force]` | `q`, `v`; `m`, `t` | a force, alone or beside a potential | the same |
/// | `#[pair]` | the distance `r` or the separation `d` = q_a − q_b; `ma`, `mb`, `a: &P`, `b: &P`, `t` | the energy of two bodies | pairs, chains, bonds of a scene |
/// | `#[pair_force]` | `d`, `va`, `vb`, and as above | the force on a from b | the same |
/// | `#[invariant]` | `q`, `v`; `t` | a number that the motion keeps | watched in runs of a particle |
///
/// ```ignore
/// #[dmech::law]
/// impl Kepler {
///     #[potential]
///     fn energy(&self, q: [f64; 2]) -> f64 {
///         -self.gm / q[0].hypot(q[1])
///     }
/// }
/// ```
///
/// # The language of a law
///
/// The body is ordinary Rust. Understood are
///
/// - positions and velocities as `f64`, `[f64; D]` or vectors of nalgebra (`norm`, `norm_squared`, `dot`, …);
/// - `let` with patterns, blocks, arithmetic, comparisons, `&&`, `||`, `!`, `if` and `else`;
/// - constant `for` loops, `(a..b).map(…).sum()`, `+=` and its kin;
/// - fields of `self`, constants and helper methods of the same block, `std::f64::consts`;
/// - `sqrt cbrt powi powf exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan sin_cos asin acos atan atan2 sinh cosh tanh asinh acosh
///   atanh hypot abs signum recip mul_add min max clamp`;
/// - `round floor ceil trunc fract rem_euclid` where the law is periodic, as `x - l * (x / l).round()` for the nearest image.
///
/// Anything else is a compile error on that very expression, which says what to write instead. A law with a choice must be
/// continuous; its force need not be. What is rounded counts as constant between its jumps, also for derivatives; across a
/// jump the discrete gradient takes the whole difference, so that the energy-exact schemes keep the energy there too. The
/// law must be continuous in what is rounded by itself: a function of the distance of images is, or a periodic one. `x.clamp(low, high)` panics in Rust where the bounds are in the wrong order: those that
/// the macro can see are checked when the program is compiled, of fields of the law it computes `x.max(low).min(high)`.
///
/// ```ignore
/// /// A bead in a periodic box of length l with a spring to its nearest image of the centre, k |d|²/2.
/// #[dmech::law]
/// impl Cell {
///     #[potential]
///     fn energy(&self, q: [f64; 2]) -> f64 {
///         let d = q.map(|x| x - self.l * (x / self.l).round());
///         0.5 * self.k * (d[0] * d[0] + d[1] * d[1])
///     }
/// }
/// ```
///
/// # What is implemented
///
/// `Potential` with gradient, Hessian, discrete gradient and its Jacobian, `Force` with its Jacobians, `Law` (or `PairLaw`),
/// which simulations run, and `Derivation`, whose `derivation()` shows all of it in readable mathematics with what each
/// function costs. Everything is generic over the scalar: `f64`, `f32`, 31 digits, SIMD lanes.
///
/// # Invariants of a law's own
///
/// What a law keeps beside energy and momenta stands in its block as an `#[invariant]`, up to eight of them beside a potential
/// or a force. A run watches them at the recorded states, in the scalar that it is made with: `run.drift_of("area")` tells how
/// each moved, and the report has a line for it. No scheme promises anything of them.
///
/// ```ignore
///     #[invariant]
///     fn area(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
///         0.5 * (q[0] * v[1] - q[1] * v[0])
///     }
/// ```
///
/// # Options
///
/// `#[dmech::law(crate = path)]` where `dmech` is known by another path.
#[proc_macro_attribute]
pub fn law(arguments: TokenStream, item: TokenStream) -> TokenStream {
    dmech_codegen::law(arguments.into(), item.into()).into()
}

/// The short form of [`macro@law`] for a law of one line, with the same language:
///
/// ```ignore
/// #[derive(dmech::Law)]
/// #[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]
/// struct Spring { k: f64 }
/// ```
///
/// It has a `#[potential]` and nothing else. `#[dmech(crate = path)]` where `dmech` is known by another path.
#[proc_macro_derive(Law, attributes(potential, force, pair, pair_force, dmech))]
pub fn derive_law(item: TokenStream) -> TokenStream {
    dmech_codegen::derive(item.into()).into()
}
