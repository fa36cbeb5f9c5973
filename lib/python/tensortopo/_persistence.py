# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Persistence of the mode."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional


@dataclass(frozen=True)
class PersistencePair:
    """A component, loop or void of {mode >= m} or {mode <= m}, from the mode of its birth to that of
    its death.

    Attributes
    ----------
    dimension : int
        0: a component; 1: a loop; 2: a void.
    kind : str
        ``superlevel`` (of {mode >= m}, born as m falls; a component at a maximum, gone where it
        meets an older one), ``sublevel`` (of {mode <= m}, born as m grows), or ``extended`` (a
        whole part of the mesh, from its largest mode to its least).
    birth, death : float, float or None
        Modes, the middles of the enclosures. No death: it lasts, or the death is not known.
    birth_range, death_range : tuple of float
        Enclosures of these modes.
    angle_persistence : float
        Difference of the signed Lode angles arcsin(mode) / 3, in radians: at least this.
    survives : float
        The relative noise r up to which each field with ``|D - D'| <= r |D|``, D the deviator, has
        a counterpart of it: sin(angle_persistence / 2).
    birth_tet, death_tet : int or None
        Ids of cells that hold the points.
    birth_point, death_point : tuple of float, or None
        About where.
    curve : int or None
        Component of the degenerate curves of mode 1 (of kind ``sublevel``: -1) that it is born at;
        of a void, of mode -1 (``sublevel``: 1) that it dies at.
    lasting : bool
        A class of the mesh itself: it has no death.
    tie : bool
        Enclosures overlap (of curves: lengths are equal), so another pairing is not excluded.
    certain : bool
        No point whose link or paths are not proved may have joined it to an older one before.
    """

    dimension: int
    kind: str
    birth: float
    death: Optional[float]
    birth_range: tuple[float, float]
    death_range: tuple[float, float]
    angle_persistence: float
    survives: float
    birth_tet: Optional[int]
    death_tet: Optional[int]
    birth_point: tuple[float, float, float]
    death_point: Optional[tuple[float, float, float]]
    curve: Optional[int]
    lasting: bool
    tie: bool
    certain: bool


@dataclass(frozen=True)
class LoopEvent:
    """A mode at which independent loops (1-cycles) appear or vanish.

    Attributes
    ----------
    kind : str
        ``superlevel``: of {mode >= m} as m falls; ``sublevel``: of {mode <= m} as m grows.
    event : str
        ``birth`` or ``death``.
    mode : float
        The middle of the enclosure.
    mode_range : tuple of float
        The enclosure.
    count : int
        How many.
    paired : int
        How many of them are in `Persistence.pairs`; which births and deaths the others belong to is
        not known.
    tet : int or None
        Id of a cell that holds the point.
    point : tuple of float
        About where; of a curve a vertex of it.
    curve : int or None
        Component of the degenerate curves: of mode 1 for a superlevel birth or a sublevel death,
        else of mode -1.
    tie : bool
        The enclosure overlaps that of a point at which as well components meet, or voids appear.
    """

    kind: str
    event: str
    mode: float
    mode_range: tuple[float, float]
    count: int
    paired: int
    tet: Optional[int]
    point: tuple[float, float, float]
    curve: Optional[int]
    tie: bool


@dataclass(frozen=True)
class BettiInterval:
    """The Betti numbers for all m between two modes.

    Attributes
    ----------
    low, high : float
        low < m < high.
    betti : tuple of int or None
        Components, loops and voids; None where that is not known.
    """

    low: float
    high: float
    betti: tuple[Optional[int], Optional[int], Optional[int]]


@dataclass(frozen=True)
class CurvePersistence:
    """A component of the degenerate curves.

    Attributes
    ----------
    mode : int
        1 or -1.
    component : int
        As `Field.degenerate_curves` numbers those of this mode.
    closed : bool
    length : float
    pair : int
        As an index into `Persistence.pairs`.
    survives : float
        Of its pair.
    """

    mode: int
    component: int
    closed: bool
    length: float
    pair: int
    survives: float


@dataclass(frozen=True)
class Persistence:
    """The persistence of the mode; see `Field.persistence`.

    Attributes
    ----------
    pairs : tuple of PersistencePair
        All components; then loops of which it is proved which birth and death belong together; then
        all voids.
    curves : tuple of CurvePersistence
        Those of mode 1 first.
    not_proved : tuple of int
        Critical points whose link, or paths from which, are not proved, for {mode >= m} and for
        {mode <= m}.
    unresolved_curve_cells : tuple of int
        Tetrahedra in which the curves of mode 1, and of mode -1, are not known.
    loops : tuple of LoopEvent
        Where loops appear and vanish.
    superlevel_betti, sublevel_betti : tuple of BettiInterval
        The Betti numbers of {mode >= m} and of {mode <= m}, by growing m.
    mesh_betti : tuple of int
        Those of the mesh.
    not_proved_voids : tuple of int
        Of `not_proved` and others, points that may change the voids of {mode >= m}, and of
        {mode <= m}.
    isotropic_vertices : int
        Vertices without a mode: with any, loops and voids are not certain.
    known_curves : bool
        All degenerate curves are known, and where they meet the boundary. If not, no loops are
        paired.
    """

    pairs: tuple[PersistencePair, ...]
    curves: tuple[CurvePersistence, ...]
    not_proved: tuple[int, int]
    unresolved_curve_cells: tuple[int, int]
    loops: tuple[LoopEvent, ...]
    superlevel_betti: tuple[BettiInterval, ...]
    sublevel_betti: tuple[BettiInterval, ...]
    mesh_betti: tuple[int, int, int]
    not_proved_voids: tuple[int, int]
    isotropic_vertices: int
    known_curves: bool

    @property
    def complete(self) -> bool:
        """Every point and path is proved, all degenerate curves are known, and a mode is everywhere."""
        return (
            not any(self.not_proved)
            and not any(self.unresolved_curve_cells)
            and not any(self.not_proved_voids)
            and self.isotropic_vertices == 0
            and self.known_curves
        )

    def __repr__(self) -> str:
        return f"Persistence({len(self.pairs)} pairs, {len(self.curves)} curves)"


def persistence_of(made: dict[str, Any]) -> Persistence:
    """Persistence from what the library gives."""
    pairs = tuple(PersistencePair(**pair) for pair in made["pairs"])
    curves = tuple(
        CurvePersistence(survives=pairs[curve["pair"]].survives, **curve) for curve in made["curves"]
    )
    return Persistence(
        pairs=pairs,
        curves=curves,
        not_proved=tuple(made["not_proved"]),
        unresolved_curve_cells=tuple(made["unresolved_curve_cells"]),
        loops=tuple(LoopEvent(**event) for event in made["loops"]),
        superlevel_betti=tuple(BettiInterval(**i) for i in made["betti"]["superlevel"]),
        sublevel_betti=tuple(BettiInterval(**i) for i in made["betti"]["sublevel"]),
        mesh_betti=made["mesh_betti"],
        not_proved_voids=made["not_proved_voids"],
        isotropic_vertices=made["isotropic_vertices"],
        known_curves=made["known_curves"],
    )
