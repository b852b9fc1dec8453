//! What a law is refused for before its body is read, and what the checked model says.

use proc_macro2::TokenStream;
use quote::ToTokens;

use super::*;

/// Takes the marks « » out of a text; the ranges between them, in the order of the text.
fn marked(text: &str) -> (String, Vec<std::ops::Range<usize>>) {
    let (mut plain, mut open, mut ranges) = (String::new(), vec![], vec![]);
    for c in text.chars() {
        match c {
            '«' => open.push(plain.len()),
            '»' => ranges.push(open.pop().expect("an opening mark")..plain.len()),
            c => plain.push(c),
        }
    }
    ranges.sort_by_key(|range| (range.start, range.end));
    (plain, ranges)
}

fn assert_refused(text: &str, messages: &[&str], read: impl Fn(TokenStream) -> Parsed) {
    let (plain, ranges) = marked(text);
    let Err(refused) = read(plain.parse().unwrap()).model.map_err(crate::with_bodies) else {
        panic!("accepted: {text}")
    };
    let mut said: Vec<_> =
        refused.mistakes.errors.iter().map(|error| (error.span().byte_range(), error.to_string())).collect();
    said.sort_by_key(|(range, _)| (range.start, range.end));
    assert_eq!(said.len(), messages.len(), "{text}: {said:#?}");
    assert_eq!(ranges.len(), messages.len(), "{text}: as many marks as messages");
    for ((range, message), (marked, expected)) in said.iter().zip(ranges.iter().zip(messages)) {
        assert_eq!(range, marked, "{text}: points at `{}`: {message}", &plain[range.clone()]);
        assert_eq!(message, expected, "{text}");
    }
}

/// An impl block that is refused at the marks.
fn refused(text: &str, messages: &[&str]) {
    assert_refused(text, messages, |item| from_impl(TokenStream::new(), item));
}

/// A struct that is refused at the marks.
fn refused_derive(text: &str, messages: &[&str]) {
    assert_refused(text, messages, from_derive);
}

fn model(text: &str) -> Model {
    from_impl(TokenStream::new(), text.parse().unwrap())
        .model
        .unwrap_or_else(|refused| panic!("{text}: {:?}", refused.mistakes))
}

fn text(tokens: &impl ToTokens) -> String {
    tokens.to_token_stream().to_string().replace(' ', "")
}

#[test]
fn what_a_model_says() {
    let model = model(
        "impl<T: Copy> physics::Kepler<T> where T: Send {
            /// Energy.
            #[inline] #[potential] pub fn energy(&self, t: f64, q: Vector3<f64>) -> f64 { q.x * t }
            const A: f64 = 1.0;
            fn helper(&self) {}
        }",
    );
    assert_eq!(text(&model.self_ty), "physics::Kepler<T>");
    assert_eq!(text(&model.generics), "<T:Copy>");
    assert_eq!(text(&model.generics.where_clause), "whereT:Send");
    assert_eq!(text(&model.krate), "::dmech");
    assert_eq!((model.name.as_str(), model.dimension), ("Kepler", 3));
    assert_eq!(model.potential.as_ref().unwrap().ident, "energy");
    assert!(model.methods.contains_key("helper") && model.constants.contains_key("A"));
}

#[test]
fn what_a_derived_model_says() {
    let item = "/// A spring.
        #[derive(Clone, Law)] #[dmech(crate = crate::facade)] #[potential(|q: f64, m: f64| -> f64 { m * self.k * q })]
        pub(crate) struct Spring<'a, T: Copy = f64, const N: usize = 2> { k: f64, other: &'a [T; N] }";
    let parsed = from_derive(item.parse().unwrap());
    assert!(parsed.item.is_empty());
    let model = parsed.model.unwrap_or_else(|refused| panic!("{:?}", refused.mistakes));
    assert_eq!(text(&model.self_ty), "Spring<'a,T,N>");
    assert_eq!(text(&model.krate), "crate::facade");
    assert_eq!((model.name.as_str(), model.dimension), ("Spring", 1));
}

