"""heyoka on the motions of the benches `peers` and `outer_ss`, one run for each line that it is sent.

The bench starts this program where a Python with heyoka is found (`pip install heyoka`), and keeps it: a line

    motion tolerance options end q… v…

is answered by `ok seconds steps order q… v…`, all of the state at the end, or by `no` and a cause. Options are names joined by
commas, or a dash. What is timed is `propagate_until` alone, whose loop is compiled: an integrator is made and compiled at
the first run of its motion and tolerance, and kept.
"""

import sys
import time

import heyoka


def planet():
    x, y, u, v = heyoka.make_vars("x", "y", "u", "v")
    c = (x * x + y * y) ** -1.5
    return [(x, u), (y, v), (u, -c * x), (v, -c * y)]


def swing():
    x, v = heyoka.make_vars("x", "v")
    return [(x, v), (v, -heyoka.sin(x))]


def eight():
    """Three bodies of mass 1, each pair once."""
    q = [heyoka.make_vars(f"q{i}") for i in range(6)]
    v = [heyoka.make_vars(f"v{i}") for i in range(6)]
    a = [[] for _ in range(6)]
    for i, j in ((0, 2), (0, 4), (2, 4)):
        x, y = q[j] - q[i], q[j + 1] - q[i + 1]
        c = (x * x + y * y) ** -1.5
        for k, d in ((0, x), (1, y)):
            a[i + k].append(c * d)
            a[j + k].append(-(c * d))
    return list(zip(q, v)) + [(v[i], a[i][0] + a[i][1]) for i in range(6)]


def chain(beta=0.3):
    """64 masses between fixed ends."""
    q = [heyoka.make_vars(f"q{i}") for i in range(64)]
    v = [heyoka.make_vars(f"v{i}") for i in range(64)]
    longer = [q[0]] + [q[i + 1] - q[i] for i in range(63)] + [-q[63]]
    pull = [r * (1.0 + beta * (r * r)) for r in longer]
    return list(zip(q, v)) + [(v[i], pull[i + 1] - pull[i]) for i in range(64)]


def outer_ss():
    """As heyoka's own benchmark has it, but for the order: first all positions."""
    masses = [1.00000597682, 1 / 1047.355, 1 / 3501.6, 1 / 22869.0, 1 / 19314.0, 7.4074074e-09]
    g = 0.01720209895 * 0.01720209895 * 365 * 365
    system = heyoka.model.nbody(6, masses=masses, Gconst=g)
    return [system[6 * i + k] for i in range(6) for k in range(3)] + [
        system[6 * i + 3 + k] for i in range(6) for k in range(3)
    ]


MOTIONS = {"orbit": planet, "eccentric": planet, "pendulum": swing, "eight": eight, "fput": chain, "outer_ss": outer_ss}
OPTIONS = ("fast_math", "slp_vectorize", "compact_mode", "high_accuracy")
kept = {}


def run(words):
    motion, tolerance, options, end, *start = words
    start = [float(x) for x in start]
    key = (MOTIONS[motion], tolerance, options)
    if key not in kept:
        chosen = {name: True for name in options.split(",") if name in OPTIONS}
        kept[key] = heyoka.taylor_adaptive(MOTIONS[motion](), start, tol=float(tolerance), **chosen)
    solver, end = kept[key], float(end)
    solver.time = 0.0
    solver.state[:] = start
    clock = time.perf_counter()
    outcome, _, _, steps, *_ = solver.propagate_until(end)
    seconds = time.perf_counter() - clock
    if outcome != heyoka.taylor_outcome.time_limit:
        raise RuntimeError(f"stopped at t = {solver.time}: {outcome}")
    state = " ".join(repr(float(x)) for x in solver.state)
    return f"ok {seconds!r} {steps} {solver.order} {state}"


print("heyoka", heyoka.__version__, flush=True)
for line in sys.stdin:
    try:
        answer = run(line.split())
    except Exception as cause:
        answer = "no " + " ".join(str(cause).split())
    print(answer, flush=True)
