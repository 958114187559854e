"""The live filter, from numpy rows and from a stream."""

import unittest

import numpy as np

import football_physics as fp

NOISE, INTERVAL = 0.01, 0.02


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
