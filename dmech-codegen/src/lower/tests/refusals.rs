//! What the body of a potential cannot contain: the words, and the piece of the text («…») that they point at.

use super::{assert_refused, body, lower_derive, lower_text};

/// A law of two coordinates whose body is refused at the marks.
fn refused(text: &str, messages: &[&str]) {
    assert_refused(&body("[f64; 2]", text), messages, lower_text);
}

/// A whole block that is refused at the marks.
fn refused_block(text: &str, messages: &[&str]) {
    assert_refused(text, messages, lower_text);
}

/// A struct with the derive that is refused at the marks.
fn refused_derive(text: &str, messages: &[&str]) {
    assert_refused(text, messages, lower_derive);
}

#[test]
fn integers_where_numbers_belong() {
    let stars = ["`**` is not an operator of Rust; a power is `x.powi(2)` or `x.powf(1.5)`"];
    refused("q[0] *«* 2»", &stars);
    refused("q[0] *«*2.0» + 1.0", &stars);
    refused("«2» * q[0]", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused("q[0] * «-2»", &["`-2` is an integer and a number is expected here; write `-2.0`"]);
    refused("let mut s = 0.0; s += «2»; s * q[0]", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused("let s: f64 = «2»; s * q[0]", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused("q[0].max(«2»)", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused("«2».sqrt() * q[0]", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused("«2u8» * q[0]", &["`2u8` is an integer and a number is expected here; write it with a decimal point"]);
    refused(
        "if q[0] > «1» { q[0] } else { «0» }",
        &[
            "`1` is an integer and a number is expected here; write `1.0`",
            "`0` is an integer and a number is expected here; write `0.0`",
        ],
    );
    refused("if q[0] > 1.0 { «1» } else { q[0] }", &["`1` is an integer and a number is expected here; write `1.0`"]);
    refused("«0»", &["`0` is an integer and a number is expected here; write `0.0`"]);
    refused(
        "let n = 2; «n» * q[0]",
        &["`n` is an integer and a number is expected here; write `n as f64`, or give it a value with a decimal point"],
    );
    refused(
        "let mut s = 0; for i in 0..2 { «s» += q[i]; } s",
        &["`s` is an integer and a number is expected here; write `s as f64`, or give it a value with a decimal point"],
    );
    refused("«q.len()» * q[0]", &["`q.len()` is an integer and a number is expected here; write `q.len() as f64`"]);
    refused(
        "«(0..2).map(|i| i * 2)».sum::<f64>() * q[0]",
        &["these terms are integers and numbers are expected here; write them with `as f64`"],
    );
    refused(
        "let (a, b): (f64, [f64; 2]) = («1», [«2», q[0]]); a * b[0]",
        &[
            "`1` is an integer and a number is expected here; write `1.0`",
            "`2` is an integer and a number is expected here; write `2.0`",
        ],
    );
    refused("f64::sqrt(«2») * q[0]", &["`2` is an integer and a number is expected here; write `2.0`"]);
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q + Self::one() + Self::half(«1») } fn one() -> f64 { «1» } fn half(x: f64) -> f64 { x / «2» } }",
        &[
            "`1` is an integer and a number is expected here; write `1.0`",
            "`1` is an integer and a number is expected here; write `1.0`",
            "`2` is an integer and a number is expected here; write `2.0`",
        ],
    );
}

#[test]
fn numbers_that_are_none() {
    refused(
        "«1.0f32» * q[0]",
        &["write the number without a suffix; the generated code runs in `f32` and other scalars as well"],
    );
    refused("q[0] as «f32» as f64", &["write `f64`; the generated code runs in `f32` and other scalars as well"]);
    refused("let x: «f32» = q[0]; x", &["write `f64`; the generated code runs in `f32` and other scalars as well"]);
    refused(
        "«q[0] as i32» as f64",
        &["an integer has no derivative; keep the number as `f64`: `floor`, `round` and `trunc` are functions of it"],
    );
    refused("«q[0] > 0.0»", &["a number is expected here, this is a condition"]);
    refused("«1e999» * q[0]", &["this number is out of range"]);
    refused("«f64::NAN» * q[0]", &["a law is finite; `NAN` has no place in it"]);
    refused("1.0 + «\"a\"»", &["a law is made of numbers, and this is text; leave it away"]);
    refused("q[0] / «0.0»", &["this divides by zero"]);
    refused("q[0].powi(«7 / 0»)", &["this integer has no value: it is out of range, or divides by zero"]);
    refused("q[0] * «300 as u8» as f64", &["this integer has no value: it is out of range, or divides by zero"]);
}

#[test]
fn functions_without_a_derivative() {
    refused(
        "q[0].«round_ties_even»() + q[1].«div_euclid»(1.0) + q[1].rem_euclid(«0.0»)",
        &[
            "write `round`: the two differ at halves alone, where a law must be continuous",
            "write `(x / l).floor()` instead of `div_euclid`",
            "this divides by zero",
        ],
    );
    refused(
        "«q[0] % 2.0»",
        &[
            "the sign of a remainder is that of what is divided; write `x.rem_euclid(l)`, or `x - l * (x / l).round()` for the nearest image",
        ],
    );
    refused(
        "q[0].«pow»(2)",
        &["numbers have `powi` for integer exponents and `powf` for others: `x.powi(2)`, `x.powf(1.5)`"],
    );
    refused("q[0].«squared»()", &["`squared` is not a function of `f64`; write `powi(2)` or `x * x`"]);
    refused("q[0].«copysign»(q[1])", &["a law has no `copysign`: for `x.copysign(y)` write `x.abs() * y.signum()`"]);
    refused("q[0].«is_nan»()", &["`is_nan` looks at how a number is stored; a law compares numbers: `x < 0.0`"]);
    refused(
        "q[0].«erf»()",
        &[
            "`erf` is not among the functions that can be differentiated: sqrt cbrt powi powf exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan sin_cos asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot abs recip mul_add min max clamp signum round floor ceil trunc fract rem_euclid",
        ],
    );
    refused(
        "q[0].«map»(|x| x)",
        &[
            "`map` is not among the functions that can be differentiated: sqrt cbrt powi powf exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan sin_cos asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot abs recip mul_add min max clamp signum round floor ceil trunc fract rem_euclid",
        ],
    );
    refused(
        "q[0].powi(«q[1]»)",
        &[
            "the exponent of `powi` is an integer that is known when the macro runs, this is a number; for any other exponent write `powf`",
        ],
    );
    refused(
        "q[0].powi(«2.5»)",
        &[
            "the exponent of `powi` is an integer that is known when the macro runs, this is a number; for any other exponent write `powf`",
        ],
    );
    let by_field = |instead: &str| {
        format!(
            "the exponent of `powi` is an integer that is known when the macro runs, and `self.n` is a field of the law; write {instead}"
        )
    };
    let (alone, among) = (by_field("`powf(self.n)`"), by_field("`powf`, and `self.n as f64` for `self.n`"));
    refused("q[0].powi(«self.n as i32»)", &[&alone]);
    refused("f64::powi(q[0], «(self.n) as i32») + q[1].powi(«self.n»)", &[&alone, &among]);
    refused("q[0].powi(«2 * self.n») + q[0].powi(«-(self.n as i32) + 1»)", &[&among, &among]);
    refused(
        "q[0].powi(«nine»)",
        &[
            "`nine` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.nine`",
        ],
    );
    refused(
        "let n = «self.n as i32»; q[0].powi(n)",
        &[
            "an integer is known when the macro runs, and `self.n` is a field of the law; keep it a number: a power by it is `powf(self.n)`",
        ],
    );
    refused("q[0].powf(«2»)", &["`powf` takes a number; write `powi(2)`, or the exponent with a decimal point"]);
    refused("«q[0].powi(100000)»", &["this power is larger than 4096, beyond any use in a law"]);
    refused(
        "q[0].«sqrt»(1.0) + q[1].«clamp»(0.0)",
        &["`sqrt` takes 0 arguments here, not 1", "`clamp` takes 2 arguments here, not 1"],
    );
    refused_block(
        "impl Law { const LOW: f64 = 0.5; #[potential] fn energy(&self, q: [f64; 2]) -> f64 { \
         «q[0].clamp(1.0, -1.0)» + «f64::clamp(q[1], 2.5, Self::LOW)» + q[0].clamp(1.0, 1.0) + q[1].clamp(self.a, self.b) } }",
        &[
            "nothing lies between 1 and -1, and Rust's `clamp` panics there; the lower bound comes first: `x.clamp(-1.0, 1.0)`",
            "nothing lies between 2.5 and 0.5, and Rust's `clamp` panics there; the lower bound comes first: `x.clamp(0.5, 2.5)`",
        ],
    );
    refused("f64::«sqrt»()", &["`f64::sqrt` is given nothing to work on; write `x.sqrt()` or `f64::sqrt(x)`"]);
    refused("q[0] «&» q[1]", &["`&` works on bits, not on numbers; conditions are joined with `&&`, `||` and `!`"]);
}

#[test]
fn paths_that_are_no_numbers() {
    let function =
        "`sin` is a function, and variables of a law are numbers; call it where its value is wanted: `x.sin(…)`";
    refused("let f = «f64::sin»; f(q[0])", &[function]);
    refused("q[0] * «std::f64::sin»", &[function]);
    refused("q[0].powi(«i32::MAX»)", &["the value of `i32::MAX` cannot be seen here; write the number itself"]);
    refused("q[«usize::MAX»]", &["the value of `usize::MAX` cannot be seen here; write the number itself"]);
}

#[test]
fn names() {
    refused(
        "«z» * q[0]",
        &[
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
        ],
    );
    refused(
        "«G» * q[0]",
        &[
            "`G` is neither a coordinate nor a parameter; declared coordinates: `q`. A constant belongs in this block, `const G: f64 = …;`, and is called `Self::G`",
        ],
    );
    refused("«PI» * q[0]", &["what `PI` was imported as cannot be seen here; write `std::f64::consts::PI`"]);
    refused(
        "«m» * q[0]",
        &[
            "`m` is not declared; for the mass, add `m: f64` to the arguments of `energy`, for a parameter of the law write `self.m`",
        ],
    );
    refused(
        "«t» * q[0]",
        &[
            "`t` is not declared; for the time, add `t: f64` to the arguments of `energy`, for a parameter of the law write `self.t`",
        ],
    );
    refused("«v»[0]", &["a potential does not depend on the velocity `v`; what depends on it is a `#[force]`"]);
    refused(
        "«crate::G» * q[0]",
        &[
            "the value of `crate::G` cannot be seen here; take it into this block, `const G: f64 = crate::G;`, and write `Self::G`",
        ],
    );
    refused(
        "Self::«G» * q[0]",
        &["`G` is not a constant of this block; declare it beside the potential: `impl Law { const G: f64 = …; }`"],
    );
    refused(
        "let x; «x» + q[0]",
        &["`x` has no value yet, at least not in every branch before this; give it one where it is declared"],
    );
    refused(
        "let x; if q[0] > 0.0 { x = 1.0; } «x»",
        &["`x` has no value yet, at least not in every branch before this; give it one where it is declared"],
    );
    refused(
        "«z».k",
        &[
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
        ],
    );
    refused(
        "«x» = q[0]; q[0]",
        &[
            "`x` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.x`",
        ],
    );
    refused_block(
        "impl<const N: usize> Law<N> { #[potential] fn energy(&self, q: f64) -> f64 { for i in 0..«N» { } q } }",
        &[
            "the value of the const parameter `N` is not known when the macro runs; state the law for one value, with a constant of the block: `const N: usize = 3;` and `Self::N`",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.f(q) } fn f(&self, x: f64) -> f64 { «q» + «G» } }",
        &[
            "`q` is not known in this helper. Give it to the helper as an argument, or read a field of the law: `self.q`",
            "`G` is not known in this helper. A constant belongs in this block, `const G: f64 = …;`, and is called `Self::G`",
        ],
    );
    refused_derive(
        "#[potential(|q: f64| self.«kk» * q)] struct Law { k: f64, g: f64 }",
        &["`kk` is not a parameter of this law; declared: `k`, `g`"],
    );
    refused_derive(
        "#[potential(|q: f64| self.«k» * q)] struct Law;",
        &["`k` is not a parameter of this law; it has none"],
    );
}

#[test]
fn arrays_and_indices() {
    refused("«q»", &["a number is expected here, this is an array of 2; write a component, `q[0]`"]);
    refused(
        "«q + q»",
        &[
            "`+` is not defined between an array of 2 and an array of 2; arrays have no arithmetic, write it for each component or use nalgebra's vectors",
        ],
    );
    refused(
        "«2.0 * q»",
        &[
            "`*` is not defined between a number and an array of 2; arrays have no arithmetic, write it for each component or use nalgebra's vectors",
        ],
    );
    refused("q[«2»]", &["2 is out of range: there are 2 components, 0 to 1"]);
    refused("q[«-1»]", &["-1 is out of range"]);
    refused("q[«q[0]»]", &["an index is a literal, a constant of this block or a loop index; this is a number"]);
    refused("«q[0][1]»", &["`q[0]` is one number; write `q[0]` without an index, or declare it as an array"]);
    refused("q[«1..4»][0]", &["4 is out of range: there are 2 components, 0 to 1"]);
    refused("q[0].«x» + q.«x»", &["a number has no part `x`", "an array of 2 has no part `x`; write an index, `q[0]`"]);
    refused(
        "q.«norm»()",
        &["arrays have no `norm`; write it out, or take nalgebra's vector as the position: `q: SVector<f64, 2>`"],
    );
    refused("q.«sum»()", &["an array is no iterator; write `iter().sum(…)`"]);
    refused(
        "q.«sort»()",
        &["`sort` cannot be read; of an array a law can use an index, `iter`, `map`, `len` and `windows`"],
    );
    refused("q.«iter_mut»()", &["change elements by their index: `for i in 0..2 { a[i] += … }`"]);
    refused(
        "for x in «self.k» { }  0.0",
        &[
            "how long `self.k` is cannot be seen from the impl block; write `for i in 0..n` with `self.k[i]` and the number of its elements for `n`, or bind it with its type: `let k: [f64; n] = self.k;`",
        ],
    );
    for borrowed in ["for &x in &«self.k» { } 0.0", "for x in &(«self.k») { } 0.0", "(&«self.k»).iter().sum::<f64>()"]
    {
        refused(
            borrowed,
            &[
                "how long `self.k` is cannot be seen from the impl block; write `for i in 0..n` with `self.k[i]` and the number of its elements for `n`, or bind it with its type: `let k: [f64; n] = self.k;`",
            ],
        );
    }
    refused(
        "«self.k».iter().sum::<f64>()",
        &[
            "how long `self.k` is cannot be seen from the impl block; write `for i in 0..n` with `self.k[i]` and the number of its elements for `n`, or bind it with its type: `let k: [f64; n] = self.k;`",
        ],
    );
    refused(
        "for x in «q[0]» { } 0.0",
        &["a loop runs over a constant range, `0..3`, or over an array; this is a number"],
    );
    refused(
        "«std::array::from_fn»(|i| q[i])[0]",
        &["write the array out, `[a, b]`, or map one: `[0, 1, 2].map(|i| …)`"],
    );
    refused(
        "[q[0]; «2.0»][0]",
        &[
            "an integer that is known when the macro runs is expected here (a literal, a constant of this block, a loop index); this is a number",
        ],
    );
    refused(
        "let mut k = self.k; «k[0]» = 1.0; k[0]",
        &[
            "whether this is an array cannot be seen from the impl block; state its type where it is bound: `let mut k: [f64; 3] = self.k;`",
        ],
    );
}

#[test]
fn patterns() {
    refused("let «[x, y, z]» = q; x + y * z", &["this pattern has 3 parts and the value has 2"]);
    refused("let «(x, y)» = q; x + y", &["this pattern does not fit an array of 2"]);
    refused(
        "let «Some(x)» = q; x",
        &[
            "this pattern cannot be read; bind names, arrays and tuples of names: `let [x, y] = q;`, `let (s, c) = x.sin_cos();`",
        ],
    );
    refused(
        "let [x] = q «else» { return 0.0 }; x",
        &["`let … else` has no use in a formula; bind names, arrays and tuples of names"],
    );
    refused(
        "let «ref x» = q; x[0]",
        &[
            "this pattern cannot be read; bind names, arrays and tuples of names: `let [x, y] = q;`, `let (s, c) = x.sin_cos();`",
        ],
    );
    refused(
        "let «Point { x }» = self; x",
        &[
            "this pattern cannot be read; bind names, arrays and tuples of names: `let [x, y] = q;`, `let (s, c) = x.sin_cos();`",
        ],
    );
}

#[test]
fn iterators() {
    refused(
        "(0..2).«filter»(|i| *i > 0).map(|i| q[i]).sum::<f64>()",
        &[
            "`filter` would change the number of terms; write the condition into the term: `.map(|i| if … { … } else { 0.0 })`",
        ],
    );
    refused(
        "(0..2).map(|i| q[i]).«sorted»().sum::<f64>()",
        &[
            "`sorted` cannot be read; of an iterator a law can use `map`, `sum`, `product`, `fold`, `zip`, `enumerate`, `rev`, `chain`, `flat_map`, `skip`, `take`, `step_by`, or write a `for` loop",
        ],
    );
    refused("(0..2).map(«|i, j| q[i]»).sum::<f64>()", &["this closure takes 2 arguments and is given 1"]);
    refused(
        "(0..2).map(«q»).sum::<f64>()",
        &["a closure is expected here, `|x| …`, or a function by its path: `f64::sqrt`, `Self::helper`"],
    );
    refused("(0..2).map(|i| q[i]).«fold»(0.0)", &["`fold` takes 2 arguments here, not 1"]);
    refused("(«0..»).map(|i| q[i]).sum::<f64>()", &["both ends of a range must be stated: `0..3`"]);
    refused(
        "(0..«q[0]»).sum::<f64>()",
        &[
            "how far this range goes must be known when the macro runs; write a literal or a constant of this block instead of a number",
        ],
    );
    refused(
        "for i in «0..100000» { } 0.0",
        &["the loops of this law take more than 10000 turns; a law is unrolled into one formula, keep it small"],
    );
}

#[test]
fn ranges_as_conditions() {
    refused(
        "if «(..).contains(&q[0])» { 1.0 } else { 0.0 }",
        &["a range without ends contains everything; leave the condition away"],
    );
    refused(
        "if («0»..1.0).contains(&q[0]) { 1.0 } else { 0.0 }",
        &["`0` is an integer and a number is expected here; write `0.0`"],
    );
    refused(
        "if (0.0..=1.0).contains(&«true») { 1.0 } else { 0.0 }",
        &["a number is expected here, this is a condition"],
    );
}

#[test]
fn branches() {
    refused(
        "if «q[0]» { 1.0 } else { 0.0 }",
        &["a condition is expected here, this is a number; compare it with something: `x < 0.0`"],
    );
    refused(
        "if «self.on» { 1.0 } else { 0.0 }",
        &[
            "`self.on` is used as a condition, and the parameters of a law are numbers; keep it as an `f64` and compare it: `if self.on > 0.0`",
        ],
    );
    for comparison in ["«self.on == Kind::Stiff»", "«Kind::Stiff != self.on»"] {
        refused(
            &format!("if {comparison} {{ 1.0 }} else {{ 0.0 }}"),
            &[
                "`self.on` is compared with `Kind::Stiff`, and the parameters of a law are numbers; keep it as an `f64` and compare that: `if self.on > 0.0`",
            ],
        );
    }
    refused(
        "if self.on == «Other::LEVEL» { 1.0 } else { 0.0 }",
        &[
            "the value of `Other::LEVEL` cannot be seen here; take it into this block, `const LEVEL: f64 = Other::LEVEL;`, and write `Self::LEVEL`",
        ],
    );
    refused("if «q[0] = 1.0» { 1.0 } else { 0.0 }", &["`=` gives a value to a variable; compare with `==`"]);
    refused("!«q[0]»", &["a condition is expected here, this is a number; compare it with something: `x < 0.0`"]);
    refused(
        "if «let» 1.0 = q[0] { 1.0 } else { 0.0 }",
        &[
            "`if let` cannot be differentiated; choose by a comparison, `if x < 0.0 { … } else { … }`, and take arrays to pieces with `let [x, y] = q;`",
        ],
    );
    refused(
        "«match» q[0] { _ => 1.0 }",
        &["`match` cannot be differentiated; write `if … { … } else if … { … } else { … }`"],
    );
    refused(
        "let a = «if q[0] > 0.0 { [q[0]] } else { q }»; a[0]",
        &["the branches of this `if` must go together; one is an array of 1, the other an array of 2"],
    );
    refused(
        "let mut n = 1; «if» q[0] > 0.0 { n = 2; } q[0].powi(n)",
        &[
            "after this `if`, `n` would be something that depends on the coordinates and is no number; only numbers can be chosen by a comparison",
        ],
    );
    refused(
        "if «(q[0] > 0.0) == (q[1] > 0.0)» { 1.0 } else { 0.0 }",
        &["conditions on the coordinates cannot be compared with each other; join them with `&&`, `||` and `!`"],
    );
    refused(
        "«if» q[0] > 0.0 { q[1] }",
        &["an `if` that has a value needs an `else` with the value elsewhere: `else { 0.0 }`"],
    );
}

#[test]
fn statements() {
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { q«;» } }",
        &["this `;` throws the value of `energy` away; remove it, so that the value comes last"],
    );
    refused(
        "if q[0] > 0.0 { «return 1.0»; } q[0]",
        &["`return` can only be the last statement; for a choice write `if … { a } else { b }`"],
    );
    refused(
        "«while» q[0] > 0.0 { } 0.0",
        &[
            "how often this loop turns must be known when the macro runs; write `for i in 0..n` with a literal or a constant of this block",
        ],
    );
    refused(
        "«loop» { }",
        &[
            "how often this loop turns must be known when the macro runs; write `for i in 0..n` with a literal or a constant of this block",
        ],
    );
    refused(
        "for i in 0..2 { «break»; } 0.0",
        &["a loop always runs to its end, without `break`; put an `if` around what only some turns do"],
    );
    refused(
        "for i in 0..2 { «continue»; } 0.0",
        &["a loop always runs to its end, without `continue`; put an `if` around what only some turns do"],
    );
    refused("«'a:» for i in 0..2 { } 0.0", &["labels have no use here, since nothing can jump to them; leave it away"]);
    refused(
        "«assert!(q[0] > 0.0)»; q[0]",
        &["a law cannot fail; check parameters where the law is made, without `assert!`"],
    );
    refused("«println!(\"x\")»; q[0]", &["a law prints nothing; `println!` belongs in the program that runs it"]);
    refused("«sum!(q)»", &["what `sum!` expands to cannot be seen here; write the formula out"]);
    refused(
        "«#[cfg(test)]» let x = 1.0; q[0]",
        &["whether this holds is not known when the macro runs; write one `impl` block for each case"],
    );
    refused(
        "«#[cfg(test)]» { 1.0; } q[0]",
        &["whether this holds is not known when the macro runs; write one `impl` block for each case"],
    );
    refused("«struct P;» q[0]", &["the body of a law is a formula; move this item out of it"]);
    refused(
        "«5.0» = q[0]; q[1]",
        &["only a variable declared with `let mut`, or an element of one, can be assigned to"],
    );
    refused(
        "«self».k = 1.0; q[0]",
        &["only a variable declared with `let mut`, or an element of one, can be assigned to"],
    );
    refused("let (mut a, mut b) = (0.0, 0.0); «(a, b)» = q[0]; a + b", &["this cannot be assigned from a number"]);
    refused(
        "let r = &«mut» q; r[0]",
        &["a formula hands values on, not places; return the new value instead of taking `&mut`"],
    );
    refused(
        "«unsafe» { q[0] }",
        &[
            "an `unsafe` block cannot be differentiated; a law is made of numbers, `let`, arithmetic, `if` on comparisons, constant loops and the functions of `f64`",
        ],
    );
    refused(
        "«async» { q[0] }",
        &[
            "an `async` block cannot be differentiated; a law is made of numbers, `let`, arithmetic, `if` on comparisons, constant loops and the functions of `f64`",
        ],
    );
    refused(
        "q[0]«?»",
        &[
            "the operator `?` cannot be differentiated; a law is made of numbers, `let`, arithmetic, `if` on comparisons, constant loops and the functions of `f64`",
        ],
    );
    refused(
        "«Point» { x: q[0] }.x",
        &["structs cannot be built in a formula; use arrays, tuples or nalgebra's vectors"],
    );
    refused(
        "<«f64» as Trait>::K * q[0]",
        &[
            "a path through a trait cannot be differentiated; a law is made of numbers, `let`, arithmetic, `if` on comparisons, constant loops and the functions of `f64`",
        ],
    );
}

