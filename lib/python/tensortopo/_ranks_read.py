# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What a rank of MPI reads of a field in pieces."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Sequence
from xml.etree import ElementTree

import numpy as np

from ._errors import FileError
from ._files import grid_of
from ._ranks import Array
from ._ranks_parts import PieceFile
from ._vtk_xml import read_piece


@dataclass
class Part:
    """The pieces of one rank.

    Attributes
    ----------
    points, tensors : ndarray, shapes (n, 3), (n, 6)
    piece : ndarray of int64, shape (n,)
        Which of all pieces has the point.
    tets : ndarray of int64, shape (m, 4)
    tensor_name : str
    files : list of PieceFile
        Where they were read; needed to write a surface in parts.
    """

    points: Array
    tensors: Array
    piece: Array
    tets: Array
    tensor_name: str = ""
    files: list[PieceFile] = dataclasses.field(default_factory=list)


def piece_sources(inputs: Sequence[Path]) -> list[str]:
    """The pieces as a .pvtu names them, or the files given.

    Raises
    ------
    FileError
    """
    if not is_pvtu(inputs):
        return [str(path) for path in inputs]
    (path,) = inputs
    try:
        root = ElementTree.parse(path).getroot()
    except OSError as error:
        raise FileError(f"{path}: {error.strerror or error}") from error
    except ElementTree.ParseError as error:
        raise FileError(f"{path}: is no XML ({error})") from error
    sources = [piece.get("Source") for piece in root.iterfind("PUnstructuredGrid/Piece")]
    if not sources or not all(sources):
        raise FileError(f"{path}: names no pieces")
    if len(set(sources)) < len(sources):
        raise FileError(f"{path}: names a piece twice")
    return [str(source) for source in sources]


def is_pvtu(inputs: Sequence[Path]) -> bool:
    """Whether one .pvtu is given."""
    return len(inputs) == 1 and inputs[0].suffix.lower() == ".pvtu"


def read_part(
    files: Sequence[Path], rank: int, ranks: int, tensor: Optional[str], components: Optional[str]
) -> Part:
    """A rank's share of the pieces: those that follow the share of the rank before."""
    begin, end = (len(files) * r // ranks for r in (rank, rank + 1))
    part = Part(np.empty((0, 3)), np.empty((0, 6)), np.empty(0, np.int64), np.empty((0, 4), np.int64))
    for number in range(begin, end):
        path = files[number]
        if path.suffix.lower() != ".vtu":
            raise FileError(f"{path}: the pieces must be .vtu files")
        grid = grid_of(path, read_piece(path), tensor, components, False)
        points = np.asarray(grid.points, np.float64)
        tets = np.asarray(grid.tets, np.int64)
        if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
            raise FileError(f"{path}: a coordinate is missing or not finite")
        if tets.size and not 0 <= tets.min() <= tets.max() < len(points):
            raise FileError(f"{path}: a cell has a vertex that is not there")
        file = PieceFile(
            path,
            number,
            (len(part.points), len(part.points) + len(points)),
            (len(part.tets), len(part.tets) + len(tets)),
            np.asarray(grid.cells, np.int64),
            grid.tensor_name,
            grid.order,
        )
        part = Part(
            np.concatenate([part.points, points]),
            np.concatenate([part.tensors, grid.tensors]),
            np.concatenate([part.piece, np.full(len(points), number)]),
            np.concatenate([part.tets, tets + len(part.points)]),
            grid.tensor_name,
            [*part.files, file],
        )
    return part
