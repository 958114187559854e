"""Fits of tracks, from arrays, data frames and tracking data."""

import datetime
import pickle
import signal
import threading
import unittest

import numpy as np

import football_physics as fp
from stand_ins import DataFrame, Unit, VerticalOrientation, tracking_dataset

VELOCITY, SPIN, NOISE = np.array([3.0, 8.0, -22.0]), np.array([0.0, 40.0, 0.0]), 0.01


def fly(seconds=1.3, noise=NOISE, scene=None, rate=50):
    """A track with 50 rows a second, or another rate."""
    balls = fp.Balls(fp.Scene() if scene is None else scene, 1)
    balls.kick(None, VELOCITY, SPIN)
    rows = []
    for _ in range(int(seconds * rate)):
        rows.append([balls.time[0], *balls.position[0]])
        balls.step(1 / rate)
    rows = np.array(rows)
    rows[:, 1:] += np.random.default_rng(3).normal(0, noise, (len(rows), 3))
    return rows


def frame_of(rows, names=("t", "x", "y", "z"), time=lambda t: t):
    t, x, y, z = rows.T
    return DataFrame(zip((*names, "speed"), ([time(value) for value in t], x, -z, y, np.zeros(len(t)))))


def long_track(minutes):
    """A ball that is kicked every three seconds, 50 rows a second."""
    rows = []
    flight = fly(3, 0.01)
    for i in range(20 * minutes):
        rows.append(flight + [3 * i, 0, 0, 0])
    return np.vstack(rows)


