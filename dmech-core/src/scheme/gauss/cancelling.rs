//! Where forces cancel: pushes are known as well as they are.

use dmech_scalar::Real;

use super::sweeps::With;
use crate::newton::scatter::{Left, SPACINGS};
use crate::system::{Eight, Staged, Staging};

/// Sweeps that are looked at.
const LOOKED_AT: usize = 3;

type EightOf<Y> = <<Y as crate::system::System>::Scalar as Staging>::Eight;

/// Sweeps on, and says whether nothing is left of their equation, L = the pushes of L, but [rounding](Left::is_rounding); how many sweeps were made,
/// and by what length they last changed the pushes.
#[cold]
#[inline(never)]
pub(super) fn is_known<Y: Staged>(
    (system, tableau): With<'_, Y>,
    stride: &Y::Stride,
    aim: &mut Y::Aim,
    pushes: &mut Y::Pushes,
) -> (bool, u32, f64) {
    let mut sweeps = 0;
    let mut swept = |pushes: &mut Y::Pushes| {
        sweeps += 1;
        system.sweep(tableau, stride, aim, pushes);
    };
    let (mut changes, mut last) = ([(); LOOKED_AT].map(|()| pushes.clone()), pushes.clone());
    for change in &mut changes {
        last = pushes.clone();
        swept(pushes);
        *change = pushes.clone();
        combine::<Y>(change, &last, -1.0);
    }
    let left = changes.each_ref().map(|change| along::<Y>(change, change));
    let parts = along::<Y>(pushes, pushes);
    let of_equation = Left { lengths: &left, parts, reach: parts, epsilon: Y::Scalar::EPSILON.to_f64() };
    let is_known = of_equation.is_rounding(&SPACINGS[..2], |k, s| {
        let mut further = last.clone();
        combine::<Y>(&mut further, &changes[k], s);
        let mut there = further.clone();
        swept(&mut there);
        combine::<Y>(&mut there, &further, -1.0);
        along::<Y>(&there, &changes[k])
    });
    (is_known, sweeps, left[LOOKED_AT - 1])
}

/// x += c y.
fn combine<Y: Staged>(x: &mut Y::Pushes, y: &Y::Pushes, c: f64) {
    let c = EightOf::<Y>::alike(Y::Scalar::from_f64(c));
    for (x, y) in Y::eights_mut(x).iter_mut().zip(Y::eights(y)) {
        *x = EightOf::<Y>::by_part(|part| x.part(part) + c * y.part(part));
    }
}

/// Σ xᵢ sign dᵢ.
fn along<Y: Staged>(x: &Y::Pushes, d: &Y::Pushes) -> f64 {
    let pairs = Y::eights(x).iter().zip(Y::eights(d));
    let signed = |(x, d): (&EightOf<Y>, &EightOf<Y>)| {
        let part = |part| {
            Real::select(d.part(part).less(EightOf::<Y>::alike(Y::Scalar::ZERO)), || -x.part(part), || x.part(part))
        };
        EightOf::<Y>::by_part(part).sum().to_f64()
    };
    pairs.map(signed).sum()
}
