use super::*;
#[test]
fn probe() {
    let bodies = [
        "2 * q[0]", "q[0] * -2", "let mut s = 0.0; s += 2; s * q[0]", "let s: f64 = 2; s * q[0]", "q[0].max(2)", "2.sqrt() * q[0]",
        "let n = 2; n * q[0]", "2u8 * q[0]", "if q[0] > 1 { q[0] } else { 0 }", "if q[0] > 1.0 { 1 } else { q[0] }", "0", "q", "q[0];", "",
        "let mut s = 0; for i in 0..2 { s += q[i]; } s",
        "z * q[0]", "G * q[0]", "PI * q[0]", "m * q[0]", "t * q[0]", "v[0]", "crate::G * q[0]", "Self::G * q[0]", "f64::NAN * q[0]",
        "q[0].floor()", "q[0].pow(2)", "q[0].erf()", "q[0].powi(q[1])", "q[0].powi(2.5)", "q[0].powf(2)", "q[0].sqrt(1.0)", "q[0].powi(100000)",
        "q[0] % 2.0", "q[0] as i32 as f64", "1.0f32 * q[0]", "q[0] as f32 as f64", "q[0] / 0.0",
        "q + q", "q[2]", "q[q[0]]", "q.norm()", "q.x", "q[0].x", "q[0][1]", "let [x, y, z] = q; x", "let (x, y) = q; x", "let Some(x) = q; x",
        "while q[0] > 0.0 { }  0.0", "loop { }", "for x in self.k { }  0.0", "for i in 0..q[0] { } 0.0", "for i in 0.. { } 0.0", "for i in 0..100000 { } 0.0",
        "match q[0] { _ => 1.0 }", "if let 1.0 = q[0] { 1.0 } else { 0.0 }", "if q[0] { 1.0 } else { 0.0 }", "if self.on { 1.0 } else { 0.0 }",
        "if q[0] > 0.0 { return 1.0; } q[0]", "assert!(q[0] > 0.0); q[0]", "println!(\"x\"); q[0]", "sum!(q)",
        "foo(q[0])", "self.foo(q[0])", "Self::foo(q[0])", "other::foo(q[0])", "energy(q)", "self.energy(q)",
        "let f = |x: f64| x * x; f(q[0])", "fn f(x: f64) -> f64 { x } f(q[0])", "let r = &mut q; r[0]", "q[0] = 1.0; x = 2.0; 5.0 = q[0]; q[1]",
        "(0..2).filter(|i| *i > 0).map(|i| q[i]).sum::<f64>()", "q.sum()", "(0..2).map(|i| q[i]).sorted().sum::<f64>()", "self.k.iter().sum::<f64>()",
        "std::array::from_fn(|i| q[i])[0]", "unsafe { q[0] }", "q[0]?", "Point { x: q[0] }.x", "\"a\"", "'a: { q[0] }", "q[0] & q[1]", "!q[0]",
        "if q[0] > 0.0 { [q[0]] } else { q }[0]", "let mut n = 1; if q[0] > 0.0 { n = 2; } q[0].powi(n)", "#[cfg(test)] let x = 1.0; q[0]",
        "let x; x + q[0]", "let mut k = self.k; k[0] = 1.0; k[0]", "(q[0] > 0.0) == (q[1] > 0.0)", "let [x, y] = q; x.dot(y)", "q[0].clamp(0.0)",
        "z + 2 * q[0] + q[5] + w.sin() + q[1].floor()", "let d = z; d * 2 * d", "1e999 * q[0]", "1.0 + \"a\"", "q.len() * q[0]", "break; q[0]",
        "let (a, b): (f64, f64) = (1, q[0]); a * b", "q[0].map(|x| x)", "q[-1]", "q[0..5][0]", "f64::sqrt()", "f64::sqrt(2) * q[0]", "std::mem::swap(q)",
    ];
    for b in bodies {
        println!("--- {b}");
        let text = body("[f64; 2]", b);
        match lower_text(&text) {
            Ok(l) => println!("    OK {}", l.graph.display(l.potential)),
            Err(e) => for (r, m) in said(Err(e)) { println!("    «{}» {}", &text[r], m); },
        }
    }
    for text in [
        "impl Law { #[potential] fn energy(&self, q: Vector2<f64>) -> f64 { let [x, y] = q; q.cross(&q) + q.z + q.foo() + q * q + q.dot(&1.0) + self.c.norm() + Vector2::new(1.0).x + SVector::zeros().x + Vector2::<f64>::identity().x} }",
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.f(q) } fn f(&self, x: f64) -> f64 { self.g(x) } fn g(&self, x: f64) -> f64 { self.f(x) + y } }",
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { self.f(q) + Self::g(q) + Self::f(q) + self.h(q) + self.k(q, q) } fn f(x: f64) -> f64 { x } fn g(&self, x: f64) -> f64 { 2 * x } #[cfg(test)] fn h(&self, x: f64) -> f64 { x } fn k(&mut self, x:f64) -> f64 { x } }",
        "impl<const N: usize> Law<N> { const A: usize = Self::B; const B: usize = Self::A; #[potential] fn energy(&self, q: f64) -> f64 { for i in 0..N { } q.powi(Self::A) } }",
    ] {
        println!("--- {text}");
        match lower_text(&text) {
            Ok(l) => println!("    OK {}", l.graph.display(l.potential)),
            Err(e) => for (r, m) in said(Err(e)) { println!("    «{}» {}", &text[r], m); },
        }
    }
}
#[test]
fn pipeline() {
    use dmech_symbolic::kernel::Kernels;
    let cases: Vec<(&str, String)> = [

        ("max 12", body("[f64; 12]", "let mut s = 0.0; for i in 0..12 { s = q[i].max(s); } s")),
        ("max 16", body("[f64; 16]", "let mut s = 0.0; for i in 0..16 { s = q[i].max(s); } s")),
        ("abs 16", body("[f64; 16]", "let mut s = 0.0; for i in 0..16 { s = (s + q[i]).abs(); } s")),
        ("sin 24", body("f64", "let mut x = q; for _ in 0..24 { x = x.sin(); } x")),
        ("sin 24 of 12", body("[f64; 12]", "let mut x = 0.0; for i in 0..12 { x = (x + q[i]).sin(); } x")),
        ("sqrt 24", body("f64", "let mut x = q; for _ in 0..24 { x = (1.0 + x).sqrt(); } x")),
        ("if chain 8", body("f64", "let mut s = q; for i in 0..8 { if s > i as f64 { s = s * 2.0; } } s")),
        ("if chain 8", body("[f64; 8]", "let mut s = q[0]; for i in 0..8 { if s > i as f64 { s = s * q[i]; } } s")),
        ("lattice 600", body("[f64; 2]", "(0..600).map(|i| ((q[0] - i as f64).powi(2) + (q[1] - 2.0 * i as f64).powi(2)).powi(-3)).sum::<f64>()")),
    ].into_iter().collect();
    for (name, text) in cases {
        let mut l = lower_text(&text).unwrap();
        let start = std::time::Instant::now();
        let _ = Kernels::new(&mut l.graph, l.potential, &l.variables);
        println!("{name}: kernels {:?} nodes {}", start.elapsed(), l.graph.len());
    }
}
