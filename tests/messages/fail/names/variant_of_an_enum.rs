//! What kind of law it is, is a number, too.
use dmech::prelude::*;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Soft,
    Stiff,
}

struct Spring {
    k: f64,
    kind: Kind,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        if self.kind == Kind::Stiff { self.k * q * q } else { 0.5 * self.k * q * q }
    }
}

fn main() {
    let _: Option<State<1>> = None;
    Spring { k: 1.0, kind: Kind::Soft }.energy(0.5);
}
