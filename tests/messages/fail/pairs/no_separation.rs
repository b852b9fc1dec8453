//! A potential of where the bodies are must name it.

pub struct Law {
    pub k: f64,
}

#[dmech::law]
impl Law {
    #[pair]
    fn energy(&self, ma: f64, mb: f64) -> f64 {
        self.k * ma * mb
    }
}

fn main() {}
