"""A goalkeeper who learns to save shots: a body in a match of its own for each environment."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._balls import EventKind
from ._environment import Environment, Step
from ._match import Match


class Goalkeeper(Environment):
    """A goalkeeper against shots, for ``num_envs`` shots at once. A step lasts :attr:`every` seconds; an episode is one shot.

    Observation, 10 numbers: the ball's position, m, and velocity, m/s, 3 each; the keeper's offset, m, and speed, m/s, to the right; his lean, rad, and its rate, rad/s.
    Right and left are as the shooter sees them: right is +x. The goal line is at z = -11 m.
    Action, 2 numbers from -1 to 1: the speed to the right, of :attr:`speed`, and the rate of the lean to the right, of :attr:`turn`. A lean turns the keeper about his feet: a dive.
    Reward: at the end of an episode 1 for a save, -1 for a goal, 0 for a shot that misses; otherwise 0.
    """

    #: The scene: the goal, and the keeper as a box that stands on its position.
    scenario: Mapping[str, Any] = {
        "goals": [{"center": [0, 0, -11], "facing": [0, 0, 1]}],
        "bodies": [{"name": "keeper", "shape": "box", "center": [0, 0.95, 0], "halfSize": [0.3, 0.95, 0.15], "surface": {"normalRestitution": 0.4}}]}

    #: The keeper's top speed, m/s, acceleration, m/s^2, and greatest rate of the lean, rad/s.
    speed, acceleration, turn = 5.0, 15.0, 4.0

    #: Bounds of the keeper's offset, m, and lean, rad. His distance before the goal line, m.
    side, lean, off_line = 3.3, 1.4, 0.4

    dt, every, seconds = 1 / 60, 6, 2.5

    def __init__(self, num_envs: int = 1) -> None:
        high = [60.0, 30.0, 60.0, 60.0, 60.0, 60.0, self.side, self.speed, self.lean, self.turn]
        super().__init__(num_envs, [-number for number in high], high, actions=2)
        self._matches = [Match(self.scenario, 1, self.dt) for _ in range(num_envs)]
        self._ball = np.zeros((num_envs, 6))
        self._keeper = np.zeros((num_envs, 4))
        self._steps = np.zeros(num_envs, np.int64)
        self._touched = np.zeros(num_envs, bool)
        self._begin(np.ones(num_envs, bool))

    def close(self) -> None:
        """Frees the matches."""
        for match in self._matches:
            match.close()

    def step(self, actions: ArrayLike) -> Step:
        """Moves all keepers, simulates :attr:`every` ticks, and starts the next episodes where one ended."""
        self._move(self._checked(actions))
        goal = np.zeros(self.num_envs, bool)
        for i, match in enumerate(self._matches):
            self._stand(i)
            events = match.step(self.every)
            if len(events):
                goal[i] = (events["kind"] == EventKind.GOAL).any()
                self._touched[i] |= bool((events["body"] == 0).any())
            ball = match.balls()[0]
            self._ball[i, :3], self._ball[i, 3:] = ball["position"], ball["velocity"]
        self._steps += 1
        self._keeper[:, ::2] += self.every * self.dt * self._keeper[:, 1::2]
        past = self._ball[:, 2] < -11.5
        away = self._touched & (self._ball[:, 5] >= 0)
        terminated = goal | past | away
        truncated = ~terminated & (self._steps * self.every * self.dt >= self.seconds)
        ended = terminated | truncated
        saved = ended & ~goal & self._touched
        reward = np.where(goal, -1.0, np.where(saved, 1.0, 0.0))
        return self._ended(reward, terminated, truncated, {"goal": goal, "saved": saved})

    def _move(self, actions: NDArray[np.float64]) -> None:
        """Sets the speeds of the next step, within the keepers' bounds at its end."""
        lasts = self.every * self.dt
        change = np.clip(self.speed * actions[:, 0] - self._keeper[:, 1], -self.acceleration * lasts, self.acceleration * lasts)
        for column, speed, bound in ((0, self._keeper[:, 1] + change, self.side), (2, self.turn * actions[:, 1], self.lean)):
            at = self._keeper[:, column]
            self._keeper[:, column + 1] = (np.clip(at + lasts * speed, -bound, bound) - at) / lasts

    def _stand(self, i: int) -> None:
        offset, speed, lean, rate = self._keeper[i]
        # The goal is at -z: a lean to the right, from up to +x, is a negative turn about z.
        self._matches[i].move_bodies((offset, 0.0, -11 + self.off_line), (0.0, 0.0, -np.sin(lean / 2), np.cos(lean / 2)), (speed, 0.0, 0.0), (0.0, 0.0, -rate))

    def _begin(self, which: NDArray[np.bool_]) -> None:
        chosen = np.flatnonzero(which)
        n = len(chosen)
        start = self._random.uniform([-6.0, 0.11, -1.0], [6.0, 0.11, 9.0], (n, 3))
        to = self._random.uniform([-3.4, 0.2, -11.0], [3.4, 2.3, -11.0], (n, 3))
        speed, side_spin = self._random.uniform(17, 28, n), self._random.uniform(-30, 30, n)
        way = to - start
        # The air takes about 1% of the speed on each metre.
        time = np.hypot(way[:, 0], way[:, 2]) / speed
        time *= 1 + 0.005 * np.hypot(way[:, 0], way[:, 2])
        velocity = way / time[:, None] * (1 + 0.005 * np.hypot(way[:, 0], way[:, 2])[:, None])
        velocity[:, 1] = way[:, 1] / time + 0.5 * 9.81 * time
        for row, i in enumerate(chosen):
            self._matches[i].place(0, start[row])
            self._matches[i].kick(0, velocity[row], (0.0, side_spin[row], 0.0))
        self._ball[chosen] = np.hstack([start, velocity])
        self._keeper[chosen] = 0
        self._steps[chosen] = 0
        self._touched[chosen] = False

    def _observe(self) -> NDArray[np.float32]:
        box = self.single_observation_space
        return np.clip(np.hstack([self._ball, self._keeper]), box.low, box.high).astype(np.float32)
