"""Points of a track or of players, from what other packages hand over: arrays, data frames, and the tracking data of kloppy."""

from __future__ import annotations

import datetime
from typing import Any, List, Tuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# The units of kloppy's pitch dimensions, m.
_UNITS = {"m": 1.0, "cm": 0.01, "ft": 0.3048, "y": 0.9144}

# After a clock that starts again, the new part of a track begins this much later, s, as for football fit --match.
_PAUSE = 60.0

_TIMES = ("t", "time", "timestamp")
_NAMES = (("x", "y", "z"), ("ball_x", "ball_y", "ball_z"))


def column_of(frame: Any, name: str) -> Floats:
    """A column of a data frame as numbers; a missing value is NaN."""
    try:
        return np.array([_number(value) for value in np.asarray(frame[name])], np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"the column {name} has a value that is no number: {error}; allowed: numbers, and for times also hh:mm:ss, ISO 8601, time differences and dates.") from None


def is_frame(source: Any) -> bool:
    """Returns True for a data frame, and for an array of numpy with named columns."""
    return hasattr(source, "columns") or bool(getattr(getattr(source, "dtype", None), "names", None))


def names_of(frame: Any) -> List[str]:
    """The names of the columns of a data frame."""
    return [str(name) for name in (frame.columns if hasattr(frame, "columns") else frame.dtype.names)]


def up(x: Floats, y: Floats, z: Floats) -> Floats:
    """Rows x, y, z with y up, of columns with z up."""
    return np.stack([x, z, -y], 1)


def kloppy_scale(dataset: Any) -> Tuple[float, float]:
    """The unit of a kloppy dataset, m, and the sign that makes its axes right-handed with z up."""
    system = getattr(dataset.metadata, "coordinate_system", None)
    unit = getattr(getattr(dataset.metadata, "pitch_dimensions", None), "unit", None)
    name = str(getattr(unit, "value", unit))
    if name not in _UNITS:
        raise ValueError(f"the unit of the tracking data is {name!r}; allowed: {' | '.join(_UNITS)}. Transform the dataset to a coordinate system in metres.")
    orientation = getattr(system, "vertical_orientation", None)
    return _UNITS[name], -1.0 if getattr(orientation, "value", orientation) == "top-to-bottom" else 1.0


def track(source: Any) -> Floats:
    """Returns a track as rows t, x, y, z with y up: s and m, in order of time, without the rows that have no position.

    source: one of these:

    - an array of rows t, x, y, z with y up; a row with a NaN is left out
    - a data frame, of pandas or alike, or an array of numpy with named columns: ``t``, ``time`` or ``timestamp`` (seconds, hh:mm:ss, ISO 8601, time differences or dates), and ``x``, ``y``,
      ``z`` or ``ball_x``, ``ball_y``, ``ball_z``. As in the files of ``football fit --match``, z is up there and the axes are right-handed
    - a tracking dataset of kloppy, in metres, centimetres, feet or yards. Its units and the direction of its y axis are those of its metadata

    If the clock starts again, as in a second half, the new part is placed one minute after the end of the old part.
    """
    if hasattr(source, "records") and hasattr(source, "metadata"):
        rows = _kloppy(source)
    elif is_frame(source):
        rows = _frame(source)
    else:
        rows = np.array(source, np.float64)
        if rows.ndim != 2 or rows.shape[1] != 4:
            raise ValueError(f"the track has shape {rows.shape}; allowed: (n, 4), rows t, x, y, z.")
    rows = rows[np.isfinite(rows).all(1)]
    back = np.flatnonzero(np.diff(rows[:, 0]) < 0) + 1
    for start in back:
        rows[start:, 0] += rows[start - 1, 0] + _PAUSE - rows[start, 0]
    return np.ascontiguousarray(rows)


def _frame(frame: Any) -> Floats:
    have = names_of(frame)
    time = next((name for name in _TIMES if name in have), None)
    places = next((names for names in _NAMES if set(names) <= set(have)), None)
    if time is None or places is None:
        raise ValueError(f"the columns are {', '.join(have)}; allowed: {' | '.join(_TIMES)}, with {' | '.join(', '.join(names) for names in _NAMES)}.")
    x, y, z = (column_of(frame, name) for name in places)
    return np.column_stack([column_of(frame, time), up(x, y, z)])


def _kloppy(dataset: Any) -> Floats:
    unit, side = kloppy_scale(dataset)
    rows = []
    for record in dataset.records:
        ball = record.ball_coordinates
        if ball is not None:
            rows.append([_number(record.timestamp), _number(ball.x), _number(ball.y), _number(getattr(ball, "z", None))])
    numbers = np.array(rows, np.float64).reshape(-1, 4)
    if len(numbers) and np.isnan(numbers[:, 3]).all():
        raise ValueError("the tracking data has no height of the ball; allowed: points with x, y and z.")
    return np.column_stack([numbers[:, 0], up(unit * numbers[:, 1], side * unit * numbers[:, 2], unit * numbers[:, 3])])


def _number(value: Any) -> float:
    """A number, or a time in seconds; NaN for none."""
    # pandas.NA compares as neither true nor false, so that only its name tells it.
    if value is None or value is np.ma.masked or type(value).__name__ == "NAType":
        return float("nan")
    if hasattr(value, "total_seconds"):
        return float(value.total_seconds())
    if isinstance(value, np.timedelta64):
        return float(value / np.timedelta64(1, "s"))
    if isinstance(value, np.datetime64):
        return float((value - np.datetime64(0, "s")) / np.timedelta64(1, "s"))
    if isinstance(value, datetime.datetime):
        return value.timestamp()
    if isinstance(value, str) and "T" in value:
        return datetime.datetime.fromisoformat(value.replace("Z", "+00:00")).timestamp()
    if isinstance(value, str) and ":" in value:
        hours, minutes, seconds = value.split(":")
        return 3600 * float(hours) + 60 * float(minutes) + float(seconds)
    return float(value)