#[test]
fn the_crate_can_be_somewhere_else() {
    let item = || "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q } }".parse().unwrap();
    for (arguments, expected) in [("", "::dmech"), ("crate = my::mechanics", "my::mechanics"), ("crate = ::d,", "::d")]
    {
        let model = from_impl(arguments.parse().unwrap(), item())
            .model
            .unwrap_or_else(|refused| panic!("{arguments}: {:?}", refused.mistakes));
        assert_eq!(text(&model.krate), expected);
    }
    for (arguments, expected) in [
        ("krate = x", "`krate` is no option of the macro; the only one is `crate = path::to::dmech`"),
        ("\"x\"", "this is no option of the macro; the only one is `crate = path::to::dmech`"),
    ] {
        let Err(refused) = from_impl(arguments.parse().unwrap(), item()).model else { panic!("accepted: {arguments}") };
        assert_eq!(refused.mistakes.errors.iter().map(ToString::to_string).collect::<Vec<_>>(), [expected]);
    }
}

/// Only the attributes of roles are taken away; everything else stays token by token, even where nothing can be read.
#[test]
fn the_item_is_emitted_again() {
    let stripped = |text: &str| {
        let Parsed { item, .. } = from_impl(TokenStream::new(), text.parse().unwrap());
        item.to_string()
    };
    let same = |text: &str| text.parse::<TokenStream>().unwrap().to_string();
    assert_eq!(
        stripped(
            "/// Law. #[allow(x)] impl Law { /// E. #[inline] #[potential] #[must_use] fn e(&self, q: f64) -> f64 { q } }"
        ),
        same(
            "/// Law. #[allow(x)] impl Law { /// E. #[inline] #[potential] #[must_use] fn e(&self, q: f64) -> f64 { q } }"
        )
    );
    assert_eq!(
        stripped(
            "#[allow(x)] impl Law { #[inline] #[potential] #[must_use] fn e(&self, q: f64) -> f64 { #[potential] q } }"
        ),
        same("#[allow(x)] impl Law { #[inline] #[must_use] fn e(&self, q: f64) -> f64 { #[potential] q } }")
    );
    assert_eq!(
        stripped(
            "impl Law { #[force] fn f(&self) {} #[pair(x)] fn p(&self) {} #[pair_force] #[my::potential] fn g(&self) {} }"
        ),
        same("impl Law { fn f(&self) {} fn p(&self) {} #[my::potential] fn g(&self) {} }")
    );
    for broken in ["impl Law { fn e( }", "struct Law { k: f64 }", "impl", "", "what is this { #[x] }"] {
        if let Ok(tokens) = broken.parse::<TokenStream>() {
            assert_eq!(stripped(broken), tokens.to_string(), "{broken}");
        }
    }
}

