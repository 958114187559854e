"""Matches: balls and moving bodies that are stepped together."""

from __future__ import annotations

import ctypes
import json
import weakref
from typing import Any, Mapping, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _structs
from ._balls import Balls
from ._scene import Scene, impact_dtype

ball_dtype = _structs.BALL
"""The type of a ball of a match: position, m; velocity, m/s; spin, rad/s; orientation x, y, z, w; time, s; motion."""

body_dtype = _structs.BODY
"""The type of a body of a match: as a ball, and impulse, the impulse of the balls on it in the last step, N s; in_play, 1 or 0."""

match_event_dtype = _structs.MATCH_EVENT
"""The type of an event of a match: the members of fp_match_event."""

# The library keeps this number of events of a step: the first 1008 and the last 16. With more room, the call would not tell how many it has written.
_MOST_EVENTS = 1024


def _text(scenario: Union[str, Mapping[str, Any]]) -> bytes:
    return scenario.encode() if isinstance(scenario, str) else _native.text(scenario)


def _balls_of(text: bytes) -> int:
    """The number of balls of a scenario."""
    try:
        balls = json.loads(text).get("balls")
    except (ValueError, AttributeError):
        # The library rejects the text, and tells why.
        return 1
    return max(1, len(balls)) if isinstance(balls, list) else 1


def _broadcast(values: ArrayLike, shape: Any, name: str) -> NDArray[Any]:
    try:
        return np.broadcast_to(np.asarray(values, np.float64), shape)
    except ValueError:
        raise ValueError(f"{name} has shape {np.shape(values)}; allowed: {shape}, or one value for all.") from None