#[test]
fn helpers() {
    refused(
        "«foo»(q[0])",
        &[
            "what `foo` computes cannot be seen here; write it as a helper in this `impl` block and call it as `Self::foo(…)`",
        ],
    );
    for (call, methods) in [
        ("sqrt", "`x.sqrt()`"),
        ("libm::pow", "`x.powi(2)`, `x.powf(1.5)`"),
        ("log", "`x.ln()`"),
        ("max", "`x.max(y)`"),
        ("arctan2", "`x.atan2(y)`"),
        ("clamp", "`x.clamp(y, z)`"),
        ("Cos", "`x.cos()`"),
    ] {
        refused(
            &format!("«{call}»(q[0])"),
            &[&format!("what `{call}` computes cannot be seen here; functions of numbers are methods: {methods}")],
        );
    }
    refused(
        "«Some»(q[0])",
        &["what `Some` computes cannot be seen here; a law is made of numbers, and this makes something else"],
    );
    refused("«energy»(q)", &["`energy` is a helper of this block; call it as `self.energy(…)` or `Self::energy(…)`"]);
    refused(
        "self.«energy»(q)",
        &["`energy` calls itself; a formula has no recursion, write a `for` loop over a constant range"],
    );
    refused(
        "self.«foo»(q[0])",
        &[
            "`foo` is not a method of this block; a helper must stand beside the potential, in the same `impl Law`, to be differentiated with it",
        ],
    );
    refused(
        "Self::«foo»(q[0])",
        &[
            "`foo` is not a method of this block; a helper must stand beside the potential, in the same `impl Law`, to be differentiated with it",
        ],
    );
    for own in ["crate::other::foo", "super::foo", "foo::<f64>"] {
        let name = own.trim_end_matches("::<f64>");
        refused(
            &format!("«{own}»(q[0])"),
            &[&format!(
                "what `{name}` computes cannot be seen here; write it as a helper in this `impl` block and call it as `Self::foo(…)`"
            )],
        );
    }
    refused(
        "«libm::j0»(q[0])",
        &[
            "what `libm::j0` computes cannot be seen here; write its formula as a helper in this `impl` block, or, where it has none, the law by hand (see “A law by hand” in the guide)",
        ],
    );
    for (call, name) in
        [("rand::random::<f64>", "rand::random"), ("std::time::Instant::now", "std::time::Instant::now")]
    {
        refused(
            &format!("q[0] * «{call}»()"),
            &[&format!(
                "what `{name}` computes cannot be seen here; a law is the same each time that it is evaluated; call this before the run, and keep its number in a field of the law"
            )],
        );
    }
    refused(
        "«Complex::new»(q[0], q[1])",
        &["what `Complex::new` computes cannot be seen here; a law is made of numbers, and this makes something else"],
    );
    refused(
        "let f = «|x: f64| x * x»; f(q[0])",
        &["closures can only be handed to `map`, `flat_map` and `fold`; write a helper in this `impl` block"],
    );
    refused(
        "fn «f»(x: f64) -> f64 { x } f(q[0])",
        &["move `f` out of the body, into this `impl` block, and call it as `Self::f(…)`"],
    );
    refused(
        "«(|x| x)»(q[0])",
        &["only helpers of this block and functions of `f64` can be called; write `Self::helper(…)`"],
    );
    refused("q[0].«k».foo()", &["a number has no part `k`"]);
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { «f»(q) + «<Self>::f»(q) + self.«f»(q) + Self::«g»(q) + self.«g»(q, q) } fn f(x: f64) -> f64 { x } fn g(&self, x: f64) -> f64 { x } }",
        &[
            "`f` is a helper of this block; call it as `self.f(…)` or `Self::f(…)`",
            "`f` is a helper of this block; call it as `self.f(…)` or `Self::f(…)`",
            "`f` takes no `&self`; call it as `Self::f(…)`",
            "`g` takes `&self`; call it as `self.g(…)`",
            "`g` takes 1 argument here, not 2",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.«h»(q) + Self::«K» + self.«k»(q) + Self::«u»(q) } #[cfg(test)] fn h(&self, x: f64) -> f64 { x } #[cfg(test)] const K: f64 = 1.0; fn k(&mut self, x: f64) -> f64 { x } async fn u(x: f64) -> f64 { x } }",
        &[
            "which `h` is meant is not known when the macro runs: it is declared twice or under `#[cfg]`; declare it once",
            "which `K` is meant is not known when the macro runs: it is declared twice or under `#[cfg]`; declare it once",
            "`k` takes `&mut self`; a law changes nothing, let the helper take `&self`",
            "`u` is `async` or `unsafe`; a helper is a plain `fn`",
        ],
    );
    refused(
        "self.a.«potential»(&q) + self.well.«depth»(q[0]) + self.k.«Cos»() + q[0].«Cos»() + self.b.«unwrap_or»(1.0)",
        &[
            "`potential` is a method of `self.a`, which the macro cannot see; write its formula as a helper `fn` of this block, or give a scene both laws: `.field(one).field(other)`",
            "`depth` is a method of `self.well`, which the macro cannot see; read the fields themselves (`self.well.k`), or write its formula as a helper `fn` of this block",
            "`Cos` is not a function of numbers; did you mean `cos`?",
            "`Cos` is not a function of numbers; did you mean `cos`?",
            "`unwrap_or` is a method of `self.b`, which the macro cannot see; a field that a law reads is an `f64`, an array of them, or has such fields; put the number there beforehand",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.f(q) } fn f(&self, x: f64) -> f64 { self.g(x) } fn g(&self, x: f64) -> f64 { self.«f»(x) } }",
        &["`f` calls itself; a formula has no recursion, write a `for` loop over a constant range"],
    );
}

