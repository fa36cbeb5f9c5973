# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Mode surfaces of meshes that lie in pieces."""
from __future__ import annotations

import hashlib
import struct
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._field import Field
from ._modes import mode_texts

PiecesDiffer = _core.PiecesDiffer


@dataclass(frozen=True)
class PieceSurface:
    """The part of a mode surface that lies in the cells that a piece owns.

    It can be pickled, so that processes can send it to each other; `merge_pieces` puts pieces together.

    Attributes
    ----------
    arrays : dict
        What `merge_pieces` reads. Of use to others are ``points`` (n, 3), ``triangles`` (m, 3) and ``normals``.
    """

    arrays: dict[str, Any]

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """(n, 3)"""
        return self.arrays["points"]

    @property
    def triangles(self) -> npt.NDArray[np.int32]:
        """(m, 3)"""
        return self.arrays["triangles"]

    @property
    def unresolved(self) -> list[tuple[int, str]]:
        """Ids of owned cells that were not extracted, with the reason."""
        return self.arrays["unresolved"]

    @property
    def not_embedded(self) -> list[int]:
        """Ids of owned cells whose triangles intersect, or are at 90 degrees or more to the gradient."""
        return self.arrays["not_embedded"]

    def __repr__(self) -> str:
        return f"PieceSurface({len(self.points)} points, {len(self.triangles)} triangles)"


@dataclass(frozen=True)
class MergedSurface:
    """The surface of a whole mesh, put together from pieces.

    Attributes
    ----------
    points, normals, medium_eigenvectors, dominant_eigenvectors : ndarray of shape (n, 3)
    mode, residual : ndarray of shape (n,)
    carrier : ndarray of uint8 of shape (n,)
        As in `Surface`.
    carrier_ids : ndarray of int64 of shape (n, 4)
        Ids of the vertices of the simplex that holds the point, ascending; -1 fills up.
    triangles : ndarray of int32 of shape (m, 3)
    component : ndarray of int32 of shape (m,)
    cell_ids : ndarray of int64 of shape (m,)
        Id of the cell that holds the triangle.
    unresolved : list of tuple
        Ids of cells that were not extracted, with the reason.
    not_embedded : list of int
        Ids of cells whose triangles have the proved topology, but intersect each other or are at 90
        degrees or more to the gradient of the mode.
    certificate : bytes or None
        What `merge_pieces` was asked for; `check` takes it.
    """

    points: npt.NDArray[np.float64]
    normals: npt.NDArray[np.float64]
    medium_eigenvectors: npt.NDArray[np.float64]
    dominant_eigenvectors: npt.NDArray[np.float64]
    mode: npt.NDArray[np.float64]
    residual: npt.NDArray[np.float64]
    carrier: npt.NDArray[np.uint8]
    carrier_ids: npt.NDArray[np.int64]
    triangles: npt.NDArray[np.int32]
    component: npt.NDArray[np.int32]
    cell_ids: npt.NDArray[np.int64]
    unresolved: list[tuple[int, str]]
    not_embedded: list[int]
    certificate: Optional[bytes] = None

    def __repr__(self) -> str:
        return f"MergedSurface({len(self.points)} points, {len(self.triangles)} triangles)"


def extract_piece(
    field: Field,
    mode: Any,
    owned: npt.ArrayLike,
    vertex_ids: npt.ArrayLike,
    whole_cells: int,
    *,
    resolution: float = 4,
    all_samples: bool = False,
    certify: bool = False,
    progress: Optional[Callable[[str, float], Any]] = None,
) -> PieceSurface:
    """The part of a mode surface that lies in the cells that a piece of a mesh owns.

    The triangles are those that the whole mesh gives, bit for bit.

    Parameters
    ----------
    field : Field
        The piece: the cells that it owns, and every cell of the whole mesh that shares a vertex with one
        of these. Its ``cell_ids`` are those of the whole mesh.
    mode : str, int, float, Fraction or Decimal
        One, as for `Field.mode_surface`.
    owned : array_like of bool of shape (m,)
        Of each cell whether the piece owns it. Each cell of the whole mesh is owned by one piece.
    vertex_ids : array_like of int of shape (n,)
        Of each point the id in the whole mesh, at least 0.
    whole_cells : int
        How many cells the whole mesh has: `merge_pieces` notices by it that a piece is missing.
    resolution, all_samples, progress
        As for `Field.mode_surface`.
    certify : bool, default False
        Keep the proofs, from which `merge_pieces` makes a certificate.

    Returns
    -------
    PieceSurface

    Raises
    ------
    ValueError
        If lists have other lengths than the mesh, ids repeat, or the whole mesh has fewer cells than the piece.
    """
    texts = mode_texts(mode)
    if len(texts) != 1:
        raise ValueError("mode: a piece is of one mode")
    # pylint: disable-next=protected-access
    made = field._mesh.piece(
        mode=texts[0],
        vertex_ids=np.ascontiguousarray(vertex_ids, dtype=np.int64),
        owned=np.ascontiguousarray(owned, dtype=bool),
        whole_cells=whole_cells,
        resolution=float(resolution),
        all_samples=all_samples,
        certify=certify,
        progress=progress,
    )
    return PieceSurface(made)