class Match:
    """One or more balls, and bodies that you move: players, feet, keepers. All that it returns are copies.

    A match is a context manager: ``with Match(...) as match:`` frees its memory at the end. Threads may share a match; their calls wait for each other.

    Parameters
    ----------
    scenario: JSON text, or a dict, with the members of a scene (see :class:`Scene`) and ``bodies``. Obstacles and bodies can have a ``mass``, kg.
        ``balls``, a list such as ``[{"ball": {"type": "beachBall"}}, {}]``, gives each ball its own size, mass and drag; ``ballContact`` is the material of their contacts.
    balls: the number of balls, 1 to 10 000; default the number of ``balls`` in the scenario, or 1. They start at rest on the ground, side by side along x from the origin.
    dt: the length of a step, s.
    """

    def __init__(self, scenario: Union[str, Mapping[str, Any]] = "{}", balls: Optional[int] = None, dt: float = 1 / 60) -> None:
        text, handle = _text(scenario), ctypes.c_void_p()
        balls = _balls_of(text) if balls is None else balls
        _native.check(_native.match_create(text, len(text), _native.whole(balls, "balls"), dt, ctypes.byref(handle)))
        self._own(handle, balls)

    @classmethod
    def replay(cls, scenario: Union[str, Mapping[str, Any]], recording: bytes) -> "Match":
        """Returns a match at the start of a recording in the same scene. Its steps repeat the recorded kicks, restarts and motions; you can only step, seek, verify and read it."""
        text, handle = _text(scenario), ctypes.c_void_p()
        _native.check(_native.match_replay(text, len(text), bytes(recording), len(recording), ctypes.byref(handle)))
        match = cls.__new__(cls)
        match._own(handle, None)
        return match

    def _own(self, handle: ctypes.c_void_p, balls: Optional[int]) -> None:
        self._value = handle.value or 0
        self._free = weakref.finalize(self, _native.match_free, self._value)
        self._balls = self._count(_native.match_read_balls, ball_dtype) if balls is None else int(balls)
        self._bodies = self._count(_native.match_read_bodies, body_dtype)
        self.dropped = 0

    def _count(self, read: Any, dtype: Any) -> int:
        """The number of items that a function reads."""
        item, low, high = np.zeros(1, dtype), 0, 1
        while not read(self._value, high - 1, 1, item.ctypes.data):
            low, high = high, 2 * high
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if not read(self._value, middle - 1, 1, item.ctypes.data) else (low, middle)
        return low

    @property
    def _handle(self) -> int:
        if not self._free.alive:
            raise ValueError("the match is closed; allowed: an open match.")
        return self._value

    def close(self) -> None:
        """Frees the memory of the match. After that, only ``close`` does not raise ValueError."""
        self._free()

    def __enter__(self) -> "Match":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    @property
    def tick(self) -> int:
        """The number of steps since the match began."""
        return int(_native.match_tick(self._handle))

    @property
    def hash(self) -> int:
        """The hash of all balls, as ``Snapshot.Hash`` returns it in C#."""
        return int(_native.match_hash(self._handle))

    def name_of(self, thing: int) -> str:
        """Returns the name of the object of an event: "ground", "left post", or the name of a body or an obstacle; "" for -1."""
        room = ctypes.create_string_buffer(256)
        _native.check(_native.match_name(self._handle, _native.whole(thing, "thing"), room, len(room)))
        return room.value.decode()

    def place(self, ball: int, position: ArrayLike) -> None:
        """Places a ball at rest at once, and discards its kick and restart of the next step. position: (3,), m. A ball in the ground is raised onto it. A recording ends."""
        at = _broadcast(position, (3,), "position").copy()
        _native.check(_native.match_place(self._handle, _native.whole(ball, "ball"), at.ctypes.data))

    def queue_place(
        self, ball: int, position: ArrayLike, velocity: ArrayLike = 0.0, spin: ArrayLike = 0.0, orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0)
    ) -> None:
        """Restarts a ball at the start of the next step, before its kick, for a kick-off, a throw-in or a corner.

        The clock and a recording continue, and no kick is discarded. A second restart of the ball before the step replaces the first.

        position: (3,), m. A ball in the ground is raised onto it.
        velocity, spin: (3,) or one number; m/s, at most 1000; rad/s, at most 10 000.
        orientation: (4,), a quaternion x, y, z, w of any length except 0.
        """
        of_place = np.array([_broadcast(position, (3,), "position"), _broadcast(velocity, (3,), "velocity"), _broadcast(spin, (3,), "spin")])
        turned = _broadcast(orientation, (4,), "orientation").copy()
        _native.check(
            _native.match_queue_place(
                self._handle, _native.whole(ball, "ball"), of_place.ctypes.data, of_place[1].ctypes.data, of_place[2].ctypes.data, turned.ctypes.data
            )
        )

    def kick(self, ball: int, velocity: ArrayLike, spin: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        """Kicks a ball at the start of the next step. velocity: (3,), m/s, at most 1000; spin: (3,), rad/s, at most 10 000. A second kick before the step replaces the first."""
        of_kick = np.array([_broadcast(velocity, (3,), "velocity"), _broadcast(spin, (3,), "spin")])
        _native.check(_native.match_kick(self._handle, _native.whole(ball, "ball"), of_kick.ctypes.data, of_kick[1].ctypes.data))

    def move_bodies(
        self, position: ArrayLike, orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0), velocity: ArrayLike = 0.0, spin: ArrayLike = 0.0, in_play: ArrayLike = True, first: int = 0
    ) -> None:
        """Moves bodies for the next step, in which they keep their velocity and spin. Bodies that you do not move continue their motion.

        position: (n, 3), m: where n bodies are now, from body ``first`` on, in the order of the scene. (3,) is one body.
        orientation: (n, 4) or (4,), quaternions x, y, z, w from body to world, of any length except 0.
        velocity, spin: (n, 3), (3,) or one number; m/s, rad/s.
        in_play: (n,) or one flag; False withdraws a body, so that no ball hits it.
        """
        if not self._bodies:
            raise ValueError("the match has no bodies to move. List them in the scenario: Match({\"bodies\": [...]}).")
        places = np.atleast_2d(np.asarray(position, np.float64))
        if places.ndim != 2 or places.shape[1] != 3:
            raise ValueError(f"position has shape {np.shape(position)}; allowed: (n, 3) or (3,).")
        n = len(places)
        ball, bodies = np.zeros(1, ball_dtype), np.zeros(n, body_dtype)
        _native.check(_native.match_read_balls(self._handle, 0, 1, ball.ctypes.data))
        bodies["position"] = places
        bodies["orientation"] = _broadcast(orientation, (n, 4), "orientation")
        bodies["velocity"] = _broadcast(velocity, (n, 3), "velocity")
        bodies["spin"] = _broadcast(spin, (n, 3), "spin")
        bodies["time"] = ball["time"]
        bodies["in_play"] = _broadcast(in_play, (n,), "in_play") != 0
        _native.check(_native.match_move_bodies(self._handle, _native.whole(first, "first"), n, bodies.ctypes.data))

    def step(self, n: int = 1) -> NDArray[Any]:
        """Takes n steps, and returns their events: an array of :data:`match_event_dtype`, ordered by step, time and ball.

        Ctrl-C ends it between two steps; :attr:`tick` then tells how many were taken. Other threads run during each step.
        The library keeps 1024 events of a step: the first 1008 and the last 16. :attr:`dropped` is the number of other events of this call.
        """
        if n < 0:
            raise ValueError(f"n is {n}; allowed: 0 or more.")
        handle, room, count, told = self._handle, np.empty(_MOST_EVENTS, match_event_dtype), ctypes.c_int32(), []
        self.dropped = 0
        at, counted = room.ctypes.data, ctypes.byref(count)
        for _ in range(n):
            status = _native.match_step(handle, at, _MOST_EVENTS, counted)
            if status not in (_native.OK, _native.BUFFER):
                _native.fail(status)
            if count.value:
                told.append(room[: count.value].copy())
                self.dropped += count.value - len(told[-1])
        return np.concatenate(told) if told else np.zeros(0, match_event_dtype)

    def impact(self, index: int) -> Any:
        """Returns the outputs of an impact, for sound, haptics and looks: a record of :data:`impact_dtype`.

        index: the index of the event in the last step, from 0. Call step() with n = 1 to have the events of one step.
        """
        outputs = np.zeros(1, impact_dtype)
        _native.check(_native.match_impact(self._handle, _native.whole(index, "index"), outputs.ctypes.data))
        return outputs[0]

    def balls(self) -> NDArray[Any]:
        """Returns the balls: an array of :data:`ball_dtype`."""
        balls = np.zeros(self._balls, ball_dtype)
        _native.check(_native.match_read_balls(self._handle, 0, self._balls, balls.ctypes.data))
        return balls

    def bodies(self) -> NDArray[Any]:
        """Returns the bodies: an array of :data:`body_dtype`. A body is where it was at its time, and has moved on since with its velocity and spin."""
        bodies = np.zeros(self._bodies, body_dtype)
        _native.check(_native.match_read_bodies(self._handle, 0, self._bodies, bodies.ctypes.data))
        return bodies

    def balls_in(self, scene: Scene) -> Balls:
        """Copies the balls into a scene: same place and motion. Use it for look-aheads, aims and interceptions in the scene of the match without its bodies."""
        balls = Balls(scene, self._balls)
        states = np.zeros((self._balls, _native.STATE_BYTES), np.uint8)
        for ball in range(self._balls):
            _native.check(_native.match_state(self._handle, ball, scene.handle, states[ball].ctypes.data))
        balls.state = states.tobytes()
        return balls

    def save(self) -> bytes:
        """Returns the whole match as bytes: balls, kicks, restarts, bodies and pushed obstacles; the same on every machine."""
        return self._bytes(_native.match_save)

    def restore(self, saved: bytes) -> None:
        """Restores what ``save`` returned, also from another match of the same scene, balls, step and version. The same bits follow. Corrupt bytes, and those of an earlier version, raise ValueError."""
        _native.check(_native.match_restore(self._handle, bytes(saved), len(saved)))

    def record(self) -> None:
        """Starts a recording at this tick. It ends when you place a ball, or restore a state that it does not contain."""
        _native.check(_native.match_record(self._handle))

    def recording(self) -> bytes:
        """Returns the recording so far, which ``Recording.FromBytes`` also reads in C#. The recording continues."""
        return self._bytes(_native.match_recording)

    def seek(self, tick: int) -> None:
        """Moves a replay to a tick, forwards or backwards."""
        _native.check(_native.match_seek(self._handle, _native.whole(tick, "tick")))

    def verify(self) -> Optional[int]:
        """Replays a recording from its start. Returns the first tick at which the balls differ from the recorded ones; None if all are bit-identical."""
        tick = ctypes.c_int64()
        _native.check(_native.match_verify(self._handle, ctypes.byref(tick)))
        return None if tick.value < 0 else tick.value

    def _bytes(self, write: Any) -> bytes:
        size, room = ctypes.c_int64(), np.zeros(0, np.uint8)
        while True:
            status = write(self._handle, room.ctypes.data if len(room) else None, len(room), ctypes.byref(size))
            if status != _native.BUFFER:
                _native.check(status)
                return room.tobytes()
            # Another thread may have made it longer since.
            room = np.zeros(size.value, np.uint8)
