//! Lines of a million points, thinned to what can be seen of them.

/// Lines of so few points are left as they are.
const FEW: usize = 4000;

/// What is written of a line beside its points is as long as a dozen points.
const FRAME: usize = 12;

/// Of lines, in pixels, the parts that leave a mark: at most about so many points, each part a range of indices of a line.
///
/// A part of a line that runs where lines are drawn already is left out, and so are points within half a pixel of the one before.
/// Where that leaves too many, pixels are taken to be larger. Points that are no finite numbers end a part.
///
/// With them comes the width that lines need to cover what they stand for.
pub(crate) fn thin(lines: &[Vec<[f64; 2]>], size: [f64; 2], most: usize) -> (Vec<(usize, Vec<usize>)>, f64) {
    if lines.iter().map(|line| line.len() + FRAME).sum::<usize>() <= most.min(FEW) + FRAME {
        return (lines.iter().enumerate().flat_map(|(which, line)| whole(which, line)).collect(), 0.0);
    }
    let mut pixel = 0.5;
    loop {
        let parts = marking(lines, size, pixel);
        if pixel > 64.0 || parts.iter().map(|(_, part)| part.len() + FRAME).sum::<usize>() <= most {
            return (parts, pixel.min(4.0));
        }
        pixel *= 1.3;
    }
}

/// Without the points that are no numbers.
fn whole(which: usize, line: &[[f64; 2]]) -> Vec<(usize, Vec<usize>)> {
    let finite = |i: &usize| line[*i].iter().all(|x| x.is_finite());
    let indices: Vec<_> = (0..line.len()).collect();
    indices
        .chunk_by(|a, b| finite(a) == finite(b))
        .filter(|part| finite(&part[0]))
        .map(|part| (which, part.to_vec()))
        .collect()
}

fn marking(lines: &[Vec<[f64; 2]>], size: [f64; 2], pixel: f64) -> Vec<(usize, Vec<usize>)> {
    let mut seen = Seen::new(size, pixel);
    let mut parts = Vec::new();
    for (which, line) in lines.iter().enumerate() {
        let mut part: Vec<usize> = Vec::new();
        // The last point that was looked at, and the last one that a line was drawn to.
        let mut at: Option<usize> = None;
        // Points since then that leave no mark.
        let mut idle: Vec<usize> = Vec::new();
        for (i, point) in line.iter().enumerate() {
            if !point.iter().all(|x| x.is_finite()) {
                end(&mut part, which, line, pixel, &mut parts);
                idle.clear();
                at = None;
                continue;
            }
            let Some(before) = at else {
                if seen.mark(*point) {
                    part.push(i);
                }
                at = Some(i);
                continue;
            };
            // Within a pixel, unless it is the end.
            let from = line[before];
            if (point[0] - from[0]).abs().max((point[1] - from[1]).abs()) < pixel && i + 1 < line.len() {
                continue;
            }
            if seen.draw(from, *point) {
                // Over a short way the line goes on: a new one is longer to write.
                if part.is_empty() || idle.len() > FRAME {
                    end(&mut part, which, line, pixel, &mut parts);
                    part.push(before);
                } else {
                    part.append(&mut idle);
                }
                idle.clear();
                part.push(i);
            } else if idle.len() <= FRAME {
                idle.push(i);
            }
            at = Some(i);
        }
        end(&mut part, which, line, pixel, &mut parts);
    }
    parts
}

/// Ends a part, without the points that lie on the straight line between others.
fn end(part: &mut Vec<usize>, which: usize, line: &[[f64; 2]], pixel: f64, parts: &mut Vec<(usize, Vec<usize>)>) {
    let long = std::mem::take(part);
    let mut short: Vec<usize> = Vec::new();
    for (k, &i) in long.iter().enumerate() {
        let straight = |from: usize| {
            let skipped = &long[long.partition_point(|&j| j <= from)..k];
            skipped.len() < 32 && skipped.iter().all(|&j| on_the_way(line[from], line[i], line[j], 0.25 * pixel))
        };
        if short.len() >= 2 && straight(short[short.len() - 2]) {
            short.pop();
        }
        short.push(i);
    }
    if !short.is_empty() {
        parts.push((which, short));
    }
}

