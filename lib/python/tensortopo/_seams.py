# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What processes send each other to number the components of a surface or of curves that stay in pieces."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable

import numpy as np
import numpy.typing as npt

from . import _core
from ._curve_pieces import PieceCurves
from ._partition import PieceSurface


@dataclass(frozen=True)
class SurfaceSeam:
    """What other pieces must know of a piece's surface; `join_seams` puts seams together.

    It grows with the seam and the number of components, not with the surface.

    Attributes
    ----------
    numbers : ndarray of int64
        All of it, to be sent.
    """

    numbers: npt.NDArray[np.int64]


@dataclass(frozen=True)
class JoinedSeams:
    """The components of a whole surface, in the order of their first triangles.

    Attributes
    ----------
    vertices, triangles, euler_characteristic, boundary_loops : ndarray of int64 of shape (n,)
        Of each component.
    numbers : list of ndarray of int32
        Of each seam given: ``numbers[i][component]`` are the numbers in the whole of components of the piece, as
        `piece_components` names them.
    """

    vertices: npt.NDArray[np.int64]
    triangles: npt.NDArray[np.int64]
    euler_characteristic: npt.NDArray[np.int64]
    boundary_loops: npt.NDArray[np.int64]
    numbers: list[npt.NDArray[np.int32]]

    def __repr__(self) -> str:
        return f"JoinedSeams({len(self.triangles)} components, {self.triangles.sum()} triangles)"


def piece_components(piece: PieceSurface) -> npt.NDArray[np.int32]:
    """The connected component of each triangle of a piece, counted within the piece.

    Parameters
    ----------
    piece : PieceSurface

    Returns
    -------
    ndarray of int32 of shape (m,)
    """
    return _core.components_of_piece(piece.arrays)


def seam_of(piece: PieceSurface) -> SurfaceSeam:
    """The seam of a piece.

    Parameters
    ----------
    piece : PieceSurface
    """
    return SurfaceSeam(_core.seam_of(piece.arrays))


def join_seams(seams: Iterable[SurfaceSeam]) -> JoinedSeams:
    """The components of the whole surface, from the seams of all of its pieces in any order.

    They are those that `merge_pieces` gives, in the same order, and the same is proved of the pieces; vertices that
    pieces share are compared by a hash of their numbers.

    Parameters
    ----------
    seams : iterable of SurfaceSeam

    Raises
    ------
    ValueError
        If the pieces do not own each cell of the whole mesh once, or numbers are not those of a seam.
    PiecesDiffer
        If pieces do not meet: they were extracted with other options, or more layers of cells around the owned ones
        are needed. The message says where. It is a ValueError.
    """
    return JoinedSeams(**_core.join_seams([seam.numbers for seam in seams]))


@dataclass(frozen=True)
class CurveSeam:
    """What other pieces must know of a piece's curves; `join_curve_seams` puts seams together.

    It grows with the vertices where lines of other pieces may end and with the number of components.

    Attributes
    ----------
    numbers : ndarray of int64
        All of it, to be sent.
    """

    numbers: npt.NDArray[np.int64]


@dataclass(frozen=True)
class JoinedCurveSeams:
    """The components of whole curves, in the order of their first lines.

    Attributes
    ----------
    vertices, lines : ndarray of int64 of shape (n,)
        Of each component.
    ends : ndarray of int64 of shape (n,)
        Of each component: at how many vertices one line ends; 0 if it is closed.
    junctions : ndarray of int64 of shape (n,)
        Of each component: at how many vertices more than two lines end.
    numbers : list of ndarray of int32
        Of each seam given: ``numbers[i][component]`` are the numbers in the whole of components of the piece, as
        `PieceCurves.component` names them.
    """

    vertices: npt.NDArray[np.int64]
    lines: npt.NDArray[np.int64]
    ends: npt.NDArray[np.int64]
    junctions: npt.NDArray[np.int64]
    numbers: list[npt.NDArray[np.int32]]

    @property
    def closed_components(self) -> int:
        """How many components have no ends."""
        return int((self.ends == 0).sum())

    def __repr__(self) -> str:
        return f"JoinedCurveSeams({len(self.lines)} components, {self.lines.sum()} lines)"


def curve_seam_of(piece: PieceCurves) -> CurveSeam:
    """The seam of a piece.

    Parameters
    ----------
    piece : PieceCurves
    """
    return CurveSeam(_core.curve_seam_of(piece.arrays))


def join_curve_seams(seams: Iterable[CurveSeam]) -> JoinedCurveSeams:
    """The components of the whole curves, from the seams of all of their pieces in any order.

    They are those that `merge_curve_pieces` gives, in the same order, and the same is proved of the pieces; vertices
    that pieces share are compared by a hash of their numbers.

    Parameters
    ----------
    seams : iterable of CurveSeam

    Raises
    ------
    ValueError
        If the pieces do not own each cell of the whole mesh once, are not of one kind, or numbers are not those of a
        seam.
    PiecesDiffer
        As `merge_curve_pieces`.
    """
    return JoinedCurveSeams(**_core.join_curve_seams([seam.numbers for seam in seams]))
