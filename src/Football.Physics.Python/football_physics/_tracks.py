"""Fits: launches, and the scene, from the track of a camera."""

from __future__ import annotations

import ctypes
import enum
from dataclasses import dataclass
from typing import Any, Dict, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _structs, _watch
from ._points import Floats, track as _track
from ._scene import Scene

piece_dtype = _structs.PIECE
"""The type of a piece of a match track: the members of fp_piece, in m, s, m/s and rad/s; kind is a :class:`PieceKind`."""

_FACTORS = ("drag", "lift", "restitution", "friction")
_PARAMETERS = (
    "wind_x", "wind_z", "drag", "crisis", "lift", "ground_height", "restitution", "restitution_rise", "friction", "sliding_friction", "rolling_friction", "rolling_friction_by_speed")


class FitVerdict(enum.IntEnum):
    """The verdict on a fit."""

    AS_EXPECTED = 0
    POOR = 1
    NOISE_OVERESTIMATED = 2
    AMBIGUOUS = 3
    OTHER_BALL = 4
    NOT_CONVERGED = 5


class MatchAnswers(enum.IntFlag):
    """The answers of a fit that are reliable to within their deviations."""

    NONE = 0
    LAUNCHES = 1
    SPINS = 2
    WIND_AND_DRAG = 4
    SURFACE = 8


class TrackSuspicions(enum.IntFlag):
    """Faults of a track that a fit suspects, or has removed (LINES, HELD)."""

    NONE = 0
    UNITS = 1
    SCALE = 2
    TURNED = 4
    DRAG_LAW = 8
    MISFIT = 16
    LINES = 32
    HELD = 64


class PieceKind(enum.IntEnum):
    """The kind of a piece of a match track."""

    FLIGHT = 0
    IMPACT = 1
    GROUND = 2
    TOUCH = 3
    LOST = 4


@dataclass(frozen=True)
class Fit:
    """A launch that was estimated from a track. Deviations are standard errors of the components."""

    #: The time of the launch, s: that of the first point.
    time: float
    #: The position, m, the velocity, m/s, and the spin, rad/s, at the launch.
    position: Floats
    velocity: Floats
    spin: Floats
    #: The same three with their standard errors.
    position_deviation: Floats
    velocity_deviation: Floats
    spin_deviation: Floats
    #: The estimated factors of the scene by name: drag, lift, restitution, friction; and their standard errors.
    factors: Dict[str, float]
    factor_deviations: Dict[str, float]
    #: The spin of another launch that fits about as well, rad/s; None if there is none.
    other_spin: Optional[Floats]
    #: The sum of the squared residuals by the noise, and the probability of an equal or larger one.
    chi_squared: float
    probability: float
    degrees_of_freedom: int
    iterations: int
    verdict: FitVerdict
    converged: bool
    #: The answers that are reliable to within their deviations, and the suspected faults of the track, by the rule of :class:`MatchFit`.
    good_for: MatchAnswers
    suspicions: TrackSuspicions
    #: True for each component of the spin that the track determines better than the prior.
    spin_identified: Tuple[bool, bool, bool]


@dataclass(frozen=True)
class MatchFit:
    """The pieces of a match track, and what they have in common."""

    #: The pieces in order of time: an array of :data:`piece_dtype`.
    pieces: NDArray[Any]
    #: The estimated parameters by name, and their standard errors: wind_x and wind_z, m/s; drag and lift, factors; crisis, a Reynolds number; ground_height, m; restitution ...
    values: Dict[str, float]
    deviations: Dict[str, float]
    #: The scene with the fitted wind, ball and surface.
    scene: Scene
    #: The root mean square of the residuals in flights of 0.3 s or longer, m.
    rms: float
    #: The share of the points above 0.5 m in such flights, 0 to 1.
    covered: float
    #: The standard deviation of the track's coordinates from one point to the next, m.
    noise: float
    #: The mean speed of the rolls, m/s, and the standard deviation of the rolling resistance there; 0 without rolls.
    rolling_speed: float
    rolling_deviation: float
    #: The numbers of flights of 0.3 s or longer, of impacts that estimate the surface, and of intervals of free slides and rolls.
    flights: int
    impacts: int
    windows: int
    #: The answers that are reliable to within their deviations, and the suspected faults of the track.
    good_for: MatchAnswers
    suspicions: TrackSuspicions