#[test]
fn the_potential_says_what_it_is_made_of() {
    for (ty, dimension) in
        [("f64", 1), ("[f64; 7]", 7), ("[f64; Self::D]", 4), ("SVector<f64, { 5 }>", 5), ("na::Vector6<f64>", 6)]
    {
        let text =
            format!("impl Law {{ const D: usize = 4; #[potential] fn energy(&self, q: {ty}) -> f64 {{ 0.0 }} }}");
        assert_eq!(model(&text).dimension, dimension, "{ty}");
    }
}
#[test]
fn where_the_attribute_stands() {
    refused(
        "fn «energy»(q: f64) -> f64 { q }",
        &[
            "`#[dmech::law]` cannot stand on this function: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "struct «Law» { k: f64 }",
        &[
            "`#[dmech::law]` goes on the `impl` block of the law: `impl Law { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`; on the struct itself write `#[derive(dmech::Law)]` and `#[potential(|q: [f64; 2]| …)]`",
        ],
    );
    refused(
        "enum «Law» { A }",
        &[
            "`#[dmech::law]` cannot stand on this enum: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "union «Law» { a: f64, b: f64 }",
        &[
            "`#[dmech::law]` cannot stand on this union: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "trait «Law» { }",
        &[
            "`#[dmech::law]` cannot stand on this trait: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "mod «law» { }",
        &[
            "`#[dmech::law]` cannot stand on this module: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "«const K: f64 = 1.0;»",
        &[
            "`#[dmech::law]` cannot stand on this item: it goes on an inherent `impl` block, `impl Kepler { #[potential] fn energy(&self, q: [f64; 2]) -> f64 { … } }`",
        ],
    );
    refused(
        "impl «Potential» for Law { #[potential] fn energy(&self, q: f64) -> f64 { q } }",
        &[
            "`#[dmech::law]` goes on an inherent block, `impl Law { … }`, not on the implementation of a trait; the traits of mechanics are implemented by the macro",
        ],
    );
    refused(
        "impl «[f64; 3]» { #[potential] fn energy(&self, q: f64) -> f64 { q } }",
        &["a law is stated for a type with a name: `impl Kepler { … }`"],
    );
    refused(
        "«unsafe» impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q } }",
        &["a law is a plain formula and cannot be `unsafe`; leave the word away"],
    );
}

#[test]
fn roles() {
    refused(
        "impl «Law» { fn energy(&self, q: f64) -> f64 { q } }",
        &[
            "no method of this block says what acts; mark the one that returns the energy of `Law` with `#[potential]` (of one body) or `#[pair]` (of two), or the one that returns its force with `#[force]` or `#[pair_force]`",
        ],
    );
    refused(
        "impl «physics::Law<3>» { }",
        &[
            "no method of this block says what acts; mark the one that returns the energy of `physics::Law<3>` with `#[potential]` (of one body) or `#[pair]` (of two), or the one that returns its force with `#[force]` or `#[pair_force]`",
        ],
    );
    refused(
        "impl Law { #[potential] fn a(&self, q: f64) -> f64 { q } #[potential] fn «b»(&self, q: f64) -> f64 { q } }",
        &[
            "`b` is a second potential, and a law has one; `a` is marked already. Add the two in one method, with the other as a helper",
        ],
    );
    refused(
        "impl Law { #[force] fn a(&self, v: f64) -> f64 { v } #[force] fn «b»(&self, q: f64) -> f64 { q } }",
        &[
            "`b` is a second force, and a law has one; `a` is marked already. Add the two in one method, with the other as a helper",
        ],
    );
    refused(
        "impl Law { #[force] fn drag(&self, «speed»: f64, q: f64) -> f64 { -q } }",
        &[
            "`speed` is not an argument a force can have; expected one of: `q` (position), `v` (velocity), `m` (mass), `t` (time). Parameters are fields of the law: `self.k`",
        ],
    );
    refused(
        "impl Law { #[force] fn «drag»(&self, t: f64) -> f64 { t } }",
        &["a force is a function of position and velocity; give it an argument `q: [f64; D]`, `v: [f64; D]` or both"],
    );
    refused(
        "impl Law { #[potential] «#[force]» fn energy(&self, q: [f64; 2]) -> f64 { q[0] } }",
        &["this method is a potential already, and a method has one role; state the force in a method of its own"],
    );
    refused(
        "impl Law { #[«forse»] fn drag(&self, v: [f64; 2]) -> [f64; 2] { v } }",
        &["`forse` is no role of a method; write `#[force]`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, «x: f64, y»: f64, t: f64) -> f64 { x * y * t } }",
        &["the position is one argument, `q: [f64; 2]`; take it to pieces in the body: `let [x, y] = q;`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «[f32; 2]») -> f32 { q[0] } }",
        &["write the law in `f64`; the generated code runs it in `f32` and other scalars as well"],
    );
    refused(
        "impl Law { #[force] fn drag(&self, q: [f64; 2], v: «[f64; 3]») -> [f64; 2] { q } }",
        &["this has 3 components, and what is named before it has 2; position, velocity and force have equally many"],
    );
    refused(
        "impl Law { #[force] fn drag(&self, v: [f64; 2]) -> «f64» { v[0] } }",
        &["this has 1 component, and what is named before it has 2; position, velocity and force have equally many"],
    );
    refused(
        "impl Law { #[force] fn drag(&self, v: [f64; 2]) -> «bool» { true } }",
        &["`bool` cannot be a force; it is written like the position: `f64`, `[f64; D]` or `SVector<f64, D>`"],
    );
    refused(
        "impl Law { #[force] fn «drag»(&self, v: [f64; 2]) { } }",
        &["a force returns its components in the form of the position; add `-> [f64; D]`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q } #[force] fn «drag»(&self, v: [f64; 2]) -> [f64; 2] { v } }",
        &["`drag` has 2 coordinates, and the potential of this law has 1"],
    );
    refused(
        "impl Law { #[potential] «#[force]» fn both(&self, q: f64) -> f64 { q } }",
        &["this method is a potential already, and a method has one role; state the force in a method of its own"],
    );
    refused(
        "impl Law { «#[potential(q)]» fn energy(&self, q: f64) -> f64 { q } }",
        &["the role of a method takes no arguments; the method says it all"],
    );
    refused(
        "impl Law { «#[cfg(test)]» #[potential] fn energy(&self, q: f64) -> f64 { q } }",
        &[
            "whether this `#[cfg]` holds is not known when the macro runs; put it on the whole `impl` block, one block for each case",
        ],
    );
}

#[test]
fn signatures() {
    refused(
        "impl Law { #[potential] fn «energy»(q: f64) -> f64 { q } }",
        &["a potential takes the law first: `fn energy(&self, q: f64) -> f64`"],
    );
    refused(
        "impl Law { #[potential] fn energy(«&mut self», q: f64) -> f64 { q } }",
        &["a potential changes nothing; write `&self`"],
    );
    refused(
        "impl Law { #[potential] fn energy(«self», q: f64) -> f64 { q } }",
        &["a potential takes the law by reference; write `&self`"],
    );
    refused(
        "impl Law { #[potential] fn energy(«self: &Self», q: f64) -> f64 { q } }",
        &["a potential takes the law by reference; write `&self`"],
    );
    refused(
        "impl Law { #[potential] «async» «unsafe» «extern \"C\"» fn energy(&self, q: f64) -> f64 { q } }",
        &[
            "a law is a plain formula and cannot be `async`; leave the word away",
            "a law is a plain formula and cannot be `unsafe`; leave the word away",
            "a law is a plain formula and cannot be `extern`; leave the word away",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy«<T>»(&self, q: f64) -> f64 «where T: Copy» { q } }",
        &[
            "a potential has no generics of its own; the generated code is generic over the scalar anyway",
            "a potential has no generics of its own; the generated code is generic over the scalar anyway",
        ],
    );
    refused(
        "impl Law { #[potential] fn «energy»(&self, q: f64) { } }",
        &["a potential returns the potential energy; add `-> f64`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64) -> «f32» { q } }",
        &["write the law in `f64`; the generated code runs it in `f32` and other scalars as well"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64) -> «[f64; 1]» { [q] } }",
        &["a potential returns the potential energy, one `f64`, not `[f64; 1]`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64) -> «&f64» { &q } }",
        &["a potential returns the potential energy, one `f64`, not `&f64`"],
    );
    refused(
        "impl Law { #[potential] fn «energy»(&self) -> f64 { 0.0 } }",
        &[
            "a potential is a function of the position; give it an argument `q: f64`, `q: [f64; D]` or `q: SVector<f64, D>`",
        ],
    );
    refused(
        "impl Law { #[potential] fn «energy»(&self, m: f64) -> f64 { m } }",
        &[
            "a potential is a function of the position; give it an argument `q: f64`, `q: [f64; D]` or `q: SVector<f64, D>`",
        ],
    );
}

#[test]
fn arguments() {
    refused(
        "impl Law { #[potential] fn energy(&self, «x»: f64, q: f64) -> f64 { x * q } }",
        &[
            "`x` is not an argument a potential can have; expected one of: `q` (position), `m` (mass), `t` (time). Parameters are fields of the law: `self.k`",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64, «v»: f64) -> f64 { q * v } }",
        &["a potential does not depend on the velocity `v`; what depends on it is a `#[force]`"],
    );
    refused("impl Law { #[potential] fn energy(&self, q: f64, «q»: f64) -> f64 { q } }", &["`q` is named twice"]);
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64, m: «[f64; 2]», t: «f32») -> f64 { q * m * t } }",
        &["the mass `m` is a number; write `m: f64`", "the time `t` is a number; write `t: f64`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, «(x, y)»: (f64, f64)) -> f64 { x * y } }",
        &["the position is one argument, `q: [f64; 2]`; take it to pieces in the body: `let [x, y] = q;`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, «[x, y]»: [f64; 2]) -> f64 { x * y } }",
        &["the position is one argument, `q`; take it to pieces in the body: `let [x, y] = q;`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «&[f64; 2]») -> f64 { q[0] } }",
        &["the position is taken by value; write `q: [f64; 2]`"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «[f32; 2]») -> f64 { q[0] } }",
        &["write the law in `f64`; the generated code runs it in `f32` and other scalars as well"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «f32») -> f64 { q } }",
        &["write the law in `f64`; the generated code runs it in `f32` and other scalars as well"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «(f64, f64)») -> f64 { q.0 } }",
        &[
            "`(f64, f64)` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, `Vector2<f64>`, `Vector3<f64>`",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «Vec<f64>») -> f64 { q[0] } }",
        &[
            "`Vec<f64>` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, `Vector2<f64>`, `Vector3<f64>`",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «[[f64; 2]; 2]») -> f64 { q[0] } }",
        &[
            "`[[f64; 2]; 2]` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, `Vector2<f64>`, `Vector3<f64>`",
        ],
    );
    refused(
        "impl<const N: usize> Law<N> { #[potential] fn energy(&self, q: «[f64; N]») -> f64 { q[0] } }",
        &[
            "the number of coordinates must be known when the macro runs; write it as a literal, `[f64; 3]`, or as a constant of this block whose value is a literal, `[f64; Self::D]`",
        ],
    );
    refused(
        "impl Law { const D: usize = 1 + 1; #[potential] fn energy(&self, q: «[f64; Self::D]») -> f64 { q[0] } }",
        &[
            "the number of coordinates must be known when the macro runs; write it as a literal, `[f64; 3]`, or as a constant of this block whose value is a literal, `[f64; Self::D]`",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «[f64; 0]») -> f64 { 0.0 } }",
        &["a position has at least one coordinate"],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: «[f64; 1000]») -> f64 { 0.0 } }",
        &[
            "1000 coordinates are more than can be derived symbolically for one particle (at most 64); many bodies with a law between them are a scene",
        ],
    );
}

