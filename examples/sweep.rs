//! A map of chaos: how fast neighbours part, for 200 × 200 starts of Hénon and Heiles at E = 1/8.
//!
//! ```text
//! cargo run --release --example sweep
//! ```
//!
//! Every point of the plane x = 0, v_x > 0 is the start of two motions 10⁻⁹ apart; where they are after 200 units of time tells
//! order from chaos. Neighbours of an orderly motion part in proportion to the time, those of a chaotic one exponentially. The
//! islands are those of M. Hénon and C. Heiles, Astron. J. 69 (1964) 73–79, figure 5; the example `section` draws their figure.
//!
//! All of them are one ensemble, side by side in the lanes of the registers and over the cores. `dmech-mpi` has the same over the ranks
//! of MPI, with the same checksum: `scripts/local.sh`.

#[path = "shared/henon_heiles.rs"]
mod henon_heiles;
#[path = "shared/picture.rs"]
mod picture;

use std::time::Instant;

use dmech::models::HenonHeiles;
use dmech::plot::plotters::prelude::{Color, RGBColor, Rectangle};
use dmech::plot::power;
use dmech::prelude::*;
use henon_heiles::{APART, END, SIDE, V, Y, cells, start};
use picture::{Axis, Drawn, INK};

/// Powers of ten by which neighbours may have parted, from below, and their colours: order is pale, chaos dark
/// (S. van der Walt and N. Smith's "magma", backwards).
const COLOURS: [(f64, RGBColor); 8] = [
    (1.0, RGBColor(252, 253, 191)),
    (1.5, RGBColor(254, 194, 140)),
    (2.0, RGBColor(252, 137, 97)),
    (2.5, RGBColor(231, 82, 99)),
    (3.0, RGBColor(183, 55, 121)),
    (4.0, RGBColor(130, 37, 129)),
    (5.0, RGBColor(81, 18, 124)),
    (6.0, RGBColor(29, 17, 71)),
];

/// The powers of ten by which two motions have parted.
fn parted(a: &State<2>, b: &State<2>) -> f64 {
    let distance = |x: &[f64; 2], y: &[f64; 2]| (x[0] - y[0]).powi(2) + (x[1] - y[1]).powi(2);
    ((distance(&a.q, &b.q) + distance(&a.v, &b.v)).sqrt() / APART).log10()
}

fn main() -> Drawn {
    let cells = cells();

    let clock = Instant::now();
    let run = Ensemble::of(2 * cells.len())
        .law(|_| HenonHeiles { lambda: 1.0 })
        .start(|k| start(&cells, k))
        .scheme(Nystrom::order6())
        .dt(0.1)
        .look_every(100)
        .run_until(END)?;
    print!("{run}");
    println!("{:.2} s, checksum {:016x}", clock.elapsed().as_secs_f64(), run.checksum());

    let mut map = vec![None; SIDE * SIDE];
    for (i, (column, row, _)) in cells.iter().enumerate() {
        map[row * SIDE + column] = Some(parted(&run.last(2 * i)?, &run.last(2 * i + 1)?));
    }
    let chaotic = map.iter().flatten().filter(|&&powers| powers > 4.0).count();
    println!(
        "{:.0} of 100 motions have parted by more than four powers of ten",
        100.0 * chaotic as f64 / cells.len() as f64
    );

    let path = picture::save("sweep.svg", [880, 640], |area| {
        let title = "Hénon and Heiles at E = 1/8: by how much neighbours part until t = 200";
        let (x, y) = (
            Axis::linear("y at the start (dimensionless)", Y[0]..Y[1]),
            Axis::linear("velocity of y at the start (dimensionless)", V[0]..V[1]),
        );
        let mut chart = picture::chart(area, title, x, y, 170)?;
        let colour = |powers: Option<f64>| {
            powers.map(|powers| COLOURS.iter().rposition(|&(from, _)| powers >= from).unwrap_or_default())
        };
        let edge = |range: [f64; 2], i: usize| range[0] + (range[1] - range[0]) * i as f64 / SIDE as f64;
        for row in 0..SIDE {
            // Cells of one colour beside each other are one rectangle.
            let mut column = 0;
            while column < SIDE {
                let first = colour(map[row * SIDE + column]);
                let same = (column..SIDE).take_while(|&other| colour(map[row * SIDE + other]) == first).count();
                if let Some(which) = first {
                    let corners = [(edge(Y, column), edge(V, row)), (edge(Y, column + same), edge(V, row + 1))];
                    chart.draw_series([Rectangle::new(corners, COLOURS[which].1.filled())])?;
                }
                column += same;
            }
        }
        picture::label(&chart, (Y[1], V[1]), (12, 12), "parted by", INK)?;
        for (i, (from, shade)) in COLOURS.iter().enumerate() {
            let top = V[1] - 0.06 - 0.045 * i as f64;
            let words = match i {
                0 => format!("less than {}", power("10", COLOURS[1].0)),
                _ => format!("{} and more", power("10", from)),
            };
            picture::label(&chart, (Y[1], top), (12, 0), "\u{25a0}", *shade)?;
            picture::label(&chart, (Y[1], top), (26, 0), &words, INK)?;
        }
        Ok(())
    })?;
    println!("Picture: {}", path.display());
    Ok(())
}
