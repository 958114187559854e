"""Long calls of the library that report their progress and that Ctrl-C ends."""

from __future__ import annotations

import _thread
import threading
from typing import Any, Callable, List, Optional, Tuple

import numpy as np

from . import _native, _structs

Progress = Optional[Callable[[float], Any]]

# The time between two looks at the progress, s.
_EVERY = 0.05


def call(function: Any, *arguments: Any, keep: Any, progress: Progress = None) -> Tuple[int, str]:
    """Calls a function of the library whose last parameter is a watch. Returns its status and the sentence of its error.

    Python runs signal handlers only in the main thread, between two of its instructions. So the main thread waits, and another thread calls the library.
    An exception meanwhile, of Ctrl-C or of the progress, cancels the call; it is raised again when the library has returned.
    keep: the arrays whose addresses are among the arguments.
    """
    watch = np.zeros(1, _structs.WATCH)
    watch["bytes"] = _structs.WATCH.itemsize
    results: List[Tuple[int, str]] = []
    ended = _thread.allocate_lock()
    ended.acquire()

    def run(_: Any = keep) -> None:
        status = function(*arguments, watch.ctypes.data)
        # The sentence of an error belongs to the thread.
        results.append((status, _native.last_error().decode() if status else ""))
        ended.release()

    starts = progress is not None or threading.current_thread() is threading.main_thread()
    try:
        try:
            if starts:
                _thread.start_new_thread(run, ())
        except RuntimeError:
            # The system has no more threads.
            starts = False
        while starts and not results:
            ended.acquire(timeout=_EVERY)
            if progress is not None and not results:
                progress(float(watch["progress"][0]))
    except BaseException:
        watch["cancel"] = 1
        while starts and not results:
            try:
                ended.acquire(timeout=_EVERY)
            except KeyboardInterrupt:
                # The call is cancelled already, and still writes into arrays of the caller.
                continue
        raise
    if not starts:
        run()
    if progress is not None and not results[0][0]:
        progress(1.0)
    return results[0]
