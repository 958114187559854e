"""Many balls in one scene, with arrays that are updated in place."""

from __future__ import annotations

import ctypes
import enum
from typing import Any, Callable, List, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _structs
from ._scene import Scene

Floats = NDArray[np.float64]
_step_many, _read_many = _native.step_many, _native.read_many

event_dtype = np.dtype(
    [("kind", "i4"), ("thing", "i4"), ("time", "f8")]
    + [(name, "f8", (3,)) for name in ("position", "velocity_before", "velocity", "spin_before", "spin", "normal")]
    + [("ball", "i8")])
"""The type of an event: the members of fp_event, and the index of the ball."""

contact_force_dtype = _structs.CONTACT_FORCE
"""The type of the forces of one contact: thing, the index of the object; point, m; normal; load and friction, N."""

_NATIVE_EVENT = np.dtype(event_dtype.descr[:-1])
_DERIVATIVES = 9 * 4 + 3 * 2

_MOST_CONTACTS = 32

# The number of steps of a ball between two chances for Ctrl-C: about 20 ms.
_MOST_STEPS = 200_000


class Motion(enum.IntEnum):
    """The motion of a ball."""

    AIRBORNE = 0
    SLIDING = 1
    ROLLING = 2
    STOPPED = 3
    SQUEEZED = 4


class EventKind(enum.IntEnum):
    """The kind of an event."""

    IMPACT = 0
    SLIDE = 1
    ROLL = 2
    REST = 3
    NET = 4
    GOAL = 5
    LEAVE = 6
    SQUEEZED = 7
    ENTER_ZONE = 8
    EXIT_ZONE = 9


class _AimRows(NamedTuple):
    velocity: Floats
    spin: Floats
    miss: Floats
    status: NDArray[np.int32]


class AimResult(_AimRows):
    """The best kicks found, one row per ball, for every status: velocity, spin, miss, status."""

    reason: List[Optional[str]]
    """Why each kick does not hit: the bound that excludes every kick, the undefined quantity, or the nearest miss; None for a hit. No item of the tuple."""

    @property
    def hit(self) -> NDArray[np.bool_]:
        """True for each kick that passes its target within the tolerance."""
        return self.status == 0


class Derivatives(NamedTuple):
    """Derivatives of the end of a run by its launch: ``position_by_velocity[ball, i, j]`` is the derivative of component i at the end by component j of the launch."""

    position_by_velocity: Floats
    position_by_spin: Floats
    velocity_by_velocity: Floats
    velocity_by_spin: Floats
    time_by_velocity: Floats
    time_by_spin: Floats
    ended: NDArray[np.bool_]


class Forces(NamedTuple):
    """The forces on a ball with which its next step begins, N, each (3,), world frame. A force that does not act is zero."""

    weight: Floats
    buoyancy: Floats
    drag: Floats
    magnus: Floats
    knuckle: Floats
    custom: Floats
    nets: Floats
    load: Floats
    friction: Floats
    sum: Floats
    #: The acceleration with which the step begins, m/s^2.
    acceleration: Floats
    #: The forces of each contact: an array of :data:`contact_force_dtype`, empty in flight.
    contacts: NDArray[Any]


def _rows(values: ArrayLike, n: int, name: str) -> Floats:
    shape = np.shape(values)
    rows = np.ascontiguousarray(np.broadcast_to(np.asarray(values, np.float64), (n, 3)) if shape in ((), (1,), (3,)) else values, np.float64)
    if rows.shape != (n, 3):
        raise ValueError(f"{name} has shape {np.shape(values)}; allowed: ({n}, 3), or (3,) for all balls.")
    return rows


