"""Vectorised environments for one kick: a penalty, and a free kick over a wall. They follow the vector environments of Gymnasium.

Gymnasium is optional; if it is installed, the spaces are Gymnasium's own. An episode is one action: the kick. :class:`Balls` simulates the kick, with one call per
tick for all balls of a batch. An episode ends when the ball crosses the goal's plane, or after :attr:`seconds`. ``step`` returns the first observation of the next
episode; ``info["final_obs"]`` contains the last observation of the finished one.
"""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._balls import Balls
from ._scene import Scene

try:
    from gymnasium.spaces import Box
except ImportError:

    class Box:  # type: ignore[no-redef]
        """A box of numbers with the members of Gymnasium's ``Box``: ``low``, ``high``, ``shape``, ``dtype``, ``sample``, ``contains``."""

        def __init__(self, low: Any, high: Any, shape: Optional[Tuple[int, ...]] = None, dtype: Any = np.float32, seed: Optional[int] = None) -> None:
            self.shape = np.shape(low) if shape is None else shape
            self.dtype = np.dtype(dtype)
            self.low = np.broadcast_to(np.asarray(low, dtype), self.shape)
            self.high = np.broadcast_to(np.asarray(high, dtype), self.shape)
            self._random = np.random.default_rng(seed)

        def seed(self, seed: Optional[int] = None) -> None:
            """Restarts the random samples."""
            self._random = np.random.default_rng(seed)

        def sample(self) -> NDArray[Any]:
            """Returns a random point of the box."""
            return self._random.uniform(self.low, self.high).astype(self.dtype)

        def contains(self, x: Any) -> bool:
            """Returns True if x is in the box."""
            x = np.asarray(x)
            return x.shape == self.shape and bool(np.all(x >= self.low) and np.all(x <= self.high))


GOAL_HALF_WIDTH, GOAL_HEIGHT, BALL_RADIUS = 3.66, 2.44, 0.11


class Shot:
    """A kick at a goal with a keeper, for ``num_envs`` balls at once.

    Observation, 2 numbers: the keeper's position, m from the middle (positive to the right), and the seconds until he moves.
    Action, 5 numbers from -1 to 1: speed, elevation, direction, topspin and sidespin, between the bounds :attr:`low` and :attr:`high`.
    Reward: 1 for a goal. Otherwise minus the distance, m, by which the ball misses the goal or is within the keeper's reach, at least -1; -1 if the ball does not reach the goal.
    """

    metadata: Dict[str, Any] = {"render_modes": [], "autoreset_mode": "SameStep"}

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
        self.num_envs = num_envs
        self.scene = Scene(dict(self.scenario))
        self._balls = Balls(self.scene, num_envs)
        self.single_observation_space = Box(np.array([-1.5, 0.0]), np.array([1.5, 0.4]), dtype=np.float32)
        self.single_action_space = Box(-1.0, 1.0, shape=(5,), dtype=np.float32)
        self.observation_space = Box(np.tile(self.single_observation_space.low, (num_envs, 1)), np.tile(self.single_observation_space.high, (num_envs, 1)), dtype=np.float32)
        self.action_space = Box(-1.0, 1.0, shape=(num_envs, 5), dtype=np.float32)
        self._random = np.random.default_rng()
        self._observation = self._draw()

    def reset(self, *, seed: Optional[int] = None, options: Optional[Mapping[str, Any]] = None) -> Tuple[NDArray[np.float32], Dict[str, Any]]:
        """Starts new episodes. There are no options: any key in ``options`` raises ValueError."""
        if options:
            raise ValueError(f"options has the key {next(iter(options))!r}; allowed: none.")
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self._observation = self._draw()
        return self._observation.copy(), {}

    def kick(self, actions: ArrayLike) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the velocities and spins of actions."""
        share = np.clip(np.asarray(actions, np.float64), -1, 1) / 2 + 0.5
        speed, elevation, direction, top, side = (self.low + share * (self.high - self.low)).T
        up, turned = np.radians(elevation), np.radians(direction)
        flat = np.stack([-np.sin(turned), np.zeros_like(turned), -np.cos(turned)], 1)
        velocity = speed[:, None] * (np.cos(up)[:, None] * flat + np.sin(up)[:, None] * np.array([0.0, 1.0, 0.0]))
        # Topspin turns about the horizontal axis across the kick, up x forward.
        spin = np.stack([top * flat[:, 2], side, -top * flat[:, 0]], 1)
        return velocity, spin

    def step(self, actions: ArrayLike) -> Tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Dict[str, Any]]:
        """Kicks all balls, simulates them to the goal, and starts the next episodes."""
        if np.shape(actions) != (self.num_envs, 5):
            raise ValueError(f"actions have shape {np.shape(actions)}; allowed: ({self.num_envs}, 5).")
        velocity, spin = self.kick(actions)
        self._balls.place(None, (0.0, 0.0, 0.0), velocity, spin)
        crossing, time = self._fly()
        reward = self._reward(crossing, time)
        last, self._observation = self._observation, self._draw()
        info = {"final_obs": last, "crossing": crossing, "time": time, "goal": reward == 1.0}
        return self._observation.copy(), reward, np.ones(self.num_envs, bool), np.zeros(self.num_envs, bool), info

    def close(self) -> None:
        """Does nothing: the memory is released with the object."""

    def _draw(self) -> NDArray[np.float32]:
        box = self.single_observation_space
        return self._random.uniform(box.low, box.high, (self.num_envs, 2)).astype(np.float32)

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
