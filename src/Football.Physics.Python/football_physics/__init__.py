"""The flight, bounce and roll of a football, with the bits that the same kick has in C# and in C.

Right-handed, y up, forward -z; SI units. A :class:`Scene` is checked and compiled once; :class:`Balls` are any number of balls in it.

>>> import football_physics as fp
>>> balls = fp.Balls(fp.Scene(), 1)
>>> balls.kick([0], [[3, 8, -22]], [[0, 40, 0]])
>>> balls.until_landing()
array([ True])
"""

from ._balls import AimResult, Balls, Derivatives, EventKind, Motion, event_dtype
from ._native import version as _version
from ._scene import Scene

__all__ = ["AimResult", "Balls", "Derivatives", "EventKind", "Motion", "Scene", "event_dtype"]
__version__ = _version().decode()