#[test]
fn derives() {
    refused_derive(
        "enum «Law» { A }",
        &["a law is a struct whose fields are its parameters; `dmech::Law` cannot be derived for an enum"],
    );
    refused_derive(
        "union «Law» { a: f64, b: f64 }",
        &["a law is a struct whose fields are its parameters; `dmech::Law` cannot be derived for a union"],
    );
    refused_derive(
        "struct «Law» { k: f64 }",
        &["the potential of `Law` is not stated; write `#[potential(|q: [f64; 2]| …)]` below the derive"],
    );
    refused_derive(
        "«#[potential]» struct Law { k: f64 }",
        &[
            "the potential is stated as a closure of the position: `#[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]`",
        ],
    );
    refused_derive(
        "#[potential(«self.k»)] struct Law { k: f64 }",
        &[
            "the potential is stated as a closure of the position: `#[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]`",
        ],
    );
    refused_derive(
        "«#[potential = \"q\"]» struct Law { k: f64 }",
        &[
            "the potential is stated as a closure of the position: `#[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]`",
        ],
    );
    refused_derive("#[potential(|«q»| q)] struct Law { k: f64 }", &["the type of `q` must be stated: `q: [f64; 2]`"]);
    refused_derive(
        "#[potential(|«q», «m»| q)] struct Law { k: f64 }",
        &["the type of `q` must be stated: `q: [f64; 2]`", "the type of `m` must be stated: `m: f64`"],
    );
    refused_derive(
        "#[potential(«||  0.0»)] struct Law { k: f64 }",
        &[
            "a potential is a function of the position; give it an argument `q: f64`, `q: [f64; D]` or `q: SVector<f64, D>`",
        ],
    );
    refused_derive(
        "#[potential(«move» |q: f64| q)] struct Law { k: f64 }",
        &["a law is a plain formula and cannot be `move`; leave the word away"],
    );
    refused_derive(
        "#[potential(|q: f64| -> «f32» { q })] struct Law { k: f64 }",
        &["write the law in `f64`; the generated code runs it in `f32` and other scalars as well"],
    );
    refused_derive(
        "#[potential(|q: f64| q)] «#[potential(|q: f64| q)]» struct Law { k: f64 }",
        &["a second potential, and a law has one; add the two in one closure"],
    );
    refused_derive(
        "«#[dmech]» #[potential(|q: f64| q)] struct Law { k: f64 }",
        &["write `#[dmech(crate = path::to::dmech)]`"],
    );
    refused_derive(
        "#[dmech(«krate» = x)] #[potential(|q: f64| q)] struct Law { k: f64 }",
        &["`krate` is no option of the macro; the only one is `crate = path::to::dmech`"],
    );
    refused_derive(
        "#[potential(|q: f64, «x»: f64| q + «z»)] struct Law { k: f64 }",
        &[
            "`x` is not an argument a potential can have; expected one of: `q` (position), `m` (mass), `t` (time). Parameters are fields of the law: `self.k`",
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
        ],
    );
}

