"""The structures of football_physics.h as types of numpy; the members that the header reserves are left out."""

from __future__ import annotations

from typing import List, Tuple

import numpy as np


def _struct(*members: Tuple[str, str, int]) -> "np.dtype[np.void]":
    """A structure in the order of its members (name, type, count), without those named "reserved"."""
    names: List[str] = []
    types: List[object] = []
    offsets: List[int] = []
    at = 0
    for name, kind, count in members:
        if name != "reserved":
            names.append(name)
            types.append((kind, (count,)) if count > 1 else kind)
            offsets.append(at)
        at += count * np.dtype(kind).itemsize
    return np.dtype({"names": names, "formats": types, "offsets": offsets, "itemsize": at})


def _vectors(*names: str) -> List[Tuple[str, str, int]]:
    return [(name, "f8", 3) for name in names]


def _numbers(*names: str) -> List[Tuple[str, str, int]]:
    return [(name, "f8", 1) for name in names]


def _integers(*names: str) -> List[Tuple[str, str, int]]:
    return [(name, "i4", 1) for name in names]


_RESERVED = ("reserved", "i4", 1)
_HAPPENED = [*_integers("kind", "thing"), *_numbers("time"), *_vectors("position", "velocity_before", "velocity", "spin_before", "spin", "normal")]

EVENT = _struct(*_HAPPENED)
BALL = _struct(*_vectors("position", "velocity", "spin"), ("orientation", "f8", 4), *_numbers("time"), *_integers("motion"), _RESERVED)
BODY = _struct(_vectors("position")[0], ("orientation", "f8", 4), *_vectors("velocity", "spin"), *_numbers("time"), *_vectors("impulse"), *_integers("in_play"), _RESERVED)
MATCH_EVENT = _struct(*_HAPPENED, *_integers("ball", "other_ball", "body"), _RESERVED, *_vectors("impulse"), *_numbers("added_energy"))
PLAYER = _struct(*_vectors("position", "velocity"), *_numbers("reaction", "acceleration", "speed", "reach", "minimum_height", "maximum_height"))
INTERCEPTION = _struct(*_integers("player"), _RESERVED, *_numbers("time", "margin"), *_vectors("position", "velocity"))
WINDOW = _struct(*_integers("player"), _RESERVED, *_numbers("start", "end"), *_vectors("position", "velocity"))
GOAL_CHANCE = _struct(
    *_numbers("scores", "on_target", "covered", "standard_error", "crosses", "aside", "height", "time", "aside_deviation", "height_deviation", "correlation"),
    *_integers("method", "kicks"))
FIT = _struct(
    *_numbers("time"), *_vectors("position", "velocity", "spin"), ("factors", "f8", 4), *_vectors("position_deviation", "velocity_deviation", "spin_deviation"),
    ("factor_deviations", "f8", 4), *_vectors("other_spin"), *_numbers("chi_squared", "probability"),
    *_integers("degrees_of_freedom", "iterations", "verdict", "converged", "identified", "has_other_spin", "good_for", "suspicions"))
PIECE = _struct(
    *_integers("kind", "points"), *_numbers("start_time", "end_time", "rms", "maximum_residual"),
    *_vectors("position", "velocity", "spin", "velocity_before", "spin_before", "velocity_deviation", "spin_deviation"),
    *_numbers("restitution", "speed_retained"), *_integers("has_restitution"), _RESERVED)
WATCH = _struct(*_integers("bytes", "cancel"), *_numbers("progress"))
FIT_MATCH = _struct(
    ("values", "f8", 12), ("deviations", "f8", 12), *_numbers("rms", "covered", "noise", "rolling_speed", "rolling_deviation"),
    *_integers("estimated", "flights", "impacts", "windows", "good_for", "suspicions"))
IMPACT = _struct(
    *_vectors("impulse"), *_numbers("normal_impulse", "tangential_impulse", "slip_before", "slip_after", "contact_time", "compression", "peak_force", "energy_lost"),
    *_integers("grips"), _RESERVED)
FILTER_SETTINGS = _struct(*_numbers("noise", "pixel_noise", "kick_velocity", "kick_spin", "kicks_per_second", "outlier_share", "window", "maximum_gap"))
ESTIMATE = _struct(
    *_numbers("time"), *_vectors("position", "velocity", "spin", "deviations"), ("covariance", "f8", 81), *_numbers("kick_time", "kick_deviation", "kick_probability"),
    *_integers("motion", "has_kick", "is_outlier", "is_held"))
FORCES = _struct(
    *_vectors("weight", "buoyancy", "drag", "magnus", "knuckle", "custom", "nets", "load", "friction", "sum", "acceleration"), *_integers("determined"), _RESERVED)
CONTACT_FORCE = _struct(*_integers("thing"), _RESERVED, *_vectors("point", "normal", "load", "friction"))
