//! No input makes the compiler hang or overflow its stack: every bound ends in an error that points at code.

use super::{body, lower_text, said};

fn refused_with(text: &str, words: &str) {
    let errors = said(lower_text(text));
    assert!(errors.iter().any(|(_, message)| message.contains(words)), "{errors:?}");
    assert!(errors.iter().all(|(range, _)| range.end > range.start), "{errors:?}");
}

fn repeated(before: &str, times: usize, after: &str) -> String {
    format!("{}q{}", before.repeat(times), after.repeat(times))
}

#[test]
fn deep_nesting() {
    for (before, after) in [
        ("(", ")"),
        ("-", ""),
        ("- -", ""),
        ("&", ""),
        ("!", ""),
        ("[", "][0]"),
        ("{ ", " }"),
        ("(1.0 + ", ")"),
        ("f64::sin(", ")"),
        ("if q > 0.0 { ", " } else { 0.0 }"),
        ("if q > 0.0 { 0.0 } else ", ""),
        ("return ", ""),
        ("|x| ", ""),
        ("x = ", ""),
        ("x += ", ""),
        ("&mut ", ""),
        ("..", ""),
        ("*", ""),
        ("a < ", ""),
        ("let x = ", ""),
        ("match x { _ => ", " }"),
        ("x.map(|x| ", ")"),
    ] {
        for times in [200, 20_000] {
            let errors = said(lower_text(&body("f64", &repeated(before, times, after))));
            assert!(!errors.is_empty());
        }
    }
    // As deep as anyone writes.
    for times in [1, 10, 20] {
        let text = body("f64", &repeated("f64::sin(-(1.0 + ", times, "))"));
        assert!(lower_text(&text).is_ok(), "{times}: {:?}", said(lower_text(&text)));
    }
}

#[test]
fn deep_types_and_patterns() {
    for (before, after) in [("&", ""), ("(", ",)"), ("[", "; 1]"), ("Vec<", ">"), ("fn() -> ", ""), ("*const ", "")] {
        for times in [200, 20_000] {
            let ty = format!("{}f64{}", before.repeat(times), after.repeat(times));
            assert!(!said(lower_text(&body(&ty, "0.0"))).is_empty());
        }
    }
    for (before, after) in [("&", ""), ("(", ",)"), ("[", "]"), ("Some(", ")"), ("x @ ", "")] {
        for times in [200, 20_000] {
            let pattern = format!("{}y{}", before.repeat(times), after.repeat(times));
            assert!(!said(lower_text(&body("f64", &format!("let {pattern} = q; q")))).is_empty());
        }
    }
}

#[test]
fn long_chains() {
    assert!(lower_text(&body("f64", &format!("q{}", " + q * q".repeat(1000)))).is_ok());
    refused_with(&body("f64", &format!("q{}", " + q".repeat(100_000))), "too long");
    refused_with(&body("f64", &format!("q{}", ".sin()".repeat(100_000))), "too long");
    refused_with(&body("f64", &format!("q{}", ".sin()".repeat(500))), "nested too deeply");
    refused_with(&body("f64", &format!("q{}", " as f64".repeat(500))), "nested too deeply");
    refused_with(&body("f64", &format!("q{}", "[0]".repeat(100_000))), "too long");
    // Statements are not nested in each other.
    assert!(lower_text(&body("f64", &format!("{} q", "let x = q * q;".repeat(3000)))).is_ok());
}

#[test]
fn long_loops() {
    refused_with(&body("f64", "let mut s = q; for i in 0..10_001 { s += q; } s"), "10000 turns");
    refused_with(&body("f64", "for i in 0..1000 { for j in 0..1000 { } } q"), "10000 turns");
    refused_with(&body("f64", "(0..100).flat_map(|i| (0..1000).map(move |j| q)).sum::<f64>()"), "10000 turns");
    refused_with(&body("f64", "for i in 0..170141183460469231731687303715884105727 { } q"), "10000 turns");
    refused_with(&body("f64", "let a = [q; 1_000_000_000]; a[0]"), "10000 turns");
    refused_with(
        &body("[f64; 2]", "let mut s = 0.0; for i in 0..9000 { s += (q[0] * i as f64).sin() * q[1]; } s"),
        "too many terms",
    );
    assert!(lower_text(&body("f64", "let mut s = 0.0; for i in 0..1000 { s += (q * i as f64).sin(); } s")).is_ok());
    refused_with(&body("f64", "(0..9000).map(|i| (q * i as f64).sin()).sum::<f64>()"), "4000 expressions");
}

