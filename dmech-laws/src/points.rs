//! The points that a law is tried at, generic and special.

use super::grow::Law;
use super::random::Random;

/// How a pair of points was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)]
pub enum Place {
    Generic,
    /// A small step.
    Near,
    /// From the origin, or to it.
    Origin,
    /// b = −a.
    Opposite,
    /// One coordinate does not move.
    OneEqual,
    /// b = a.
    Same,
    /// b = a on a seam.
    SameOnSeam,
    /// One end on a seam, or a rounding beside it.
    OnSeam,
    /// Both ends there.
    BothOnSeam,
    /// Numbers such as 0, 1, 0.7.
    Round,
    /// Hundreds away.
    Far,
}

impl Place {
    /// All of them.
    pub const ALL: [Self; 11] = {
        use Place::*;
        [Generic, Near, Origin, Opposite, OneEqual, Same, SameOnSeam, OnSeam, BothOnSeam, Round, Far]
    };
}

fn generic(random: &mut Random, dimension: usize) -> Vec<f64> {
    (0..dimension).map(|_| random.within(-1.7, 1.7)).collect()
}

/// Numbers that laws have their seams and edges at.
fn round(random: &mut Random, dimension: usize) -> Vec<f64> {
    let numbers = [0.0, 0.0, 1.0, -1.0, 0.7, -0.5, 0.25, 0.5, 2.0, -0.0, 1e-9, 0.3];
    (0..dimension).map(|_| random.pick(&numbers)).collect()
}

/// A point on a seam between two random points, to the last bit: of the two neighbours that lie on its two sides, one.
fn on_seam(law: &Law, random: &mut Random) -> Option<Vec<f64>> {
    for _ in 0..4 {
        let (a, b) = (generic(random, law.dimension), generic(random, law.dimension));
        if let Some((before, after)) = seam_between(law, &a, &b) {
            return Some(if random.once_in(2) { before } else { after });
        }
    }
    None
}

/// The two points nearest to one another on the segment from a to b that lie in different branches of some choice.
pub(crate) fn seam_between(law: &Law, a: &[f64], b: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
    let along = |s: f64| a.iter().zip(b).map(|(a, b)| a + s * (b - a)).collect::<Vec<_>>();
    let start = law.tree.sides_taken(a);
    if law.tree.sides_taken(b) == start {
        return None;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..56 {
        let middle = 0.5 * (low + high);
        if law.tree.sides_taken(&along(middle)) == start { low = middle } else { high = middle }
    }
    Some((along(low), along(high)))
}

/// Pairs of points for a law: one of each kind that it has.
pub fn pairs(law: &Law, random: &mut Random) -> Vec<(Place, Vec<f64>, Vec<f64>)> {
    let d = law.dimension;
    let mut found = vec![];
    let a = generic(random, d);
    found.push((Place::Generic, a.clone(), generic(random, d)));
    let gap = random.pick(&[0.1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15]);
    let step = |random: &mut Random, from: &[f64], gap: f64| -> Vec<f64> {
        from.iter().map(|x| x + gap * random.within(-1.0, 1.0)).collect()
    };
    found.push((Place::Near, a.clone(), step(random, &a, gap)));
    found.push((Place::Opposite, a.clone(), a.iter().map(|x| -x).collect()));
    found.push((Place::Same, a.clone(), a.clone()));
    let origin = vec![0.0; d];
    let b = generic(random, d);
    found.push(if random.once_in(2) { (Place::Origin, origin, b) } else { (Place::Origin, b, origin) });
    if d > 1 {
        let mut b = generic(random, d);
        let i = random.below(d);
        b[i] = a[i];
        found.push((Place::OneEqual, a.clone(), b));
    }
    let (r, s) = (round(random, d), round(random, d));
    found.push((Place::Round, r.clone(), s));
    found.push((Place::Same, r.clone(), r));
    let reach = random.pick(&[30.0, 300.0, 2000.0]);
    let far: Vec<f64> = (0..d).map(|_| random.within(-reach, reach)).collect();
    let other = if random.once_in(2) { a.clone() } else { far.iter().map(|x| x * random.within(0.5, 1.2)).collect() };
    found.push((Place::Far, far, other));
    if let Some(seam) = on_seam(law, random) {
        let gap = random.pick(&[1.0, 1e-3, 1e-7, 1e-12]);
        let b = step(random, &seam, gap);
        found.push(if random.once_in(2) { (Place::OnSeam, seam.clone(), b) } else { (Place::OnSeam, b, seam.clone()) });
        found.push((Place::SameOnSeam, seam.clone(), seam.clone()));
        if let Some(other) = on_seam(law, random) {
            found.push((Place::BothOnSeam, seam, other));
        }
    }
    found
}
