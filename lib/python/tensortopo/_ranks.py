# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What the ranks of MPI read of a mesh that lies in pieces, and exchange about it: numbers of points, and ghosts."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, NoReturn, Optional, Sequence, TypeVar
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from ._errors import FileError
from ._files import grid_of
from ._vtk_xml import read_piece

Array = npt.NDArray[Any]
Result = TypeVar("Result")


class RankError(ValueError):
    """Something went wrong on a rank; raised on all."""


def together(comm: Any, work: Callable[[], Result]) -> Result:
    """What ``work()`` gives, if it succeeds on all ranks; else the error of the first that fails, on all."""
    result: Optional[Result] = None
    problem: Optional[str] = None
    try:
        result = work()
    except (ValueError, OSError, MemoryError) as error:
        problem = str(error) or type(error).__name__
    for text in comm.allgather(problem):
        if text is not None:
            raise RankError(text)
    return result  # type: ignore[return-value]


@dataclass(frozen=True)
class PieceFile:
    """A file of a rank's pieces.

    Attributes
    ----------
    path : Path
    number : int
        Among all pieces.
    points, tets : tuple of int
        Where its points and tetrahedra begin and end among those of the rank.
    cells : ndarray of int64
        Of each of its tetrahedra, which of the file's cells it is.
    tensor_name, order : str
        Name of the tensors' array, and order of its components.
    """

    path: Path
    number: int
    points: tuple[int, int]
    tets: tuple[int, int]
    cells: Array
    tensor_name: str
    order: str


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


def _send(comm: Any, to: Array, *columns: Array) -> tuple[Array, list[list[Array]]]:
    """Rows to the ranks that ``to`` names; the order they went in, and by source what arrived."""
    order = np.argsort(to, kind="stable")
    bounds = np.searchsorted(to[order], np.arange(comm.size + 1))
    rows = [order[bounds[r] : bounds[r + 1]] for r in range(comm.size)]
    return order, comm.alltoall([[column[r] for column in columns] for r in rows])


def _home_of(points: Array, ranks: int) -> Array:
    """A rank for each place, the same wherever the place is known."""
    bits = np.ascontiguousarray(points + 0.0).view(np.uint64)  # both zeros are one
    mixed = np.zeros(len(points), np.uint64)
    for k in range(3):
        mixed = (mixed ^ bits[:, k]) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(29)
    return ((mixed >> np.uint64(11)) % np.uint64(ranks)).astype(np.int64)


def _place(point: Array) -> str:
    return "(" + " ".join(repr(float(x)) for x in point) + ")"


def _firsts(points: Array, tensors: Array, piece: Array, source: Array, index: Array) -> Array:
    """Of points in one order of pieces: of each the row of the first that it becomes one with.

    Points of different pieces that agree in place and tensor become one, as where a file of pieces is read.
    """

    def refuse(row: int, problem: str) -> NoReturn:
        raise ValueError(f"{problem} at {_place(points[row])}")

    order = np.lexsort((index, source, points[:, 2], points[:, 1], points[:, 0]))
    first = np.arange(len(points))
    if len(points) == 0:
        return first
    sorted_points = points[order]
    begins = np.flatnonzero(
        np.append(True, (sorted_points[1:] != sorted_points[:-1]).any(axis=1))
    )
    ends = np.append(begins[1:], len(points))
    for begin, end in zip(begins[ends - begins > 1], ends[ends - begins > 1]):
        rows = order[begin:end]
        pieces = piece[rows]
        if pieces.min() == pieces.max():
            continue  # of one piece: these stay apart
        if len(np.unique(pieces)) < len(pieces):
            refuse(rows[0], "two points of a piece coincide where pieces meet,")
        if (tensors[rows] != tensors[rows[0]]).any():
            refuse(rows[0], "pieces give different tensors at the same point,")
        first[rows] = rows[0]
    return first


@dataclass
class Numbered:
    """The points of a rank's pieces.

    Attributes
    ----------
    ids : ndarray of int64
        In the whole mesh: in the order of pieces and their points, each counted where it comes first.
    is_first : ndarray of bool
        Whether it is counted here.
    starts : ndarray of int64
        The first id that each rank counts, and the number of all.
    """

    ids: Array
    is_first: Array
    starts: Array

    def home(self, ids: Array) -> Array:
        """The rank that counts each vertex."""
        return np.searchsorted(self.starts, ids, side="right") - 1


