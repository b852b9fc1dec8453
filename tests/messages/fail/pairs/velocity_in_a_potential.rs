//! A potential energy has no velocity in it.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, va: [f64; 2]) -> f64 {
        self.k * va[0] / r
    }
}

fn main() {}
