//! Position, velocity and force have as many components.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        q[0] * q[1] * q[2]
    }
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        [-self.c * v[0], -self.c * v[1]]
    }
}

fn main() {}
