"""Simulates the flight, bounce and roll of a football. Results are bit-identical to those in C# and C.

The axes are right-handed, with y up and -z forward; units are SI. A :class:`Scene` is checked and compiled once; a :class:`Balls` object holds any number of balls in it.

>>> import football_physics as fp
>>> balls = fp.Balls(fp.Scene(), 1)
>>> balls.kick([0], [[3, 8, -22]], [[0, 40, 0]])
>>> balls.until_landing()
array([ True])
"""

from ._balls import AimResult, Balls, Derivatives, EventKind, Forces, Motion, contact_force_dtype, event_dtype
from ._filter import BallFilter, estimate_dtype
from ._match import Match, ball_dtype, body_dtype, match_event_dtype
from ._native import version as _version
from ._players import ChanceMethod, GoalChance, Interception, Players, goal_chance, intercept, intercept_windows, window_dtype
from ._points import track
from ._scene import Scene, impact_dtype
from ._tracks import Fit, FitVerdict, MatchAnswers, MatchFit, PieceKind, TrackSuspicions, fit, fit_match, piece_dtype

__all__ = [
    "AimResult", "BallFilter", "Balls", "ChanceMethod", "Derivatives", "EventKind", "Fit", "FitVerdict", "Forces", "GoalChance", "Interception", "Match", "MatchAnswers", "MatchFit", "Motion", "PieceKind",
    "Players", "Scene", "TrackSuspicions", "ball_dtype", "body_dtype", "contact_force_dtype", "envs", "estimate_dtype", "event_dtype", "fit", "fit_match", "goal_chance", "impact_dtype", "intercept",
    "intercept_windows", "match_event_dtype", "piece_dtype",
    "track", "window_dtype"]
__version__ = _version().decode()
