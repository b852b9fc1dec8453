//! Laws that use all of the language, to be damaged.

pub(crate) const LAWS: [&str; 8] = [
    "impl<const N: usize> Chain<N> {
        const D: usize = 3; const K: [f64; 2] = [1.0, 2.0];
        #[potential] fn energy(&self, q: [f64; Self::D], m: f64, t: f64) -> f64 {
            let [x, .., z] = q; let mut sum = 0.0; let (s, c) = x.sin_cos();
            for i in 0..Self::D { sum += self.k[i] * q[i].powi(2) - (i as f64) / 3.0; }
            if x < 0.5 && !(z >= t) { sum *= s; } else { sum = sum - c; }
            let parts = (0..2).map(|i| Self::K[i] * q[i + 1] * m).sum::<f64>();
            sum + parts + self.well(x, &q) + x.powf(1.5).clamp(-1.0, 1.0)
        }
        fn well(&self, x: f64, q: &[f64; 3]) -> f64 { return (x - self.a.b).hypot(q[1]) + std::f64::consts::PI; }
    }",
    "impl Law { #[potential] fn energy(&self, q: Vector3<f64>) -> f64 {
            let d = q - self.c; let mut e = -d / 2.0; e.x += q.dot(&d); e[1] *= 3.0;
            let n = Vector3::new(1.0, e.y, self.k).cross(&d).norm(); let Self { g, .. } = *self;
            if n > 1.0 { n } else if n > g { d.norm_squared() } else { q.map(|x| x * x).sum() }
        } }",
    "impl Kepler { #[potential] fn energy(&self, q: f64) -> f64 { -self.gm / (q * q + 1e-3).sqrt() }
        fn drag(&self, v: f64) -> f64 { -v } #[cfg(test)] const MASS: f64 = 1.0; }",
    "impl Wind { #[potential] fn bowl(&self, q: [f64; 2]) -> f64 { 0.25 * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2) }
        #[force] fn drag(&self, q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> [f64; 2] {
            let w = self.g * (self.omega * t).cos(); let c = m * (0.1 + v[0] * v[0]).sqrt(); [-c * (v[0] - w), -c * v[1] * q[0]] } }",
    "impl Pol { #[force] fn force(&self, q: f64, v: f64) -> f64 { self.mu * (1.0 - q * q) * v - q.abs().min(2.0).tanh() } }",
    "impl Ions { const S: f64 = 1.5;
        #[pair] fn energy(&self, r: f64, ma: f64, mb: f64, a: &Charge, b: &Charge, t: f64) -> f64 {
            let (s, c) = (self.omega * t).sin_cos(); let x = (Self::S / r).powi(6);
            if r < self.cut { self.k * a.q * b.q * c / r + x * (x - s) } else { self.well(r, ma * mb) + a.shape[1] * b.shape[1] }
        }
        fn well(&self, r: f64, m: f64) -> f64 { (-m * r.min(2.0)).exp() - self.w[0] } }",
    "impl Links { #[pair] fn spring(&self, d: Vector2<f64>, a: &Link, b: &Link) -> f64 { let e = d.norm() - self.l; (a.k + b.k) * e * e }
        #[pair_force] fn drag(&self, d: [f64; 2], va: [f64; 2], vb: [f64; 2], ma: f64, mb: f64, a: &Link, b: &Link, t: f64) -> [f64; 2] {
            let r = d[0].hypot(d[1]); let c = self.c * (a.c * ma - b.c / mb) / (1.0 + r);
            let [ux, uy] = [va[0] - vb[0], va[1] - vb[1]]; [-c * ux * uy.abs(), -c * uy + (self.w * t).cos() * d[1]] } }",
    "#[derive(Clone)] #[dmech(crate = my::dmech)] #[potential(|q: [f64; 2], t: f64| 0.5 * self.k * q[0].cos() + self.w[1] * t)]
        struct Spring { k: f64, w: [f64; 2] }",
];

/// What damage is done with.
pub(crate) const WORDS: [&str; 70] = [
    "q",
    "v",
    "self",
    "Self",
    "x",
    "0",
    "1",
    "2.0",
    "1e308",
    "-",
    "+",
    "*",
    "/",
    "%",
    ".",
    "..",
    "=",
    "+=",
    "==",
    "<",
    "&",
    "&&",
    "!",
    "?",
    ";",
    ",",
    "if",
    "else",
    "for",
    "in",
    "let",
    "mut",
    "return",
    "fn",
    "sum",
    "powi",
    "norm",
    "as",
    "f64",
    "i32",
    "K",
    "_",
    "|",
    "[0]",
    "(q)",
    "{ q }",
    "{ }",
    "()",
    "[]",
    "#",
    "#[potential]",
    "#[force]",
    "#[pair]",
    "#[pair_force]",
    "r",
    "d",
    "t",
    "va",
    "mb",
    "a",
    "&Charge",
    "a.q",
    "impl",
    "while",
    "match",
    "'a",
    "\"text\"",
    "atan2",
    "exp",
    "ln",
];
