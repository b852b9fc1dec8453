//! The facade under another name, for the attribute and for the short form.
extern crate dmech as mechanics;

mod dmech {}

mod facade {
    pub use mechanics::*;
}

use facade::prelude::*;

struct Spring {
    k: f64,
}

#[mechanics::law(crate = mechanics)]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.k * q * q
    }
}

#[derive(facade::Law)]
#[dmech(crate = crate::facade)]
#[potential(|q: f64| 0.25 * self.k * q * q * q * q)]
struct Quartic {
    k: f64,
}

fn main() {
    assert_eq!(Spring { k: 4.0 }.gradient([0.5]), [2.0]);
    assert_eq!(Quartic { k: 4.0 }.gradient([0.5]), [0.5]);
}
