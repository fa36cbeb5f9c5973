# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Ranks of MPI number degenerate curves, and write them in parts: each those of its pieces."""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

from . import _core
from ._curve_pieces import MergedCurves, PieceCurves
from ._partition import CertifiedField, certified_numbers
from ._parts import PartArrays
from ._ranks import Array, PieceFile
from ._ranks_parts import (
    OutputKind,
    RankPieces,
    WrittenPart,
    certified_part,
    file_numbers,
    join_on_first,
    write_output_parts,
    write_part_files,
)
from ._seams import JoinedCurveSeams, curve_seam_of, join_curve_seams
from ._vtk_xml import piece_text

_ARRAYS = PartArrays(
    (
        ("mode", "Float64", 1),
        ("dominant_eigenvector", "Float64", 3),
        ("residual", "Float64", 1),
        ("separation", "Float64", 1),
    ),
    (("tet", "Int64", 1), ("component", "Int32", 1), ("whole_component", "Int32", 1)),
    {"Scalars": "mode"},
)


@dataclass(frozen=True)
class WholeCurves:
    """What a rank knows of the whole curves.

    Attributes
    ----------
    component : ndarray of int32
        Of each line of the rank its component in the whole.
    counts : dict of str to int
        What a certificate of parts claims of the whole; on the first rank, else empty.
    """

    component: Array
    counts: dict[str, int]


def _counts_of(joined: JoinedCurveSeams) -> dict[str, int]:
    return {
        "vertices": int(joined.vertices.sum()),
        "lines": int(joined.lines.sum()),
        "components": len(joined.lines),
        "closed_components": int((joined.ends == 0).sum()),
    }


def curve_kind(mode: Any) -> Optional[str]:
    """The kind of degenerate curves that a mode stands for, 1 linear and -1 planar; None for surfaces."""
    try:
        exact = Fraction(mode.strip() if isinstance(mode, str) else mode)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        return None
    return {1: "linear", -1: "planar"}.get(int(exact)) if exact.denominator == 1 else None


def number_curves(comm: Any, own: Optional[PieceCurves]) -> tuple[Optional[WholeCurves], Optional[str]]:
    """The components of the whole curves, for which ranks exchange no more than seams; or why they do not agree.

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
    joined, numbers, differ = join_on_first(comm, own, curve_seam_of, join_curve_seams)
    if differ is not None:
        return None, differ
    component = np.empty(0, np.int32) if own is None else numbers[own.component]
    return WholeCurves(component, {} if joined is None else _counts_of(joined)), None


def curve_part(
    piece: PieceCurves, cells: Array, vertices: Array, component: Array, certified: Optional[CertifiedField]
) -> tuple[MergedCurves, Array]:
    """What a piece has of the curves in some of its cells, in the numbers of the part's file; of each line its
    component in the whole.

    Parameters
    ----------
    piece : PieceCurves
    cells, vertices : ndarray of int64 of shape (n, 2)
        Ids in the whole mesh, and numbers in the part's file.
    component : ndarray of int32
        Of each line of the piece its component in the whole.
    certified : CertifiedField or None
        What the certificate says of the part's file; None makes none.
    """
    made = _core.curve_part(piece.arrays, cells, vertices, component, certified_numbers(certified, ""))
    return MergedCurves(**{name: made[name] for name in MergedCurves.__dataclass_fields__}), made["whole_component"]


def curve_part_bytes(curves: MergedCurves, whole_component: Array) -> bytes:
    """The part's .vtp."""
    text = piece_text(
        "PolyData",
        {"NumberOfPoints": len(curves.points), "NumberOfVerts": 0, "NumberOfLines": len(curves)},
        {
            "PointData": {
                "mode": curves.mode,
                "dominant_eigenvector": curves.dominant_eigenvectors,
                "residual": curves.residual,
                "separation": curves.separation,
            },
            "CellData": {
                "tet": curves.cell_ids,
                "component": curves.component,
                "whole_component": whole_component,
            },
            "Points": {"Points": curves.points},
            "Lines": {
                "connectivity": curves.connectivity.astype(np.int64),
                "offsets": curves.offsets[1:],
            },
        },
        marks=_ARRAYS.marks,
    )
    return text.encode("utf-8")


def write_curve_parts(
    comm: Any,
    output: Path,
    certificate: Optional[Path],
    pieces: RankPieces,
    whole: WholeCurves,
    mode: str,
    sources: Sequence[str],
) -> None:
    """Writes degenerate curves in parts, all files or none. All ranks call it.

    Parameters
    ----------
    comm, output, certificate, pieces, sources
        As for `write_parts`.
    whole : WholeCurves
    mode : {"1", "-1"}

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """

    def write(filled: Path, number: int) -> WrittenPart:
        file: PieceFile = pieces.files[number]
        curves = pieces.surface
        assert isinstance(curves, PieceCurves)  # a rank without cells has no files with cells
        certified = certified_part(pieces, file) if certificate is not None else None
        part, components = curve_part(curves, *file_numbers(pieces, file), whole.component, certified)
        return write_part_files(filled, output.stem, file, curve_part_bytes(part, components), part.certificate)

    write_output_parts(
        comm, output, certificate, pieces, OutputKind("polylines", _ARRAYS), write, mode, whole.counts, sources
    )
