//! Where forces cancel: sweeps come as near as the force is known.

use dmech_scalar::{Mask, Real};

use super::sweeps::{Sweeps, With, finite};
use crate::newton::resolution::Swept;
use crate::system::stages;
use crate::system::{Eight, Staged, Staging};

type EightOf<Y> = <<Y as crate::system::System>::Scalar as Staging>::Eight;

/// Moves position and velocity to the end of the step where sweeps from these pushes only change them by [rounding](Swept::is_rounding) of the
/// force. Whether they do.
#[cold]
#[inline(never)]
pub(super) fn settle<Y: Staged>(
    (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    t: Y::Scalar,
    [q, v]: [&mut Y::Sum; 2],
    pushes: &mut Y::Pushes,
    Sweeps { aim, made, .. }: &mut Sweeps<Y>,
) -> bool {
    if !finite::<Y>(pushes).all() {
        return false;
    }
    system.aim(tableau, stride, t, q, v, pushes, aim);
    let (per_unit, rounding) = (Y::per_unit(aim).to_vec(), Y::nearing(aim).rounding().to_f64());
    let length = |x: &Y::Pushes| largest::<Y>(&per_unit, x);
    let mut swept = |mut pushes: Y::Pushes| {
        *made += 1;
        system.sweep(tableau, stride, aim, &mut pushes);
        pushes
    };
    let last = swept(pushes.clone());
    let delta = sum::<Y>(&last, -1.0, pushes);
    let next = swept(last.clone());
    let known_to = Swept { length: length(&delta), rounding };
    let is_rounding = known_to.is_rounding(
        |s| sum::<Y>(&swept(sum::<Y>(&last, s, &delta)), -1.0, &next),
        |x, c, y| length(&sum::<Y>(x, c, y)),
    );
    if is_rounding {
        *pushes = next;
        Y::settle_pushes(tableau, stride, pushes, [q, v]);
    }
    is_rounding
}

/// x + c y.
fn sum<Y: Staged>(x: &Y::Pushes, c: f64, y: &Y::Pushes) -> Y::Pushes {
    let (mut sum, c) = (x.clone(), EightOf::<Y>::alike(Y::Scalar::from_f64(c)));
    for (x, y) in Y::eights_mut(&mut sum).iter_mut().zip(Y::eights(y)) {
        *x = EightOf::<Y>::by_part(|part| c.mul_add(y.part(part), x.part(part)));
    }
    sum
}

/// The largest, in units of what counts for its coordinate or body.
fn largest<Y: Staged>(per_unit: &[Y::Scalar], pushes: &Y::Pushes) -> f64 {
    if !finite::<Y>(pushes).all() {
        return f64::NAN;
    }
    let pushes = Y::eights(pushes).iter().zip(per_unit.iter().cycle());
    let in_units = pushes
        .map(|(push, per_unit)| (stages::largest_of::<Y::Scalar>(core::slice::from_ref(push)) * *per_unit).to_f64());
    in_units.fold(0.0, f64::max)
}
