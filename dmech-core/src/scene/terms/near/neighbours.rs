//! Who may be within reach of whom for a while.

use dmech_scalar::{Lanes, Real};

use super::cells::Cells;
use super::row::square;
use crate::scene::space::Space;
use crate::scene::vectors::Vectors;

/// How far beyond the cut-off the lists reach, over the cut-off: shorter means new lists more often, longer means longer
/// ones (of 0.10, 0.14, 0.18 and 0.24 the second is the fastest for 32 000 atoms of a liquid, cut off at 2.5).
const SKIN: f64 = 0.14;

/// For each body the later ones that are nearer than the cut-off and a skin, ascending.
///
/// The lists hold until a body has moved by half the skin.
#[derive(Debug, Default)]
pub(super) struct Neighbours {
    /// Where the bodies were, by column, and how far they may go from there. Empty before the first lists.
    made_at: Vec<f64>,
    made_for: Option<usize>,
    slack: f64,
    /// The neighbours of body a are `with[first[a]..first[a + 1]]`.
    first: Vec<usize>,
    with: Vec<u32>,
    longest: usize,
    /// The earlier neighbours of each body, in any order: those of body b are `earlier[place[b]]`.
    earlier: Vec<u32>,
    place: Vec<[usize; 2]>,
    cells: Cells,
    /// Where the candidates of a cell are, eight by eight, component after component.
    places: Vec<[f64; Lanes::COUNT]>,
    kept: Vec<u32>,
}

impl Neighbours {
    /// Makes new lists if these do not hold at one of the moments.
    pub(super) fn cover<const D: usize>(&mut self, space: &impl Space<D>, cutoff: f64, q: &[&Vectors<D>]) {
        let Some((first, others)) = q.split_first() else { return };
        if self.made_for == Some(first.bodies()) && q.iter().all(|q| moved(q, &self.made_at, self.slack)) {
            return;
        }
        // A long step goes further than a skin: what is within reach at its end must be found from its start.
        let far = others.iter().map(|q| farthest(q, first.flat())).fold(0.0, f64::max);
        let least = 0.5 * SKIN * cutoff;
        let slack = if far < cutoff { f64::max(least, 1.01 * far) } else { least };
        self.made_at.clear();
        self.made_at.extend_from_slice(first.flat());
        (self.made_for, self.slack) = (Some(first.bodies()), slack);
        self.make(space, cutoff + 2.0 * slack, first);
        if far >= cutoff {
            others.iter().for_each(|q| self.join(space, cutoff + 2.0 * slack, q));
        }
    }

    /// Adds those who are near at another moment, so far away that one reach for both would take in everybody.
    #[cold]
    fn join<const D: usize>(&mut self, space: &impl Space<D>, reach: f64, q: &Vectors<D>) {
        let (first, with) = (core::mem::take(&mut self.first), core::mem::take(&mut self.with));
        self.make(space, reach, q);
        let (mut joined, mut begins, mut row) = (Vec::new(), vec![0], Vec::new());
        self.longest = 0;
        for a in 0..q.bodies() {
            row.clear();
            row.extend_from_slice(&with[first[a]..first[a + 1]]);
            row.extend_from_slice(self.of(a));
            row.sort_unstable();
            row.dedup();
            joined.extend_from_slice(&row);
            begins.push(joined.len());
            self.longest = self.longest.max(row.len());
        }
        (self.first, self.with) = (begins, joined);
    }

    fn make<const D: usize>(&mut self, space: &impl Space<D>, reach: f64, q: &Vectors<D>) {
        let (bodies, limit) = (q.bodies(), reach * reach);
        let Neighbours { first, with, earlier, place, cells, places, kept, .. } = self;
        cells.fill(space, reach, q);
        first.clear();
        first.resize(bodies + 1, 0);
        earlier.clear();
        place.clear();
        place.resize(bodies, [0; 2]);
        cells.each(|mine, candidates| {
            let columns = q.columns();
            places.clear();
            for eight in candidates.chunks(Lanes::COUNT) {
                // What fills up the last register is not looked at.
                let body = |lane: usize| eight[lane.min(eight.len() - 1)] as usize;
                places.extend(columns.iter().map(|column| <[f64; 8]>::from(Lanes::from_fn(|lane| column[body(lane)]))));
            }
            kept.resize(kept.len().max(candidates.len() + Lanes::COUNT), 0);
            for &b in mine {
                let (here, mut count) = (q.get(b as usize), 0);
                for (eight, there) in candidates.chunks(Lanes::COUNT).zip(places.as_chunks::<D>().0) {
                    let apart: Lanes = square(space, there.map(Lanes::from), here.map(Lanes::splat));
                    let near = apart.less_or_equal(Lanes::splat(limit)).to_array();
                    // Each is written, and kept if it counts: no branch can be guessed here.
                    for (&a, near) in eight.iter().zip(near) {
                        kept[count] = a;
                        count += usize::from(near && a < b);
                    }
                }
                kept[..count].iter().for_each(|&a| first[a as usize + 1] += 1);
                place[b as usize] = [earlier.len(), earlier.len() + count];
                earlier.extend_from_slice(&kept[..count]);
            }
        });
        self.longest = first.iter().copied().max().unwrap_or(0);
        for a in 0..bodies {
            first[a + 1] += first[a];
        }
        // Bodies ascending, each to the lists of the earlier ones: those are then ascending too.
        with.clear();
        with.resize(earlier.len(), 0);
        for b in 0..bodies {
            let [start, end] = place[b];
            for &a in &earlier[start..end] {
                with[first[a as usize]] = b as u32;
                first[a as usize] += 1;
            }
        }
        // Each has gone to where the next began.
        first.rotate_right(1);
        if let Some(zero) = first.first_mut() {
            *zero = 0;
        }
    }

    /// The later neighbours of body a.
    #[inline(always)]
    pub(super) fn of(&self, a: usize) -> &[u32] {
        &self.with[self.first[a]..self.first[a + 1]]
    }

    /// How many neighbours the one with the most has.
    pub(super) fn longest(&self) -> usize {
        self.longest
    }

    /// One more than the last body in some rows and their lists.
    pub(super) fn end(&self, rows: core::ops::Range<usize>) -> usize {
        rows.clone().filter_map(|a| self.of(a).last()).fold(rows.end, |end, &b| end.max(b as usize + 1))
    }
}

/// Whether no body has gone further than so far from where it was; not where a position is no number.
fn moved<const D: usize>(q: &Vectors<D>, from: &[f64], slack: f64) -> bool {
    farthest(q, from) <= slack
}

/// The largest distance of a body from where it was; NaN if a position is no number.
fn farthest<const D: usize>(q: &Vectors<D>, from: &[f64]) -> f64 {
    let (bodies, columns) = (q.bodies(), q.columns());
    let mut largest = 0.0;
    for i in 0..bodies {
        let square: f64 = (0..D).map(|k| (columns[k][i] - from[k * bodies + i]).powi(2)).sum();
        if square > largest || square.is_nan() {
            largest = square;
        }
    }
    largest.sqrt()
}
