"""heyoka's batch mode on the planets of the bench `batch`, one run of all for each line that it is sent.

The bench starts this program where a Python with heyoka is found (`pip install heyoka`), and keeps it: a line

    multiple tolerance options end gm… x… y… u… v…

is answered by `ok seconds steps order x… y…` of the end, or by `no` and a cause. So many times the recommended number of
planets ride in a batch; options are names joined by commas, or a dash. What is timed is `propagate_until` alone, whose loop is
compiled: an integrator is made and compiled at the first run with its options, and kept.
"""

import sys
import time

import heyoka
import numpy

OPTIONS = ("fast_math", "high_accuracy")
kept = {}


def planet():
    x, y, u, v = heyoka.make_vars("x", "y", "u", "v")
    c = heyoka.par[0] * (x * x + y * y) ** -1.5
    return [(x, u), (y, v), (u, -c * x), (v, -c * y)]


def run(words):
    multiple, tolerance, options, end, *numbers = words
    batch, end = int(multiple) * heyoka.recommended_simd_size(), float(end)
    gm, *states = numpy.array(numbers, dtype=float).reshape(5, -1)
    states = numpy.array(states)
    if gm.size % batch:
        raise ValueError(f"{gm.size} planets in batches of {batch}")
    key = (batch, tolerance, options)
    if key not in kept:
        chosen = {name: True for name in options.split(",") if name in OPTIONS}
        start, pars = numpy.ones((4, batch)), numpy.ones((1, batch))
        kept[key] = heyoka.taylor_adaptive_batch(planet(), start, pars=pars, tol=float(tolerance), **chosen)
    solver = kept[key]
    ends, seconds, steps = numpy.empty((2, gm.size)), 0.0, 0
    for first in range(0, gm.size, batch):
        group = slice(first, first + batch)
        solver.set_time(0.0)
        solver.state[:] = states[:, group]
        solver.pars[:] = gm[group]
        clock = time.perf_counter()
        solver.propagate_until(end)
        seconds += time.perf_counter() - clock
        for outcome, _, _, made in solver.propagate_res:
            if outcome != heyoka.taylor_outcome.time_limit:
                raise RuntimeError(f"stopped: {outcome}")
            steps += made
        ends[:, group] = solver.state[:2]
    places = " ".join(repr(float(x)) for x in ends.ravel())
    return f"ok {seconds!r} {steps} {solver.order} {places}"


print(f"heyoka {heyoka.__version__}, batches of {heyoka.recommended_simd_size()} and more", flush=True)
for line in sys.stdin:
    try:
        answer = run(line.split())
    except Exception as cause:
        answer = "no " + " ".join(str(cause).split())
    print(answer, flush=True)
