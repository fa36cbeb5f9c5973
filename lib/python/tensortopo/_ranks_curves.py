# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Ranks of MPI number degenerate curves, and write them in parts: each those of its pieces."""
from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any, Optional

import numpy as np

from ._curve_pieces import PieceCurves
from ._parts import PartArrays, pvtp_bytes
from ._ranks import Array
from ._ranks_parts import RankPieces, join_on_first, put_parts
from ._seams import curve_seam_of, join_curve_seams
from ._vtk_xml import piece_text

_ARRAYS = PartArrays(
    (
        ("mode", "Float64", 1),
        ("dominant_eigenvector", "Float64", 3),
        ("residual", "Float64", 1),
        ("separation", "Float64", 1),
    ),
    (("tet", "Int64", 1), ("whole_component", "Int32", 1)),
    {"Scalars": "mode"},
)


def curve_kind(mode: Any) -> Optional[str]:
    """The kind of degenerate curves that a mode stands for, 1 linear and -1 planar; None for surfaces."""
    try:
        exact = Fraction(mode.strip() if isinstance(mode, str) else mode)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        return None
    return {1: "linear", -1: "planar"}.get(int(exact)) if exact.denominator == 1 else None


def number_curves(comm: Any, own: Optional[PieceCurves]) -> tuple[Optional[Array], Optional[str]]:
    """Of each line of this rank its component in the whole, for which ranks exchange no more than seams; or why they
    do not agree.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    own : PieceCurves or None
        The curves of this rank, if it has cells.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    _, numbers, differ = join_on_first(comm, own, curve_seam_of, join_curve_seams)
    if differ is not None:
        return None, differ
    return np.empty(0, np.int32) if own is None else numbers[own.component], None


def _lines_in_order(curves: PieceCurves, first: int, last: int) -> list[int]:
    """The lines in cells of some ids, in an order that does not depend on the piece: by the ids of their cells."""
    arrays = curves.arrays
    cell_ids = curves.cell_ids
    which = np.flatnonzero((cell_ids >= first) & (cell_ids <= last))

    def key(line: int) -> tuple[Any, ...]:
        cell = arrays["line_cells"][line]
        simplex = sorted(arrays["vertex_ids"][cell[cell >= 0]].tolist())
        return int(cell_ids[line]), -len(simplex), simplex, int(arrays["line_ordinals"][line])

    return sorted(which.tolist(), key=key)


def _part_bytes(curves: PieceCurves, component: Array, lines: list[int], tets: Array) -> bytes:
    """The .vtp of some lines, each in the direction in which its cell has it; points as lines have them first."""
    arrays = curves.arrays
    of_piece = curves.lines
    turned = [of_piece[i][::-1] if arrays["line_reversed"][i] else of_piece[i] for i in lines]
    number: dict[int, int] = {}
    for line in turned:
        for vertex in line.tolist():
            number.setdefault(vertex, len(number))
    vertices = np.fromiter(number, np.int64, len(number))
    connectivity = [number[vertex] for line in turned for vertex in line.tolist()]
    text = piece_text(
        "PolyData",
        {"NumberOfPoints": len(vertices), "NumberOfVerts": 0, "NumberOfLines": len(lines)},
        {
            "PointData": {
                "mode": arrays["mode"][vertices],
                "dominant_eigenvector": arrays["dominant_eigenvectors"][vertices],
                "residual": arrays["residual"][vertices],
                "separation": arrays["separation"][vertices],
            },
            "CellData": {"tet": tets, "whole_component": component[lines]},
            "Points": {"Points": arrays["points"][vertices]},
            "Lines": {
                "connectivity": np.array(connectivity, np.int64),
                "offsets": np.cumsum([len(line) for line in turned], dtype=np.int64),
            },
        },
        marks=_ARRAYS.marks,
    )
    return text.encode("utf-8")


def write_curve_parts(comm: Any, output: Path, pieces: RankPieces, component: Array) -> None:
    """Writes degenerate curves in parts, all files or none. All ranks call it.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    output : Path
        The .pvtp. The parts go into a folder of its name without the ending.
    pieces : RankPieces
    component : ndarray of int32
        Of each line of this rank its component in the whole.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    folder = output.with_suffix("")

    def write(filled: Path, number: int) -> str:
        file = pieces.files[number]
        curves = pieces.surface
        assert isinstance(curves, PieceCurves)  # a rank without cells has no files with cells
        first, last = (int(pieces.cell_ids[i]) for i in (file.tets[0], file.tets[1] - 1))
        lines = _lines_in_order(curves, first, last)
        tets = file.cells[curves.cell_ids[lines] - first]
        name = f"{folder.name}_{file.number}.vtp"
        (filled / name).write_bytes(_part_bytes(curves, component, lines, tets))
        return name

    def finish(parts: list[str]) -> dict[Path, bytes]:
        return {output: pvtp_bytes([f"{folder.name}/{part}" for part in parts], _ARRAYS)}

    put_parts(comm, output, pieces, lambda: None, write, finish)