class Balls:
    """Any number of balls in a scene. The balls do not touch one another.

    ``position``, ``velocity``, ``spin`` (n x 3; m, m/s, rad/s) and ``motion`` (n; :class:`Motion`) are read-only arrays that every call updates in place. Keep a
    reference to an array and read it after each call; nothing is copied. Use an object in one thread at a time; other threads run during a call.

    Parameters
    ----------
    scene: the scene.
    n: the number of balls; 0 or more.
    position: the initial positions, (n, 3) or (3,), m; default the origin. A position below the ground is raised onto it. Without ground, the balls start in the air.
    """

    def __init__(self, scene: Scene, n: int, position: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        self.scene = scene
        self._n = int(n)
        if self._n < 0:
            raise ValueError(f"n is {n}; allowed: 0 or more.")
        self._states = np.zeros((self._n, _native.STATE_BYTES), np.uint8)
        arrays: List[Any] = [np.zeros((self._n, 3)), np.zeros((self._n, 3)), np.zeros((self._n, 3)), np.zeros(self._n, np.int32)]
        self._arrays = arrays
        views = [array.view() for array in arrays]
        for view in views:
            view.flags.writeable = False
        self.position, self.velocity, self.spin, self.motion = views
        # Read the addresses once: numpy takes longer to return one than a step takes.
        self._handle = scene.handle
        self._at = self._states.ctypes.data
        self._out = tuple(array.ctypes.data for array in arrays)
        self.place(None, position)

    def __len__(self) -> int:
        return self._n

    def place(self, which: Any, position: ArrayLike, velocity: ArrayLike = (0.0, 0.0, 0.0), spin: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        """Places balls with a velocity and a spin, and sets their time to 0.

        which: a mask of length n, a list of indices, or None for all balls. The other arguments have one row per selected ball, or one row for all.
        """
        mask, rows = self._chosen(which, (position, "position"), (velocity, "velocity"), (spin, "spin"))
        _native.check(_native.launch_many(self._handle, self._at, self._n, mask.ctypes.data, *(row.ctypes.data for row in rows)))
        self._read()

    def kick(self, which: Any, velocity: ArrayLike, spin: ArrayLike = (0.0, 0.0, 0.0), **unknown: Any) -> None:
        """Kicks balls from their positions. For which, see :meth:`place`. Speeds are at most 1000 m/s, spins at most 10 000 rad/s."""
        if unknown:
            raise TypeError(f"kick has no argument {', '.join(unknown)}. Pass velocity and spin as vectors: spin=[0, 40, 0] is a sidespin of 40 rad/s, and the topspin of a kick to -z is -x.")
        mask, rows = self._chosen(which, (velocity, "velocity"), (spin, "spin"))
        _native.check(_native.kick_many(self._handle, self._at, self._n, mask.ctypes.data, *(row.ctypes.data for row in rows)))
        self._read()

    def step(self, dt: float, k: int = 1) -> None:
        """Advances all balls by k steps of dt seconds. If Ctrl-C ends the call, no ball has moved."""
        if self._n * k > _MOST_STEPS:
            self._in_parts(max(1, _MOST_STEPS // k), lambda at, n, _: self._step_part(at, n, dt, k))
            return
        status = _step_many(self._handle, self._at, self._n, dt, k) or _read_many(self._handle, self._at, self._n, *self._out)
        if status:
            _native.fail(status)

    def step_events(self, dt: float, capacity: int = 32) -> NDArray[Any]:
        """Advances all balls by one step, and returns the events of this step: an array of :data:`event_dtype`, ordered by ball and time."""
        if capacity < 0:
            raise ValueError(f"capacity is {capacity}; allowed: 0 or more.")
        # The library keeps at most this number of events of a step; with more room, it would not tell how many it has written.
        capacity = min(capacity, 1024)
        room = np.zeros(capacity, _NATIVE_EVENT)
        count = ctypes.c_int32()
        told = []
        for ball in range(self._n):
            status = _native.step(self._handle, self._at + ball * _native.STATE_BYTES, dt, room.ctypes.data, capacity, ctypes.byref(count))
            if status not in (_native.OK, _native.BUFFER):
                _native.fail(status)
            if count.value:
                events = np.zeros(min(count.value, capacity), event_dtype)
                for name in _NATIVE_EVENT.names or ():
                    events[name] = room[name][: len(events)]
                events["ball"] = ball
                told.append(events)
        self._read()
        return np.concatenate(told) if told else np.zeros(0, event_dtype)

    def forces(self, ball: int = 0, dt: float = 1 / 60) -> Optional[Forces]:
        """Computes the forces with which the next step of a ball begins, for arrows and overlays. The ball does not move.

        It returns None if the step begins with an impact or solves the contacts by impulses, or if the contacts of a ball at rest do not determine their forces.
        dt: the length of the next step, s. It matters only for a ball that is about to stop.
        """
        outputs, contacts, count = np.zeros(1, _structs.FORCES), np.zeros(_MOST_CONTACTS, contact_force_dtype), ctypes.c_int32()
        at = self._state_at(_native.whole(ball, "ball"))
        _native.check(_native.forces(self._handle, at, dt, outputs.ctypes.data, contacts.ctypes.data, len(contacts), ctypes.byref(count)))
        return Forces(*(outputs[0][name] for name in Forces._fields[:-1]), contacts[: count.value]) if outputs["determined"][0] else None

    def until_landing(self, dt: float = 1 / 60, seconds: float = 20.0) -> NDArray[np.bool_]:
        """Runs each ball to just after its next impact, for at most the given seconds. Returns True for each ball that had an impact."""
        return self._run(dt, seconds, 1)

    def until_rest(self, dt: float = 1 / 60, seconds: float = 60.0) -> NDArray[np.bool_]:
        """Runs each ball until it rests, for at most the given seconds. Returns True for each ball that rests."""
        return self._run(dt, seconds, 2)

    def look_ahead(self, seconds: float = 3.0, every: float = 1 / 60) -> Floats:
        """Returns the predicted paths, (n, rows, 4), with rows t, x, y, z; the balls do not move. If every is the step of your loop, the prediction is bit-identical to the steps."""
        rows = int(seconds / every + 1e-9) + 1 if seconds >= 0 and every > 0 else 0
        path = np.empty((self._n, rows, 4))
        for ball in range(self._n):
            _native.check(_native.look_ahead(self._handle, self._at + ball * _native.STATE_BYTES, seconds, every, path.ctypes.data + ball * rows * 32, rows, None))
        return path

    def aim(self, targets: ArrayLike, speed: float = 25.0, **request: Any) -> AimResult:
        """Finds for each ball the kick from its position to its target, (n, 3) or (3,), m.

        request: further members of an aim in a scenario, by name: ``spin={"side": 40}``, ``elevation={"max": 60}``, ``through=[x, y, z]``, ``arc="high"`` ...
        """
        targets = _rows(targets, self._n, "targets")
        result = AimResult(np.zeros((self._n, 3)), np.zeros((self._n, 3)), np.zeros(self._n), np.zeros(self._n, np.int32))
        result.reason = []
        for ball in range(self._n):
            text = _native.text({"from": self.position[ball], "target": targets[ball], "speed": speed, **request})
            _native.check(_native.aim(
                self._handle, text, len(text), result.velocity[ball].ctypes.data, result.spin[ball].ctypes.data, result.miss[ball:].ctypes.data, result.status[ball:].ctypes.data))
            result.reason.append(_native.aim_reason().decode() or None)
        return result

    def derivatives(self, seconds: ArrayLike, dt: float = 0.01, stop: str = "time") -> Derivatives:
        """Runs each ball for a time, one for all or one per ball, or until an event (``stop``: time, impact or rest). Returns the derivatives of the ends by the launches, from one run per ball."""
        stops = {"time": 0, "impact": 1, "rest": 2}
        if stop not in stops:
            raise ValueError(f"stop is {stop!r}; allowed: {' | '.join(stops)}.")
        numbers = np.zeros((self._n, _DERIVATIVES))
        durations = np.broadcast_to(np.asarray(seconds, np.float64), (self._n,)).tolist()
        ended = np.zeros(self._n, np.int32)
        for ball in range(self._n):
            _native.check(_native.derivatives_run(
                self._handle, self._at + ball * _native.STATE_BYTES, dt, durations[ball], stops[stop], numbers.ctypes.data + ball * _DERIVATIVES * 8, ended.ctypes.data + 4 * ball))
        self._read()
        matrices = [numbers[:, 9 * i : 9 * i + 9].reshape(self._n, 3, 3) for i in range(4)]
        return Derivatives(matrices[0], matrices[1], matrices[2], matrices[3], numbers[:, 36:39], numbers[:, 39:42], ended != 0)

    @property
    def time(self) -> Floats:
        """The time since each ball was placed, s, as a new array."""
        times = np.empty(self._n)
        _native.check(_native.time_many(self._handle, self._at, self._n, times.ctypes.data))
        return times

    @property
    def hashes(self) -> NDArray[np.uint64]:
        """The hash of each ball's complete state, as ``Snapshot.Hash`` returns it in C#."""
        return np.array([_native.hash_of(self._at + ball * _native.STATE_BYTES) for ball in range(self._n)], np.uint64)

    @property
    def state(self) -> bytes:
        """All states as bytes, for this version of the library. Assign the bytes to restore the states. An invalid state raises ValueError and changes nothing."""
        return self._states.tobytes()

    @state.setter
    def state(self, value: bytes) -> None:
        if len(value) != self._states.nbytes:
            raise ValueError(f"state has {len(value)} bytes; allowed: {self._states.nbytes}, of {self._n} balls.")
        states = np.frombuffer(value, np.uint8).reshape(self._states.shape)
        _native.check(_native.read_many(self._handle, states.ctypes.data, self._n, None, None, None, None))
        self._states[...] = states
        self._read()

    def _state_at(self, ball: int) -> int:
        """The address of a ball's state."""
        if not 0 <= ball < self._n:
            raise ValueError(f"ball is {ball}; allowed: 0 ... {self._n - 1}.")
        return self._at + ball * _native.STATE_BYTES

    def _run(self, dt: float, seconds: float, stop: int) -> NDArray[np.bool_]:
        ended = np.zeros(self._n, np.int32)
        part = max(1, int(_MOST_STEPS * min(1.0, dt / seconds))) if seconds > 0 and dt > 0 else self._n
        if self._n > part:
            at_ended = ended.ctypes.data
            self._in_parts(part, lambda at, n, first: _native.check(_native.run_many(self._handle, at, n, dt, seconds, stop, at_ended + 4 * first)))
        else:
            _native.check(_native.run_many(self._handle, self._at, self._n, dt, seconds, stop, ended.ctypes.data))
            self._read()
        return ended != 0

    def _step_part(self, at: int, n: int, dt: float, k: int) -> None:
        while k > 0:
            _native.check(_step_many(self._handle, at, n, dt, min(k, _MOST_STEPS)))
            k -= _MOST_STEPS

    def _in_parts(self, size: int, advance: Callable[[int, int, int], None]) -> None:
        """Advances the balls in parts of a size, so that Python sees Ctrl-C in between. After an exception, all balls are where they were."""
        before = self._states.copy()
        try:
            for first in range(0, self._n, size):
                advance(self._at + first * _native.STATE_BYTES, min(size, self._n - first), first)
            self._read()
        except BaseException:
            self._states[...] = before
            self._read()
            raise

    def _read(self) -> None:
        _native.check(_read_many(self._handle, self._at, self._n, *self._out))

    def _chosen(self, which: Any, *arguments: Any) -> Any:
        """Returns the mask of the selected balls, and arguments with one row per ball."""
        mask = np.ones(self._n, np.uint8)
        if which is not None:
            chosen = np.asarray(which)
            if chosen.dtype == np.bool_ and chosen.shape != (self._n,):
                raise ValueError(f"the mask has shape {chosen.shape}; allowed: ({self._n},).")
            mask[:] = 0
            try:
                mask[chosen] = 1
            except IndexError as error:
                raise ValueError(f"of the balls that are named, {error}; allowed: 0 ... {self._n - 1}.") from None
        named = np.flatnonzero(mask) if which is None or np.asarray(which).dtype == np.bool_ else np.asarray(which, np.int64)
        rows = []
        for values, name in arguments:
            of_named = _rows(values, len(named), name)
            all_rows = np.zeros((self._n, 3))
            all_rows[named] = of_named
            rows.append(all_rows)
        return mask, rows