#[test]
fn vectors() {
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: Vector2<f64>) -> f64 { let «[x, y]» = q; x + y + q.«cross»(&q) + q.«z» + q.«foo»() + q.dot(«&1.0») + q.«norm»(1.0) } }",
        &[
            "this pattern does not fit a vector with 2 components; take its components: `let (x, y) = (q.x, q.y);`",
            "the cross product needs three components, not 2",
            "a vector with 2 components has no component `z`",
            "`foo` cannot be read; of a vector a law can use `+ - * /`, `norm`, `norm_squared`, `dot`, `cross`, `normalize`, `metric_distance`, `component_mul`, `component_div`, `sum`, `map`, `iter`, an index and `x`, `y`, `z`",
            "a vector is expected here, this is a number",
            "`norm` takes 0 arguments here, not 1",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: Vector2<f64>) -> f64 { («q * q»).x + («1.0 + q»).x + «self.c».norm() + («q + Vector3::zeros()»).x + q.dot(«&Vector3::zeros()») } }",
        &[
            "`*` is not defined between a vector with 2 components and a vector with 2 components; write `dot`, `cross` or `component_mul`",
            "`+` is not defined between a number and a vector with 2 components; write a component, `q.x`, or the length, `q.norm()`",
            "how many components `self.c` has cannot be seen from the impl block; bind it with its type: `let c: Vector2<f64> = self.c;`",
            "`+` is not defined between a vector with 2 components and a vector with 3 components",
            "this vector has 3 components, the other 2",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: Vector2<f64>) -> f64 { Vector2::«new»(1.0).x + «SVector::zeros()».x + Vector2::<f64>::«identity»().x + Vector2::from(«1.0»).x + q[«2»] } }",
        &[
            "`new` takes 2 arguments here, not 1",
            "how many components this vector has must be stated: `Vector3::zeros()`, `SVector::<f64, 3>::zeros()`",
            "`Vector2::identity` cannot be read; make vectors with `new`, `zeros`, `repeat` or `from([…])`",
            "an array of as many numbers as the vector has components is expected here, this is a number",
            "2 is out of range: there are 2 components, 0 to 1",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: Vector2<f64>) -> f64 { «q» } }",
        &[
            "a number is expected here, this is a vector with 2 components; write a component, `q.x`, or the length, `q.norm()`",
        ],
    );
}

