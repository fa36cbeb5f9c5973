# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Extracted surfaces and curves."""
from __future__ import annotations

from dataclasses import dataclass, field as dataclass_field
from fractions import Fraction
from typing import Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]
Ids = npt.NDArray[np.int64]

#: What the numbers in ``carrier`` stand for.
CARRIERS = ("edge", "face", "tet", "vertex")


@dataclass(frozen=True)
class Unresolved:
    """A cell that an output leaves out.

    Attributes
    ----------
    cell_id : int
        Its id in the field.
    tet : int
        Its index in ``field.tets``.
    reason : str
        Why, as the program's reports name it.
    mode : Fraction
        The mode for which it is left out.
    """

    cell_id: int
    tet: int
    reason: str
    mode: Fraction


@dataclass(frozen=True)
class Component:
    """A connected component of a surface.

    Attributes
    ----------
    euler_characteristic, boundary_loops, triangles : int
    genus : int
        Handles of an orientable component, cross-caps of another; -1 where it is no manifold.
    area : float
        Of the triangles.
    orientable, manifold : bool
    """

    euler_characteristic: int
    boundary_loops: int
    genus: int
    triangles: int
    area: float
    orientable: bool
    manifold: bool


@dataclass(frozen=True)
class SurfaceLevel:
    """One mode's part of a surface.

    Attributes
    ----------
    mode : Fraction
    vertices, triangles : int
        They follow those of the mode before.
    components : tuple of Component
        In the order of their first triangles.
    distance_bound : float or None
        Proved bound on the distance between triangles and level, both ways; with ``certify`` or
        ``max_error``.
    tets_farther : int
        Tetrahedra in which ``max_error`` is not proved.
    not_embedded : tuple of int
        Tetrahedra, as indices into ``field.tets``, whose triangles have the proved topology, but intersect
        each other or are at 90 degrees or more to the gradient of the mode.
    stability : dict or None
        With ``uncertainty``: ``stable_tets`` and ``unstable_tets`` of the mesh, ``crossed_stable_tets``,
        ``crossings`` (vertices on edges of the mesh) and ``stable_crossings`` of them, ``crossing_reasons``
        (the others by the reason's name), ``reasons`` (unstable tetrahedra by the reason's name),
        ``stable_components``.
    statistics : dict
        What the extraction counted, and its seconds.
    """

    mode: Fraction
    vertices: int
    triangles: int
    components: tuple[Component, ...]
    distance_bound: Optional[float]
    tets_farther: int
    not_embedded: tuple[int, ...]
    stability: Optional[dict[str, Any]]
    statistics: dict[str, float] = dataclass_field(repr=False)


@dataclass(frozen=True)
class CurveLevel:
    """One kind's part of degenerate curves.

    Attributes
    ----------
    mode : Fraction
        1 for linear degenerate curves, -1 for planar ones.
    vertices, lines, components, closed_components : int
    length : float
    stability : dict or None
        As of `SurfaceLevel`; ``crossings`` are vertices on faces of the mesh.
    statistics : dict
        What the extraction counted, and its seconds.
    """

    mode: Fraction
    vertices: int
    lines: int
    components: int
    closed_components: int
    length: float
    stability: Optional[dict[str, Any]]
    statistics: dict[str, float] = dataclass_field(repr=False)


def _unresolved(made: dict[str, Any], cell_ids: Ids) -> tuple[Unresolved, ...]:
    return tuple(
        Unresolved(int(cell_ids[tet]), tet, reason, Fraction(mode))
        for tet, reason, mode in made["unresolved"]
    )


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")


class _Output:
    """What surfaces and curves have in common. Arrays are read-only views of the library's."""

    points: Doubles
    mode: Doubles
    residual: Doubles
    dominant_eigenvectors: Doubles
    carrier: npt.NDArray[np.uint8]
    carrier_vertices: Indices
    tet: Indices
    component: Indices
    stable: Optional[Indices] = None
    instability: Optional[Indices] = None
    crossing_stable: Optional[Indices] = None
    crossing_instability: Optional[Indices] = None

    def __init__(self, made: dict[str, Any], cell_ids: Ids) -> None:
        for name, value in made.items():
            if isinstance(value, np.ndarray):
                setattr(self, name, value)
        self.unresolved: tuple[Unresolved, ...] = _unresolved(made, cell_ids)
        self.certificate: Optional[bytes] = made["certificate"]
        self.claims: int = made["claims"]
        ids = cell_ids[self.tet]
        ids.flags.writeable = False
        self.cell_ids: Ids = ids