/// Whether a point lies between two others, and no further than a distance from the line through them.
fn on_the_way(a: [f64; 2], b: [f64; 2], p: [f64; 2], distance: f64) -> bool {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0].hypot(along[1]);
    let part = along[0] * to[0] + along[1] * to[1];
    (0.0..=length * length).contains(&part) && (along[0] * to[1] - along[1] * to[0]).abs() <= distance * length
}

/// Which pixels have been drawn on.
pub(crate) struct Seen {
    columns: usize,
    rows: usize,
    pixel: f64,
    drawn: Vec<bool>,
}

impl Seen {
    pub(crate) fn new(size: [f64; 2], pixel: f64) -> Self {
        let [columns, rows] = size.map(|length| (length / pixel).ceil().max(1.0) as usize + 1);
        Seen { columns, rows, pixel, drawn: vec![false; columns * rows] }
    }

    /// Whether it is the first mark here; what is outside is seen always and nowhere.
    pub(crate) fn mark(&mut self, [x, y]: [f64; 2]) -> bool {
        self.index(x, y).is_some_and(|index| !std::mem::replace(&mut self.drawn[index], true))
    }

    /// How many pixels of a box have been drawn on.
    pub(crate) fn within(&self, x: [f64; 2], y: [f64; 2]) -> usize {
        let steps =
            |[from, to]: [f64; 2]| (0..=((to - from) / self.pixel) as usize).map(move |k| from + k as f64 * self.pixel);
        let drawn = |x: f64| steps(y).filter(|&y| self.index(x, y).is_some_and(|index| self.drawn[index])).count();
        steps(x).map(drawn).sum()
    }

    /// Draws a line; whether any of it is new.
    pub(crate) fn draw(&mut self, from: [f64; 2], to: [f64; 2]) -> bool {
        let longest = (to[0] - from[0]).abs().max((to[1] - from[1]).abs());
        let steps = (longest / self.pixel).ceil().clamp(1.0, 4.0 * (self.columns + self.rows) as f64) as usize;
        let mut new = false;
        for k in 0..=steps {
            let part = k as f64 / steps as f64;
            new |= self.mark([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
        }
        new
    }

    fn index(&self, x: f64, y: f64) -> Option<usize> {
        let (x, y) = ((x / self.pixel).floor(), (y / self.pixel).floor());
        let inside = x >= 0.0 && y >= 0.0 && x < self.columns as f64 && y < self.rows as f64;
        inside.then(|| y as usize * self.columns + x as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::thin;

    /// What is left of a line leaves no pixel out that the line has: every point is within a pixel and a half of a drawn one.
    #[test]
    fn a_thinned_line_covers_what_the_line_covers() {
        let spiral = |k: usize| {
            let turn = 1e-3 * k as f64;
            [300.0 + 2e-1 * turn * turn.cos(), 300.0 + 2e-1 * turn * turn.sin()]
        };
        let line: Vec<_> = (0..1_000_000).map(spiral).collect();
        let (parts, _) = thin(std::slice::from_ref(&line), [600.0, 600.0], 40_000);
        assert!(parts.iter().map(|(_, part)| part.len()).sum::<usize>() <= 40_000);
        let mut near = std::collections::HashSet::new();
        for (_, part) in &parts {
            for ends in part.windows(2) {
                let ([a, b], [c, d]) = (line[ends[0]], line[ends[1]]);
                for k in 0..=64 {
                    let s = f64::from(k) / 64.0;
                    near.insert((((a + s * (c - a)) / 2.0).round() as i32, ((b + s * (d - b)) / 2.0).round() as i32));
                }
            }
        }
        let covered = |[x, y]: &[f64; 2]| {
            let (x, y) = ((x / 2.0).round() as i32, (y / 2.0).round() as i32);
            (-1..=1).any(|i| (-1..=1).any(|j| near.contains(&(x + i, y + j))))
        };
        assert!(line.iter().all(covered));
    }

    #[test]
    fn what_is_no_number_ends_a_part() {
        let line = vec![[0.0, 1.0], [f64::NAN, 2.0], [300.0, 400.0], [500.0, 600.0], [7.0, f64::INFINITY]];
        assert_eq!(thin(std::slice::from_ref(&line), [900.0, 900.0], 100).0, [(0, vec![0]), (0, vec![2, 3])]);
        assert_eq!(thin(&[line], [900.0, 900.0], 0).0, [(0, vec![0]), (0, vec![2, 3])]);
    }
}
