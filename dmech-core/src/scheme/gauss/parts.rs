//! Steps whose sweeps come no nearer.

use dmech_scalar::{Mask, Real};

use super::cancelling;
use super::sweeps::{Stalled, Sweeps, With, apart, finite};
use crate::system::Staged;

/// How often a step is halved where its sweeps do not come nearer.
const HALVINGS: u32 = 6;

/// A step that was made otherwise.
pub(super) struct Parted<R> {
    /// The work done.
    pub(super) work: R,
    /// It was too long, or no smooth motion.
    pub(super) rough: bool,
}

/// A step whose sweeps have stalled: in two halves, each of which may be halved again; where that is no help, as one whose forces cancel,
/// or in halves that are made so. The pushes become those of a force that stays as it is.
#[cold]
pub(super) fn otherwise<Y: Staged>(
    with @ (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
    halvings: u32,
) -> Result<Parted<Y::Scalar>, Stalled> {
    let begun = (q.clone(), v.clone(), pushes.clone());
    let made = in_halves(with, stride, t, [&mut *q, &mut *v], pushes, sweeps, (halvings, false));
    let Err(lost) = made else {
        return made.map(|work| Parted { work, rough: true });
    };
    (*q, *v, *pushes) = begun;
    let before = Y::value(v).clone();
    if cancelling::settle(with, stride, t, [&mut *q, &mut *v], pushes, sweeps) {
        let work = system.work_of_pushes(tableau, Y::dt(stride), &before, pushes);
        guess_from(system, stride, t + Y::dt(stride), [q, v], pushes);
        return Ok(Parted { work, rough: false });
    }
    if halvings == HALVINGS {
        return Err(lost);
    }
    let work = in_halves(with, stride, t, [q, v], pushes, sweeps, (halvings, true))?;
    Ok(Parted { work, rough: true })
}

/// A step in two halves, of which each may be halved again, or made [otherwise]. Returns the work done.
fn in_halves<Y: Staged>(
    with @ (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    sweeps: &mut Sweeps<Y>,
    (halvings, each_otherwise): (u32, bool),
) -> Result<Y::Scalar, Stalled> {
    let half = system.stage(stride, Y::Scalar::from_f64(0.5), 0.0);
    let mut work = Y::Scalar::ZERO;
    for t in [t, t + Y::dt(&half)] {
        guess_from(system, &half, t, [&*q, &*v], pushes);
        let before = Y::value(v).clone();
        if let Err(stalled) = apart(with, &half, (t, Y::Scalar::ZERO), [&mut *q, &mut *v], pushes, sweeps) {
            if each_otherwise {
                work += otherwise(with, &half, t, [&mut *q, &mut *v], pushes, sweeps, halvings + 1)?.work;
                continue;
            }
            if halvings < HALVINGS {
                work += in_halves(with, &half, t, [&mut *q, &mut *v], pushes, sweeps, (halvings + 1, false))?;
                continue;
            }
            // Where a force jumps between two sides there may be no solution: the last guess is as good as any.
            if !(Y::PIECEWISE && finite::<Y>(pushes).all()) {
                return Err(stalled);
            }
            Y::settle_pushes(tableau, &half, pushes, [&mut *q, &mut *v]);
        }
        work += system.work_of_pushes(tableau, Y::dt(&half), &before, pushes);
    }
    guess_from(system, stride, t + Y::dt(stride), [q, v], pushes);
    Ok(work)
}

/// The pushes of a force that stays as it is there.
fn guess_from<Y: Staged>(system: &Y, stride: &Y::Stride, t: Y::Scalar, [q, v]: [&Y::Sum; 2], pushes: &mut Y::Pushes) {
    let mut slope = system.zero();
    system.slope(t, Y::value(q), Y::value(v), &mut slope);
    *pushes = system.pushes(stride, &slope);
}