@dataclass(frozen=True)
class CertifiedField:
    """What a certificate says of a field that lies in pieces.

    Attributes
    ----------
    points : int
        How many points the whole mesh has.
    sha256 : str
        The hash of the whole field's numbers, as `Field.sha256` gives it; `FieldHash` computes it piece by piece.
    tensor_name : str
        What the file that is checked calls the tensors.
    components : str
        The order of their components there, as in `COMPONENT_ORDERS`, or ``full``.
    """

    points: int
    sha256: str
    tensor_name: str = "tensor"
    components: str = "vtk"


def certified_numbers(certify: Optional[CertifiedField], mode: str) -> Optional[dict[str, Any]]:
    """What the module is told of a field that a certificate is about."""
    if certify is None:
        return None
    return {
        "mode": mode,
        "tensor": certify.tensor_name,
        "components": certify.components,
        "points": certify.points,
        "sha256": certify.sha256,
    }


def merge_pieces(
    pieces: Iterable[PieceSurface],
    *,
    certify: Optional[CertifiedField] = None,
    mode: Any = None,
) -> MergedSurface:
    """The surface of the whole mesh, from all of its pieces in any order.

    It is what `Field.mode_surface` gives for the whole mesh, bit for bit and in the same order, and so is
    the certificate, byte for byte.

    Parameters
    ----------
    pieces : iterable of PieceSurface
    certify : CertifiedField, optional
        Make a certificate, of pieces that were extracted with ``certify=True``; ``mode`` is theirs.
    mode : str, int, float, Fraction or Decimal, optional

    Raises
    ------
    ValueError
        If the pieces do not own each cell of the whole mesh once, are not those of one mesh, or a certificate is
        asked for without their proofs.
    PiecesDiffer
        If they do not meet: they were extracted with other options, or more layers of cells around the owned ones
        are needed. The message says where. It is a ValueError.
    """
    certified = certified_numbers(certify, "" if certify is None else mode_texts(mode)[0])
    made = _core.merge_pieces([piece.arrays for piece in pieces], certified)
    return MergedSurface(**{name: made[name] for name in MergedSurface.__dataclass_fields__})


def restrict_piece(piece: PieceSurface, cells: npt.ArrayLike, vertices: npt.ArrayLike) -> PieceSurface:
    """The surface in some of the cells that a piece owns, as that of a mesh that has no others.

    `merge_pieces` of the result alone gives the surface of that mesh: its triangles are those of the piece,
    bit for bit. Normals remain those of the piece.

    Parameters
    ----------
    piece : PieceSurface
    cells : array_like of int of shape (m, 2)
        Of each cell of the part its id in the whole mesh, and its id in the part.
    vertices : array_like of int of shape (n, 2)
        The same of vertices, at least those of the cells.

    Raises
    ------
    ValueError
        If ids repeat, the piece does not own a cell, or a vertex has no number.
    """
    pairs = [np.ascontiguousarray(ids, dtype=np.int64) for ids in (cells, vertices)]
    return PieceSurface(_core.restrict_piece(piece.arrays, pairs[0], pairs[1]))


class FieldHash:
    """The hash of a field's numbers, piece by piece: what `Field.sha256` gives for the whole.

    First all points in the order of their ids are added, then their tensors, then all cells. What is in memory
    is what is added at a time.

    Parameters
    ----------
    points, cells : int
        How many the whole mesh has.
    """

    def __init__(self, points: int, cells: int) -> None:
        self._hash = hashlib.sha256(struct.pack("<Q", points))
        self._cells = cells

    def add_points(self, points: npt.ArrayLike) -> None:
        """``points``: coordinates, shape (n, 3)."""
        self._hash.update(np.ascontiguousarray(points, dtype="<f8").tobytes())

    def add_tensors(self, tensors: npt.ArrayLike) -> None:
        """``tensors``: xx, yy, zz, xy, yz, xz, shape (n, 6), after all points."""
        self._hash.update(np.ascontiguousarray(tensors, dtype="<f8").tobytes())

    def begin_cells(self) -> None:
        """After all tensors."""
        self._hash.update(struct.pack("<Q", self._cells))

    def add_cells(self, tets: npt.ArrayLike) -> None:
        """``tets``: ids of the vertices of cells, shape (m, 4), in the order of the cells' ids."""
        ids = np.sort(np.asarray(tets, dtype="<i8"), axis=1)
        self._hash.update(np.ascontiguousarray(ids).tobytes())

    def sha256(self) -> str:
        """After all cells."""
        return self._hash.hexdigest()