#[test]
fn towers_of_functions() {
    refused_with(&body("f64", "let mut x = q; for _ in 0..1000 { x = x.sin(); } x"), "too many times");
    refused_with(&body("f64", "let mut x = q; for _ in 0..100 { x = x.powi(4096).powi(4096); } x"), "larger than 4096");
    refused_with(&body("f64", "let mut x = q; for _ in 0..1000 { x *= x; } x"), "larger than 4096");
    refused_with(&body("f64", "let mut x = q; for _ in 0..1000 { x = x * q + 1.0; } x"), "too many times");
    assert!(lower_text(&body("f64", "let mut x = q; for _ in 0..20 { x = x.sin(); } x")).is_ok());
    assert!(lower_text(&body("f64", "let mut x = q; for _ in 0..150 { x = x * q + 1.0; } x")).is_ok());
}

/// Choices that depend on each other are bounded; those that each add a term are not nested at all.
#[test]
fn choices_upon_choices() {
    refused_with(
        &body("f64", "let mut s = q; for i in 0..20 { if s > i as f64 { s = s * 2.0; } } s"),
        "depend on each other",
    );
    refused_with(&body("[f64; 20]", "q.iter().fold(0.0, |s, x| (s + x).abs())"), "depend on each other");
    assert!(lower_text(&body("[f64; 12]", "q.iter().fold(0.0, |s, &x| x.max(s))")).is_ok());
    let contacts = "let mut s = q[0]; for i in 0..64 { if q[i] > 0.1 { s += q[i] * q[i]; } else { s -= q[i]; } } s";
    let lowered = lower_text(&body("[f64; 64]", contacts)).unwrap();
    let q: Vec<_> = (0..64).map(|i| f64::from(i) / 32.0 - 1.0).collect();
    let sum = q.iter().fold(q[0], |s, &x| if x > 0.1 { s + x * x } else { s - x });
    assert!((super::value(&lowered, &q, 1.0, 0.0, &|_| None) - sum).abs() < 1e-13);
}

/// Each helper calls the next one ten times: 10^12 calls.
#[test]
fn helpers_upon_helpers() {
    let mut text = String::from("impl Law { #[potential] fn energy(&self, q: f64) -> f64 { Self::f0(q) }");
    for i in 0..12 {
        text += &format!(" fn f{i}(x: f64) -> f64 {{ {} }}", format!("Self::f{}(x) + ", i + 1).repeat(9) + "x");
    }
    text += " fn f12(x: f64) -> f64 { x } }";
    refused_with(&text, "too often");
}

/// Conditions are trees; a variable that joins itself with itself doubles them.
#[test]
fn conditions_upon_conditions() {
    refused_with(
        &body(
            "f64",
            "let mut c = q > 0.0; for i in 0..100 { c = c && q > 1.0 || c && q < 2.0; } if c { q } else { 0.0 }",
        ),
        "joins too many",
    );
    refused_with(
        &body("f64", "let mut c = q > 0.0; for i in 0..100 { if c { c = q > 2.0 && c; } } if c { q } else { 0.0 }"),
        "no number",
    );
}

#[test]
fn recursion() {
    let text = "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.f(q) }
        fn f(&self, x: f64) -> f64 { Self::g(x) } fn g(x: f64) -> f64 { Law::f(self, x) } }";
    refused_with(text, "calls itself");
    refused_with(
        "impl Law { const A: f64 = 2.0 * Self::A; #[potential] fn energy(&self, q: f64) -> f64 { q.powi(Self::B) }
        const B: i32 = Self::B; }",
        "calls itself",
    );
}
