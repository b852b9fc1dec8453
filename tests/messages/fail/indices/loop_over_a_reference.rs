//! How long a field is, is not known; that it is borrowed changes nothing.

struct Weights {
    w: [f64; 3],
}

#[dmech::law]
impl Weights {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let mut sum = 0.0;
        for &w in &self.w {
            sum += w * q * q;
        }
        for w in self.w.iter() {
            sum += w * q * q;
        }
        for w in &(self.w) {
            sum += w * q * q;
        }
        sum
    }
}

fn main() {}
