"""Who gets the ball, and who scores."""

from __future__ import annotations

import ctypes
import enum
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _structs, _watch
from ._balls import Balls
from ._points import Floats, column_of, is_frame, kloppy_scale, names_of, up
from ._scene import Scene

# With more kicks, a call takes long enough for its own thread.
_LONG = 5000

window_dtype = _structs.WINDOW
"""The type of a time interval in which a player can reach the ball: player; start and end, s; position, m, and velocity, m/s, of the ball at the start."""


class ChanceMethod(enum.IntEnum):
    """The method that computed a chance to score."""

    DERIVATIVES = 0
    FLIGHTS = 1


class Players:
    """Players who run to the ball. The defaults are a fit adult's.

    Parameters
    ----------
    position: where the players are, one of these:

        - (n, 3) or (3,), m, with y up; the height is ignored
        - a data frame, of pandas or alike, with columns x and y on the ground and z up, m, and optionally ``vx`` and ``vy``, m/s
        - a frame of a tracking dataset of kloppy: its ``players_coordinates`` in the order of the frame. A frame has no velocities

    velocity: (n, 3) or (3,), m/s; default 0, or the columns of the data frame.
    reaction: the reaction time, s. Until then, a player keeps his velocity. acceleration: m/s^2. speed: the top speed, m/s. reach: the maximum horizontal distance of the ball, m.
    heights: the minimum and maximum height of the ball's centre that he can play, m: up to about 0.6 with the foot, 2.3 with the head, 2.7 with a keeper's hands.

    Each of the last five is one value, or one for each player.
    """

    def __init__(
        self, position: Any, velocity: Optional[ArrayLike] = None, reaction: Optional[ArrayLike] = None, acceleration: Optional[ArrayLike] = None, speed: Optional[ArrayLike] = None,
        reach: Optional[ArrayLike] = None, heights: Optional[ArrayLike] = None
    ) -> None:
        places, moves = _places(position)
        n = len(places)
        self._rows = np.zeros(n, _structs.PLAYER)
        if n:
            _native.check(_native.player_default(self._rows.ctypes.data))
            self._rows[:] = self._rows[0]
        self._rows["position"] = places
        given = [("velocity", moves if velocity is None else velocity, (n, 3)), ("reaction", reaction, (n,)), ("acceleration", acceleration, (n,)), ("speed", speed, (n,)), ("reach", reach, (n,))]
        if heights is not None:
            low_high = np.asarray(heights, np.float64)
            if low_high.shape not in ((2,), (n, 2)):
                raise ValueError(f"heights has shape {low_high.shape}; allowed: (2,) or ({n}, 2).")
            given += [("minimum_height", low_high[..., 0], (n,)), ("maximum_height", low_high[..., 1], (n,))]
        for name, value, shape in given:
            if value is not None:
                try:
                    self._rows[name] = np.broadcast_to(np.asarray(value, np.float64), shape)
                except ValueError:
                    raise ValueError(f"{name} has shape {np.shape(value)}; allowed: {shape}, or one value for all.") from None

    def __len__(self) -> int:
        return len(self._rows)

    def request(self, player: int = 0) -> Mapping[str, Any]:
        """Returns a player as the member ``keeper`` of a chance to score."""
        row = self._rows[player]
        return {
            **{name: row[name].tolist() for name in ("position", "velocity", "reaction", "acceleration", "speed", "reach")},
            "heights": [float(row["minimum_height"]), float(row["maximum_height"])]}


@dataclass(frozen=True)
class Interception:
    """The player who reaches the ball first."""

    #: His index.
    player: int
    #: When he reaches the ball, s since its launch.
    time: float
    #: His lead over the second player, s; infinite if no other player reaches the ball.
    margin: float
    #: The position of the ball's centre then, m, and its velocity, m/s.
    position: Floats
    velocity: Floats


@dataclass(frozen=True)
class GoalChance:
    """How a player's kicks spread on the plane of a goal, and the probability that they score."""

    #: The probability of a ball on target that the goalkeeper cannot reach, 0 to 1.
    scores: float
    #: The probability of a goal if nobody stops the ball, 0 to 1.
    on_target: float
    #: The probability of a ball on target that the goalkeeper can reach in time, 0 to 1; 0 without a goalkeeper.
    covered: float
    #: The standard error of ``scores``; 0 if derivatives were used.
    standard_error: float
    #: The share of the kicks that cross the plane of the goal, 0 to 1; the following numbers refer to these kicks.
    crosses: float
    #: The mean offset to the right of the goal's centre as the goalkeeper sees it, m, the mean height, m, and the mean time since the kick, s.
    aside: float
    height: float
    time: float
    #: The standard deviations of offset and height, m, and their correlation, -1 to 1.
    aside_deviation: float
    height_deviation: float
    correlation: float
    method: ChanceMethod
    #: The number of simulated kicks.
    kicks: int


