"""Scenes."""

from __future__ import annotations

import ctypes
import json as _json
import weakref
from typing import Any, Mapping, Union

import numpy as np

from . import _native


class Scene:
    """A scene, checked and compiled; nothing changes it, and threads may share it.

    Parameters
    ----------
    scenario: JSON text, or a dict of it: ``profile``, ``ball``, ``air``, ``gravity``, ``forces``, ``ground``, ``goals``, ``obstacles``, ``nets``, ``zones``, ``dials``, ``solver``.
        Default the default scene, the modern ball on match turf.

    Raises
    ------
    ValueError: a member is unknown, of the wrong type or out of range; the message names it, its value and what is allowed.
    """

    def __init__(self, scenario: Union[str, Mapping[str, Any]] = "{}") -> None:
        text = scenario if isinstance(scenario, str) else _json.dumps(scenario)
        handle = ctypes.c_void_p()
        bytes_ = text.encode()
        _native.check(_native.scene_create(bytes_, len(bytes_), ctypes.byref(handle)))
        self.handle: int = handle.value or 0
        self.json = text
        weakref.finalize(self, _native.scene_free, self.handle)

    def name_of(self, thing: int) -> str:
        """The name of what an event tells of: "ground", "left post", an obstacle's; "" for -1."""
        room = ctypes.create_string_buffer(256)
        _native.check(_native.name(self.handle, thing, room, len(room)))
        return room.value.decode()

    def added_energy(self, event: Any) -> float:
        """The energy that an impact with a bumper added to the ball, J; 0 for any other event. event: one of :meth:`Balls.step_events`."""
        room = np.zeros(1, [item for item in event.dtype.descr if item[0] != "ball"])
        for name in room.dtype.names or ():
            room[name] = event[name]
        return float(_native.added_energy(self.handle, room.ctypes.data))

    def __reduce__(self) -> Any:
        return Scene, (self.json,)

    def __repr__(self) -> str:
        return f"Scene({self.json!r})"
