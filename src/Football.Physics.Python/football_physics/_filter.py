"""Following a ball live."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any, Iterable, Iterator, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native, _structs
from ._points import Floats
from ._scene import Scene

estimate_dtype = _structs.ESTIMATE
"""The type of an estimate: the members of fp_estimate, in s, m, m/s and rad/s. deviations are those of a component of position, velocity and spin."""


class BallFilter:
    """Follows one ball through a stream of noisy points, with kicks that nobody announces, bounces, gaps and wrong points.

    Parameters
    ----------
    scene: the scene; default: the default scene.
    settings: ``noise`` (m, default 0.02), ``pixel_noise`` (pixels), ``kick_velocity`` (m/s), ``kick_spin`` (rad/s), ``kicks_per_second``, ``outlier_share``, ``window`` (s),
        ``maximum_gap`` (s).

    Raises
    ------
    ValueError: a setting is unknown or out of range.
    """

    def __init__(self, scene: Optional[Scene] = None, **settings: float) -> None:
        self.scene = Scene() if scene is None else scene
        given = np.zeros(1, _structs.FILTER_SETTINGS)
        _native.check(_native.filter_default(given.ctypes.data))
        for name, value in settings.items():
            if name not in (given.dtype.names or ()):
                raise ValueError(f"{name} is not a setting; allowed: {', '.join(given.dtype.names or ())}.")
            given[name] = value
        handle = ctypes.c_void_p()
        _native.check(_native.filter_create(self.scene.handle, given.ctypes.data, ctypes.byref(handle)))
        self.handle = handle.value or 0
        weakref.finalize(self, _native.filter_free, self.handle)

    def update(self, rows: ArrayLike, noise: Optional[ArrayLike] = None) -> "np.ndarray[Any, Any]":
        """Includes rows (t, x, y, z), with y up, and returns the estimate after each, as an array of :data:`estimate_dtype`.

        A row with y = NaN has no height; a row with x = NaN is a gap. noise: the standard deviation of the coordinates in m, a number or one per row.

        Raises
        ------
        ValueError: a row is out of range, or its time is before the window. The rows before it count.
        """
        points = np.atleast_2d(np.asarray(rows, float))
        if points.ndim != 2 or points.shape[1] != 4:
            raise ValueError(f"rows has the shape {points.shape}; allowed: (n, 4), for t, x, y and z.")
        times = np.ascontiguousarray(points[:, 0])
        positions = np.ascontiguousarray(points[:, 1:])
        deviations = None if noise is None else np.ascontiguousarray(np.broadcast_to(np.asarray(noise, float), len(times)))
        found = np.zeros(len(times), estimate_dtype)
        _native.check(_native.filter_update(
            self.handle, times.ctypes.data, positions.ctypes.data, None if deviations is None else deviations.ctypes.data, len(times), found.ctypes.data))
        return found

    def update_pixel(self, time: float, camera: ArrayLike, u: float, v: float, noise: float = 0) -> "np.ndarray[Any, Any]":
        """Includes a pixel of a camera, a 3 x 4 matrix, and returns the estimate. noise: pixels; 0 for that of the settings."""
        matrix = np.ascontiguousarray(np.asarray(camera, float))
        if matrix.size != 12:
            raise ValueError(f"camera has {matrix.size} numbers; allowed: 12, in 3 rows of 4.")
        found = np.zeros(1, estimate_dtype)
        _native.check(_native.filter_update_pixel(self.handle, time, matrix.ctypes.data, u, v, noise, found.ctypes.data))
        return found

    def follow(self, points: Iterable[ArrayLike], noise: Optional[float] = None) -> Iterator["np.void"]:
        """Yields the estimate after each point (t, x, y, z) of a stream, as soon as the point is there."""
        for point in points:
            yield self.update(point, noise)[0]

    def look_ahead(self, seconds: float, every: float = 0.02) -> Floats:
        """Returns the path ahead as rows (t, x, y, z, deviation); the deviation is that of a component, in m."""
        path = np.zeros((int(seconds / every * (1 + 1e-12)) + 1 if every > 0 else 0, 5))
        written = ctypes.c_int64()
        _native.check(_native.filter_look_ahead(self.handle, seconds, every, path.ctypes.data, len(path), ctypes.byref(written)))
        return path[: written.value]

    def reset(self) -> None:
        """Forgets all points."""
        _native.check(_native.filter_reset(self.handle))

    @property
    def state(self) -> bytes:
        """The whole filter as bytes. Assign them to a filter with the same scene and settings to restore it."""
        count = ctypes.c_int64()
        _native.filter_save(self.handle, None, 0, ctypes.byref(count))
        room = ctypes.create_string_buffer(count.value)
        _native.check(_native.filter_save(self.handle, room, count.value, ctypes.byref(count)))
        return room.raw

    @state.setter
    def state(self, saved: bytes) -> None:
        _native.check(_native.filter_restore(self.handle, saved, len(saved)))
