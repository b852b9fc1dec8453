//! A law acts on one body or between two.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[potential]
    fn well(&self, q: f64) -> f64 {
        self.k * q * q
    }
    #[pair]
    fn spring(&self, r: f64) -> f64 {
        self.k * r * r
    }
}

fn main() {}
