"""Interceptions and chances to score."""

import unittest

import numpy as np

import football_physics as fp
from stand_ins import DataFrame, VerticalOrientation, tracking_dataset

GOAL = {"goals": [{"center": [0, 0, -20], "facing": [0, 0, 1]}]}
PLACES = np.array([[6.0, 0.0, -8.0], [-4.0, 0.0, -16.0]])


def kicked():
    balls = fp.Balls(fp.Scene(), 2)
    balls.kick(None, [[0, 0, 0], [2, 6, -14]], [[0, 0, 0], [0, 20, 0]])
    return balls


class Interceptions(unittest.TestCase):
    def test_the_first_player_is_just_in_time(self):
        balls = kicked()
        before = balls.state
        first = fp.intercept(balls, PLACES, ball=1)
        self.assertEqual((before, 1), (balls.state, first.player))
        # A standing player reacts for 0.2 s, accelerates by 6 m/s^2 to at most 8 m/s, and reaches 0.6 m.
        running = first.time - 0.2
        self.assertLess(running, 8 / 6)
        distance = np.hypot(*(first.position - PLACES[1])[[0, 2]])
        self.assertAlmostEqual(0.5 * 6 * running**2 + 0.6, distance, 6)
        balls.step(first.time / 100, 100)
        np.testing.assert_allclose(balls.position[1], first.position, atol=1e-4)
        np.testing.assert_allclose(balls.velocity[1], first.velocity, atol=1e-3)

    def test_windows_start_with_the_arrivals(self):
        windows = fp.intercept_windows(kicked(), PLACES, ball=1)
        first = fp.intercept(kicked(), PLACES, ball=1)
        self.assertEqual([0, 1], windows["player"].tolist())
        self.assertEqual(first.time, windows["start"][1])
        self.assertAlmostEqual(first.margin, windows["start"][0] - windows["start"][1], 9)
        self.assertTrue((windows["end"] > windows["start"]).all())

    def test_nobody_is_none_and_a_slow_player_is_late(self):
        self.assertIsNone(fp.intercept(kicked(), [], ball=1))
        self.assertEqual(0, len(fp.intercept_windows(kicked(), [], ball=1)))
        self.assertIsNone(fp.intercept(kicked(), fp.Players(PLACES, speed=0.1), seconds=2, ball=1))
        found = fp.intercept(kicked(), fp.Players(PLACES, speed=[8, 0.1]), ball=1)
        self.assertEqual((0, True), (found.player, np.isinf(fp.intercept(kicked(), PLACES[:1], ball=1).margin)))

    def test_data_frames_and_tracking_data_are_the_same_players(self):
        first = fp.intercept(kicked(), PLACES, ball=1)
        x, z = PLACES[:, 0], PLACES[:, 2]
        for orientation in VerticalOrientation:
            frame = tracking_dataset([[0, 0, 0, 0]], list(zip(x, z)), orientation=orientation).records[0]
            self.assertEqual(first.time, fp.intercept(kicked(), frame, ball=1).time)
        self.assertEqual(first.time, fp.intercept(kicked(), DataFrame({"x": x, "y": -z}), ball=1).time)
        moving = fp.intercept(kicked(), DataFrame({"x": x, "y": -z, "vx": [0, 5], "vy": [0, -1]}), ball=1)
        self.assertEqual(fp.intercept(kicked(), fp.Players(PLACES, [[0, 0, 0], [5, 0, 1]]), ball=1).time, moving.time)
        self.assertLess(moving.time, first.time)

    def test_the_balls_of_a_match_are_intercepted_in_a_scene_without_bodies(self):
        with fp.Match({"bodies": [{"shape": "sphere", "center": [0, 0, 0], "radius": 1}]}) as match:
            match.move_bodies([30, 0, 30])
            match.kick(0, [2, 6, -14], [0, 20, 0])
            match.step()
            found = fp.intercept(match.balls_in(fp.Scene()), PLACES)
        self.assertEqual(1, found.player)

    def test_wrong_arguments_are_refused(self):
        balls = kicked()
        for sentence, call in [
            ("ball is 2; allowed: 0 ... 1", lambda: fp.intercept(balls, PLACES, ball=2)),
            ("ball is -1", lambda: fp.intercept_windows(balls, PLACES, ball=-1)),
            ("seconds is 0", lambda: fp.intercept(balls, PLACES, seconds=0)),
            ("position has shape", lambda: fp.Players([1, 2])),
            ("speed has shape", lambda: fp.Players(PLACES, speed=[1, 2, 3])),
            ("heights has shape", lambda: fp.Players(PLACES, heights=2)),
            ("the columns are a", lambda: fp.Players(DataFrame({"a": [1]}))),
            ("acceleration is -1", lambda: fp.intercept(balls, fp.Players(PLACES, acceleration=-1))),
            ("keeper has 2 players", lambda: fp.goal_chance(fp.Scene(GOAL), [0, 0, 0], [0, 4, -24], keeper=fp.Players(PLACES))),
            ("velocity has shape", lambda: fp.goal_chance(fp.Scene(GOAL), [0, 0, 0], [0, 4])),
            ("goal is 0", lambda: fp.goal_chance(fp.Scene(), [0, 0, 0], [0, 4, -24])),
            ("kicks is 1", lambda: fp.goal_chance(fp.Scene(GOAL), [0, 0, 0], [0, 4, -24], kicks=1)),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                call()


class Chances(unittest.TestCase):
    def test_the_share_on_target_is_that_of_kicks_in_numpy(self):
        n, degrees = 400, 6.0
        scene, velocity = fp.Scene(GOAL), np.array([1.0, 4.0, -24.0])
        found = fp.goal_chance(scene, [0, 0.11, 0], velocity, spread={"azimuthDegrees": degrees, "speedPercent": 0, "elevationDegrees": 0, "spinPercent": 0}, kicks=2000)
        turn = np.radians(np.random.default_rng(2).normal(0, degrees, n))
        kicks = np.stack([velocity[0] * np.cos(turn) + velocity[2] * np.sin(turn), np.full(n, velocity[1]), velocity[2] * np.cos(turn) - velocity[0] * np.sin(turn)], 1)
        balls = fp.Balls(scene, n)
        balls.kick(None, kicks)
        scored = np.zeros(n, bool)
        for _ in range(15):
            events = balls.step_events(0.1)
            scored[events["ball"][events["kind"] == fp.EventKind.GOAL]] = True
        share = scored.mean()
        self.assertTrue(0.3 < share < 0.98)
        self.assertLess(abs(found.on_target - share), 4 * np.sqrt(share * (1 - share) * (1 / n + 1 / 2000)))
        self.assertEqual((0.0, found.on_target), (found.covered, found.scores))

    def test_a_keeper_covers_a_part(self):
        keeper = fp.Players([0, 0, -19.5], reach=1, heights=[0, 2.7])
        alone, kept = (
            fp.goal_chance(fp.Scene(GOAL), [0, 0.11, 0], [2, 4, -24], keeper=k, spread={"azimuthDegrees": 2}, kicks=500) for k in (None, keeper))
        self.assertAlmostEqual(kept.on_target, kept.scores + kept.covered, 9)
        self.assertLess(kept.scores, alone.scores)
        self.assertTrue(0 < kept.time < 2 and kept.crosses == 1)


if __name__ == "__main__":
    unittest.main()
