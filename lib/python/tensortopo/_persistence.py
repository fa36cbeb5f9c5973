# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Persistence of the mode."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional


@dataclass(frozen=True)
class PersistencePair:
    """A component of {mode >= m} or {mode <= m}, from the mode of its birth to that of its death.

    Attributes
    ----------
    kind : str
        ``superlevel`` (born at a maximum, gone where it meets an older component of {mode >= m}),
        ``sublevel`` (born at a minimum), or ``extended`` (a whole part of the mesh, from its
        largest mode to its least).
    birth, death : float, float or None
        Modes, the middles of the enclosures. No death: it is not known.
    birth_range, death_range : tuple of float
        Enclosures of these modes.
    angle_persistence : float
        Difference of the signed Lode angles arcsin(mode) / 3, in radians: at least this.
    survives : float
        The relative noise r up to which each field with ``|D - D'| <= r |D|``, D the deviator, has
        a counterpart of the component: sin(angle_persistence / 2).
    birth_tet, death_tet : int or None
        Ids of cells that hold the points.
    birth_point, death_point : tuple of float, or None
        About where.
    curve : int or None
        Component of the degenerate curves of mode 1 (of kind ``sublevel``: -1) that it is born at.
    tie : bool
        Enclosures overlap (of curves: lengths are equal), so another pairing is not excluded.
    certain : bool
        No point whose link or paths are not proved may have joined it to an older one before.
    """

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
    tie: bool
    certain: bool


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
    """The persistence of the mode in dimension 0; see `Field.persistence`.

    Attributes
    ----------
    pairs : tuple of PersistencePair
    curves : tuple of CurvePersistence
        Those of mode 1 first.
    not_proved : tuple of int
        Critical points whose link, or paths from which, are not proved, for {mode >= m} and for
        {mode <= m}.
    unresolved_curve_cells : tuple of int
        Tetrahedra in which the curves of mode 1, and of mode -1, are not known.
    """

    pairs: tuple[PersistencePair, ...]
    curves: tuple[CurvePersistence, ...]
    not_proved: tuple[int, int]
    unresolved_curve_cells: tuple[int, int]

    @property
    def complete(self) -> bool:
        """Every point and path is proved, and all degenerate curves are known."""
        return not any(self.not_proved) and not any(self.unresolved_curve_cells)

    def __repr__(self) -> str:
        return f"Persistence({len(self.pairs)} pairs, {len(self.curves)} curves)"


def persistence_of(made: dict[str, Any]) -> Persistence:
    """Persistence from what the library gives."""
    pairs = tuple(PersistencePair(**pair) for pair in made["pairs"])
    curves = tuple(
        CurvePersistence(survives=pairs[curve["pair"]].survives, **curve) for curve in made["curves"]
    )
    return Persistence(
        pairs, curves, tuple(made["not_proved"]), tuple(made["unresolved_curve_cells"])
    )
