//! Bodies whose motion several schemes are held to.

use dmech::models::pairs::{FermiPastaUlamTsingou, Spring};
use dmech::prelude::*;

pub(super) const SPRING: FermiPastaUlamTsingou = FermiPastaUlamTsingou { k: 1.2, alpha: 0.4, beta: 0.7 };
pub(super) const BOND: Spring = Spring { k: 0.9, length: 0.6 };

/// Nine masses on a line, the ends pinned, one of them struck.
pub(super) fn line() -> Scene<1> {
    let at = |i: u32| if i.is_multiple_of(8) { 0.0 } else { 0.03 * f64::from(i * i % 7) };
    let all = (0..9).fold(Scene::new(), |scene, i| {
        scene.body(0.9 + 0.1 * f64::from(i % 3), [at(i)], [if i == 4 { 0.8 } else { 0.0 }])
    });
    all.pin(0).pin(8)
}

/// Three stars.
pub(super) fn stars() -> Scene<2> {
    Scene::new().body(1.3, [0.9, 0.1], [0.1, 0.6]).body(0.7, [-0.8, 0.3], [0.2, -0.7]).body(
        2.1,
        [0.2, -1.1],
        [-0.7, 0.1],
    )
}
