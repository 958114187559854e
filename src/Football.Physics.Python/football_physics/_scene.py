"""Scenes."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _structs

impact_dtype = _structs.IMPACT
"""The type of the outputs of an impact: impulse and normal and tangential impulse, N s; slip before and after, m/s; contact time, s; compression, m; peak force, N; energy lost, J; grips."""


class Scene:
    """A scene, checked and compiled. It is immutable, and threads may share it.

    Parameters
    ----------
    scenario: JSON text, or a dict with the same members: ``profile``, ``ball``, ``air``, ``gravity``, ``forces``, ``ground``, ``goals``, ``obstacles``, ``nets``, ``zones``, ``dials``, ``solver``.
        Default: the default scene, a modern ball on match turf.

    Raises
    ------
    ValueError: a member is unknown, of the wrong type or out of range; the message names the member, its value and the allowed range.
    """

    def __init__(self, scenario: Union[str, Mapping[str, Any]] = "{}") -> None:
        if isinstance(scenario, Mapping) and "bodies" in scenario:
            raise ValueError("bodies is a member of a match. Use Match(scenario), whose bodies you can move, or obstacles for things that stand still.")
        text = scenario if isinstance(scenario, str) else _native.text(scenario).decode()
        handle = ctypes.c_void_p()
        bytes_ = text.encode()
        _native.check(_native.scene_create(bytes_, len(bytes_), ctypes.byref(handle)))
        self._own(handle.value or 0, text)

    @classmethod
    def _of(cls, handle: int) -> Scene:
        """A scene that the library made."""
        scene = cls.__new__(cls)
        scene._own(handle, None)
        return scene

    def _own(self, handle: int, text: Optional[str]) -> None:
        self.handle = handle
        #: The text of the scene; None for a fitted scene.
        self.json = text
        weakref.finalize(self, _native.scene_free, handle)

    def name_of(self, thing: int) -> str:
        """Returns the name of the object of an event: "ground", "left post", or the name of an obstacle; "" for -1."""
        room = ctypes.create_string_buffer(256)
        _native.check(_native.name(self.handle, _native.whole(thing, "thing"), room, len(room)))
        return room.value.decode()

    def added_energy(self, event: Any) -> float:
        """Returns the energy that a bumper added to the ball in an impact, J; 0 for any other event. event: an event of :meth:`Balls.step_events`."""
        room = np.zeros(1, [item for item in event.dtype.descr if item[0] != "ball"])
        for name in room.dtype.names or ():
            room[name] = event[name]
        return float(_native.added_energy(self.handle, room.ctypes.data))

    def impact(self, event: Any) -> Any:
        """Returns the outputs of an impact with a stationary surface, for sound, haptics and looks: a record of :data:`impact_dtype`.

        It has the impulse, N s; normal and tangential impulse, slip before and after, m/s; contact time, s; compression, m; peak force, N; energy lost, J; grips.
        event: an impact of :meth:`Balls.step_events`. For the event of a match, use :meth:`Match.impact`.
        """
        room = np.zeros(1, [item for item in event.dtype.descr if item[0] != "ball"])
        for name in room.dtype.names or ():
            room[name] = event[name]
        outputs = np.zeros(1, impact_dtype)
        _native.check(_native.impact(self.handle, room.ctypes.data, outputs.ctypes.data))
        return outputs[0]

    def air(
        self, position: ArrayLike, velocity: ArrayLike, spin: ArrayLike, time: float = 0.0, air_distance: Optional[ArrayLike] = None,
        orientation: Optional[ArrayLike] = None,
    ) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Computes the air's force, N, and torque, N m, on bodies that your own code moves: two arrays with the shape of ``velocity``, (n, 3) or (3,).

        It includes drag, Magnus force, spin decay, wind and knuckle force, as in a flight of the library. It does not include gravity and buoyancy, and ignores ground and obstacles.

        position, velocity, spin: (n, 3), or (3,) for all bodies; m, m/s, rad/s, world frame.
        air_distance: the distances flown through the air since the kick, (n,) or one number, m; only a knuckle force needs them.
        orientation: quaternions x, y, z, w from body to world, (n, 4) or (4,); only a knuckle force needs them. Default: the identity.
        """
        rows = [np.asarray(values, np.float64) for values in (position, velocity, spin)]
        shape = np.shape(velocity)
        for name, values in zip(("position", "velocity", "spin"), rows):
            if len(shape) not in (1, 2) or shape[-1] != 3 or values.shape not in (shape, (3,)):
                raise ValueError(f"{name} has shape {values.shape}; allowed: the shape of velocity, which is (n, 3) or (3,); or (3,) for all bodies.")
        n = 1 if len(shape) == 1 else shape[0]
        full = [np.ascontiguousarray(np.broadcast_to(values, (n, 3))) for values in rows]
        flown = None if air_distance is None else np.ascontiguousarray(np.broadcast_to(np.asarray(air_distance, np.float64), (n,)))
        turned = None if orientation is None else np.ascontiguousarray(np.broadcast_to(np.asarray(orientation, np.float64), (n, 4)))
        force, torque = np.empty(shape), np.empty(shape)
        _native.check(_native.air_many(
            self.handle, n, *(values.ctypes.data for values in full), time, None if flown is None else flown.ctypes.data,
            None if turned is None else turned.ctypes.data, force.ctypes.data, torque.ctypes.data))
        return force, torque

    def __reduce__(self) -> Any:
        if self.json is None:
            raise TypeError("a fitted scene has no text, and cannot be pickled. Pickle the track and fit it again.")
        return Scene, (self.json,)

    def __repr__(self) -> str:
        return "<fitted Scene>" if self.json is None else f"Scene({self.json!r})"
