//! The same work in many places.

#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Does the work at each place, of which it has the number; on all cores, where there are more than one.
pub(super) fn each_on_its_core<T: Send>(places: &mut [T], work: impl Fn(usize, &mut T) + Sync + Send) {
    #[cfg(feature = "parallel")]
    let places = places.par_iter_mut();
    #[cfg(not(feature = "parallel"))]
    let places = places.iter_mut();
    places.enumerate().for_each(|(i, place)| work(i, place));
}
