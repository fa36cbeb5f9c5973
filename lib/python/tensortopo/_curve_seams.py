# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What processes send each other to number the components of curves that stay in pieces."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable

import numpy as np
import numpy.typing as npt

from . import _core
from ._curve_pieces import PieceCurves


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
