//! Stages side by side: the instructions of schemes that know the force at eight moments of a step together.

mod abreast;
mod digits;
mod eight;
mod nearing;
mod settle;
pub(crate) mod tableau;

pub(crate) use eight::Part;
pub(crate) use eight::weighed;
pub use eight::{Eight, Staging};
pub use nearing::Nearing;
pub(crate) use nearing::moves;
pub(crate) use settle::{drift, path, settle};

use dmech_scalar::{Mask, Real};

use super::System;
pub(crate) use tableau::{Columns, Row, STAGES, Tableau};

/// A system whose force can be had at eight moments of a step together, in the lanes of a register.
///
/// The *push* of a stage is Lᵢ = −(h²/m) bᵢ S(Qᵢ, Vᵢ, t + cᵢ h) with the slope S = ∇Φ − F: a length, by which positions and,
/// over h, velocities follow.
///
/// ```text
/// Qᵢ = q + cᵢ h v + Σⱼ νᵢⱼ Lⱼ,   Vᵢ = v + Σⱼ μᵢⱼ Lⱼ/h
/// q′ = q + h v + Σ (1 − cⱼ) Lⱼ,   v′ = v + Σ Lⱼ/h
/// ```
pub trait Staged: System<Scalar: Staging> {
    /// The pushes of a step: eight numbers for each coordinate.
    type Pushes: Clone + core::fmt::Debug;
    /// What stays the same from sweep to sweep.
    type Aim: Clone + core::fmt::Debug;

    /// The pushes of a force that does not change.
    fn pushes(&self, stride: &Self::Stride, slope: &Self::Vector) -> Self::Pushes;
    /// Room for [`aim`](Staged::aim).
    fn aims(&self) -> Self::Aim;
    /// Those of each coordinate.
    fn eights(pushes: &Self::Pushes) -> &[<Self::Scalar as Staging>::Eight];
    /// The same, to be written to.
    fn eights_mut(pushes: &mut Self::Pushes) -> &mut [<Self::Scalar as Staging>::Eight];
    /// The coordinates of a position, in the order of their pushes.
    fn coordinates(q: &Self::Vector) -> &[Self::Scalar];
    /// Prepares the sweeps of a step.
    #[expect(clippy::too_many_arguments, reason = "all that a step begins with")]
    fn aim(
        &self,
        tableau: &Tableau,
        stride: &Self::Stride,
        t: Self::Scalar,
        q: &Self::Sum,
        v: &Self::Sum,
        pushes: &Self::Pushes,
        aim: &mut Self::Aim,
    );
    /// Positions from the pushes, and pushes from the positions. Whether some push has come nearer, and by the two last changes
    /// another sweep would bring it nearer still: by more than the position's rounding.
    fn sweep(
        &self,
        tableau: &Tableau,
        stride: &Self::Stride,
        aim: &mut Self::Aim,
        pushes: &mut Self::Pushes,
    ) -> <Self::Scalar as Real>::Mask;
    /// 1 over the change of a push that counts, of each coordinate or body.
    fn per_unit(aim: &Self::Aim) -> &[Self::Scalar];
    /// How near the last sweep has come.
    fn nearing(aim: &Self::Aim) -> &Nearing<Self::Scalar>;
    /// Moves position and velocity to the end of the step.
    fn settle_pushes(tableau: &Tableau, stride: &Self::Stride, pushes: &Self::Pushes, moves: [&mut Self::Sum; 2]);
    /// Σ m Ṽᵢ·Lᵢ/h over the stages, with Ṽᵢ = v + Σⱼ λᵢⱼ Lⱼ/h, of a step of length dt that began with the velocity v.
    fn work_of_pushes(
        &self,
        tableau: &Tableau,
        dt: Self::Scalar,
        v: &Self::Vector,
        pushes: &Self::Pushes,
    ) -> Self::Scalar;
}

/// The polynomial through the pushes of the last step, continued into the next, `ratio` times as long; where that is 0 they are a guess
/// already.
#[inline(always)]
pub(crate) fn go_on<R: Staging>(pushes: &mut [R::Eight], tableau: &Tableau, ratio: R) {
    let (guessed, even) = (ratio.equal(R::ZERO), ratio.equal(R::ONE));
    if guessed.all() {
        return;
    }
    let evenly = |push: &R::Eight, part| weighed(&tableau.continued, push, part, R::Eight::alike(R::ZERO));
    if even.all() {
        return pushes.iter_mut().for_each(|push| *push = R::Eight::by_part(|part| evenly(push, part)));
    }
    let columns = continued(tableau, ratio);
    for push in pushes {
        let mut next = R::Eight::by_part(|part| mixed(&columns, push, part));
        if even.any() {
            next = either(even, &R::Eight::by_part(|part| evenly(push, part)), &next);
        }
        *push = either(guessed, push, &next);
    }
}