def intercept(balls: Balls, players: Any, seconds: float = 10.0, ball: int = 0) -> Optional[Interception]:
    """Finds the player who reaches a ball first; None if nobody does.

    balls: the balls, unchanged. For a match, use :meth:`Match.balls_in`.
    players: :class:`Players`, or what it accepts as positions.
    seconds: how far to look, s, at most 3600. ball: the index of the ball.
    """
    found, rows = np.zeros(1, _structs.INTERCEPTION), _rows_of(players)
    _native.check(_native.intercept(balls.scene.handle, balls._state_at(ball), seconds, rows.ctypes.data if len(rows) else None, len(rows), found.ctypes.data))
    row = found[0]
    if row["player"] < 0:
        return None
    return Interception(int(row["player"]), float(row["time"]), float(row["margin"]), row["position"].copy(), row["velocity"].copy())


def intercept_windows(balls: Balls, players: Any, seconds: float = 10.0, ball: int = 0) -> NDArray[Any]:
    """Finds all time intervals in which each player can reach a ball: an array of :data:`window_dtype`, sorted by player, then by time. For the arguments, see :func:`intercept`."""
    rows, count = _rows_of(players), ctypes.c_int32()
    windows = np.zeros(8 * len(rows), window_dtype)
    while True:
        status = _native.intercept_windows(
            balls.scene.handle, balls._state_at(ball), seconds, rows.ctypes.data if len(rows) else None, len(rows), windows.ctypes.data if len(windows) else None, len(windows),
            ctypes.byref(count))
        if status != _native.BUFFER:
            _native.check(status)
            return windows[: count.value].copy()
        windows = np.zeros(count.value, window_dtype)


def goal_chance(
    scene: Scene, position: ArrayLike, velocity: ArrayLike, spin: ArrayLike = (0.0, 0.0, 0.0), keeper: Optional[Players] = None, spread: Optional[Mapping[str, float]] = None,
    progress: _watch.Progress = None, **request: Any
) -> GoalChance:
    """Computes the probability that a player's kick scores.

    scene: a scene with a goal. position, velocity, spin: (3,); m, m/s, rad/s: the intended kick.
    keeper: the goalkeeper: :class:`Players` with one player; default none.
    spread: how the kicks vary: ``speedPercent``, ``elevationDegrees``, ``azimuthDegrees``, ``spinPercent``, and their correlations.
    progress: a function that receives the progress, 0 to 1, about 20 times per second; default none. An exception that it raises cancels the call, as Ctrl-C does.
    request: ``goal``, the index of the goal; ``kicks``, the number of kicks to simulate, at 2 to 6 microseconds each; ``seed``; ``alwaysSimulate``;
    ``orientation``, (x, y, z, w) of the ball, for the knuckle force.
    """
    members = {"position": _vector(position, "position"), "velocity": _vector(velocity, "velocity"), "spin": _vector(spin, "spin"), **request}
    if keeper is not None:
        if len(keeper) != 1:
            raise ValueError(f"keeper has {len(keeper)} players; allowed: 1.")
        members["keeper"] = keeper.request()
    if spread is not None:
        members["spread"] = dict(spread)
    text, found = _native.text(members), np.zeros(1, _structs.GOAL_CHANCE)
    kicks = request.get("kicks")
    if progress is not None or (isinstance(kicks, (int, np.integer)) and kicks > _LONG):
        status, sentence = _watch.call(_native.goal_chance, scene.handle, text, len(text), found.ctypes.data, keep=(scene, found), progress=progress)
        if status:
            _native.fail(status, sentence)
    else:
        _native.check(_native.goal_chance(scene.handle, text, len(text), found.ctypes.data, None))
    row = found[0]
    numbers = {name: float(row[name]) for name in (_structs.GOAL_CHANCE.names or ())[:-2]}
    return GoalChance(**numbers, method=ChanceMethod(int(row["method"])), kicks=int(row["kicks"]))


def _vector(values: ArrayLike, name: str) -> Any:
    vector = np.asarray(values, np.float64)
    if vector.shape != (3,):
        raise ValueError(f"{name} has shape {vector.shape}; allowed: (3,).")
    return vector.tolist()


def _rows_of(players: Any) -> NDArray[Any]:
    return (players if isinstance(players, Players) else Players(players))._rows


def _places(source: Any) -> Tuple[Floats, Optional[Floats]]:
    """Positions with y up, and velocities where the source has some."""
    if hasattr(source, "players_coordinates"):
        unit, side = kloppy_scale(source.dataset)
        points = [(point.x, point.y) for point in source.players_coordinates.values()]
        ground = np.array(points, np.float64).reshape(-1, 2) * unit
        return up(ground[:, 0], side * ground[:, 1], np.zeros(len(ground))), None
    if is_frame(source):
        have = names_of(source)
        if not {"x", "y"} <= set(have):
            raise ValueError(f"the columns are {', '.join(have)}; allowed: x, y, with vx, vy.")
        x, y = column_of(source, "x"), column_of(source, "y")
        moves = up(column_of(source, "vx"), column_of(source, "vy"), np.zeros(len(x))) if {"vx", "vy"} <= set(have) else None
        return up(x, y, np.zeros(len(x))), moves
    places = np.atleast_2d(np.asarray(source, np.float64))
    if places.size == 0:
        places = np.zeros((0, 3))
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"position has shape {np.shape(source)}; allowed: (n, 3) or (3,).")
    return places, None
