# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as data."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence


@dataclass(frozen=True)
class Defect:
    """One thing that makes a mesh unfit as the domain of a field.

    Attributes
    ----------
    kind : str
        ``wrong_length``, ``non_finite_point``, ``non_finite_tensor``, ``out_of_range``,
        ``index_out_of_range``, ``repeated_vertex``, ``degenerate_cell``, ``duplicated_cell``,
        ``crowded_face`` or ``overlapping_cells``; with ``strict=True`` also ``torn_faces`` and
        ``isotropic``.
    where : int
        The vertex (of the first three kinds: its id if ids were given) or the id of the cell.
    text : str
        What is wrong and where.
    """

    kind: str
    where: int
    text: str


class MeshError(ValueError):
    """A mesh is no domain of a piecewise linear field.

    Attributes
    ----------
    defects : tuple of Defect
        All defects, at most 1000, in the order of the kinds of checks, then of cells.
    """

    def __init__(self, defects: Sequence[Defect], source: str = "") -> None:
        self.defects: tuple[Defect, ...] = tuple(defects)
        more = len(self.defects) - 1
        text = self.defects[0].text if self.defects else "the mesh has no defects"
        super().__init__((f"{source}: " if source else "") + text + (f" (and {more} more, see .defects)" if more > 0 else ""))


class Cancelled(RuntimeError):
    """A progress callback returned False."""


class FileError(OSError):
    """A file cannot be read as what it should be, or cannot be written."""


class UnresolvedError(RuntimeError):
    """With ``strict=True``: some cells are left out, or not within ``max_error``.

    Attributes
    ----------
    unresolved : tuple of Unresolved
        The cells that are left out, with their reasons.
    """

    def __init__(self, unresolved: Sequence[object], text: str = "") -> None:
        self.unresolved = tuple(unresolved)
        super().__init__(text or f"{len(self.unresolved)} cells are left out: {self.unresolved[0]}")