#[test]
fn invariants_that_are_none() {
    for (invariant, message) in [
        (
            "fn kept(&self, q: [f64; 2], «m»: f64) -> f64 { q[0] }",
            "`m` is not known to a conserved quantity, which is a function of `q`, `v` and `t`; make the mass a field of the law, `self.m`, or state the quantity per unit of mass",
        ),
        (
            "fn «kept»(&self) -> f64 { self.k }",
            "a conserved quantity is a function of position and velocity; give it an argument `q: [f64; D]`, `v: [f64; D]` or both",
        ),
        (
            "fn kept(&self, q: [f64; 2]) -> «[f64; 2]» { q }",
            "a conserved quantity is one number: the method returns `f64`",
        ),
        (
            "fn «kept»(&self, q: [f64; 3]) -> f64 { q[2] }",
            "`kept` has 3 coordinates, and the potential of this law has 2",
        ),
        (
            "fn kept(&self, q: [f64; 2]) -> f64 { q[0].«squared»() }",
            "`squared` is not a function of `f64`; write `powi(2)` or `x * x`",
        ),
        (
            "fn kept(&self, q: [f64; 2]) -> f64 { self.«kept»(q) }",
            "`kept` calls itself; a formula has no recursion, write a `for` loop over a constant range",
        ),
    ] {
        let potential = "#[potential] fn energy(&self, q: [f64; 2]) -> f64 { q[0] * q[1] }";
        refused_block(&format!("impl Law {{ {potential} #[invariant] {invariant} }}"), &[message]);
    }
    let one = |name: String| format!("#[invariant] fn {name}(&self, q: f64) -> f64 {{ q }}");
    let eight: String = (0..8).map(|k| one(format!("k{k}"))).collect();
    refused_block(
        &format!(
            "impl Law {{ #[potential] fn energy(&self, q: f64) -> f64 {{ q }} {eight} {} }}",
            one("«k8»".to_owned())
        ),
        &["a run watches 8 invariants of a law, and `k8` is one more; leave one away"],
    );
    refused_block(
        "impl «Law» { #[invariant] fn kept(&self, q: f64) -> f64 { q } }",
        &[
            "no method of this block says what acts; mark the one that returns the energy of `Law` with `#[potential]` (of one body) or `#[pair]` (of two), or the one that returns its force with `#[force]` or `#[pair_force]`",
        ],
    );
    refused_block(
        "impl Law { #[pair] fn energy(&self, d: [f64; 2]) -> f64 { d[0] * d[0] } #[invariant] fn «kept»(&self, q: [f64; 2]) -> f64 { q[0] } }",
        &[
            "`kept` is an invariant of one body in a law between two; what many bodies keep is computed from the states of the run",
        ],
    );
}

