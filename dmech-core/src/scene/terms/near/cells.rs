//! Bodies by the cell of space in which they are.

use crate::scene::space::Space;
use crate::scene::vectors::Vectors;

/// Bodies by cells whose sides are a reach long or a little longer: those within reach of a body are in its cell or in one
/// beside it.
///
/// Cells are found by a hash of their coordinates among as many places as there are bodies, so that the room is O(N)
/// however far apart bodies are. Two cells with one place are told apart by their coordinates.
#[derive(Debug, Default)]
pub(super) struct Cells {
    /// The coordinates of the cell of each body, D numbers each.
    coordinates: Vec<i64>,
    /// The bodies of place p are `bodies[first[p]..first[p + 1]]`, ascending.
    first: Vec<usize>,
    bodies: Vec<u32>,
    /// How many cells there are along each coordinate before they repeat; 0 in open space.
    counts: Vec<i64>,
    mine: Vec<u32>,
    candidates: Vec<u32>,
}

/// Coordinates beyond this are those of the last cell: positions that are as far away are not finite, or their step is wrong.
const LAST: f64 = 4e18;

impl Cells {
    /// Puts every body into its cell.
    pub(super) fn fill<const D: usize>(&mut self, space: &impl Space<D>, reach: f64, q: &Vectors<D>) {
        let bodies = q.bodies();
        let lengths = space.lengths();
        // Rounding of a position must not put a body two cells away.
        let reach = reach * (1.0 + 1e-9);
        // More cells than bodies would be empty.
        let most = (bodies.max(1) as f64).powf(1.0 / D.max(1) as f64).ceil() * 2.0;
        let count = |length: f64| (length / reach).floor().clamp(1.0, most);
        self.counts.clear();
        self.counts.resize(D, 0);
        self.coordinates.clear();
        self.coordinates.resize(D * bodies, 0);
        for (k, column) in q.columns().into_iter().enumerate() {
            let cell = |x: f64| match lengths {
                Some(lengths) => {
                    let (part, count) = (x / lengths[k], count(lengths[k]));
                    ((part - part.floor()) * count).floor().min(count - 1.0)
                }
                None => (x / reach).floor().clamp(-LAST, LAST),
            };
            for (i, &x) in column.iter().enumerate() {
                self.coordinates[i * D + k] = cell(x) as i64;
            }
            self.counts[k] = lengths.map_or(0, |lengths| count(lengths[k]) as i64);
        }
        self.sort(bodies);
    }

    /// The bodies by place, by counting.
    fn sort(&mut self, bodies: usize) {
        let places = bodies.next_power_of_two();
        self.first.clear();
        self.first.resize(places + 1, 0);
        for i in 0..bodies {
            let place = place(self.cell(i), places);
            self.first[place + 1] += 1;
        }
        for p in 0..places {
            self.first[p + 1] += self.first[p];
        }
        self.bodies.clear();
        self.bodies.resize(bodies, 0);
        for i in 0..bodies {
            let place = place(self.cell(i), places);
            self.bodies[self.first[place]] = i as u32;
            self.first[place] += 1;
        }
        self.first.rotate_right(1);
        self.first[0] = 0;
    }

    /// The coordinates of the cell of body i.
    fn cell(&self, i: usize) -> &[i64] {
        let dimension = self.counts.len();
        &self.coordinates[i * dimension..(i + 1) * dimension]
    }

    /// Visits every cell that is not empty: its bodies, and those in it and beside it that come before the last of them.
    pub(super) fn each(&mut self, mut visit: impl FnMut(&[u32], &[u32])) {
        let (mut mine, mut candidates) = (core::mem::take(&mut self.mine), core::mem::take(&mut self.candidates));
        let mut beside = vec![0; self.counts.len()];
        for p in 0..self.first.len() - 1 {
            let all = &self.bodies[self.first[p]..self.first[p + 1]];
            for (rank, &body) in all.iter().enumerate() {
                let cell = self.cell(body as usize);
                // The first of its cell stands for it.
                if all[..rank].iter().any(|&other| self.cell(other as usize) == cell) {
                    continue;
                }
                mine.clear();
                mine.extend(all[rank..].iter().filter(|&&other| self.cell(other as usize) == cell));
                candidates.clear();
                let last = mine.last().copied().unwrap_or(0);
                self.collect(cell, last, 0, &mut beside, &mut candidates);
                visit(&mine, &candidates);
            }
        }
        (self.mine, self.candidates) = (mine, candidates);
    }

    /// The bodies before `last` of all cells beside one, coordinate after coordinate.
    fn collect(&self, cell: &[i64], last: u32, k: usize, beside: &mut [i64], found: &mut Vec<u32>) {
        if k == cell.len() {
            let place = place(beside, self.first.len() - 1);
            let there = &self.bodies[self.first[place]..self.first[place + 1]];
            let there = there.iter().take_while(|&&body| body < last);
            found.extend(there.filter(|&&body| self.cell(body as usize) == &*beside));
            return;
        }
        // In a box of two cells both neighbours are the same one, and in one of a single cell it is itself.
        let steps = match self.counts[k] {
            1 => 0..=0,
            2 => 0..=1,
            _ => -1..=1,
        };
        for step in steps {
            beside[k] = cell[k] + step;
            if self.counts[k] > 0 {
                beside[k] = beside[k].rem_euclid(self.counts[k]);
            }
            self.collect(cell, last, k + 1, beside, found);
        }
    }
}

/// Where a cell is kept; neighbours along the last coordinate are neighbours there.
#[inline]
fn place(cell: &[i64], places: usize) -> usize {
    let hash = cell
        .iter()
        .fold(0_u64, |hash, &c| hash.wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(23).wrapping_add(c as u64));
    hash as usize & (places - 1)
}
