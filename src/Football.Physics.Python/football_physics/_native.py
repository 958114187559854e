"""The C library, by ctypes: its functions with their types, and its errors as exceptions."""

import ctypes
import json
import operator
import pathlib
import sys
from typing import Optional

import numpy as np

from . import _structs

_NAMES = {"win32": "football_physics.dll", "darwin": "libfootball_physics.dylib"}
_library = ctypes.CDLL(str(pathlib.Path(__file__).parent / _NAMES.get(sys.platform, "libfootball_physics.so")))

STATE_BYTES = 216
BALL_BYTES = 120
EVENT_BYTES = 160
ABI_VERSION = 2
OK, ARGUMENT, SCENE, BUFFER, HANDLE, ABI, INTERNAL, CANCELLED = range(8)

_P, _I, _L, _D = ctypes.c_void_p, ctypes.c_int32, ctypes.c_int64, ctypes.c_double


def _function(name, *types, returns=ctypes.c_int):
    function = getattr(_library, name)
    function.argtypes = types
    function.restype = returns
    return function


check_abi = _function("fp_check_abi", _I, _I, _I, _I)
version = _function("fp_version", returns=ctypes.c_char_p)
last_error = _function("fp_last_error", returns=ctypes.c_char_p)
scene_create = _function("fp_scene_create", ctypes.c_char_p, _L, _P)
scene_free = _function("fp_scene_free", _P)
name = _function("fp_name", _P, _I, _P, _I)
added_energy = _function("fp_added_energy", _P, _P, returns=ctypes.c_double)
hash_of = _function("fp_hash", _P, returns=ctypes.c_uint64)
launch_many = _function("fp_launch_many", _P, _P, _L, _P, _P, _P, _P)
kick_many = _function("fp_kick_many", _P, _P, _L, _P, _P, _P)
step = _function("fp_step", _P, _P, _D, _P, _I, _P)
step_many = _function("fp_step_many", _P, _P, _L, _D, _I)
read = _function("fp_read", _P, _P, _P)
read_many = _function("fp_read_many", _P, _P, _L, _P, _P, _P, _P)
time_many = _function("fp_time_many", _P, _P, _L, _P)
run_many = _function("fp_run_many", _P, _P, _L, _D, _D, _I, _P)
look_ahead = _function("fp_look_ahead", _P, _P, _D, _D, _P, _L, _P)
aim = _function("fp_aim", _P, ctypes.c_char_p, _L, _P, _P, _P, _P)
aim_reason = _function("fp_aim_reason", returns=ctypes.c_char_p)
derivatives_run = _function("fp_derivatives_run", _P, _P, _D, _D, _I, _P, _P)
air_many = _function("fp_air_many", _P, _L, _P, _P, _P, _D, _P, _P, _P, _P)
impact = _function("fp_impact", _P, _P, _P)
forces = _function("fp_forces", _P, _P, _D, _P, _P, _I, _P)
snapshot_write = _function("fp_snapshot_write", _P, _P)
snapshot_read = _function("fp_snapshot_read", _P, _P)
check_structs = _function("fp_check_structs", *[_I] * 14)
match_create = _function("fp_match_create", ctypes.c_char_p, _L, _I, _D, _P)
match_free = _function("fp_match_free", _P)
match_name = _function("fp_match_name", _P, _I, _P, _I)
match_place = _function("fp_match_place", _P, _I, _P)
match_queue_place = _function("fp_match_queue_place", _P, _I, _P, _P, _P, _P)
match_kick = _function("fp_match_kick", _P, _I, _P, _P)
match_move_bodies = _function("fp_match_move_bodies", _P, _I, _I, _P)
match_step = _function("fp_match_step", _P, _P, _I, _P)
match_impact = _function("fp_match_impact", _P, _I, _P)
match_read_balls = _function("fp_match_read_balls", _P, _I, _I, _P)
match_read_bodies = _function("fp_match_read_bodies", _P, _I, _I, _P)
match_state = _function("fp_match_state", _P, _I, _P, _P)
match_hash = _function("fp_match_hash", _P, returns=ctypes.c_uint64)
match_tick = _function("fp_match_tick", _P, returns=_L)
match_save = _function("fp_match_save", _P, _P, _L, _P)
match_restore = _function("fp_match_restore", _P, ctypes.c_char_p, _L)
match_record = _function("fp_match_record", _P)
match_recording = _function("fp_match_recording", _P, _P, _L, _P)
match_replay = _function("fp_match_replay", ctypes.c_char_p, _L, ctypes.c_char_p, _L, _P)
match_seek = _function("fp_match_seek", _P, _L)
match_verify = _function("fp_match_verify", _P, _P)
player_default = _function("fp_player_default", _P)
intercept = _function("fp_intercept", _P, _P, _D, _P, _I, _P)
intercept_windows = _function("fp_intercept_windows", _P, _P, _D, _P, _I, _P, _I, _P)
goal_chance = _function("fp_goal_chance_watched", _P, ctypes.c_char_p, _L, _P, _P)
fit = _function("fp_fit_watched", _P, _P, _P, _P, _L, ctypes.c_char_p, _L, _P, _P)
fit_match = _function("fp_fit_match_watched", _P, _P, _P, _P, _L, ctypes.c_char_p, _L, _P, _I, _P, _P, _P, _P)
filter_default = _function("fp_filter_default", _P)
filter_create = _function("fp_filter_create", _P, _P, _P)
filter_free = _function("fp_filter_free", _P)
filter_reset = _function("fp_filter_reset", _P)
filter_update = _function("fp_filter_update", _P, _P, _P, _P, _L, _P)
filter_update_pixel = _function("fp_filter_update_pixel", _P, _D, _P, _D, _D, _D, _P)
filter_look_ahead = _function("fp_filter_look_ahead", _P, _D, _D, _P, _L, _P)
filter_save = _function("fp_filter_save", _P, _P, _L, _P)
filter_restore = _function("fp_filter_restore", _P, ctypes.c_char_p, _L)


def text(request) -> bytes:
    """JSON in UTF-8 of a request or a scene whose numbers and vectors may be numpy's."""
    return json.dumps(request, default=_plain).encode()


def _plain(value):
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"a member is a {type(value).__name__}; allowed: numbers, texts, booleans, lists, dicts and arrays.")


def whole(value, name: str) -> int:
    """A whole number that C can hold; ctypes would cut off a longer one."""
    number = operator.index(value)
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{name} is {number}; allowed: {-(2**31)} ... {2**31 - 1}.")
    return number


def fail(status: int, sentence: Optional[str] = None) -> None:
    """Raises the error of a failed call, with the library's message; default: that of the last call of this thread."""
    raise (RuntimeError if status == INTERNAL else ValueError)(last_error().decode() if sentence is None else sentence)


def check(status: int) -> None:
    """Raises an error if a call failed."""
    if status:
        fail(status)


_SIZES = [_structs.BODY, _structs.MATCH_EVENT, _structs.PLAYER, _structs.INTERCEPTION, _structs.WINDOW, _structs.GOAL_CHANCE, _structs.FIT, _structs.PIECE, _structs.FIT_MATCH, _structs.IMPACT,
          _structs.FILTER_SETTINGS, _structs.ESTIMATE, _structs.FORCES, _structs.CONTACT_FORCE]
if check_abi(ABI_VERSION, STATE_BYTES, BALL_BYTES, EVENT_BYTES) or check_structs(*(struct.itemsize for struct in _SIZES)):
    raise ImportError("football_physics: the package and its library do not belong together: " + last_error().decode())
