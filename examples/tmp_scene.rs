use dmech::models::pairs::{FermiPastaUlamTsingou, Gravity};
use dmech::prelude::*;
use std::hint::black_box;
fn chain(n: usize) -> Scene<1> {
    let mut s = Scene::new();
    for i in 0..n {
        s = s.body(1.0 + 0.1 * (i % 3) as f64, [0.0 + 0.01 * i as f64], [if i == n / 2 { 1.1 } else { 0.0 }]);
    }
    s.pin(0).pin(n - 1)
}
fn cloud(n: usize) -> Scene<3> {
    let mut s = Scene::new();
    let mut x = 12345u64;
    let mut r = || {
        x = x.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (x >> 11) as f64 / (1u64 << 53) as f64
    };
    for _ in 0..n {
        s = s.body(1.0 / n as f64, [r() * 4.0, r() * 4.0, r() * 4.0], [r() - 0.5, r() - 0.5, r() - 0.5]);
    }
    s
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let steps: u64 = a[2].parse().unwrap();
    macro_rules! go {
        ($scene:expr, $scheme:expr, $dt:expr) => {{
            let mut st = Simulation::scene($scene).scheme($scheme).dt($dt).stepper().unwrap();
            st.advance(black_box(steps)).unwrap();
            println!("{:?}", st.q().get(1));
        }};
    }
    let law = FermiPastaUlamTsingou { k: 1.0, alpha: 0.0, beta: 0.3 };
    let g = Gravity { g: 1.0 };
    match a[1].as_str() {
        "chain-leapfrog" => go!(chain(64).chain(law), Leapfrog, 0.01),
        "chain-explicit" => go!(chain(64).chain(law), Explicit, 0.001),
        "chain-nystrom6" => go!(chain(64).chain(law), Nystrom::order6(), 0.05),
        "chain-dg" => go!(chain(64).chain(law), DiscreteGradient, 0.05),
        "chain-implicit" => go!(chain(64).chain(law), Implicit, 0.05),
        "chain-kanatani" => go!(chain(64).chain(law), Kanatani, 0.05),
        "chain-dg4" => go!(chain(64).chain(law), Composed::order4(DiscreteGradient), 0.1),
        "cloud-leapfrog" => go!(cloud(60).pairs(g), Leapfrog, 1e-4),
        "eight-leapfrog" => go!(cloud(3).pairs(g), Leapfrog, 1e-4),
        "eight-nystrom6" => go!(cloud(3).pairs(g), Nystrom::order6(), 1e-4),
        "eight-dg" => go!(cloud(3).pairs(g), DiscreteGradient, 1e-4),
        _ => panic!(),
    }
}