class Tracks(unittest.TestCase):
    def test_every_source_gives_the_same_rows(self):
        rows = fly()
        for source in (
            rows.tolist(), frame_of(rows), frame_of(rows, ("timestamp", "ball_x", "ball_y", "ball_z"), lambda t: np.timedelta64(round(t * 1e6), "us")),
            tracking_dataset(rows), tracking_dataset(rows, unit=Unit.CENTIMETERS, orientation=VerticalOrientation.TOP_TO_BOTTOM)):
            np.testing.assert_allclose(fp.track(source), rows, atol=2e-6)

    def test_times_come_in_many_forms(self):
        start = datetime.datetime(2026, 1, 1, tzinfo=datetime.timezone.utc)
        for times in (
            [0.5, 3725.25], ["00:00:00.5", "01:02:05.25"], ["2020-06-05T20:29:57.840+02:00", "2020-06-05T19:32:02.590Z"], [datetime.timedelta(seconds=0.5), datetime.timedelta(seconds=3725.25)],
            [start, start + datetime.timedelta(seconds=3724.75)], np.array(["2026-01-01T00:00:00.50", "2026-01-01T01:02:05.25"], "datetime64[ms]")):
            rows = fp.track(DataFrame({"timestamp": times, "x": [1, 2], "y": [0, 0], "z": [0, 0]}))
            self.assertAlmostEqual(3724.75, rows[1, 0] - rows[0, 0], 6)
        named = np.array([(1, 2, 3, 4)], [("t", "f8"), ("x", "f8"), ("y", "f8"), ("z", "f8")])
        np.testing.assert_array_equal([[1, 2, 4, -3]], fp.track(named))

    def test_a_track_is_a_copy(self):
        rows = fly()
        before = rows.copy()
        fp.track(rows)[:] = 0
        np.testing.assert_array_equal(before, rows)

    def test_rows_without_a_ball_are_left_out_and_a_second_half_follows(self):
        rows = np.array([[0, 1, 2, 3], [1, np.nan, np.nan, np.nan], [2, 4, 5, 6], [0, 7, 8, 9], [1, 1, 1, 1]], float)
        expected = np.array([[0, 1, 2, 3], [2, 4, 5, 6], [62, 7, 8, 9], [63, 1, 1, 1]], float)
        missing = type("NAType", (), {})()
        for source in (rows, tracking_dataset(rows), *(DataFrame({"time": [0, 1, 2, 0, 1], "x": [1, none, 4, 7, 1], "y": [-3, None, -6, -9, -1], "z": [2, None, 5, 8, 1]}) for none in (None, np.nan, missing))):
            np.testing.assert_array_equal(expected, fp.track(source))

    def test_sources_without_a_meaning_are_refused(self):
        flat = tracking_dataset(fly())
        for record in flat.records:
            record.ball_coordinates = record.ball_coordinates.__class__(1.0, 2.0, None)
        for sentence, source in [
            (r"the track has shape \(5, 3\)", np.zeros((5, 3))),
            ("the columns are t, x", DataFrame({"t": [0], "x": [0]})),
            ("the column x has a value that is no number", DataFrame({"t": [0], "x": ["left"], "y": [0], "z": [0]})),
            ("the unit of the tracking data is 'normed'; allowed: m ", tracking_dataset(fly(), unit=Unit.NORMED)),
            ("no height of the ball", flat),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                fp.track(source)


class Fits(unittest.TestCase):
    def test_a_fit_finds_the_launch_within_its_errors(self):
        rows = fly()
        for source in (rows, tracking_dataset(rows, unit=Unit.CENTIMETERS, orientation=VerticalOrientation.TOP_TO_BOTTOM)):
            found = fp.fit(fp.Scene(), source, NOISE)
            self.assertEqual(fp.FitVerdict.AS_EXPECTED, found.verdict)
            self.assertTrue(found.converged)
            for name, truth in (("velocity", VELOCITY), ("spin", SPIN), ("position", [0, 0.11, 0])):
                off = (getattr(found, name) - truth) / getattr(found, name + "_deviation")
                self.assertLess(np.abs(off).max(), 4, name)
            self.assertLess(found.velocity_deviation.max(), 0.1)
            self.assertTrue(found.spin_identified[1])
            self.assertIn(fp.MatchAnswers.LAUNCHES, found.good_for)
            self.assertEqual(fp.TrackSuspicions.NONE, found.suspicions)
            self.assertEqual((3 * len(rows) - 9, {}), (found.degrees_of_freedom, found.factors))
            # The mean of chi squared is the degrees of freedom, its variance twice that.
            self.assertLess(abs(found.chi_squared - found.degrees_of_freedom), 4 * np.sqrt(2 * found.degrees_of_freedom))

    def test_a_fit_finds_a_factor_of_the_drag(self):
        truth = fp.Scene({"forces": {"drag": "constant", "dragCoefficient": 0.25}})
        guess = fp.Scene({"forces": {"drag": "constant", "dragCoefficient": 0.2}})
        found = fp.fit(guess, fly(scene=truth), NOISE, also=["drag"])
        self.assertLess(abs(found.factors["drag"] - 1.25), 4 * found.factor_deviations["drag"])
        self.assertLess(found.factor_deviations["drag"], 0.05)
        self.assertEqual(["drag"], list(found.factors))

    def test_a_noise_of_each_row_is_a_weight(self):
        rows = fly()
        rows[20, 1:] += 3
        noise = np.full(len(rows), NOISE)
        self.assertEqual(fp.FitVerdict.POOR, fp.fit(fp.Scene(), rows, noise).verdict)
        noise[20] = 10
        self.assertEqual(fp.FitVerdict.AS_EXPECTED, fp.fit(fp.Scene(), rows, noise).verdict)

    def test_a_match_is_divided_at_a_bounce(self):
        found = fp.fit_match(fp.Scene(), fly(2.6), NOISE, free=[])
        kinds = found.pieces["kind"].tolist()
        self.assertEqual([fp.PieceKind.FLIGHT, fp.PieceKind.IMPACT, fp.PieceKind.FLIGHT], kinds[:3])
        self.assertAlmostEqual(1.53, found.pieces["start_time"][1], 2)
        np.testing.assert_allclose(found.pieces["velocity"][0], VELOCITY, atol=0.1)
        self.assertLess(abs(found.noise - NOISE), 0.005)
        self.assertEqual({}, found.values)

    def test_a_match_fit_makes_a_scene_with_its_wind(self):
        windy = fp.Scene({"air": {"wind": [0, 0, 3]}})
        found = fp.fit_match(fp.Scene(), fly(2.6, 0.002, windy), 0.002, free=["wind"])
        self.assertEqual(["wind_x", "wind_z"], list(found.values))
        for name, truth in (("wind_x", 0), ("wind_z", 3)):
            self.assertLess(abs(found.values[name] - truth), 5 * found.deviations[name] + 0.1, name)
        ends = []
        for scene in (windy, found.scene):
            balls = fp.Balls(scene, 1)
            balls.kick(None, VELOCITY, SPIN)
            balls.step(0.02, 60)
            ends.append(balls.position[0].copy())
        self.assertLess(np.linalg.norm(ends[0] - ends[1]), 0.2)
        with self.assertRaisesRegex(TypeError, "a fitted scene has no text"):
            pickle.dumps(found.scene)

    def test_wrong_arguments_are_refused(self):
        rows = fly()
        for sentence, call in [
            ("noise has shape", lambda: fp.fit(fp.Scene(), rows, [0.01, 0.02])),
            ("noise", lambda: fp.fit(fp.Scene(), rows, -1.0)),
            ("also is ", lambda: fp.fit(fp.Scene(), rows, also=["wind"])),
            ("unknown", lambda: fp.fit(fp.Scene(), rows, unknown=1)),
            ("free is ", lambda: fp.fit_match(fp.Scene(), rows, free=["gravity"])),
            ("", lambda: fp.fit(fp.Scene(), rows[:3])),
            ("", lambda: fp.fit(fp.Scene(), rows[::-1][:, [1, 0, 2, 3]])),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                call()


class LongCalls(unittest.TestCase):
    """Without the interruption, the calls would take half a minute or more."""

    def interrupted(self, call):
        """Raises SIGINT while a call runs."""
        told = [0.0]

        def interrupt(value):
            # The signal comes from another thread, once the library works.
            if value > 0 and told[-1] == 0:
                told.append(value)
                thread = threading.Thread(target=signal.raise_signal, args=(signal.SIGINT,))
                thread.start()
                thread.join()

        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            with self.assertRaises(KeyboardInterrupt):
                call(interrupt)
        finally:
            signal.signal(signal.SIGINT, before)
        self.assertTrue(0 < told[-1] < 0.9, told)

    @unittest.skipUnless(hasattr(signal, "raise_signal") and threading.current_thread() is threading.main_thread(), "needs the main thread")
    def test_ctrl_c_ends_a_fit(self):
        track = long_track(60)
        self.interrupted(lambda progress: fp.fit_match(fp.Scene(), track, progress=progress))
        flight = fly(20, 0.01, rate=2500)
        self.interrupted(lambda progress: fp.fit(fp.Scene(), flight, noise=0.01, also=["drag", "lift", "restitution", "friction"], progress=progress))

    @unittest.skipUnless(hasattr(signal, "raise_signal") and threading.current_thread() is threading.main_thread(), "needs the main thread")
    def test_ctrl_c_ends_a_fit_without_a_progress(self):
        track = long_track(60)
        timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                fp.fit_match(fp.Scene(), track)
        finally:
            timer.join()
            signal.signal(signal.SIGINT, before)

    @unittest.skipUnless(hasattr(signal, "raise_signal") and threading.current_thread() is threading.main_thread(), "needs the main thread")
    def test_ctrl_c_ends_a_chance_to_score(self):
        goal = fp.Scene({"goals": [{"center": [0, 0, -20], "facing": [0, 0, 1]}]})
        self.interrupted(lambda progress: fp.goal_chance(goal, [0, 0.11, 0], [2, 4, -24], spread={"azimuthDegrees": 2}, kicks=100_000_000, alwaysSimulate=True, progress=progress))

    @unittest.skipUnless(hasattr(signal, "raise_signal") and threading.current_thread() is threading.main_thread(), "needs the main thread")
    def test_ctrl_c_ends_a_run_of_many_balls_which_are_then_where_they_were(self):
        for call in (lambda balls: balls.step(1 / 60, 1_000_000), lambda balls: balls.until_rest(1e-5, 1000)):
            balls = fp.Balls(fp.Scene(), 3000)
            balls.kick(None, [0, 8, -22])
            state = balls.state
            timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
            before = signal.signal(signal.SIGINT, signal.default_int_handler)
            timer.start()
            try:
                with self.assertRaises(KeyboardInterrupt):
                    call(balls)
            finally:
                timer.join()
                signal.signal(signal.SIGINT, before)
            self.assertEqual(state, balls.state)
            np.testing.assert_array_equal(balls.position[0], [0, 0.11, 0])

    def test_parts_have_the_bits_of_a_whole(self):
        velocity = np.random.default_rng(1).uniform([-3, 5, -26], [3, 10, -10], (1000, 3))
        whole, parts = (fp.Balls(fp.Scene(), 1000) for _ in range(2))
        for balls in (whole, parts):
            balls.kick(None, velocity, [0, 40, 0])
        for _ in range(1000):
            whole.step(0.01)
        parts.step(0.01, 1000)
        self.assertEqual(whole.state, parts.state)
        rests = parts.until_rest(0.01, 60)
        for i in range(0, 1000, 250):
            one = fp.Balls(fp.Scene(), 1)
            one.kick(None, velocity[i], [0, 40, 0])
            one.step(0.01, 1000)
            self.assertEqual([rests[i]], one.until_rest(0.01, 60).tolist())
            self.assertEqual(parts.hashes[i], one.hashes[0])

    def test_the_progress_goes_up_to_1_and_changes_nothing(self):
        track, told = fly(), []
        watched, plain = fp.fit_match(fp.Scene(), track, progress=told.append), fp.fit_match(fp.Scene(), track)
        self.assertEqual((plain.rms, plain.values), (watched.rms, watched.values))
        self.assertEqual(sorted(told), told)
        self.assertEqual(1.0, told[-1])

    def test_an_error_of_the_progress_cancels_the_fit(self):
        def fail(value):
            raise RuntimeError(f"no thread at {value >= 0}")

        with self.assertRaisesRegex(RuntimeError, "no thread at True"):
            fp.fit_match(fp.Scene(), long_track(60), progress=fail)

    def test_errors_and_results_of_other_threads_are_the_same(self):
        track, found = fly(), []

        def fit():
            with self.assertRaisesRegex(ValueError, "also is"):
                fp.fit(fp.Scene(), track, also=["mass"])
            found.append(fp.fit(fp.Scene(), track).velocity)

        thread = threading.Thread(target=fit)
        thread.start()
        thread.join()
        fit()
        np.testing.assert_array_equal(found[0], found[1])


if __name__ == "__main__":
    unittest.main()
