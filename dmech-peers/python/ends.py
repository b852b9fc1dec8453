"""Where the five motions end, to all digits: prints the numbers of src/ends.rs.

The starts are the f64 that the programs start from, taken as exact. Kepler's motion and the pendulum in closed form, with 40
digits of mpmath; the figure-eight and the chain by heyoka's Taylor series in mpfr numbers of 113 and of 160 bits, whose
results agree to 30 digits.

    pip install heyoka mpmath && python ends.py
"""

import math

import heyoka
import mpmath
from mpmath import mpf

mpmath.mp.dps = 40


def planet(q, v, end):
    """From an apsis on the x axis with velocity along y."""
    q, v, end = mpf(q), mpf(v), mpf(end)
    axis = 1 / (2 / abs(q) - v * v)
    eccentricity = abs(1 - abs(q) / axis)
    mean = end / axis ** mpf(1.5) + (0 if abs(q) < axis else mpmath.pi)
    mean = mpmath.fmod(mean, 2 * mpmath.pi)
    # Pericentre on the side of positive x in both motions.
    anomaly = mpmath.findroot(lambda x: x - eccentricity * mpmath.sin(x) - mean, mean)
    short = axis * mpmath.sqrt(1 - eccentricity**2)
    return [axis * (mpmath.cos(anomaly) - eccentricity), short * mpmath.sin(anomaly)]


def pendulum(angle, end):
    k = mpmath.sin(mpf(angle) / 2)
    quarter = mpmath.ellipk(k * k)
    return [2 * mpmath.asin(k * mpmath.ellipfun("sn", quarter - mpf(end), m=k * k))]


def by_series(system, start, end, positions):
    """The end in mpfr numbers of two precisions, which must agree."""
    ends = []
    for bits in (113, 160):
        real = lambda x: heyoka.real(x, bits)
        solver = heyoka.taylor_adaptive(system(real), [real(x) for x in start], fp_type=heyoka.real, compact_mode=True)
        solver.propagate_until(real(end))
        ends.append([mpf(str(solver.state[i])) for i in positions])
    assert max(abs(a - b) for a, b in zip(*ends)) < mpf("1e-25"), "two precisions disagree"
    return ends[1]


def eight(_):
    bodies = [heyoka.make_vars(*(f"{name}{i}" for name in "xyuv")) for i in range(3)]
    system = []
    for x, y, u, v in bodies:
        pull = [0.0, 0.0]
        for other in bodies:
            if other[0] != x:
                d = [other[0] - x, other[1] - y]
                c = (d[0] * d[0] + d[1] * d[1]) ** -1.5
                pull = [pull[0] + c * d[0], pull[1] + c * d[1]]
        system += [(x, u), (y, v), (u, pull[0]), (v, pull[1])]
    return system


def chain(real):
    q = [heyoka.make_vars(f"q{i}") for i in range(64)]
    v = [heyoka.make_vars(f"v{i}") for i in range(64)]
    longer = [q[0]] + [q[i + 1] - q[i] for i in range(63)] + [-q[63]]
    pull = [r + real(0.3) * r * r * r for r in longer]
    return list(zip(q, v)) + [(v[i], pull[i + 1] - pull[i]) for i in range(64)]


def show(name, numbers):
    print(name)
    for x in numbers:
        print(f"    {mpmath.nstr(x, 22, strip_zeros=False)}  f64 {float(x)!r}")


show("orbit", planet(0.5, 1.63, 350.0))
show("eccentric", planet(-1.9, -math.sqrt(0.1 / 1.9), 200.0 * math.pi))
show("pendulum", pendulum(math.pi / 4, 100.0))
half = (0.5 * 0.93240737, 0.5 * 0.86473146)
start = [0.97000436, -0.24308753, *half, -0.97000436, 0.24308753, *half, 0.0, 0.0, -0.93240737, -0.86473146]
show("eight", by_series(eight, start, 100.0, [0, 1, 4, 5, 8, 9]))
start = [10.0 * math.sin(math.pi * (j + 1) / 65.0) for j in range(64)] + [0.0] * 64
show("fput", by_series(chain, start, 1000.0, range(64)))
