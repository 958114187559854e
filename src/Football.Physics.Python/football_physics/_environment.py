"""What all environments share: spaces, seeds, and the checks of options and actions."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

try:
    from gymnasium.spaces import Box  # type: ignore[import]
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


Step = Tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Dict[str, Any]]


class Environment:
    """A vector environment as Gymnasium describes them, with ``num_envs`` environments. Every array that it returns is the caller's own."""

    metadata: Dict[str, Any] = {"render_modes": [], "autoreset_mode": "SameStep"}

    def __init__(self, num_envs: int, low: ArrayLike, high: ArrayLike, actions: int) -> None:
        if num_envs < 1:
            raise ValueError(f"num_envs is {num_envs}; allowed: 1 or more.")
        self.num_envs = num_envs
        low, high = np.asarray(low, np.float64), np.asarray(high, np.float64)
        self.single_observation_space = Box(low, high, dtype=np.float32)
        self.single_action_space = Box(-1.0, 1.0, shape=(actions,), dtype=np.float32)
        self.observation_space = Box(np.tile(low, (num_envs, 1)), np.tile(high, (num_envs, 1)), dtype=np.float32)
        self.action_space = Box(-1.0, 1.0, shape=(num_envs, actions), dtype=np.float32)
        self._random = np.random.default_rng()

    def reset(self, *, seed: Optional[int] = None, options: Optional[Mapping[str, Any]] = None) -> Tuple[NDArray[np.float32], Dict[str, Any]]:
        """Starts new episodes. There are no options: any key in ``options`` raises ValueError."""
        if options:
            raise ValueError(f"options has the key {next(iter(options))!r}; allowed: none.")
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self._begin(np.ones(self.num_envs, bool))
        return self._observe(), {}

    def close(self) -> None:
        """Does nothing: the memory is released with the object."""

    def _checked(self, actions: ArrayLike) -> NDArray[np.float64]:
        """Actions within -1 and 1."""
        checked = np.asarray(actions, np.float64)
        if checked.shape != self.action_space.shape:
            raise ValueError(f"actions have shape {checked.shape}; allowed: {self.action_space.shape}.")
        if not np.isfinite(checked).all():
            raise ValueError("actions contain a number that is not finite; allowed: -1 to 1.")
        return np.clip(checked, -1, 1)

    def _ended(self, reward: NDArray[np.float64], terminated: NDArray[np.bool_], truncated: NDArray[np.bool_], info: Dict[str, Any]) -> Step:
        """The result of a step, with the next episodes begun where one ended."""
        ended = terminated | truncated
        if ended.any():
            info.update({"final_obs": self._observe(), "_final_obs": ended})
            self._begin(ended)
        return self._observe(), reward, terminated, truncated, info

    def _begin(self, which: NDArray[np.bool_]) -> None:
        """Begins new episodes where a mask is true."""
        raise NotImplementedError

    def _observe(self) -> NDArray[np.float32]:
        """Returns the observations as a new array."""
        raise NotImplementedError
