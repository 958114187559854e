"""The live filter, from numpy rows and from a stream."""

import pathlib
import unittest

import numpy as np

import football_physics as fp

NOISE, INTERVAL = 0.01, 0.02
HASHES = pathlib.Path(__file__).parents[1] / "Native" / "follow.txt"
MASK = (1 << 64) - 1
CAMERAS = ([1500, 0, -960, 38400, 0, -1500, -540, 36600, 0, 0, -1, 40], [-960, 0, -1500, 38400, -540, -1500, 0, 36600, -1, 0, 0, 40])
KICKS = {40: ((18.0, 9.0, 3.0), (10.0, 20.0, -15.0)), 170: ((-12.0, 5.0, 4.0), (0.0, 30.0, 0.0)), 300: ((6.0, 0.5, -14.0), (-20.0, 0.0, 10.0))}


def mix(value, words):
    for word in words:
        value = ((value ^ int(word)) * 0x9E3779B97F4A7C15) & MASK
        value ^= value >> 29
    return value


def draws(seed):
    """SplitMix64, as in follow.c."""
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & MASK
        z = ((seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        yield ((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0)


def golden_points():
    """The noisy positions of follow.c, by the same arithmetic."""
    balls, drawn, points = fp.Balls(fp.Scene(), 1), draws(7), []
    balls.place(None, (1.0, 0.0, 2.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    for i in range(400):
        if i in KICKS:
            balls.kick(None, *KICKS[i])
        point = []
        for axis in range(3):
            total = -6.0
            for _ in range(12):
                total += next(drawn)
            point.append(float(balls.position[0][axis]) + 0.02 * total)
        if i % 37 == 36:
            point[0] += 3
        points.append(point)
        balls.step(0.02)
    return points


def golden_lines():
    points = golden_points()
    for kind in ("position", "plan", "pixel"):
        ball, value, held = fp.BallFilter(), 0, None

        def deliver(at, value):
            x, y, z = points[at]
            if kind != "pixel":
                return mix(value, np.frombuffer(ball.update([[at * 0.02, x, y if kind == "position" else np.nan, z]]).tobytes(), np.uint64))
            for m in CAMERAS:
                a, b, w = (m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z + m[4 * row + 3] for row in range(3))
                value = mix(value, np.frombuffer(ball.update_pixel(at * 0.02, m, a / w, b / w).tobytes(), np.uint64))
            return value

        for i in range(400):
            if 220 <= i < 235:
                pass
            elif i % 29 == 28:
                held = i
            else:
                value = deliver(i, value)
                if held is not None:
                    value = deliver(held, value)
                held = None
            if i % 100 == 99:
                yield f"{kind} {i + 1} {value:016x}"
        yield f"{kind} ahead {mix(0, np.frombuffer(ball.look_ahead(1.0, 0.1).tobytes(), np.uint64)):016x}"
        yield f"{kind} saved {mix(len(ball.state), ball.state):016x}"


def track(seconds=2.0):
    """A ball at rest that is kicked after half a second: the points and the true rows."""
    balls = fp.Balls(fp.Scene(), 1)
    points, truth = [], []
    for i in range(int(seconds / INTERVAL)):
        if i == 25:
            balls.kick(None, [18.0, 9.0, 3.0], [10.0, 20.0, -15.0])
        truth.append([*balls.position[0], *balls.velocity[0]])
        points.append([i * INTERVAL, *balls.position[0]])
        balls.step(INTERVAL)
    points = np.array(points)
    points[:, 1:] += np.random.default_rng(3).normal(0, NOISE, (len(points), 3))
    return points, np.array(truth)


class Filters(unittest.TestCase):
    def test_a_kick_is_found_and_rows_equal_a_stream(self):
        points, truth = track()
        found = fp.BallFilter(noise=NOISE).update(points)
        self.assertEqual(len(points), len(found))
        kicks = found[found["has_kick"] == 1]
        self.assertGreater(len(kicks), 5)
        self.assertAlmostEqual(0.5, kicks[0]["kick_time"], delta=0.021)
        late = slice(40, None)
        off = np.linalg.norm(found["velocity"][late] - truth[late, 3:], axis=1)
        self.assertTrue((off < 5 * 3 ** 0.5 * found["deviations"][late, 1]).all())
        stream = fp.BallFilter(noise=NOISE)
        for one, many in zip(stream.follow(iter(points.tolist())), found):
            self.assertEqual(one.tobytes(), many.tobytes())

    def test_three_streams_have_the_hashes_of_csharp(self):
        self.assertEqual(HASHES.read_text().splitlines(), list(golden_lines()))

    def test_a_restored_filter_gives_the_same_bits(self):
        points, _ = track()
        one, two = fp.BallFilter(noise=NOISE), fp.BallFilter(noise=NOISE)
        one.update(points[:40])
        two.state = one.state
        self.assertEqual(one.update(points[40:]).tobytes(), two.update(points[40:]).tobytes())
        self.assertEqual(one.state, two.state)
        with self.assertRaisesRegex(ValueError, "settings"):
            fp.BallFilter(noise=0.5).state = one.state
        with self.assertRaisesRegex(ValueError, "Save"):
            two.state = b"x" * 100

    def test_the_path_ahead_has_a_deviation(self):
        points, truth = track()
        ball = fp.BallFilter(noise=NOISE)
        ball.update(points[:60])
        path = ball.look_ahead(0.5)
        self.assertEqual((26, 5), path.shape)
        self.assertLess(np.linalg.norm(path[25, 1:4] - truth[84, :3]), 5 * 3 ** 0.5 * path[25, 4])
        self.assertGreater(path[25, 4], path[0, 4])

    def test_bad_input_is_named(self):
        ball = fp.BallFilter()
        for rows, name in (([[np.nan, 0, 1, 0]], "time"), ([[0, 1e9, 1, 0]], "position"), ([[0, 0, 1]], "rows")):
            with self.assertRaisesRegex(ValueError, name):
                ball.update(rows)
        with self.assertRaisesRegex(ValueError, "deviation"):
            ball.update([[0, 0, 1, 0]], 0)
        with self.assertRaisesRegex(ValueError, "nois"):
            fp.BallFilter(nois=1)
        with self.assertRaises(ValueError):
            ball.look_ahead(1)


if __name__ == "__main__":
    unittest.main()
