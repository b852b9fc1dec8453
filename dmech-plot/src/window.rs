//! What lies between the axes: the library beneath would move all else onto the frame, where nothing is.

use std::ops::Range;

use crate::Chart;

type Point = (f64, f64);

pub(crate) struct Window {
    x: Range<f64>,
    y: Range<f64>,
}

impl Window {
    pub(crate) fn of(chart: &Chart<'_>) -> Self {
        Window { x: chart.x_range(), y: chart.y_range() }
    }

    fn has(&self, (x, y): Point) -> bool {
        (self.x.start..=self.x.end).contains(&x) && (self.y.start..=self.y.end).contains(&y)
    }

    pub(crate) fn points<'a>(&'a self, points: &'a [Point]) -> impl Iterator<Item = Point> + 'a {
        points.iter().copied().filter(|&point| self.has(point))
    }

    /// The pieces of a line within, cut at the frame; what is no finite number ends a piece.
    pub(crate) fn pieces(&self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        let mut goes_on = false;
        for (k, &to) in line.iter().enumerate() {
            let from = if k > 0 { line[k - 1] } else { to };
            let Some([enter, leave]) = self.within(from, to) else {
                goes_on = false;
                continue;
            };
            let at = |part: f64| match part {
                0.0 => from,
                1.0 => to,
                part => (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1)),
            };
            match pieces.last_mut() {
                Some(piece) if goes_on => piece.push(at(leave)),
                _ if k == 0 || enter == leave => pieces.push(vec![at(leave)]),
                _ => pieces.push(vec![at(enter), at(leave)]),
            }
            goes_on = leave == 1.0;
        }
        pieces
    }

    /// The shares of the way from one point to another between which it runs within (Liang and Barsky 1984).
    fn within(&self, from: Point, to: Point) -> Option<[f64; 2]> {
        let [mut enter, mut leave] = [0.0_f64, 1.0_f64];
        for (a, b, range) in [(from.0, to.0, &self.x), (from.1, to.1, &self.y)] {
            let way = b - a;
            if !way.is_finite() || way == 0.0 && !(range.start..=range.end).contains(&a) {
                return None;
            }
            if way != 0.0 {
                let mut ends = [(range.start - a) / way, (range.end - a) / way];
                ends.sort_by(f64::total_cmp);
                (enter, leave) = (enter.max(ends[0]), leave.min(ends[1]));
            }
        }
        (enter <= leave).then_some([enter, leave])
    }
}

#[cfg(test)]
mod tests {
    use super::Window;

    const WINDOW: Window = Window { x: -1.0..3.0, y: -0.5..0.5 };

    #[test]
    fn a_line_is_cut_at_the_frame() {
        // In, out at the top, back in, and a jump across.
        let line = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (4.0, 0.0), (4.0, -3.0), (-2.0, 3.0)];
        let pieces = WINDOW.pieces(&line);
        let expected =
            [vec![(0.0, 0.0), (0.5, 0.5)], vec![(1.5, 0.5), (2.0, 0.0), (3.0, 0.0)], vec![(1.5, -0.5), (0.5, 0.5)]];
        assert_eq!(pieces.len(), expected.len(), "{pieces:?}");
        for (piece, expected) in pieces.iter().zip(&expected) {
            assert_eq!(piece.len(), expected.len(), "{pieces:?}");
            assert!(piece.iter().zip(expected).all(|(a, b)| (a.0 - b.0).hypot(a.1 - b.1) < 1e-12), "{pieces:?}");
        }
    }

    #[test]
    fn what_lies_within_stays_as_it_is_and_nothing_is_drawn_outside() {
        let wave: Vec<_> = (0..=1000).map(|k| 0.01 * f64::from(k) - 4.0).map(|t| (t, 0.9 * (6.0 * t).sin())).collect();
        let pieces = WINDOW.pieces(&wave);
        assert!(pieces.len() > 5);
        for &(x, y) in pieces.iter().flatten() {
            assert!(
                (x - 1.0).abs() <= 2.0 + 1e-12 && y.abs() <= 0.5 + 1e-12 && (y - 0.9 * (6.0 * x).sin()).abs() < 1e-3
            );
        }
        let inside: Vec<_> = wave.iter().copied().filter(|&point| WINDOW.has(point)).collect();
        assert!(inside.iter().all(|point| pieces.iter().flatten().any(|other| other == point)));
        assert_eq!(WINDOW.points(&wave).collect::<Vec<_>>(), inside);
    }

    #[test]
    fn what_is_no_number_ends_a_piece() {
        let line = [(0.0, 0.0), (1.0, 0.0), (f64::NAN, 0.0), (1.0, f64::INFINITY), (2.0, 0.1), (2.5, 0.2)];
        assert_eq!(WINDOW.pieces(&line), [vec![(0.0, 0.0), (1.0, 0.0)], vec![(2.0, 0.1), (2.5, 0.2)]]);
        assert!(WINDOW.pieces(&[(f64::NAN, 0.0)]).is_empty() && WINDOW.pieces(&[]).is_empty());
        assert_eq!(WINDOW.pieces(&[(0.0, 0.0)]), [vec![(0.0, 0.0)]]);
    }
}
