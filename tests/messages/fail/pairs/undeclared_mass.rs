//! What the body reads is declared.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, r: f64, ma: f64) -> f64 {
        self.k * ma * mb / r
    }
}

fn main() {}