def fit(scene: Scene, track: Any, noise: Optional[ArrayLike] = None, progress: _watch.Progress = None, **request: Any) -> Fit:
    """Estimates the launch of a ball from its track: one flight, which may bounce.

    scene: the scene.
    track: rows t, x, y, z with y up, a data frame, or a tracking dataset of kloppy; see :func:`track`.
    noise: the standard deviation of the coordinates, m: one number, or one per row of the result of :func:`track`; default 0.02.
    progress: a function that receives the progress, 0 to 1, about 20 times per second; default none. An exception that it raises cancels the fit.
    request: members of a scenario's ``fit``: ``also=["drag", "lift", "restitution", "friction"]``, ``spin``, ``spinDeviation``, ``factorDeviation``, ``timeStep``.

    Ctrl-C cancels the fit. Other threads run meanwhile.
    """
    points, of_noise, text = _arguments(track, noise, request)
    found = np.zeros(1, _structs.FIT)
    status, sentence = _watch.call(
        _native.fit, scene.handle, *_addresses(points, of_noise), len(points[0]), text, len(text), found.ctypes.data, keep=(scene, points, of_noise, found), progress=progress)
    if status:
        _native.fail(status, sentence)
    row = found[0]
    names = [name for name in _FACTORS if name in request.get("also", ())]
    vectors = {name: row[name].copy() for name in ("position", "velocity", "spin", "position_deviation", "velocity_deviation", "spin_deviation")}
    identified = int(row["identified"])
    return Fit(
        time=float(row["time"]), **vectors,
        factors={name: float(row["factors"][_FACTORS.index(name)]) for name in names},
        factor_deviations={name: float(row["factor_deviations"][_FACTORS.index(name)]) for name in names},
        other_spin=row["other_spin"].copy() if row["has_other_spin"] else None,
        chi_squared=float(row["chi_squared"]), probability=float(row["probability"]), degrees_of_freedom=int(row["degrees_of_freedom"]), iterations=int(row["iterations"]),
        verdict=FitVerdict(int(row["verdict"])), converged=bool(row["converged"]),
        good_for=MatchAnswers(int(row["good_for"])), suspicions=TrackSuspicions(int(row["suspicions"])),
        spin_identified=(bool(identified & 64), bool(identified & 128), bool(identified & 256)))


def fit_match(
    scene: Scene, track: Any, noise: Optional[ArrayLike] = None, free: Optional[Sequence[str]] = None, progress: _watch.Progress = None, **request: Any
) -> MatchFit:
    """Divides the track of a match into flights, impacts, touches and ground contact, and estimates the wind, the ball and the surface.

    scene: the scene, as known before.
    track, noise: as for :func:`fit`; the noise is the smallest one.
    free: the quantities to estimate: wind, drag, crisis, lift, surface, height; default wind, drag, surface and height.
    progress: as for :func:`fit`.
    request: ``windDeviation``, ``factorDeviation``, ``crisisDeviation``, ``spinDeviation``.

    Ctrl-C cancels the fit. Other threads run meanwhile.
    """
    if free is not None:
        request["free"] = list(free)
    points, of_noise, text = _arguments(track, noise, request)
    n = len(points[0])
    # An impact, a touch or a gap is a piece too, between two points.
    pieces = np.zeros(4 * n + 16, piece_dtype)
    found, count, handle = np.zeros(1, _structs.FIT_MATCH), ctypes.c_int32(), ctypes.c_void_p()
    try:
        status, sentence = _watch.call(
            _native.fit_match, scene.handle, *_addresses(points, of_noise), n, text, len(text), pieces.ctypes.data, len(pieces), ctypes.byref(count), found.ctypes.data, ctypes.byref(handle),
            keep=(scene, points, of_noise, pieces, found), progress=progress)
    except BaseException:
        if handle.value:
            _native.scene_free(handle.value)
        raise
    fitted = Scene._of(handle.value) if handle.value else scene
    if status:
        _native.fail(status, sentence)
    row = found[0]
    estimated = [i for i in range(len(_PARAMETERS)) if int(row["estimated"]) >> i & 1]
    return MatchFit(
        pieces=pieces[: count.value].copy(), scene=fitted,
        values={_PARAMETERS[i]: float(row["values"][i]) for i in estimated}, deviations={_PARAMETERS[i]: float(row["deviations"][i]) for i in estimated},
        rms=float(row["rms"]), covered=float(row["covered"]), noise=float(row["noise"]), rolling_speed=float(row["rolling_speed"]), rolling_deviation=float(row["rolling_deviation"]),
        flights=int(row["flights"]), impacts=int(row["impacts"]), windows=int(row["windows"]),
        good_for=MatchAnswers(int(row["good_for"])), suspicions=TrackSuspicions(int(row["suspicions"])))


def _arguments(track: Any, noise: Optional[ArrayLike], request: Dict[str, Any]) -> Any:
    rows = _track(track)
    points = (np.ascontiguousarray(rows[:, 0]), np.ascontiguousarray(rows[:, 1:]))
    of_noise = None
    if noise is not None:
        given = np.asarray(noise, np.float64)
        if given.ndim and given.shape != (len(rows),):
            raise ValueError(f"noise has shape {given.shape}; allowed: one number, or ({len(rows)},), one for each row with a position.")
        of_noise = np.ascontiguousarray(np.broadcast_to(given, (len(rows),)))
    return points, of_noise, _native.text(request)


def _addresses(points: Any, noise: Optional[Floats]) -> Any:
    return points[0].ctypes.data, points[1].ctypes.data, None if noise is None else noise.ctypes.data
