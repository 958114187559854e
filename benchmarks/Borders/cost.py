"""Measures the cost of a step from Python: the kick of cost.c, with one ball, and with 4 096 at once and updated arrays."""

import time

import numpy as np

import football_physics as fp


def least(balls, steps, rounds):
    saved, best = balls.state, float("inf")
    for _ in range(rounds):
        balls.state = saved
        start = time.perf_counter()
        for _ in range(steps):
            balls.step(0.01)
        best = min(best, time.perf_counter() - start)
    return 1e9 * best / steps


one = fp.Balls(fp.Scene(), 1, (0, 1, 0))
one.kick(None, (3, 9, -24), (0, 40, 0))
call = least(one, 20, 3000)
many = fp.Balls(fp.Scene(), 4096, (0, 1, 0))
many.kick(None, np.random.default_rng(1).uniform([-3, 8, -26], [3, 10, -22], (4096, 3)), (0, 40, 0))
batch = least(many, 2, 300)
print(f"| Python, `Balls.step`, one ball | {call:.0f} |")
print(f"| Python, `Balls.step`, 4 096 balls, a ball | {batch / 4096:.1f} |")
position = many.position
read = float("inf")
for _ in range(200):
    start = time.perf_counter()
    for _ in range(1000):
        position = many.position
    read = min(read, (time.perf_counter() - start) * 1e6)
print(f"| Python, reading `position` of 4 096 balls | {read:.0f} |")
print(f"\nPython, 4 096 balls: {4096e3 / batch:.1f} million steps per second on one core")
