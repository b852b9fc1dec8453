//! What the macro costs: from the tokens of a law to the tokens of its implementation.
//!
//! `cargo bench -p dmech-codegen` prints milliseconds, the best of several.

use std::time::Instant;

use proc_macro2::TokenStream;

const KEPLER: &str = "
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        -self.gm / (x * x + y * y).sqrt()
    }
}";

/// Three bodies in space that attract each other: every coordinate meets every other.
const THREE_BODIES: &str = "
impl ThreeBodies {
    #[potential]
    fn energy(&self, q: [f64; 9]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let dx = q[3 * i] - q[3 * j];
                let dy = q[3 * i + 1] - q[3 * j + 1];
                let dz = q[3 * i + 2] - q[3 * j + 2];
                sum -= self.g / (dx * dx + dy * dy + dz * dz).sqrt();
            }
        }
        sum
    }
}";

/// Nine coordinates in one function that does not fall into parts.
const DENSE: &str = "
impl Dense {
    #[potential]
    fn energy(&self, q: [f64; 9]) -> f64 {
        let mut sum = 0.0;
        for i in 0..9 {
            for j in 0..i {
                sum += self.k * (q[i] - 0.5 * q[j]).powi(4) + (q[i] * q[j]).cos();
            }
        }
        sum
    }
}";

fn main() {
    println!("{:<16} {:>10} {:>12}", "law", "ms", "tokens");
    for (name, source) in [("Kepler", KEPLER), ("three bodies", THREE_BODIES), ("dense", DENSE)] {
        let tokens: TokenStream = source.parse().expect("Rust tokens");
        let mut best = f64::INFINITY;
        let mut count = 0;
        for _ in 0..5 {
            let clock = Instant::now();
            let expanded = dmech_codegen::law(TokenStream::new(), tokens.clone());
            best = best.min(clock.elapsed().as_secs_f64() * 1e3);
            count = expanded.to_string().len();
        }
        println!("{name:<16} {best:>10.2} {count:>12}");
    }
}