#[test]
fn everything_in_one_run() {
    refused(
        "«z» + «2» * q[0] + q[«5»] + «w».sin() + q[1].«fma»()",
        &[
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
            "`2` is an integer and a number is expected here; write `2.0`",
            "5 is out of range: there are 2 components, 0 to 1",
            "`w` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.w`",
            "`fma` is not among the functions that can be differentiated: sqrt cbrt powi powf exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan sin_cos asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot abs recip mul_add min max clamp signum round floor ceil trunc fract rem_euclid",
        ],
    );
    refused(
        "let d = «z»; let e = d * 2.0; for i in 0..3 { d += e[i].foo(bar); } d.norm()",
        &[
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
        ],
    );
    refused_block(
        "impl Law { #[potential] fn energy(«&mut self», q: «[f32; 2]», «k»: f64) -> f64 { k * «z» + q[7] + q[0].erf() } }",
        &[
            "a potential changes nothing; write `&self`",
            "write the law in `f64`; the generated code runs it in `f32` and other scalars as well",
            "`k` is not an argument a potential can have; expected one of: `q` (position), `m` (mass), `t` (time). Parameters are fields of the law: `self.k`",
            "`z` is neither a coordinate nor a parameter; declared coordinates: `q`. A parameter is a field of the law: `self.z`",
        ],
    );
}
