"""The C library, by ctypes: its functions with their types, and its errors as exceptions."""

import ctypes
import pathlib
import sys

_NAMES = {"win32": "football_physics.dll", "darwin": "libfootball_physics.dylib"}
_library = ctypes.CDLL(str(pathlib.Path(__file__).parent / _NAMES.get(sys.platform, "libfootball_physics.so")))

STATE_BYTES = 216
BALL_BYTES = 120
EVENT_BYTES = 160
ABI_VERSION = 1
OK, ARGUMENT, SCENE, BUFFER, HANDLE, ABI, INTERNAL = range(7)

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
derivatives_run = _function("fp_derivatives_run", _P, _P, _D, _D, _I, _P, _P)
air_many = _function("fp_air_many", _P, _L, _P, _P, _P, _D, _P, _P, _P)
snapshot_write = _function("fp_snapshot_write", _P, _P)
snapshot_read = _function("fp_snapshot_read", _P, _P)


def fail(status: int) -> None:
    """Raises the error of a failed call, with the library's message."""
    sentence = last_error().decode()
    raise (RuntimeError if status == INTERNAL else ValueError)(sentence)


def check(status: int) -> None:
    """Raises an error if a call failed."""
    if status:
        fail(status)


if check_abi(ABI_VERSION, STATE_BYTES, BALL_BYTES, EVENT_BYTES):
    raise ImportError("football_physics: the package and its library do not belong together: " + last_error().decode())
