# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Degenerate curves of meshes that lie in pieces."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Iterable, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._field import Field
from ._partition import CertifiedField, certified_numbers


def _lines(offsets: npt.NDArray[np.int64], connectivity: npt.NDArray[np.int32]) -> list[npt.NDArray[np.int32]]:
    return np.split(connectivity, offsets[1:-1]) if len(offsets) > 1 else []


@dataclass(frozen=True)
class PieceCurves:
    """The part of degenerate curves that lies in the cells that a piece owns.

    It can be pickled, so that processes can send it to each other; `merge_curve_pieces` puts pieces together.

    Attributes
    ----------
    arrays : dict
        What `merge_curve_pieces` reads. Of use to others are ``points`` (n, 3), and ``offsets`` and ``connectivity``
        of lines.
    """

    arrays: dict[str, Any]

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """(n, 3)"""
        return self.arrays["points"]

    @property
    def lines(self) -> list[npt.NDArray[np.int32]]:
        """The vertices of each line."""
        return _lines(self.arrays["offsets"], self.arrays["connectivity"])

    @property
    def component(self) -> npt.NDArray[np.int32]:
        """The connected component of each line, counted within the piece."""
        return self.arrays["component"]

    @property
    def cell_ids(self) -> npt.NDArray[np.int64]:
        """The id of the cell that holds each line, or of one around."""
        return self.arrays["cell_ids"][self.arrays["tet"]]

    @property
    def unresolved(self) -> list[tuple[int, str]]:
        """Ids of owned cells whose curves are not known, with the reason."""
        return self.arrays["unresolved"]

    def __len__(self) -> int:
        return len(self.arrays["offsets"]) - 1

    def __repr__(self) -> str:
        return f"PieceCurves({self.arrays['kind']}: {len(self.points)} points, {len(self)} lines)"


@dataclass(frozen=True)
class MergedCurves:
    """The degenerate curves of a whole mesh, put together from pieces.

    Attributes
    ----------
    points, dominant_eigenvectors : ndarray of shape (n, 3)
    mode, residual, separation : ndarray of shape (n,)
        As in `Curves`.
    carrier : ndarray of uint8 of shape (n,)
        As in `Curves`.
    carrier_ids : ndarray of int64 of shape (n, 4)
        Ids of the vertices of the simplex that holds the point, ascending; -1 fills up.
    offsets, connectivity : ndarray
        As in `Curves`; see `lines`.
    component : ndarray of int32, one a line
    cell_ids : ndarray of int64, one a line
        Id of the cell that holds the line, or of one around.
    unresolved : list of tuple
        Ids of cells whose curves are not known, with the reason.
    special : list of tuple
        Ids of other cells in which a curve may be in special position, with what is special.
    certificate : bytes or None
        What `merge_curve_pieces` was asked for; `check` takes it.
    """

    points: npt.NDArray[np.float64]
    dominant_eigenvectors: npt.NDArray[np.float64]
    mode: npt.NDArray[np.float64]
    residual: npt.NDArray[np.float64]
    separation: npt.NDArray[np.float64]
    carrier: npt.NDArray[np.uint8]
    carrier_ids: npt.NDArray[np.int64]
    offsets: npt.NDArray[np.int64]
    connectivity: npt.NDArray[np.int32]
    component: npt.NDArray[np.int32]
    cell_ids: npt.NDArray[np.int64]
    unresolved: list[tuple[int, str]]
    special: list[tuple[int, str]]
    certificate: Optional[bytes] = None

    @property
    def lines(self) -> list[npt.NDArray[np.int32]]:
        """The vertices of each line."""
        return _lines(self.offsets, self.connectivity)

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __repr__(self) -> str:
        return f"MergedCurves({len(self.points)} points, {len(self)} lines)"


def extract_curve_piece(
    field: Field,
    kind: str,
    owned: npt.ArrayLike,
    vertex_ids: npt.ArrayLike,
    whole_cells: int,
    *,
    resolution: float = 4,
    progress: Optional[Callable[[str, float], Any]] = None,
) -> PieceCurves:
    """The part of degenerate curves that lies in the cells that a piece of a mesh owns.

    The lines are those that the whole mesh gives, bit for bit.

    Parameters
    ----------
    field : Field
        The piece, as for `extract_piece`.
    kind : {"linear", "planar"}
        As for `Field.degenerate_curves`.
    owned : array_like of bool of shape (m,)
        Of each cell whether the piece owns it. Each cell of the whole mesh is owned by one piece.
    vertex_ids : array_like of int of shape (n,)
        Of each point the id in the whole mesh, at least 0.
    whole_cells : int
        How many cells the whole mesh has: `merge_curve_pieces` notices by it that a piece is missing.
    resolution, progress
        As for `Field.degenerate_curves`.

    Returns
    -------
    PieceCurves

    Raises
    ------
    ValueError
        For another kind, or as `extract_piece`.
    """
    if kind not in ("linear", "planar"):
        raise ValueError(f"kind: a piece is of one kind, linear or planar, not '{kind}'")
    # pylint: disable-next=protected-access
    made = field._mesh.curve_piece(
        kind=kind,
        vertex_ids=np.ascontiguousarray(vertex_ids, dtype=np.int64),
        owned=np.ascontiguousarray(owned, dtype=bool),
        whole_cells=whole_cells,
        resolution=float(resolution),
        progress=progress,
    )
    return PieceCurves(made)


def merge_curve_pieces(
    pieces: Iterable[PieceCurves], *, certify: Optional[CertifiedField] = None
) -> MergedCurves:
    """The degenerate curves of the whole mesh, from all of its pieces in any order.

    They are what `Field.degenerate_curves` gives for the whole mesh, bit for bit and in the same order, and so is
    the certificate, byte for byte.

    Parameters
    ----------
    pieces : iterable of PieceCurves
    certify : CertifiedField, optional
        Make a certificate.

    Raises
    ------
    ValueError
        If the pieces do not own each cell of the whole mesh once, are not those of one mesh, or not of one kind.
    PiecesDiffer
        If they do not meet: they were extracted with other options, or more layers of cells around the owned ones
        are needed. The message says where. It is a ValueError.
    """
    made = _core.merge_curve_pieces([piece.arrays for piece in pieces], certified_numbers(certify, ""))
    return MergedCurves(**{name: made[name] for name in MergedCurves.__dataclass_fields__})
