//! Bodies within reach of each other, on all cores where that pays, equal to the bit for any number of threads.

mod cells;
mod neighbours;
mod row;

use std::sync::{Mutex, MutexGuard, PoisonError};

use self::neighbours::Neighbours;
use self::row::Row;
use super::Pairs;
use super::cores::each_on_its_core;
use super::links::{self, KnownLinks, Links};
use super::numbers::NumberColumns;
use super::sweep::Kernels;
use crate::error::{Error, SceneError};
use crate::law::Numbers;
use crate::scene::space::Space;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;

/// From so many bodies on the rows are cut into chunks.
const CUT: usize = 8192;
/// Chunks at most: each has room for what all later bodies feel.
const MOST: usize = 8;

/// Bodies nearer to each other than the cut-off.
#[derive(Debug)]
pub struct Near {
    cutoff: f64,
    /// Made when it is needed.
    room: Mutex<Room>,
}

/// What is remembered between passes, for speed only: no result depends on it.
#[derive(Debug, Default)]
struct Room {
    neighbours: Neighbours,
    /// Positions at each moment, body by body: what belongs to a body is in one line of the cache.
    places: Vec<f64>,
    chunks: Vec<Chunk>,
}

/// What the bodies feel from the rows of a chunk, from its first body on.
#[derive(Debug, Default)]
struct Chunk {
    felt: Vec<f64>,
    row: Row,
}

impl Clone for Near {
    fn clone(&self) -> Self {
        Near::new(self.cutoff)
    }
}

impl Near {
    pub(crate) fn new(cutoff: f64) -> Self {
        Near { cutoff, room: Mutex::default() }
    }

    fn room(&self) -> MutexGuard<'_, Room> {
        self.room.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// How many chunks: it depends on the number of bodies only, so that sums are formed in the same order on any machine.
fn chunks(bodies: usize) -> usize {
    (bodies / (CUT / 2)).clamp(1, MOST)
}

/// Few bodies are all looked at: beyond its reach the law gives nothing.
impl KnownLinks for Near {
    #[inline(always)]
    fn visit(bodies: usize, visit: impl FnMut(usize, usize)) {
        Pairs::visit(bodies, visit);
    }
}

impl Links for Near {
    const OF_DISTANCE: bool = true;

    fn each<const D: usize, const S: usize>(
        &self,
        space: &impl Space<D>,
        q: [&Vectors<D>; S],
        mut visit: impl FnMut(usize, usize),
    ) {
        let Room { neighbours, places, .. } = &mut *self.room();
        neighbours.cover(space, self.cutoff, &q);
        let (places, square) = (by_body(q, places), self.cutoff * self.cutoff);
        for a in 0..links::bodies(q) {
            for &b in neighbours.of(a) {
                let apart = places.map(|places| row::square(space, places[a], places[b as usize]));
                if apart.iter().any(|&apart| apart < square) {
                    visit(a, b as usize);
                }
            }
        }
    }

    fn cutoff(&self) -> Option<f64> {
        Some(self.cutoff)
    }

    fn sweep<const SET: bool, const D: usize, const S: usize, N: Numbers>(
        &self,
        space: &impl Space<D>,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        out: &mut Vectors<D>,
    ) {
        if SET {
            out.clear();
        }
        let bodies = links::bodies(q);
        let Room { neighbours, places, chunks: room } = &mut *self.room();
        let moments = row::places(kernel);
        neighbours.cover(space, self.cutoff, &q[..moments]);
        let (places, neighbours) = (by_body(q, places), &*neighbours);
        let count = chunks(bodies);
        room.resize_with(count, Chunk::default);
        let begin = |c: usize| bodies * c / count;
        each_on_its_core(room, |c, Chunk { felt, row }| {
            let rows = begin(c)..begin(c + 1);
            let end = neighbours.end(rows.clone());
            felt.clear();
            felt.resize(D * (end - rows.start), 0.0);
            row.fit(neighbours.longest(), self.cutoff);
            let start = rows.start;
            for a in rows {
                let found = row.gather(space, moments, &places, a, neighbours.of(a));
                row.add(kernel, numbers, &places, [a, start], found, felt.as_chunks_mut().0);
            }
        });
        for (c, Chunk { felt, .. }) in room.iter().enumerate() {
            let felt = felt.as_chunks::<D>().0;
            for (k, out) in out.columns_mut().into_iter().enumerate() {
                for (out, felt) in out[begin(c)..].iter_mut().zip(felt) {
                    *out += felt[k];
                }
            }
        }
    }

    fn topology(&self) -> Topology {
        Topology::Near
    }

    fn check<const D: usize>(&self, _: usize, space: &impl Space<D>) -> Result<(), Error> {
        let cutoff = self.cutoff;
        // The square decides who is within reach.
        let square = cutoff * cutoff;
        if !(cutoff > 0.0 && square > 0.0 && square.is_finite()) {
            return Err(SceneError::Cutoff { cutoff }.into());
        }
        for (component, length) in space.lengths().into_iter().flatten().enumerate() {
            if 2.0 * cutoff > length {
                return Err(SceneError::CutoffInBox { cutoff, component, length }.into());
            }
        }
        Ok(())
    }
}

/// The positions at each moment, body by body.
fn by_body<'a, const D: usize, const S: usize>(q: [&Vectors<D>; S], places: &'a mut Vec<f64>) -> [&'a [[f64; D]]; S] {
    let numbers = D * links::bodies(q);
    places.resize(S * numbers, 0.0);
    let mut rest = places.as_mut_slice();
    q.map(|q| {
        let moment = rest.split_off_mut(..numbers).unwrap_or_default().as_chunks_mut::<D>().0;
        for (k, column) in q.columns().into_iter().enumerate() {
            moment.iter_mut().zip(column).for_each(|(place, &x)| place[k] = x);
        }
        &*moment
    })
}
