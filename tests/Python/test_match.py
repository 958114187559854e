"""Matches: the bits of C#, bodies, saves, recordings, refusals."""

import ctypes
import math
import pathlib
import signal
import threading
import unittest

import numpy as np

import football_physics as fp

HASHES = pathlib.Path(__file__).parents[1] / "Native" / "match.txt"
MASK = (1 << 64) - 1
PLAYERS, STEP, MINUTE = 22, 1 / 60, 3600
LEG = {"bodies": [{"name": "leg", "shape": "capsule", "from": [0, -0.4, 0], "to": [0, 0.4, 0], "radius": 0.1, "mass": 5}]}


def mix(value, words):
    for word in words:
        value = ((value ^ word) * 0x9E3779B97F4A7C15) & MASK
        value ^= value >> 29
    return value


def words(*arrays):
    """The bits of numbers, one array after another."""
    return np.concatenate([np.asarray(array, np.float64).ravel() for array in arrays]).view(np.uint64).tolist()


def is_keeper(player):
    return player % 11 == 0


class Game:
    """The game of match.c."""

    def __init__(self):
        bodies = []
        for i in range(PLAYERS):
            if is_keeper(i):
                bodies.append({"name": f"keeper {i}", "shape": "box", "center": [0, 1, 0], "halfSize": [0.5, 1, 0.2]})
            else:
                bodies.append({"name": f"player {i}", "shape": "capsule", "from": [0, 0.25, 0], "to": [0, 1.55, 0], "radius": 0.25, "mass": 75})
        scene = {
            "goals": [{"center": [0, 0, -52.5], "facing": [0, 0, 1]}, {"center": [0, 0, 52.5], "facing": [0, 0, -1]}],
            "zones": [{"name": "area", "shape": "box", "center": [0, 1, -44], "halfSize": [20, 1, 8.5]}],
            "obstacles": [{"name": "bag", "shape": "sphere", "center": [3, 0.3, 5], "radius": 0.3, "mass": 4}],
            "bodies": bodies}
        self.match = fp.Match(scene, balls=2, dt=STEP)
        self.place = [[5.0 * (i % 11) - 25, -10.0 if i < 11 else 10.0] for i in range(PLAYERS)]
        self.since_kick, self.seed, self.hash = [0, 0], 0, 0

    def draw(self, size):
        self.seed = (self.seed + 0x9E3779B97F4A7C15) & MASK
        z = ((self.seed ^ (self.seed >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return size * (2 * (((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0)) - 1)

    def nearest(self, team, ball):
        found, least = 11 * team, math.inf
        for i in range(11 * team, 11 * team + 11):
            x, z = ball[0] - self.place[i][0], ball[2] - self.place[i][1]
            d = math.sqrt(x * x + z * z)
            if d < least:
                found, least = i, d
        return found, least

    def kick(self, balls):
        for b, at in enumerate(balls):
            self.since_kick[b] += 1
            least = min(self.nearest(team, at)[1] for team in range(2))
            if abs(at[0]) > 40 or abs(at[2]) > 60 or self.since_kick[b] > 1200:
                self.match.place(b, [self.draw(20), 1 + self.draw(1), self.draw(30)])
                self.since_kick[b] = 0
            elif least < 0.8 and at[1] < 1 and self.since_kick[b] > 30:
                velocity = [self.draw(18), 4 + self.draw(4), self.draw(22)]
                self.match.kick(b, velocity, [self.draw(40), self.draw(60), self.draw(20)])
                self.since_kick[b] = 0

    def move(self, balls, tick):
        chaser = [self.nearest(team, balls[team])[0] for team in range(2)]
        position, velocity = np.zeros((PLAYERS, 3)), np.zeros((PLAYERS, 3))
        orientation, spin = np.zeros((PLAYERS, 4)), np.zeros((PLAYERS, 3))
        for i in range(PLAYERS):
            team, (px, pz) = i // 11, self.place[i]
            chases = i == chaser[team]
            x = balls[team][0] if chases else 6.0 * (i % 11) - 30
            z = balls[team][2] if chases else (9.0 if team else -9.0) * (i % 3 + (5.6 if is_keeper(i) else 1))
            if is_keeper(i) and not chases:
                x = balls[0][0] * 0.05
            dx, dz, speed = x - px, z - pz, 7.0 if chases else 4.0
            d = math.sqrt(dx * dx + dz * dz)
            if d > speed * STEP:
                velocity[i, 0], velocity[i, 2] = speed * dx / d, speed * dz / d
            position[i, 0], position[i, 2] = px, pz
            c = dz / d if d > 0 else 1.0
            side = math.sqrt((1 - c) / 2)
            orientation[i, 1], orientation[i, 3] = -side if dx < 0 else side, math.sqrt((1 + c) / 2)
            spin[i, 1] = 2 if is_keeper(i) else 0
            self.place[i] = [px + STEP * float(velocity[i, 0]), pz + STEP * float(velocity[i, 2])]
        in_play = np.array([not (i == 5 and tick // MINUTE % 3 == 1) for i in range(PLAYERS)])
        self.match.move_bodies(position, orientation, velocity, spin, in_play)

    def play(self):
        balls = self.match.balls()["position"].tolist()
        self.kick(balls)
        self.move(balls, self.match.tick)
        for e in self.match.step():
            kind, thing, ball, other, body = (int(e[name]) & 0xFFFFFFFF for name in ("kind", "thing", "ball", "other_ball", "body"))
            self.hash = mix(self.hash, [kind << 32 | thing, ball << 32 | other, body])
            self.hash = mix(self.hash, words(*(e[name] for name in ("time", "position", "velocity", "spin", "normal", "impulse", "added_energy"))))
        bodies = self.match.bodies()
        self.hash = mix(self.hash, words(np.hstack([bodies["velocity"], bodies["impulse"]])))
        self.hash = mix(self.hash, [self.match.hash])


class Bits(unittest.TestCase):
    def test_a_minute_with_22_players_has_the_hash_of_csharp_also_restored(self):
        game, other = Game(), Game()
        for tick in range(MINUTE):
            if tick == 1499:
                saved, before = game.match.save(), [list(place) for place in game.place]
                since, seed, value = list(game.since_kick), game.seed, game.hash
                for _ in range(10):
                    game.play()
                after = game.hash
                # It goes on in another match, of the same game.
                other.match.restore(saved)
                game.match, other.match = other.match, game.match
                game.place, game.since_kick, game.seed, game.hash = before, since, seed, value
                for _ in range(10):
                    game.play()
                self.assertEqual(after, game.hash)
            if 1499 <= tick < 1509:
                continue
            game.play()
        self.assertEqual(f"minute 1 {game.hash:016x}", HASHES.read_text().splitlines()[0])

    def test_without_bodies_a_match_is_balls(self):
        balls = fp.Balls(fp.Scene(), 1)
        balls.kick([0], [3, 8, -22], [0, 40, 0])
        balls.step(STEP, 120)
        with fp.Match() as match:
            match.kick(0, [3, 8, -22], [0, 40, 0])
            match.step(120)
            self.assertEqual((120, int(balls.hashes[0])), (match.tick, match.hash))
            np.testing.assert_array_equal(balls.position, match.balls()["position"])
            copied = match.balls_in(fp.Scene())
            np.testing.assert_array_equal(balls.position, copied.position)
            balls.until_rest(), copied.until_rest()
            np.testing.assert_array_equal(balls.position, copied.position)


class Bodies(unittest.TestCase):
    def test_the_impulse_on_the_body_is_what_the_ball_lost(self):
        match = fp.Match(LEG, balls=2)
        match.kick(0, [0, 1, -12])
        hits = []
        for _ in range(60):
            match.move_bodies([0, 0.5, -6], velocity=[0, 0, 1])
            events = match.step()
            for event in events[events["body"] == 0]:
                hits.append(event)
                np.testing.assert_allclose(event["impulse"], 0.43 * (event["velocity"] - event["velocity_before"]), atol=1e-12)
                np.testing.assert_allclose(match.bodies()["impulse"][0], -event["impulse"], atol=1e-12)
                self.assertEqual("leg", match.name_of(event["thing"]))
        self.assertEqual([0], [int(hit["ball"]) for hit in hits])
        match.move_bodies([0, 0.5, -6], in_play=False)
        self.assertEqual([0], match.bodies()["in_play"].tolist())

    def test_returned_arrays_are_copies(self):
        match = fp.Match(LEG, balls=2)
        for array in (match.balls(), match.bodies()):
            array["position"] = 7
        match.kick(0, [0, 5, 0])
        events, before = match.step(90), match.hash
        self.assertGreater(len(events), 0)
        told = events.copy()
        match.step(90)
        np.testing.assert_array_equal(told, events)
        self.assertNotEqual(7, match.balls()["position"][1, 0])
        self.assertNotEqual(before, match.hash)

    def test_events_beyond_those_that_a_step_keeps_are_counted(self):
        match = fp.Match(balls=1050, dt=0.7)
        for ball in range(1050):
            match.kick(ball, [0, 3, 0])
        events = match.step()
        self.assertEqual((1024, 26), (len(events), match.dropped))
        self.assertEqual([*range(1008), *range(1034, 1050)], events["ball"].tolist())
        match.step(0)
        self.assertEqual(0, match.dropped)

    def test_many_balls_are_counted_in_a_replay(self):
        for n in (1, 2, 3, 37):
            match = fp.Match(LEG, balls=n)
            match.record()
            match.step(3)
            again = fp.Match.replay(LEG, match.recording())
            self.assertEqual((n, 1), (len(again.balls()), len(again.bodies())))


class Recordings(unittest.TestCase):
    def test_a_replay_has_the_same_bits_forwards_and_backwards(self):
        match = fp.Match(LEG)
        match.record()
        match.kick(0, [3, 8, -22], [0, 40, 0])
        hashes = []
        for tick in range(100):
            match.move_bodies([1 + 0.01 * tick, 0.5, -6])
            match.step()
            hashes.append(match.hash)
        recording = match.recording()
        with fp.Match.replay(LEG, recording) as again:
            self.assertIsNone(again.verify())
            for tick in (100, 3, 64, 65, 1):
                again.seek(tick)
                self.assertEqual((tick, hashes[tick - 1]), (again.tick, again.hash))
            again.step(9)
            self.assertEqual(hashes[9], again.hash)
            with self.assertRaisesRegex(ValueError, "replays a recording"):
                again.kick(0, [0, 1, 0])
        with self.assertRaises(ValueError):
            fp.Match.replay(LEG, recording[:-1])
        with self.assertRaises(ValueError):
            fp.Match.replay("{}", recording)

    def test_a_restart_comes_before_the_kick_and_is_recorded_and_saved(self):
        with fp.Match() as match, fp.Match() as other:
            match.record()
            match.step(5)
            match.kick(0, [0, 1, -9])
            match.queue_place(0, [3, 0, 4])
            saved = match.save()
            match.step()
            self.assertAlmostEqual(match.balls()["time"][0], 6 / 60)
            np.testing.assert_allclose(match.balls()["position"][0], [3, 0.12, 4 - 9 / 60], atol=0.02)
            match.queue_place(0, [1, 2, 0], velocity=[-8, 3, 1], spin=[0, 6, 0], orientation=[0, 2, 0, 2])
            match.step(20)
            self.assertIsNone(fp.Match.replay({}, match.recording()).verify())
            other.restore(saved)
            other.step()
            other.queue_place(0, [1, 2, 0], [-8, 3, 1], [0, 6, 0], [0, 2, 0, 2])
            other.step(20)
            self.assertEqual(match.hash, other.hash)
            with self.assertRaisesRegex(ValueError, "place.velocity is"):
                match.queue_place(0, [1, 2, 0], velocity=2000)
            with self.assertRaisesRegex(ValueError, "orientation has shape"):
                match.queue_place(0, [1, 2, 0], orientation=[0, 0, 1])


class Refusals(unittest.TestCase):
    def test_errors_have_a_sentence_and_change_nothing(self):
        match = fp.Match(LEG, balls=2)
        match.kick(0, [0, 5, -10])
        match.step(10)
        saved = match.save()
        for sentence, call in [
            ("gravity is -1; allowed: ", lambda: fp.Match({"gravity": -1})),
            ("balls is 0; allowed: ", lambda: fp.Match(balls=0)),
            ("dt is 0; allowed: ", lambda: fp.Match(dt=0)),
            ("n is -1; allowed: ", lambda: match.step(-1)),
            ("velocity has shape", lambda: match.kick(0, [0, 1])),
            ("velocity is ", lambda: match.kick(0, [0, math.nan, 0])),
            ("ball is 4294967296; allowed", lambda: match.place(2**32, [0, 1, 0])),
            ("balls is 4294967297; allowed", lambda: fp.Match(balls=2**32 + 1)),
            ("ball is 2", lambda: match.kick(2, [0, 1, 0])),
            ("position has shape", lambda: match.move_bodies([0, 1])),
            ("orientation has shape", lambda: match.move_bodies([0, 1, 0], orientation=[0, 0, 1])),
            ("n is 2; allowed: ", lambda: match.move_bodies(np.zeros((2, 3)))),
            (r"bodies\[0\]", lambda: match.move_bodies([0, 1, 0], orientation=[0, 0, 0, 0])),
            ("", lambda: match.restore(saved[:-1])),
            ("", lambda: match.restore(bytes(len(saved)))),
            ("", match.recording),
            ("match replays no recording", lambda: match.seek(3)),
            ("thing is 77", lambda: match.name_of(77)),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                call()
        self.assertEqual(saved, match.save())

    def test_numpy_describes_a_scene_and_other_objects_do_not(self):
        with fp.Match({"gravity": np.float64(5), "obstacles": [{"shape": "sphere", "center": np.zeros(3), "radius": 1, "mass": np.int64(3)}]}) as match:
            self.assertEqual(1, len(match.balls()))
        self.assertEqual('{"gravity": 5.0}', fp.Scene({"gravity": np.float64(5)}).json)
        with self.assertRaisesRegex(TypeError, "a member is a set; allowed: "):
            fp.Match({"obstacles": {1, 2}})

    def test_a_closed_match_says_so_and_closes_twice(self):
        with fp.Match() as match:
            pass
        match.close()
        for call in (match.step, match.balls, match.save, lambda: match.hash):
            with self.assertRaisesRegex(ValueError, "the match is closed"):
                call()


class DifferentBalls(unittest.TestCase):
    SCENE = {"balls": [{"ball": {"type": "beachBall"}}, {}, {"ball": {"mass": 0.8}}], "ballContact": {"normalRestitution": 0.5}}

    def test_each_ball_has_its_own_size_and_mass(self):
        with fp.Match(self.SCENE) as match:
            height = match.balls()["position"][:, 1]
            self.assertEqual(3, len(height))
            self.assertGreater(height[0], height[1] + 0.05)
            match.kick(1, [-8, 0.5, -0.5])
            events = match.step(120)
            pair = events[(events["other_ball"] >= 0) & (events["kind"] == fp.EventKind.IMPACT)]
            self.assertGreaterEqual(len(pair), 2)
            np.testing.assert_allclose(pair["impulse"][0], -pair["impulse"][1], atol=1e-12)
            mass = np.linalg.norm(pair["impulse"], axis=1) / np.linalg.norm(pair["velocity"] - pair["velocity_before"], axis=1)
            self.assertLess(mass[list(pair["ball"]).index(0)], 0.3)
            self.assertAlmostEqual(0.43, mass[list(pair["ball"]).index(1)], 2)

    def test_a_recording_needs_the_same_balls(self):
        with fp.Match(self.SCENE) as match:
            match.record()
            match.kick(0, [0, 5, -10])
            match.step(60)
            recording, hash_ = match.recording(), match.hash
        again = fp.Match.replay(self.SCENE, recording)
        again.step(60)
        self.assertEqual(hash_, again.hash)
        self.assertIsNone(again.verify())
        with self.assertRaisesRegex(ValueError, "The scene differs from the recorded one"):
            fp.Match.replay({}, recording)

    def test_the_number_of_balls_is_that_of_the_scenario(self):
        with self.assertRaisesRegex(ValueError, "balls is 3 balls; allowed: 2, the number of balls of the match"):
            fp.Match(self.SCENE, balls=2)
        self.assertEqual(1, len(fp.Match().balls()))


class Threads(unittest.TestCase):
    @unittest.skipUnless(hasattr(signal, "raise_signal") and threading.current_thread() is threading.main_thread(), "needs the main thread")
    def test_ctrl_c_ends_a_long_call_between_two_steps(self):
        match = fp.Match()
        # The kick keeps the ball busy; without the interruption, the call would last for hours.
        match.kick(0, [3, 8, -22])
        timer = threading.Timer(0.05, signal.raise_signal, [signal.SIGINT])
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                match.step(1 << 40)
        finally:
            timer.join()
            signal.signal(signal.SIGINT, before)
        tick = match.tick
        match.step()
        self.assertEqual(tick + 1, match.tick)

    def test_a_call_lets_other_threads_run(self):
        # ctypes releases the lock of the interpreter for a CDLL, and keeps it for a PyDLL.
        from football_physics import _native

        self.assertIs(ctypes.CDLL, type(_native._library))

    def test_threads_step_matches_of_their_own(self):
        found = [0] * 3

        def play(i):
            with fp.Match(LEG) as match:
                match.kick(0, [3, 8, -22], [0, 40, 0])
                match.step(200)
                found[i] = match.hash

        threads = [threading.Thread(target=play, args=(i,)) for i in range(3)]
        [t.start() for t in threads]
        [t.join() for t in threads]
        self.assertEqual(1, len(set(found)))
        self.assertNotEqual(0, found[0])


if __name__ == "__main__":
    unittest.main()