class Surface(_Output):
    """The surfaces of one mode or of several; see `Field.mode_surface`.

    Attributes
    ----------
    points : ndarray, shape (k, 3)
        One vertex for one point, across tetrahedra.
    triangles : ndarray of int32, shape (t, 3)
        Counter-clockwise seen from the larger mode.
    normals, medium_eigenvectors, dominant_eigenvectors : ndarray, shape (k, 3)
        Unit gradient of the mode, and unit eigenvectors of arbitrary sign.
    mode, residual : ndarray, shape (k,)
        The mode asked for, and by how much the mode of the field at the rounded vertex differs.
    carrier : ndarray of uint8, shape (k,)
        What holds the vertex, a subscript of `CARRIERS`.
    carrier_vertices : ndarray of int32, shape (k, 4)
        The vertices of that simplex, ascending; -1 fills up.
    tet, component : ndarray of int32, shape (t,)
        The tetrahedron that holds the triangle, as an index into ``field.tets``; the connected
        component, numbered in the order of first triangles.
    cell_ids : ndarray of int64, shape (t,)
        The id of that tetrahedron.
    stable, instability : ndarray of int32, shape (t,), or None
        With ``uncertainty``: 1 where the level is proved to have the same topology in that tetrahedron
        for all fields within it, else 0; and why it is not: 0 it is, 1 a deviator is not larger than
        its radius, 2 a vertex can be on either side, 3, 4 and 5 there is no proof for an edge, a face or
        the inside, 6 unresolved. 1 and 2 are exact: there are two such fields that differ.
    crossing_stable, crossing_instability : ndarray of int32, shape (k,), or None
        The same of crossings, the vertices on edges of the mesh: 1 where all these fields are proved to
        cross the edge alike. -1 at other vertices.
    levels : tuple of SurfaceLevel
        One for each mode, with its topology.
    unresolved : tuple of Unresolved
        Cells that no proof covers, and that the surface leaves out.
    certificate : bytes or None
        With ``certify=True``: the certificate, a JSON file; see `check`.
    claims : int
        How many claims the certificate makes.
    """

    triangles: Indices
    normals: Doubles
    medium_eigenvectors: Doubles

    def __init__(self, made: dict[str, Any], cell_ids: Ids) -> None:
        super().__init__(made, cell_ids)
        self.levels: tuple[SurfaceLevel, ...] = tuple(
            SurfaceLevel(
                Fraction(level["mode"]),
                level["vertices"],
                level["triangles"],
                tuple(Component(**part) for part in level["parts"]),
                level["distance_bound"],
                level["tets_farther"],
                tuple(level["not_embedded"]),
                level["stability"],
                level["statistics"],
            )
            for level in made["levels"]
        )

    @property
    def modes(self) -> tuple[Fraction, ...]:
        """The modes, in the order of the parts."""
        return tuple(level.mode for level in self.levels)

    @property
    def components(self) -> tuple[Component, ...]:
        """The components of all modes."""
        return tuple(component for level in self.levels for component in level.components)

    @property
    def euler_characteristic(self) -> int:
        """Of all components together."""
        return sum(component.euler_characteristic for component in self.components)

    @property
    def boundary_loops(self) -> int:
        """Of all components together."""
        return sum(component.boundary_loops for component in self.components)

    @property
    def area(self) -> float:
        """Of all triangles."""
        return sum(component.area for component in self.components)

    @property
    def statistics(self) -> dict[str, float]:
        """What the extraction of all modes counted, added up."""
        total: dict[str, float] = {}
        for level in self.levels:
            for name, value in level.statistics.items():
                total[name] = total.get(name, 0) + value
        return total

    def __repr__(self) -> str:
        modes = ", ".join(str(mode) for mode in self.modes)
        return (
            f"Surface(mode={modes}: {_count(len(self.points), 'point')}, "
            f"{_count(len(self.triangles), 'triangle')}, "
            f"{_count(len(self.components), 'component')}, {len(self.unresolved)} unresolved)"
        )


class Curves(_Output):
    """Degenerate curves as polylines; see `Field.degenerate_curves`.

    Attributes
    ----------
    points : ndarray, shape (k, 3)
    offsets, connectivity : ndarray
        Line i has the vertices ``connectivity[offsets[i]:offsets[i + 1]]``; see `lines`.
    dominant_eigenvectors : ndarray, shape (k, 3)
        Unit eigenvectors of the eigenvalue that is not repeated.
    mode, residual : ndarray, shape (k,)
        1 or -1; sqrt(1 - mode^2) of the field at the rounded vertex.
    separation : ndarray, shape (k,)
        Positive where tensors across the curve have a wedge, negative where a trisector.
    carrier, carrier_vertices : ndarray
        As in `Surface`.
    tet, component, cell_ids : ndarray
        One a line, as in `Surface`.
    stable, instability : ndarray of int32, one a line, or None
        With ``uncertainty``, as in `Surface`: 1 where the curves are proved to be the same in that
        tetrahedron; the reasons are 1, 6, 7 a vertex can be degenerate, 8 an edge may be, and 9 and 10
        there is no proof for a face or the inside. 1 and 7 are exact.
    crossing_stable, crossing_instability : ndarray of int32, shape (k,), or None
        The same of the vertices on faces of the mesh; -1 at others.
    levels : tuple of CurveLevel
        One for each kind.
    unresolved, certificate, claims
        As in `Surface`.
    """

    offsets: Ids
    connectivity: Indices
    separation: Doubles

    def __init__(self, made: dict[str, Any], cell_ids: Ids) -> None:
        super().__init__(made, cell_ids)
        self.levels: tuple[CurveLevel, ...] = tuple(
            CurveLevel(
                Fraction(level["mode"]),
                level["vertices"],
                level["lines"],
                level["components"],
                level["closed_components"],
                level["length"],
                level["stability"],
                level["statistics"],
            )
            for level in made["levels"]
        )

    @property
    def lines(self) -> list[Indices]:
        """The vertices of each line, views of `connectivity`."""
        return np.split(self.connectivity, self.offsets[1:-1]) if len(self.offsets) > 1 else []

    @property
    def length(self) -> float:
        """Of all lines."""
        return sum(level.length for level in self.levels)

    def __iter__(self) -> Iterator[Doubles]:
        """The points of each line."""
        return (self.points[line] for line in self.lines)

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __repr__(self) -> str:
        modes = ", ".join(str(level.mode) for level in self.levels)
        components = sum(level.components for level in self.levels)
        return (
            f"Curves(mode={modes}: {_count(len(self.points), 'point')}, "
            f"{_count(len(self), 'line')}, {_count(components, 'component')}, "
            f"{len(self.unresolved)} unresolved)"
        )