def number_points(comm: Any, points: Array, tensors: Array, piece: Array) -> Numbered:
    """Numbers for the points of all ranks, whose pieces are in the order of the ranks.

    Raises
    ------
    RankError
        If pieces give different tensors at one point, or two points of one piece coincide where others meet it.
    """
    index = np.arange(len(points))
    order, arrived = _send(comm, _home_of(points, comm.size), points, tensors, piece, index)
    source = np.repeat(np.arange(comm.size), [len(rows[0]) for rows in arrived])
    columns = [np.concatenate([rows[k] for rows in arrived]) for k in range(4)]
    first = together(comm, lambda: _firsts(columns[0], columns[1], columns[2], source, columns[3]))
    bounds = np.searchsorted(source, np.arange(comm.size + 1))
    answers = comm.alltoall(
        [
            (source[first[a:b]], columns[3][first[a:b]])
            for a, b in zip(bounds[:-1], bounds[1:])
        ]
    )
    rank, place = np.empty_like(index), np.empty_like(index)
    rank[order] = np.concatenate([answer[0] for answer in answers])
    place[order] = np.concatenate([answer[1] for answer in answers])

    is_first = (rank == comm.rank) & (place == index)
    counts = comm.allgather(int(is_first.sum()))
    starts = np.concatenate([[0], np.cumsum(counts)])
    ids = np.full(len(points), -1)
    ids[is_first] = starts[comm.rank] + np.arange(counts[comm.rank])
    others = np.flatnonzero(~is_first)
    order, asked = _send(comm, rank[others], place[others])
    told = comm.alltoall([ids[rows[0]] for rows in asked])
    ids[others[order]] = np.concatenate(told)
    return Numbered(ids, is_first, starts)


@dataclass
class Cells:
    """Tetrahedra, with their vertices.

    Attributes
    ----------
    ids : ndarray of int64, shape (m,)
    tets : ndarray of int64, shape (m, 4)
        Ids of vertices.
    vertex_ids : ndarray of int64, shape (n,)
        Ascending, at least those of ``tets``.
    points, tensors : ndarray, shapes (n, 3), (n, 6)
    """

    ids: Array
    tets: Array
    vertex_ids: Array
    points: Array
    tensors: Array

    def rows(self, which: Array) -> Cells:
        """Some of them, with no other vertices."""
        tets = self.tets[which]
        used = np.unique(tets)
        at = np.searchsorted(self.vertex_ids, used)
        return Cells(self.ids[which], tets, used, self.points[at], self.tensors[at])

    @staticmethod
    def joined(parts: list[Cells]) -> Cells:
        """All of them, each once."""
        ids, first = np.unique(np.concatenate([p.ids for p in parts]), return_index=True)
        tets = np.concatenate([p.tets for p in parts])[first]
        vertex_ids, at = np.unique(np.concatenate([p.vertex_ids for p in parts]), return_index=True)
        points = np.concatenate([p.points for p in parts])[at]
        return Cells(ids, tets, vertex_ids, points, np.concatenate([p.tensors for p in parts])[at])


def _pairs(left: Array, right: Array) -> tuple[Array, Array]:
    """All pairs of rows of ``left`` and of ``right``, which is sorted, that are equal."""
    begin = np.searchsorted(right, left, side="left")
    count = np.searchsorted(right, left, side="right") - begin
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.repeat(np.arange(len(left)), count), np.repeat(begin, count) + within


def with_ghosts(comm: Any, owned: Cells, numbered: Numbered, layers: int) -> Cells:
    """The cells of a rank with layers of those around, each of the cells that share a vertex with those before."""
    mine = np.unique(owned.tets)
    _, incident = _send(comm, numbered.home(mine), mine)
    known_rank = np.repeat(np.arange(comm.size), [len(rows[0]) for rows in incident])
    known = np.concatenate([rows[0] for rows in incident])
    order = np.lexsort((known_rank, known))
    known, known_rank = known[order], known_rank[order]

    corner_order = np.argsort(owned.tets.ravel(), kind="stable")
    corners = owned.tets.ravel()[corner_order]
    held = owned
    for _ in range(layers):
        wanted = np.unique(held.tets)
        _, wishes = _send(comm, numbered.home(wanted), wanted)
        wish_rank = np.repeat(np.arange(comm.size), [len(rows[0]) for rows in wishes])
        wish = np.concatenate([rows[0] for rows in wishes])
        row, at = _pairs(wish, known)
        other = wish_rank[row] != known_rank[at]
        row, at = row[other], at[other]
        _, tasks = _send(comm, known_rank[at], wish[row], wish_rank[row])
        vertex = np.concatenate([rows[0] for rows in tasks])
        receiver = np.concatenate([rows[1] for rows in tasks])
        row, at = _pairs(vertex, corners)
        cell = corner_order[at] // 4
        sent = [owned.rows(np.unique(cell[receiver[row] == r])) for r in range(comm.size)]
        held = Cells.joined([held, *comm.alltoall(sent)])
    return held
