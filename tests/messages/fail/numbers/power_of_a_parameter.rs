//! An exponent that is a field of the law.

struct Well {
    n: f64,
    m: i32,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let n = self.n as i32;
        q[0].powi(self.n as i32)
            + f64::powi(q[1], self.m)
            + q[0].powi(2 * self.m)
            + f64::powi(q[0], (self.n) as i32)
            + q[1].powi(n)
            + q[1].powi(q[0] as i32)
    }
}

fn main() {}