/// A row for each column of [`Tableau::continued`], for a step `ratio` times as long as the last: with ℓⱼ(1 + ρ cᵢ) by products
/// of the distances from the nodes, none of which is divided by.
fn continued<R: Staging>(tableau: &Tableau, ratio: R) -> [R::Eight; STAGES] {
    let number = |x: f64| R::Eight::alike(R::from_f64(x));
    let mut columns = [R::Eight::splat(R::ZERO); STAGES];
    for part in 0..R::Eight::PARTS {
        let at = R::Eight::row(&tableau.nodes, part).mul_add(R::Eight::alike(ratio), number(1.0));
        let away = |j: usize| at - number(tableau.nodes.hi[j]);
        // b ρ², on the way up the product of what is before, on the way down of what is behind.
        let mut before = R::Eight::row(&tableau.weights, part) * R::Eight::alike(ratio * ratio);
        for j in 0..STAGES {
            columns[j].set(part, before);
            before *= away(j);
        }
        let mut after = number(1.0);
        for j in (0..STAGES).rev() {
            columns[j].set(part, columns[j].part(part) * after * number(tableau.barycentric.hi[j]));
            after *= away(j);
        }
    }
    columns
}

/// A part of Σⱼ columnⱼ xⱼ.
#[inline(always)]
fn mixed<R: Real, E: Eight<R>>(columns: &[E; STAGES], x: &E, part: usize) -> E::Part {
    let mut sum = columns[0].part(part) * x.each(0);
    for j in 1..STAGES {
        sum = columns[j].part(part).mul_add(x.each(j), sum);
    }
    sum
}

/// On a smooth motion what the sixth and the seventh polynomial have of a force is this part, or less, of what the fourth and the fifth
/// have; where something bends or jumps in a step it is as large as they, however small.
const FALLS: f64 = 2.0 / 3.0;
/// What the seventh has beside the largest push, in steps that are far too long.
const LARGE: f64 = 0.15;
/// Beyond so many ulp of the largest push, and this part of its own, it is no rounding: a force that is a small difference of large numbers
/// has many.
const NO_ROUNDING: [f64; 2] = [1e4, 1e-6];
/// And beyond so many ulp of the position: of a body at rest nothing is left but rounding of forces that cancel.
const BY_PLACE: f64 = 64.0;

/// Whether the polynomials of the force on some coordinate do not fall off, or are large at the last: what eight stages cannot see is then
/// about as large as that.
#[cold]
pub(crate) fn bends<R: Staging>(tableau: &Tableau, pushes: &[R::Eight], q: &[R]) -> R::Mask {
    let [ulps, part] = NO_ROUNDING.map(R::from_f64);
    let of_place = R::from_f64(BY_PLACE) * R::EPSILON;
    let (of_all, mut bent) = (ulps * R::EPSILON * largest_of::<R>(pushes), R::Mask::of(false));
    for (push, place) in pushes.iter().zip(q) {
        let share = |row: &Row| times(row, push).sum().abs();
        let [fourth, fifth, sixth, seventh] = &tableau.highest;
        let (own, seventh) = (largest_of::<R>(core::slice::from_ref(push)), share(seventh));
        let last = share(sixth).max(seventh);
        let told = of_all.max(part * own).max(of_place * place.abs()).less(last);
        // On most motions there is nothing to be told.
        if told.any() {
            let stays = (R::from_f64(FALLS) * share(fourth).max(share(fifth))).less(last);
            bent = bent.or(told.and(stays.or((R::from_f64(LARGE) * own).less(seventh))));
        }
    }
    bent
}

/// Coefficients times numbers.
#[inline(always)]
pub(crate) fn times<R: Real, E: Eight<R>>(row: &Row, x: &E) -> E {
    E::by_part(|part| E::row(row, part) * x.part(part))
}

/// `yes` where the mask holds, `no` elsewhere.
#[inline(always)]
pub(crate) fn either<R: Real, E: Eight<R>>(mask: R::Mask, yes: &E, no: &E) -> E {
    E::by_part(|part| E::either(mask, yes.part(part), no.part(part)))
}

/// The largest of all.
#[inline(always)]
pub(crate) fn largest_of<R: Staging>(pushes: &[R::Eight]) -> R {
    let largest = |part| {
        let none = R::Eight::alike(R::ZERO);
        pushes.iter().fold(none, |all, push| R::Eight::larger(all, push.part(part)))
    };
    R::Eight::by_part(largest).largest()
}

/// Whether every push is finite: 0·x is 0 for a finite x and NaN for any other.
#[inline(always)]
pub(crate) fn are_finite<R: Staging>(pushes: &[R::Eight]) -> R::Mask {
    let zeros = |part| {
        let none = R::Eight::alike(R::ZERO);
        pushes.iter().fold(none, |sum, push| none.mul_add(push.part(part), sum))
    };
    R::Eight::by_part(zeros).sum().equal(R::ZERO)
}

#[cfg(test)]
mod tests;
