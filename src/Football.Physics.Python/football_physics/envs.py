"""Vectorised environments: a penalty, a free kick over a wall, a goalkeeper, and a dribble past defenders. They follow the vector environments of Gymnasium.

Gymnasium is optional; if it is installed, the spaces are Gymnasium's own. If an episode ends, ``step`` returns the first observation of the next one;
``info["final_obs"]`` then contains the last observations, and ``info["_final_obs"]`` is true for each episode that ended.
For :class:`Penalty` and :class:`FreeKick`, an episode is one action: the kick. :class:`Balls` simulates the kick, with one call per tick for all balls of a batch.
The episode ends when the ball crosses the goal's plane, or after :attr:`Shot.seconds`.
"""

from __future__ import annotations

from typing import Any, Mapping, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._balls import Balls
from ._dribble import Dribble
from ._environment import Box, Environment, Step
from ._goalkeeper import Goalkeeper
from ._scene import Scene

__all__ = ["Box", "Dribble", "Environment", "FreeKick", "Goalkeeper", "Penalty", "Shot"]

GOAL_HALF_WIDTH, GOAL_HEIGHT, BALL_RADIUS = 3.66, 2.44, 0.11


class Shot(Environment):
    """A kick at a goal with a keeper, for ``num_envs`` balls at once.

    Observation, 2 numbers: the keeper's position, m from the middle (positive to the right), and the seconds until he moves.
    Action, 5 numbers from -1 to 1: speed, elevation, direction, topspin and sidespin, between the bounds :attr:`low` and :attr:`high`.
    Reward: 1 for a goal. Otherwise minus the distance, m, by which the ball misses the goal or is within the keeper's reach, at least -1; -1 if the ball does not reach the goal.
    """

    #: The distance of the goal, m, and the other members of the scene.
    distance = 11.0
    scenario: Mapping[str, Any] = {}

    #: Bounds of the kick: m/s, degrees above the ground, degrees to the left, rad/s, rad/s.
    low = np.array([15.0, 0.0, -20.0, -40.0, -60.0])
    high = np.array([32.0, 30.0, 20.0, 60.0, 60.0])

    #: The reach of the standing keeper, m, and the speed at which it grows once he moves, m/s.
    reach, dive = 0.9, 3.5

    dt, seconds = 1 / 60, 2.5

    def __init__(self, num_envs: int = 1) -> None:
        super().__init__(num_envs, [-1.5, 0.0], [1.5, 0.4], actions=5)
        self.scene = Scene(dict(self.scenario))
        self._balls = Balls(self.scene, num_envs)
        self._begin(np.ones(num_envs, bool))

    def kick(self, actions: ArrayLike) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the velocities and spins of actions."""
        share = self._checked(actions) / 2 + 0.5
        speed, elevation, direction, top, side = (self.low + share * (self.high - self.low)).T
        up, turned = np.radians(elevation), np.radians(direction)
        flat = np.stack([-np.sin(turned), np.zeros_like(turned), -np.cos(turned)], 1)
        velocity = speed[:, None] * (np.cos(up)[:, None] * flat + np.sin(up)[:, None] * np.array([0.0, 1.0, 0.0]))
        # Topspin turns about the horizontal axis across the kick, up x forward.
        spin = np.stack([top * flat[:, 2], side, -top * flat[:, 0]], 1)
        return velocity, spin

    def step(self, actions: ArrayLike) -> Step:
        """Kicks all balls, simulates them to the goal, and starts the next episodes."""
        velocity, spin = self.kick(actions)
        self._balls.place(None, (0.0, 0.0, 0.0), velocity, spin)
        crossing, time = self._fly()
        reward = self._reward(crossing, time)
        info = {"crossing": crossing, "time": time, "goal": reward == 1.0}
        return self._ended(reward, np.ones(self.num_envs, bool), np.zeros(self.num_envs, bool), info)

    def _begin(self, which: NDArray[np.bool_]) -> None:
        # An episode is one step, so all of them begin together.
        box = self.single_observation_space
        self._observation = self._random.uniform(box.low, box.high, (self.num_envs, 2)).astype(np.float32)

    def _observe(self) -> NDArray[np.float32]:
        return self._observation.copy()

    def _fly(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns where, (x, y), and when the balls cross the goal's plane; NaN for a ball that does not cross it."""
        crossing, time = np.full((self.num_envs, 2), np.nan), np.full(self.num_envs, np.nan)
        position = self._balls.position
        for tick in range(int(self.seconds / self.dt)):
            before = position.copy()
            self._balls.step(self.dt)
            now = np.isnan(time) & (before[:, 2] > -self.distance) & (position[:, 2] <= -self.distance)
            if now.any():
                share = (before[now, 2] + self.distance) / (before[now, 2] - position[now, 2])
                crossing[now] = before[now, :2] + share[:, None] * (position[now, :2] - before[now, :2])
                time[now] = (tick + share) * self.dt
                if not np.isnan(time).any():
                    break
        return crossing, time

    def _reward(self, crossing: NDArray[np.float64], time: NDArray[np.float64]) -> NDArray[np.float64]:
        inside = np.maximum(np.abs(crossing[:, 0]) - GOAL_HALF_WIDTH, crossing[:, 1] - GOAL_HEIGHT) + BALL_RADIUS
        keeper, waits = self._observation.T
        from_keeper = np.hypot(crossing[:, 0] - keeper, crossing[:, 1] - 1.0)
        saved = self.reach + self.dive * np.maximum(0.0, time - waits) - from_keeper
        miss = np.maximum(inside, saved)
        return np.where(np.isnan(time), -1.0, np.where(miss <= 0, 1.0, -np.minimum(np.maximum(miss, 1e-9), 1.0)))


class Penalty(Shot):
    """A penalty from 11 m against a keeper who waits."""


class FreeKick(Shot):
    """A free kick from 22 m over a wall that is 1.85 m high and 9.15 m away. The keeper may stand anywhere."""

    distance = 22.0
    low = np.array([18.0, 5.0, -20.0, -40.0, -80.0])
    high = np.array([32.0, 35.0, 20.0, 60.0, 80.0])
    scenario: Mapping[str, Any] = {
        "obstacles": [{"name": "wall", "shape": "box", "center": [0, 0.925, -9.15], "halfSize": [1.25, 0.925, 0.2], "surface": {"normalRestitution": 0.3}}]
    }
