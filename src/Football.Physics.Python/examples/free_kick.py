"""A small network learns free kicks over a wall, with numpy alone: from where the ball is to go, to the kick. Its gradient is the flight's own, by derivatives of the launch.

    python3 free_kick.py [STEPS]        prints the loss, plays what was learnt with a wall and a goal, and draws free_kick.svg
"""

import sys
import time

import numpy as np

import football_physics as fp

GOAL, WALL, WALL_HEIGHT = 22.0, 9.15, 1.85
STEPS = int(sys.argv[1]) if len(sys.argv) > 1 else 250
BATCH, HIDDEN, RATE = 48, 24, 0.02
random = np.random.default_rng(1)


def targets(n):
    """Corners of the goal and what is between: x, y."""
    return np.stack([random.uniform(-3.2, 3.2, n), random.uniform(0.4, 2.1, n)], 1)


# The kick: what the network says is added to one that gets over the wall. Velocity, m/s, and sidespin.
MIDDLE, SIZE = np.array([0.0, 8.0, -22.0, 0.0]), np.array([5.0, 3.0, 4.0, 60.0])
weights = [random.normal(0, 0.5, (2, HIDDEN)), np.zeros(HIDDEN), random.normal(0, 0.1, (HIDDEN, 4)), np.zeros(4)]


def network(to):
    hidden = np.tanh((to / 2) @ weights[0] + weights[1])
    return hidden, MIDDLE + SIZE * (hidden @ weights[2] + weights[3])


def crossing(balls, path, distance):
    """Where the balls cross a plane, (x, y), and its derivatives by velocity and sidespin, (n, 2, 4)."""
    z = path[:, :, 3]
    row = np.argmax(z < -distance, 1)
    row[row == 0] = path.shape[1] - 1
    ball = np.arange(len(path))
    share = (z[ball, row - 1] + distance) / (z[ball, row - 1] - z[ball, row])
    when = path[ball, row - 1, 0] + np.clip(share, 0, 1) * (path[ball, row, 0] - path[ball, row - 1, 0]) - path[:, 0, 0]
    saved = balls.state
    d = balls.derivatives(when, dt=1 / 60)
    at, v = balls.position.copy(), balls.velocity.copy()
    balls.state = saved
    moved = np.concatenate([d.position_by_velocity, d.position_by_spin[:, :, 1:2]], 2)
    # A launch that is later at the plane crosses it elsewhere: without the motion along the path. The same takes the last of the way to it.
    late = (at[:, 2] + distance) / v[:, 2]
    at -= late[:, None] * v
    moved -= v[:, :, None] * (moved[:, 2:3, :] / v[:, 2][:, None, None])
    return at[:, :2], moved[:, :2, :]


def loss_and_gradient(balls, to):
    hidden, kick = network(to)
    spin = np.zeros((len(to), 3))
    spin[:, 1] = kick[:, 3]
    balls.place(None, (0, 0, 0), kick[:, :3], spin)
    path = balls.look_ahead(2.0, 1 / 60)
    at_goal, by_goal = crossing(balls, path, GOAL)
    at_wall, by_wall = crossing(balls, path, WALL)
    off = at_goal - to
    low = np.maximum(0, WALL_HEIGHT + 0.25 - at_wall[:, 1])
    loss = np.mean(np.sum(off**2, 1) + 4 * low**2)
    by_kick = (2 * np.einsum("ni,nij->nj", off, by_goal) - 8 * low[:, None] * by_wall[:, 1, :]) * SIZE / len(to)
    # Back through the network.
    into = (by_kick @ weights[2].T) * (1 - hidden**2)
    return loss, [(to / 2).T @ into, into.sum(0), hidden.T @ by_kick, by_kick.sum(0)], at_goal


start = time.perf_counter()
balls = fp.Balls(fp.Scene(), BATCH)
mean, square = [np.zeros_like(w) for w in weights], [np.zeros_like(w) for w in weights]
for step in range(1, STEPS + 1):
    loss, gradient, _ = loss_and_gradient(balls, targets(BATCH))
    for i, g in enumerate(gradient):
        mean[i] = 0.9 * mean[i] + 0.1 * g
        square[i] = 0.99 * square[i] + 0.01 * g * g
        weights[i] -= RATE * (1 - step / (STEPS + 1)) * (mean[i] / (1 - 0.9**step)) / (np.sqrt(square[i] / (1 - 0.99**step)) + 1e-8)
    if step in (1, 10, 30, 100) or step == STEPS:
        print(f"step {step:4d}: loss {loss:9.4f} m^2")

# What was learnt, where there is a wall, and a goal that tells.
pitch = fp.Scene({
    "goals": [{"center": [0, 0, -GOAL], "facing": [0, 0, 1]}],
    "obstacles": [{"name": "wall", "shape": "box", "center": [0, WALL_HEIGHT / 2, -WALL], "halfSize": [1.25, WALL_HEIGHT / 2, 0.2]}]})
played = fp.Balls(pitch, 100)
to = targets(100)
kick = network(to)[1]
played.place(None, (0, 0, 0), kick[:, :3], np.stack([np.zeros(100), kick[:, 3], np.zeros(100)], 1))
goals = sum(len(events[events["kind"] == fp.EventKind.GOAL]) for events in (played.step_events(1 / 60) for _ in range(150)))
test = fp.Balls(fp.Scene(), 100)
_, _, at = loss_and_gradient(test, to)
print(f"{goals} goals of 100 over the wall; {np.median(np.hypot(*(at - to).T)):.3f} m off, the middle one; {time.perf_counter() - start:.1f} s")

lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-420 -300 840 330"><rect x="-366" y="-244" width="732" height="244" fill="none" stroke="#333" stroke-width="12"/>']
for (x, y), (u, v) in zip(to * 100, at * 100):
    lines.append(f'<line x1="{x:.1f}" y1="{-y:.1f}" x2="{u:.1f}" y2="{-v:.1f}" stroke="#c33"/><circle cx="{x:.1f}" cy="{-y:.1f}" r="3"/><circle cx="{u:.1f}" cy="{-v:.1f}" r="11" fill="none" stroke="#36c"/>')
with open("free_kick.svg", "w", encoding="utf-8") as file:
    file.write("\n".join(lines) + "\n</svg>\n")
