# SPDX-License-Identifier: BSD-3-Clause
"""Progress of VTK's readers and filters, for whoever listens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Hear = Callable[[str], None]

_listeners: list[Hear] = []


@contextmanager
def listening(hear: Hear) -> Iterator[None]:
    """Hear what work says in this context."""
    _listeners.append(hear)
    try:
        yield
    finally:
        _listeners.remove(hear)


def say(what: str) -> None:
    """Tell what is being done."""
    for hear in _listeners:
        hear(what)


def _report(algorithm: Any, _event: str) -> None:
    say(f"{algorithm.GetClassName()} {algorithm.GetProgress():.0%}")


@contextmanager
def watching(algorithm: Any) -> Iterator[None]:
    """Tell how far a reader or filter is while it is updated in this context."""
    if not _listeners:
        yield
        return
    say(algorithm.GetClassName())
    tag = algorithm.AddObserver("ProgressEvent", _report)
    try:
        yield
    finally:
        algorithm.RemoveObserver(tag)
