"""The environments whose episodes last several steps, and what all environments have in common."""

import unittest

import numpy as np

from football_physics import envs

ALL = (envs.Penalty, envs.FreeKick, envs.Goalkeeper, envs.Dribble)


def play(env, policy, steps, seed=3, change=False):
    """The observations, rewards and ends of some steps; with change, every returned array is overwritten."""
    observation, _ = env.reset(seed=seed)
    told = []
    for _ in range(steps):
        observation, reward, terminated, truncated, info = env.step(policy(observation))
        told.append([array.copy() for array in (observation, reward, terminated, truncated)])
        if change:
            for array in (observation, reward, terminated, truncated, *info.values()):
                array[...] = 1
            observation = told[-1][0]
    return told


def run_ahead(observation):
    """Runs after the ball, and kicks it straight ahead."""
    n = len(observation)
    return np.hstack([np.clip(2 * observation[:, :2], -1, 1), np.tile([0.0, 0.6], (n, 1))])


def dive(observation):
    """Runs and dives to where the ball will be."""
    left = np.maximum((observation[:, 2] + 10.6) / np.maximum(-observation[:, 5], 1), 0.02)
    aside = observation[:, 0] + observation[:, 3] * left - observation[:, 6]
    height = np.maximum(observation[:, 1] + observation[:, 4] * left - 4.9 * left**2, 0.1)
    lean = np.where(np.abs(aside) > 0.5, np.sign(aside) * np.minimum(np.arctan2(np.abs(aside), height), 1.4), 0)
    return np.clip(np.stack([3 * aside, 4 * (lean - observation[:, 8])], 1), -1, 1)


class Common(unittest.TestCase):
    def test_a_seed_repeats_everything_and_returned_arrays_are_the_callers(self):
        for kind in ALL:
            with self.subTest(kind.__name__):
                env = kind(num_envs=8)
                actions = np.random.default_rng(1).uniform(-1, 1, (30, *env.action_space.shape))
                runs = []
                for change in (False, True, False):
                    draws = iter(actions)
                    runs.append(play(env, lambda _: next(draws), 30, change=change))
                for step in zip(*runs):
                    for arrays in zip(*step):
                        np.testing.assert_array_equal(arrays[0], arrays[1])
                        np.testing.assert_array_equal(arrays[0], arrays[2])
                self.assertTrue(any(terminated.any() for _, _, terminated, _ in runs[0]))
                self.assertTrue(all(env.single_observation_space.contains(row) for observation, *_ in runs[0] for row in observation))

    def test_environments_of_a_batch_do_not_depend_on_each_other(self):
        for kind, policy in ((envs.Goalkeeper, dive), (envs.Dribble, run_ahead)):
            env = kind(num_envs=4)
            usual = play(env, policy, 4)
            other = play(env, lambda o: np.vstack([policy(o)[:3], -policy(o)[3:]]), 4)
            np.testing.assert_array_equal(usual[-1][0][:3], other[-1][0][:3])
            self.assertFalse(np.array_equal(usual[-1][0][3], other[-1][0][3]))

    def test_wrong_arguments_are_refused(self):
        for kind in ALL:
            env = kind(num_envs=2)
            shape = env.action_space.shape
            for sentence, call in [
                ("options has the key 'wind'; allowed: none.", lambda: env.reset(options={"wind": 1})),
                ("num_envs is 0; allowed: 1 or more.", lambda: kind(num_envs=0)),
                ("actions have shape", lambda: env.step(np.zeros((3, shape[1])))),
                ("actions contain a number that is not finite", lambda: env.step(np.full(shape, np.nan))),
            ]:
                with self.subTest(kind.__name__ + sentence), self.assertRaisesRegex(ValueError, sentence):
                    call()


class Keepers(unittest.TestCase):
    def test_a_keeper_who_dives_saves_more_than_one_who_stands(self):
        env = envs.Goalkeeper(num_envs=64)
        saves, goals = [], []
        for policy in (lambda o: np.zeros((len(o), 2)), dive):
            told = play(env, policy, 50)
            rewards = np.concatenate([reward for _, reward, *_ in told])
            saves.append((rewards == 1).sum())
            goals.append((rewards == -1).sum())
        self.assertGreater(saves[1], 3 * saves[0])
        self.assertLess(goals[1], goals[0] / 2)
        env.close()
        with self.assertRaisesRegex(ValueError, "the match is closed"):
            env.step(np.zeros((64, 2)))

    def test_a_keeper_stays_within_his_bounds_and_his_acceleration(self):
        env = envs.Goalkeeper(num_envs=1)
        states = np.array([o[0] for o, *_ in play(env, lambda o: np.ones((1, 2)), 6)])
        self.assertAlmostEqual(1.5, states[0, 7], 6)
        self.assertAlmostEqual(0.15, states[0, 6], 6)
        self.assertLessEqual(np.abs(states[:, 6]).max(), 3.3 + 1e-6)
        self.assertLessEqual(np.abs(states[:, 8]).max(), 1.4 + 1e-6)

    def test_the_last_observation_is_of_the_episode_that_ended(self):
        env = envs.Goalkeeper(num_envs=16)
        observation, _ = env.reset(seed=1)
        for _ in range(30):
            observation, _, terminated, truncated, info = env.step(np.zeros((16, 2)))
            ended = terminated | truncated
            if not ended.any():
                self.assertNotIn("final_obs", info)
                continue
            np.testing.assert_array_equal(ended, info["_final_obs"])
            np.testing.assert_array_equal(observation[~ended], info["final_obs"][~ended])
            # The next shot starts before the penalty spot, and the keeper in the middle.
            self.assertTrue((observation[ended, 2] >= -1).all() and (observation[ended, 6] == 0).all())


class Alone(envs.Dribble):
    """A dribble without defenders."""

    defenders = 0


class Dribbles(unittest.TestCase):
    def test_alone_the_rewards_add_up_to_the_way_and_the_line(self):
        env = Alone(num_envs=1)
        env.reset(seed=3)
        start, total = float(env._balls.position[0, 2]), 0.0
        self.assertEqual(-0.5, start)
        for _, reward, terminated, _ in play(env, run_ahead, 80):
            total += reward[0]
            if terminated[0]:
                break
        self.assertTrue(terminated[0])
        # The ball is over the line at -30 m, by at most one touch.
        self.assertTrue(1 + 29.5 / 30 <= total <= 1 + 32.5 / 30, total)

    def test_defenders_win_the_ball_of_a_player_who_waits(self):
        env = envs.Dribble(num_envs=32)
        told = play(env, lambda o: np.zeros((32, 4)), 100)
        self.assertTrue(np.any([terminated for *_, terminated, _ in told], axis=0).all())
        self.assertEqual({-1.0}, set(np.round([reward[i] for _, reward, terminated, _ in told for i in np.flatnonzero(terminated)], 9)))

    def test_a_run_gets_past_more_often_than_chance(self):
        random = np.random.default_rng(5)
        over = []
        for policy in (run_ahead, lambda o: random.uniform(-1, 1, (64, 4))):
            over.append(sum((reward > 0.5).sum() for _, reward, *_ in play(envs.Dribble(num_envs=64), policy, 100)))
        self.assertGreater(over[0], 20)
        self.assertLess(over[1], 3)

    def test_an_episode_without_an_end_is_truncated_after_its_time(self):
        env = Alone(num_envs=3)
        told = play(env, lambda o: np.zeros((3, 4)), 201)
        self.assertEqual([199], [i for i, (_, _, terminated, truncated) in enumerate(told) if truncated.all() and not terminated.any()])


if __name__ == "__main__":
    unittest.main()
