"""The package as it is installed: bits, live arrays, refusals, environments."""

import gc
import pathlib
import pickle
import threading
import unittest

import numpy as np

import football_physics as fp
from football_physics import envs

KICKS = pathlib.Path(__file__).parents[1] / "Native" / "kicks.txt"
MASK = (1 << 64) - 1


def draw(seed):
    """SplitMix64, as in kicks.c."""
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & MASK
        z = ((seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        yield ((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0)


def mix(value, word):
    value = ((value ^ word) * 0x9E3779B97F4A7C15) & MASK
    return value ^ (value >> 29)


class Bits(unittest.TestCase):
    def test_a_hundred_kicks_have_the_hash_of_csharp(self):
        balls, value = fp.Balls(fp.Scene(), 1), 0
        for seed in range(100):
            u = draw(seed)
            position = [60 * next(u) - 30, 2 * next(u), 90 * next(u) - 45]
            velocity = [50 * next(u) - 25 for _ in range(3)]
            spin = [120 * next(u) - 60 for _ in range(3)]
            balls.place(None, position, velocity, spin)
            for _ in range(1200):
                for event in balls.step_events(1 / 60):
                    words = np.frombuffer(event.tobytes()[:160], np.uint64)
                    value = mix(value, int(event["kind"]) << 32 | int(event["thing"]) & 0xFFFFFFFF)
                    for word in words[1:]:
                        value = mix(value, int(word))
                value = mix(value, int(balls.hashes[0]))
                if balls.motion[0] == fp.Motion.STOPPED:
                    break
        self.assertEqual(f"default 100 {value:016x}", KICKS.read_text().splitlines()[0])

    def test_the_kick_of_the_default_is_the_one_in_the_table(self):
        table = np.loadtxt(KICKS.parents[1] / "Golden" / "one-default.csv", delimiter=",", skiprows=1)
        balls = fp.Balls(fp.Scene(), 1)
        balls.place(None, (0.0, 0.0, 0.0), table[0, 4:7], table[0, 7:10])
        for row in table:
            seen = np.concatenate([balls.position[0], balls.velocity[0], balls.spin[0]])
            np.testing.assert_array_equal(seen, row[1:])
            balls.step(0.01)
        self.assertEqual(balls.motion[0], fp.Motion.STOPPED)

    def test_many_balls_are_each_the_ball_alone_and_a_restored_one_goes_the_same_way(self):
        scene, random = fp.Scene({"profile": "published"}), np.random.default_rng(1)
        velocity, spin = random.uniform([-5, 3, -25], [5, 9, -15], (32, 3)), random.uniform(-50, 50, (32, 3))
        many = fp.Balls(scene, 32)
        many.kick(None, velocity, spin)
        many.step(1 / 60, 30)
        saved = many.state
        many.step(1 / 60, 60)
        hashes = many.hashes
        many.state = saved
        many.step(1 / 60, 60)
        np.testing.assert_array_equal(hashes, many.hashes)
        for ball in (0, 17, 31):
            alone = fp.Balls(scene, 1)
            alone.kick([0], velocity[ball], spin[ball])
            alone.step(1 / 60, 90)
            self.assertEqual(hashes[ball], alone.hashes[0])

    def test_forces_are_those_of_the_next_step(self):
        board = {"name": "board", "shape": "box", "center": [1, 0.5, 0], "halfSize": [0.1, 0.5, 40]}
        scene = fp.Scene({"gravity": [2, -9.6, 0], "obstacles": [board]})
        balls = fp.Balls(scene, 2)
        balls.place(None, [[0, 1, 0], [0.79, 0.11, 0]], [[2, 6, -24], [0, 0, -9]], [[20, 40, 5], [-80, 0, 0]])
        flight = balls.forces(0)
        parts = [getattr(flight, name) for name in fp.Forces._fields[:9]]
        np.testing.assert_allclose(sum(parts), flight.sum, rtol=1e-12)
        self.assertEqual(len(flight.contacts), 0)
        self.assertGreater(flight.drag @ [-2, -6, 24], 0)
        contacts = set()
        for _ in range(120):
            before, seen = balls.hashes, balls.forces(1)
            np.testing.assert_array_equal(balls.hashes, before)
            if seen is not None:
                contacts |= {scene.name_of(int(contact["thing"])) for contact in seen.contacts}
                np.testing.assert_allclose(seen.contacts["load"].sum(axis=0), seen.load, atol=1e-12)
            balls.step(1 / 60)
        self.assertEqual(contacts, {"ground", "board"})
        for wrong in (lambda: balls.forces(2), lambda: balls.forces(0, 0), lambda: balls.forces(0, np.nan)):
            with self.assertRaises(ValueError):
                wrong()

    def test_look_ahead_is_the_future(self):
        balls = fp.Balls(fp.Scene(), 2)
        balls.kick(None, [[1, 6, -18], [3, 2, 5]], [0, 30, 0])
        path = balls.look_ahead(1, 1 / 60)
        self.assertEqual((2, 61, 4), path.shape)
        balls.step(1 / 60, 60)
        np.testing.assert_array_equal(path[:, -1, 1:], balls.position)
        np.testing.assert_array_equal(path[:, -1, 0], balls.time)

    def test_without_ground_balls_fall_from_where_they_are(self):
        balls = fp.Balls(fp.Scene({"ground": {"surface": "none"}, "air": {"density": 0}, "gravity": 9.81}), 2)
        np.testing.assert_array_equal(0, balls.position)
        balls.step(0.01, 100)
        np.testing.assert_allclose(balls.position, [[0, -4.905, 0]] * 2, atol=1e-9)

    def test_threads_share_a_scene(self):
        scene, found = fp.Scene(), [0] * 4

        def fly(i):
            balls = fp.Balls(scene, 64)
            balls.kick(None, [3, 8, -20], [0, 40, 0])
            balls.until_rest()
            found[i] = set(balls.hashes.tolist())

        threads = [threading.Thread(target=fly, args=(i,)) for i in range(4)]
        [t.start() for t in threads]
        [t.join() for t in threads]
        self.assertEqual(1, len(set.union(*found)))


class Arrays(unittest.TestCase):
    def test_live_arrays_are_the_same_always_and_read_only(self):
        balls = fp.Balls(fp.Scene(), 3)
        position, motion = balls.position, balls.motion
        balls.kick([1], [0, 5, -10])
        balls.step(0.1)
        self.assertIs(position, balls.position)
        self.assertIs(motion, balls.motion)
        self.assertEqual([fp.Motion.STOPPED, fp.Motion.AIRBORNE, fp.Motion.STOPPED], [fp.Motion.STOPPED if v == 0 else fp.Motion(m) for m, v in zip(motion, np.abs(balls.velocity).sum(1))])
        self.assertGreater(position[1, 1], 0.3)
        with self.assertRaises(ValueError):
            position[0, 0] = 1

    def test_masks_indices_and_rows(self):
        balls = fp.Balls(fp.Scene(), 4)
        balls.kick(np.array([True, False, True, False]), [[0, 5, -1], [0, 5, -2]])
        self.assertEqual([-1, 0, -2, 0], balls.velocity[:, 2].tolist())
        balls.kick([3, 0], [[0, 5, -3], [0, 5, -4]])
        self.assertEqual([-4, 0, -2, -3], balls.velocity[:, 2].tolist())
        balls.kick([-1], [0, 5, -9])
        self.assertEqual(-9, balls.velocity[3, 2])

    def test_landing_aims_and_derivatives(self):
        balls = fp.Balls(fp.Scene(), 2)
        found = balls.aim([[2, 1.5, -20], [-2, 0.5, -18]], speed=25, spin={"side": 20})
        self.assertTrue(found.hit.all())
        self.assertLess(found.miss.max(), 0.011)
        self.assertEqual([None, None], found.reason)
        far = balls.aim([[2, 1.5, -20], [0, 1, -200]], speed=25)
        self.assertEqual((0, 1), tuple(far.status))
        self.assertIsNone(far.reason[0])
        self.assertRegex(far.reason[1], "^Flights at close elevations all pass below the target or fall short of it")
        balls.kick(None, found.velocity, found.spin)
        start = balls.state
        ends = balls.derivatives(0.5)
        at = balls.position.copy()
        balls.state = start
        balls.kick(None, found.velocity + [0, 1e-4, 0], found.spin)
        balls.step(0.01, 50)
        np.testing.assert_allclose((balls.position - at) / 1e-4, ends.position_by_velocity[:, :, 1], rtol=1e-3, atol=1e-4)
        self.assertTrue(balls.until_landing().all())
        np.testing.assert_allclose(balls.position[:, 1], 0.11, atol=1e-9)

    def test_names_and_events(self):
        scene = fp.Scene({"goals": [{"center": [0, 0, -11], "facing": [0, 0, 1]}]})
        balls = fp.Balls(scene, 2)
        balls.kick([1], [0, 3, -25])
        told = np.concatenate([balls.step_events(1 / 60) for _ in range(60)])
        goal = told[told["kind"] == fp.EventKind.GOAL]
        self.assertEqual(([1], "goal"), (goal["ball"].tolist(), scene.name_of(int(goal["thing"][0]))))

    def test_a_bumper_adds_energy(self):
        bumper = {"name": "bumper", "shape": "sphere", "center": [0, 1, -3], "radius": 0.3, "surface": {"normalRestitution": 1.5}}
        scene = fp.Scene({"gravity": 0, "air": {"density": 0}, "obstacles": [bumper]})
        balls = fp.Balls(scene, 1)
        balls.place([True], [[0, 1, 0]], [[0, 0, -4]])
        events = [event for _ in range(100) for event in balls.step_events(0.02)]
        self.assertEqual(["bumper"], [scene.name_of(int(event["thing"])) for event in events])
        speed = np.linalg.norm(events[0]["velocity"])
        self.assertGreater(speed, 4.5)
        self.assertAlmostEqual(0.5 * 0.43 * (speed**2 - 16), scene.added_energy(events[0]), 9)

    def test_zones_and_layers(self):
        zone = {"name": "area", "shape": "box", "center": [0, 2, -12], "halfSize": [20, 4, 8], "of": "centre"}
        wall = {"shape": "box", "center": [0, 1, -2], "halfSize": [3, 3, 0.1], "layer": 3}
        scene = fp.Scene({"ball": {"ignores": [3]}, "zones": [zone], "obstacles": [wall], "gravity": [0, -9.81, 0]})
        balls = fp.Balls(scene, 1)
        balls.kick([0], [0, 3, -25])
        told = np.concatenate([balls.step_events(1 / 60) for _ in range(120)])
        told = told[told["kind"] >= fp.EventKind.ENTER_ZONE]
        self.assertEqual([fp.EventKind.ENTER_ZONE, fp.EventKind.EXIT_ZONE], told["kind"].tolist())
        np.testing.assert_allclose(told["position"][:, 2], [-4, -20], atol=1e-8)
        self.assertEqual("area", scene.name_of(int(told["thing"][0])))


class Refusals(unittest.TestCase):
    def test_errors_have_the_librarys_sentence(self):
        balls = fp.Balls(fp.Scene(), 2)
        before = balls.state
        for sentence, call in [
            ("gravity is -1; allowed: ", lambda: fp.Scene({"gravity": -1})),
            ("the input", lambda: fp.Scene("{")),
            ("dt is -1.0; allowed: ".replace("-1.0", "-1"), lambda: balls.step(-1)),
            ("steps is -1; allowed: ", lambda: balls.step(0.01, -1)),
            ("launch.velocity is ", lambda: balls.kick(None, [0, np.nan, 0])),
            ("velocity has shape", lambda: balls.kick(None, np.zeros((3, 3)))),
            (r"velocity has shape \(2,\)", lambda: balls.kick(None, [1, 2])),
            ("bodies is a member of a match", lambda: fp.Scene({"bodies": []})),
            ("the mask has shape", lambda: balls.kick(np.array([True]), [0, 0, 0])),
            ("of the balls that are named", lambda: balls.kick([2], [0, 0, 0])),
            ("state has 3 bytes", lambda: setattr(balls, "state", b"abc")),
            (r"states\[0\] was never launched. Launch the ball first.", lambda: setattr(balls, "state", bytes(len(before)))),
            ("n is -1", lambda: fp.Balls(fp.Scene(), -1)),
            ("stop is 'never'", lambda: balls.derivatives(1, stop="never")),
            ("every is 0", lambda: balls.look_ahead(1, 0)),
            ("thing is 7", lambda: balls.scene.name_of(7)),
            ("aim.speed is -1".replace("aim.", ""), lambda: balls.aim([0, 1, -20], speed=-1)),
            ("targetVelocity cannot be combined with", lambda: balls.aim([0, 1, -20], through=[0, 2, -10], targetVelocity=[1, 0, 0])),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, "^(aim\\.)?" + sentence.replace(".", "\\.")):
                call()
        self.assertEqual(before, balls.state)

    def test_scenes_are_freed_and_copied(self):
        handle = fp.Scene().handle
        gc.collect()
        from football_physics import _native

        self.assertEqual(_native.HANDLE, _native.scene_free(handle))
        self.assertEqual("{}", pickle.loads(pickle.dumps(fp.Scene())).json)


class Environments(unittest.TestCase):
    def test_a_change_of_a_returned_array_changes_nothing_and_options_are_refused(self):
        rewards = []
        for change in (False, True):
            env = envs.Penalty(num_envs=16)
            observation, _ = env.reset(seed=3)
            observation[:] = 9 if change else observation
            observation, reward, *_ = env.step(np.zeros((16, 5)))
            observation[:] = 9 if change else observation
            rewards.append((reward, env.step(np.zeros((16, 5)))[1]))
        np.testing.assert_array_equal(*rewards)
        with self.assertRaisesRegex(ValueError, "options has the key 'wind'; allowed: none."):
            env.reset(options={"wind": 1})

    def test_a_batch_of_kicks_is_repeatable_and_some_go_in(self):
        for kind in (envs.Penalty, envs.FreeKick):
            rewards = []
            for _ in range(2):
                env = kind(num_envs=2048)
                observation, _ = env.reset(seed=3)
                self.assertTrue(all(env.single_observation_space.contains(row) for row in observation))
                env.action_space.seed(5) if hasattr(env.action_space, "seed") else None
                _, reward, terminated, truncated, info = env.step(np.random.default_rng(5).uniform(-1, 1, (2048, 5)))
                self.assertTrue(terminated.all() and not truncated.any())
                np.testing.assert_array_equal(observation, info["final_obs"])
                rewards.append(reward)
            np.testing.assert_array_equal(*rewards)
            self.assertTrue(((rewards[0] == 1) | ((rewards[0] < 0) & (rewards[0] >= -1))).all())
            self.assertGreater((rewards[0] == 1).sum(), 5)
            with self.assertRaises(ValueError):
                env.step(np.zeros((3, 5)))

    def test_the_wall_is_in_the_way(self):
        env = envs.FreeKick(num_envs=1)
        env.reset(seed=1)
        low = np.array([[1, -1, 0, 0, 0]])
        self.assertEqual(-1, env.step(low)[1][0])


class Air(unittest.TestCase):
    def test_a_constant_drag_has_its_closed_form_and_rows_are_independent(self):
        scene = fp.Scene({"air": {"density": 1.2}, "ball": {"radius": 0.11}, "forces": {"drag": "constant", "dragCoefficient": 0.25, "magnus": "none", "spinDecay": "none", "buoyancy": False}})
        velocity = np.array([[0.0, 0.0, -20.0], [3.0, 4.0, 0.0], [0.0, 0.0, 0.0]])
        force, torque = scene.air((0.0, 1.0, 0.0), velocity, (0.0, 40.0, 0.0))
        speed = np.linalg.norm(velocity, axis=1, keepdims=True)
        np.testing.assert_allclose(force, -0.5 * 1.2 * np.pi * 0.11**2 * 0.25 * speed * velocity, rtol=1e-12)
        np.testing.assert_array_equal(torque, np.zeros((3, 3)))
        one, _ = scene.air((0.0, 1.0, 0.0), velocity[1], (0.0, 40.0, 0.0))
        np.testing.assert_array_equal(one, force[1])

    def test_an_euler_step_is_the_step_of_the_library(self):
        scene = fp.Scene({"solver": {"integrator": "euler"}, "forces": {"buoyancy": False}})
        balls = fp.Balls(scene, 20)
        draws = np.random.default_rng(5)
        velocity, spin = draws.uniform(-20, 20, (20, 3)), draws.uniform(-50, 50, (20, 3))
        balls.place(None, (0.0, 30.0, 0.0), velocity, spin)
        force, torque = scene.air(balls.position, velocity, spin)
        balls.step(0.001)
        np.testing.assert_allclose(balls.velocity, velocity + 0.001 * (force / 0.43 + np.array([0.0, -9.81, 0.0])), atol=1e-9)
        self.assertTrue((np.sum(torque * spin, axis=1) < 0).all())

    def test_wrong_shapes_and_numbers_are_rejected(self):
        with self.assertRaisesRegex(ValueError, "spin has shape"):
            fp.Scene().air((0.0, 0.0, 0.0), np.zeros((2, 3)), np.zeros((3, 3)))
        with self.assertRaisesRegex(ValueError, "velocity is "):
            fp.Scene().air((0.0, 0.0, 0.0), (2000.0, 0.0, 0.0), (0.0, 0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
