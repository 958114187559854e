"""A dribble past defenders: all balls of a batch in one call."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._balls import Balls
from ._environment import Environment, Step
from ._scene import Scene


class Dribble(Environment):
    """A player with the ball and :attr:`defenders` before him, for ``num_envs`` dribbles at once. A step lasts 0.1 s.

    The player starts with the ball at his feet, and shall bring it over a line, :attr:`length` m ahead (towards -z), within a strip of +-:attr:`side` m.
    Each defender runs to where the ball will soon be. He wins it if it is within his reach and closer to him than to the player.
    Observation, on the ground, to the right and ahead: the ball from the player, m; its velocity and that of the player, m/s; the player's offset from the middle of the strip and his
    distance from the line, m; then for each defender his place from the player, m, and his velocity, m/s.
    Action, 4 numbers from -1 to 1: the velocity to run at, to the right and ahead, of :attr:`speed`; and a kick along the ground, to the right and ahead, of :attr:`kick_speed`.
    A kick needs the ball within :attr:`reach`. A kick of less than 5% is none.
    Reward: the metres by which the ball gets closer to the line, as a share of its distance; 1 more for a ball that the player brings over it; 1 less for a ball that is won, or leaves the strip.
    """

    scenario: Mapping[str, Any] = {}

    #: The number of defenders.
    defenders = 2

    #: The strip, m.
    length, side = 30.0, 10.0

    #: The player: top speed, m/s, acceleration, m/s^2, the reach of his foot, m, and the fastest kick, m/s.
    speed, acceleration, reach, kick_speed = 7.5, 8.0, 0.9, 12.0

    #: A defender: top speed, m/s, acceleration, m/s^2, reach, m, and how far he looks ahead, s.
    defender_speed, defender_acceleration, defender_reach, ahead = 5.5, 5.0, 0.7, 0.3

    dt, every, seconds = 1 / 60, 6, 20.0

    def __init__(self, num_envs: int = 1) -> None:
        high = np.array([40.0] * 2 + [60.0] * 2 + [self.speed] * 2 + [40.0, 70.0] + ([60.0] * 2 + [self.defender_speed] * 2) * self.defenders)
        super().__init__(num_envs, -high, high, actions=4)
        self.scene = Scene(dict(self.scenario))
        self._balls = Balls(self.scene, num_envs)
        # Places and velocities on the ground, x and z: the player, then his defenders.
        self._place = np.zeros((num_envs, 1 + self.defenders, 2))
        self._velocity = np.zeros_like(self._place)
        self._steps = np.zeros(num_envs, np.int64)
        self._begin(np.ones(num_envs, bool))

    def step(self, actions: ArrayLike) -> Step:
        """Kicks and moves for 0.1 s, and starts the next episodes where one ended."""
        actions = self._checked(actions) * [1.0, -1.0, 1.0, -1.0]
        before = self._balls.position[:, 2].copy()
        self._kick(actions[:, 2:])
        self._run(0, self.speed * _within(actions[:, :2], 1.0), self.acceleration)
        ball = self._balls.position[:, ::2]
        for i in range(1, 1 + self.defenders):
            way = ball + self.ahead * self._balls.velocity[:, ::2] - self._place[:, i]
            self._run(i, _within(way / 0.3, self.defender_speed), self.defender_acceleration)
        self._balls.step(self.dt, self.every)
        self._place += self.every * self.dt * self._velocity
        self._steps += 1

        distance = np.linalg.norm(self._place - ball[:, None, :], axis=2)
        high = self._balls.position[:, 1]
        won = ((distance[:, 1:] < self.defender_reach) & (distance[:, 1:] < distance[:, :1])).any(1) & (high < 1)
        over = (ball[:, 1] < -self.length) & (self._place[:, 0, 1] < -self.length + 1.5) & (distance[:, 0] < 2.5) & ~won
        out = (np.abs(ball[:, 0]) > self.side) | (ball[:, 1] > 5) | (ball[:, 1] < -self.length - 5)
        lost = ~over & (won | out)
        terminated = over | lost
        truncated = ~terminated & (self._steps * self.every * self.dt >= self.seconds)
        reward = (before - ball[:, 1]) / self.length + over - lost
        return self._ended(reward, terminated, truncated, {"over": over, "lost": lost})

    def _kick(self, kick: NDArray[np.float64]) -> None:
        close = np.linalg.norm(self._balls.position[:, ::2] - self._place[:, 0], axis=1) < self.reach
        kicks = close & (self._balls.position[:, 1] < 0.6) & (np.linalg.norm(kick, axis=1) >= 0.05)
        if kicks.any():
            velocity = np.zeros((self.num_envs, 3))
            velocity[:, ::2] = self.kick_speed * _within(kick, 1.0)
            self._balls.kick(kicks, velocity[kicks])

    def _run(self, i: int, wanted: NDArray[np.float64], acceleration: float) -> None:
        self._velocity[:, i] += _within(wanted - self._velocity[:, i], acceleration * self.every * self.dt)

    def _begin(self, which: NDArray[np.bool_]) -> None:
        n = int(which.sum())
        low, high = -self.side + 3, self.side - 3
        start = np.stack([self._random.uniform(low, high, n), np.zeros(n)], 1)
        self._place[which, 0] = start
        # The defenders stand behind one another, each in his part of the way.
        for i in range(self.defenders):
            ahead = self.length * (i + self._random.uniform(0.5, 1.0, n)) / self.defenders
            self._place[which, 1 + i] = np.stack([self._random.uniform(low, high, n), -ahead], 1)
        self._velocity[which] = 0
        self._steps[which] = 0
        if n:
            self._balls.place(which, np.stack([start[:, 0], np.zeros(n), start[:, 1] - 0.5], 1))

    def _observe(self) -> NDArray[np.float32]:
        player = self._place[:, :1]
        ball = np.stack([self._balls.position[:, ::2], self._balls.velocity[:, ::2]], 1)
        ball[:, 0] -= player[:, 0]
        others = np.stack([self._place[:, 1:] - player, self._velocity[:, 1:]], 2).reshape(self.num_envs, 2 * self.defenders, 2)
        # Ahead is -z.
        pairs = np.concatenate([ball, self._velocity[:, :1], others], 1) * [1.0, -1.0]
        place = np.stack([player[:, 0, 0], self.length + player[:, 0, 1]], 1)
        numbers = np.hstack([pairs[:, :3].reshape(self.num_envs, 6), place, pairs[:, 3:].reshape(self.num_envs, 4 * self.defenders)])
        box = self.single_observation_space
        return np.clip(numbers, box.low, box.high).astype(np.float32)


def _within(vectors: NDArray[np.float64], most: float) -> NDArray[np.float64]:
    """Vectors shortened to a length."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors * np.minimum(1.0, most / np.maximum(length, 1e-300))