/// Arguments of laws between two bodies, each with what is said of it.
#[test]
fn laws_between_two_bodies() {
    const PAIR: &str = "`r` (distance), `d` (separation q_a − q_b), `ma` (mass of a), `mb` (mass of b), `a` (data of a), `b` (data of b), `t` (time). Parameters are fields of the law: `self.k`";
    let pair = |arguments: &str, message: &str| {
        refused(&format!("impl Law {{ #[pair] fn energy(&self, {arguments}) -> f64 {{ 1.0 }} }}"), &[message]);
    };
    let force = |arguments: &str, message: &str| {
        refused(&format!("impl Law {{ #[pair_force] fn pull(&self, {arguments}) -> f64 {{ 1.0 }} }}"), &[message]);
    };
    pair("«s»: f64", &format!("`s` is not an argument a pair potential can have; expected one of: {PAIR}"));
    pair(
        "«q»: f64",
        "`q` belongs to a law of one body, and here there are two: write the distance `r: f64`, or the separation `d: [f64; D]`, which is q_a − q_b",
    );
    pair("r: f64, «m»: f64", "`m` belongs to a law of one body, and here there are two: write `ma` and `mb`");
    force("d: f64, «v»: f64", "`v` belongs to a law of one body, and here there are two: write `va` and `vb`");
    pair(
        "r: f64, «va»: f64",
        "a pair potential does not depend on the velocity `va`; what depends on it is a `#[pair_force]`",
    );
    pair(
        "«x: f64, y»: f64, ma: f64",
        "the separation q_a − q_b is one argument, `d: [f64; 2]`; take it to pieces in the body: `let [x, y] = d;`",
    );
    pair("r: f64, «mass»: f64", "`mass` is not an argument a pair potential can have; the mass of a is called `ma`");
    force(
        "d: f64, «separation»: f64",
        "`separation` is not an argument a pair force can have; the separation q_a − q_b is called `d`",
    );
    pair("r: «[f64; 2]»", "the distance `r` is a number; write `r: f64`");
    pair("r: f64, ma: «f32»", "the mass `ma` is a number; write `ma: f64`");
    pair("r: f64, «r»: f64", "`r` is named twice");
    pair(
        "«r»: f64, d: [f64; 2]",
        "the distance `r` is the length of the separation `d`; name one of the two and compute the other from it",
    );
    pair(
        "d: «Vec<f64>»",
        "`Vec<f64>` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, `Vector2<f64>`, `Vector3<f64>`",
    );
    pair(
        "«[x, y]»: [f64; 2]",
        "the separation q_a − q_b is one argument, `d`; take it to pieces in the body: `let [x, y] = d;`",
    );
    pair("r: f64, a: «Charge»", "the data of a body is only read; take it by reference: `a: &Charge`");
    pair("r: f64, b: «&mut Charge»", "the data of a body is only read; take it by reference: `b: &Charge`");
    pair(
        "r: f64, a: &Charge, b: «&Spin»",
        "all bodies of a scene carry data of one type, and this law has named `&Charge` before; collect what different bodies carry in one struct",
    );
    force(
        "«r»: f64",
        "a force between two bodies has a direction: take the separation `d: [f64; D]`, whose length is the distance, `let r = (d[0] * d[0] + d[1] * d[1]).sqrt();`",
    );
    force(
        "d: f64, va: «[f64; 2]»",
        "this has 2 components, and what is named before it has 1; position, velocity and force have equally many",
    );
    refused(
        "impl Law { #[pair] fn «energy»(&self, ma: f64) -> f64 { ma } }",
        &[
            "a potential of two bodies is a function of where they are; give it the distance `r: f64` or the separation `d: [f64; D]`, which is q_a − q_b",
        ],
    );
    refused(
        "impl Law { #[pair_force] fn «pull»(&self, ma: f64) -> f64 { ma } }",
        &[
            "a force between two bodies is a function of their separation and velocities; give it `d: [f64; D]`, `va: [f64; D]`, `vb: [f64; D]` or several of them",
        ],
    );
    refused(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q } #[pair] fn «spring»(&self, r: f64) -> f64 { r } }",
        &[
            "`spring` acts on one body and another method of this block on two; put them on two types, one law each, and give the scene both: `.field(one).pairs(other)`",
        ],
    );
    refused(
        "impl Law { #[pair] fn energy(&self, d: f64, a: &Charge) -> f64 { d } #[pair_force] fn drag(&self, d: f64, a: &«Spin») -> f64 { d } }",
        &[
            "all bodies of a scene carry data of one type, and this law has named `&Charge` before; collect what different bodies carry in one struct",
        ],
    );
    refused(
        "impl Law { #[pair] fn one(&self, r: f64) -> f64 { r } #[pair] fn «two»(&self, r: f64) -> f64 { r } }",
        &[
            "`two` is a second pair potential, and a law has one; `one` is marked already. Add the two in one method, with the other as a helper",
        ],
    );
}
