//! One says what the other says.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, d: [f64; 2]) -> f64 {
        self.k * d[0] / r
    }
}

fn main() {}
