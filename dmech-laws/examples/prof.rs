use dmech_laws::*;
use std::time::*;
fn main() {
    let n = 1000;
    let (mut t, mut sizes) = ([Duration::ZERO; 4], [0usize; 4]);
    let mut worst: Vec<(Duration, u64)> = vec![];
    for k in 0..n {
        let c = Instant::now();
        let mut r = Random::member(2026, k);
        let law = Law::random(&mut r);
        t[0] += c.elapsed();
        let c = Instant::now();
        let e = Engine::new(&law, k % 6 == 0);
        let s = c.elapsed();
        t[1] += s;
        worst.push((s, k));
        let c = Instant::now();
        let p = pairs(&law, &mut r);
        t[2] += c.elapsed();
        let c = Instant::now();
        for (_, a, b) in p { try_pair(&law, &e, &a, &b, true); }
        t[3] += c.elapsed();
    }
    worst.sort(); worst.reverse();
    println!("{t:?} {sizes:?} {:?}", &worst[..20]);
    println!("{:?}", worst[n as usize/2]);
}
