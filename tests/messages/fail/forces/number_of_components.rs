//! A force has one component for each coordinate.

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 3]) -> [f64; 3] {
        let [x, y, _] = v;
        [-self.c * x, -self.c * y]
    }
}

fn main() {}
