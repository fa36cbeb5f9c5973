# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The topology of mode surfaces against the mode."""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Optional


@dataclass(frozen=True)
class SweepLevel:
    """The mode surface of one mode, extracted.

    Attributes
    ----------
    mode : Fraction
    components, euler_characteristic, boundary_loops : int
    area : float
    unresolved : int
        Tetrahedra without a proof; with any, the rest does not tell the topology.
    """

    mode: Fraction
    components: int
    euler_characteristic: int
    boundary_loops: int
    area: float
    unresolved: int


@dataclass(frozen=True)
class CriticalPoint:
    """A point of the mesh at whose mode the topology changes, or may do.

    Attributes
    ----------
    low, high : float
        The mode there is within.
    vertices : list of int
        Of the simplex that it is inside of.
    point : tuple of float
        About where.
    change : str
        ``regular``, ``birth``, ``death``, ``join``, ``split``, ``open``, ``close``, ``other`` or
        ``undecided``.
    euler_change : int or None
        By how much the Euler characteristic grows with the mode; None if undecided.
    on_boundary : bool
        Of the mesh.
    components, boundary_loops : list of int or None
        The least and the most by which these numbers grow.
    """

    low: float
    high: float
    vertices: list[int]
    point: tuple[float, float, float]
    change: str
    euler_change: Optional[int]
    on_boundary: bool
    components: Optional[list[int]]
    boundary_loops: Optional[list[int]]


@dataclass(frozen=True)
class SweepEvent:
    """A critical value, or several too close to each other for doubles to separate."""

    low: float
    high: float
    points: tuple[CriticalPoint, ...]
    euler_change: Optional[int]


@dataclass(frozen=True)
class SweepInterval:
    """The modes between two events, and with what topology: the same for all of them.

    ``level`` is an index into ``Sweep.levels``, or None.
    """

    low: float
    high: float
    euler_characteristic: Optional[int]
    level: Optional[int]


@dataclass(frozen=True)
class Sweep:
    """The diagram of topology against the mode; see `Field.sweep`.

    Attributes
    ----------
    levels : tuple of SweepLevel
        By mode.
    samples : tuple of int
        Those asked for, as indices into ``levels``.
    events : tuple of SweepEvent
        Disjoint, ascending.
    intervals : tuple of SweepInterval
        One more: before, between and after the events.
    contradictions : tuple of int
        Levels whose Euler characteristic is not what the events between say. There should be none.
    """

    levels: tuple[SweepLevel, ...]
    samples: tuple[int, ...]
    events: tuple[SweepEvent, ...]
    intervals: tuple[SweepInterval, ...]
    contradictions: tuple[int, ...]

    @property
    def complete(self) -> bool:
        """No contradictions, the change at each event is known, and no tetrahedron is unresolved."""
        return (
            not self.contradictions
            and all(i.euler_characteristic is not None or not i.low < i.high for i in self.intervals)
            and all(event.euler_change is not None for event in self.events)
            and all(level.unresolved == 0 for level in self.levels)
        )

    def __repr__(self) -> str:
        return f"Sweep({len(self.levels)} levels, {len(self.events)} events)"


def sweep_of(made: dict[str, Any]) -> Sweep:
    """The diagram from what the library gives."""
    def level_of(level: dict[str, Any]) -> SweepLevel:
        mode = Fraction(level.pop("mode"))
        return SweepLevel(mode, **level)

    levels = (level_of(level) for level in made["levels"])
    events = (
        SweepEvent(
            event["low"],
            event["high"],
            tuple(CriticalPoint(**point) for point in event["points"]),
            event["euler_change"],
        )
        for event in made["events"]
    )
    intervals = (SweepInterval(**interval) for interval in made["intervals"])
    return Sweep(
        tuple(levels),
        tuple(made["samples"]),
        tuple(events),
        tuple(intervals),
        tuple(made["contradictions"]),
    )
