# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Mode surfaces and degenerate curves of fields in pieces, on the ranks of MPI.

::

    mpirun -n 4 python3 -m tensortopo.mpi field.pvtu -o surface.vtp --mode 1/2 --certify surface.json

Each rank reads its share of the pieces, gets from the others the cells around it, and extracts; the first rank
puts the surfaces together and writes. With ``--mode 1`` or ``--mode=-1`` these are the degenerate curves. With
``-o surface.pvtp`` each rank writes the parts of its own pieces, and no more than seams are sent to the first rank.
The files have the same bytes on any number of ranks. Needs mpi4py.
"""
from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Optional, Sequence, Union

import numpy as np

from ._curve_pieces import MergedCurves, PieceCurves, extract_curve_piece, merge_curve_pieces
from ._field import Field
from ._files import output_bytes
from ._modes import mode_texts
from ._partition import (
    CertifiedField,
    FieldHash,
    MergedSurface,
    PieceSurface,
    PiecesDiffer,
    extract_piece,
    merge_pieces,
)
from ._parts import require_below
from ._ranks import (
    Array,
    Cells,
    Part,
    RankError,
    is_pvtu,
    number_points,
    piece_sources,
    read_part,
    together,
    with_ghosts,
)
from ._ranks_curves import WholeCurves, curve_kind, number_curves, write_curve_parts
from ._ranks_parts import RankPieces, WholeNumbers, number_components, write_parts
from ._vtk_xml import write_whole

_MOST_LAYERS = 8


@dataclass(frozen=True)
class Extracted:
    """A surface or curves on the ranks.

    Attributes
    ----------
    pieces : RankPieces
        What this rank has.
    merged : MergedSurface, MergedCurves or None
        The whole, on the first rank, unless it stays in parts.
    whole : WholeNumbers, WholeCurves or None
        Of a surface, or of curves, that stay in parts.
    """

    pieces: RankPieces
    merged: Union[MergedSurface, MergedCurves, None]
    whole: Union[WholeNumbers, WholeCurves, None] = None


def _field_hash(comm: Any, owned: Cells, first: Cells, starts: Array, cells: int) -> Optional[str]:
    """On the first rank: the hash of the whole field, from what the ranks send one after the other."""

    def in_turn(value: Array) -> Any:
        if comm.rank != 0:
            comm.send(value, 0)
            return
        yield value
        for rank in range(1, comm.size):
            yield comm.recv(source=rank)

    total = FieldHash(int(starts[-1]), cells)
    for points in in_turn(first.points):
        total.add_points(points)
    for tensors in in_turn(first.tensors):
        total.add_tensors(tensors)
    total.begin_cells()
    for tets in in_turn(owned.tets):
        total.add_cells(tets)
    return total.sha256() if comm.rank == 0 else None


def mode_surface(
    comm: Any,
    part: Part,
    mode: Any,
    *,
    certify: bool = False,
    resolution: float = 4,
    all_samples: bool = False,
    cells: Optional[int] = None,
) -> Optional[MergedSurface]:
    """The mode surface of a mesh whose pieces lie on the ranks. All ranks call it.

    It is what `Field.mode_surface` gives for the whole mesh, bit for bit, and so is the certificate. Points are
    numbered as if the pieces were read one after the other: those of different pieces in one place become one.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    part : Part
        The pieces of this rank, which follow those of the rank before.
    mode, resolution, all_samples, certify
        As for `extract_piece`.
    cells : int, optional
        How many cells the whole mesh has, if that is known: then a piece that is missing is noticed.

    Returns
    -------
    MergedSurface or None
        None but on the first rank.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    made = extracted(comm, part, mode, certify=certify, resolution=resolution, all_samples=all_samples, cells=cells)
    return made.merged if isinstance(made.merged, MergedSurface) else None


def degenerate_curves(
    comm: Any,
    part: Part,
    kind: str,
    *,
    certify: bool = False,
    resolution: float = 4,
    cells: Optional[int] = None,
) -> Optional[MergedCurves]:
    """The degenerate curves of a mesh whose pieces lie on the ranks. All ranks call it.

    They are what `Field.degenerate_curves` gives for the whole mesh, bit for bit, and so is the certificate.

    Parameters
    ----------
    comm, part, certify, resolution, cells
        As for `mode_surface`.
    kind : {"linear", "planar"}

    Returns
    -------
    MergedCurves or None
        None but on the first rank.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    mode = {"linear": 1, "planar": -1}[kind]
    made = extracted(comm, part, mode, certify=certify, resolution=resolution, cells=cells)
    return made.merged if isinstance(made.merged, MergedCurves) else None


def extracted(
    comm: Any,
    part: Part,
    mode: Any,
    *,
    certify: bool = False,
    resolution: float = 4,
    all_samples: bool = False,
    cells: Optional[int] = None,
    in_parts: bool = False,
) -> Extracted:
    """What `mode_surface` or, of modes 1 and -1, `degenerate_curves` gives, and the piece of each rank.

    Parameters
    ----------
    comm, part, mode, certify, resolution, all_samples, cells
        As for `mode_surface`.
    in_parts : bool, default False
        What is extracted stays in parts: ranks exchange seams, and components are numbered. With ``certify``, proofs
        of surfaces are kept for certificates of parts; curves need none.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    numbered = number_points(comm, part.points, part.tensors, part.piece)
    counts = comm.allgather(len(part.tets))
    whole = sum(counts)
    if cells is not None and cells != whole:
        raise RankError(f"the pieces have {whole} of the {cells} cells of the whole mesh: a piece is missing")
    if whole == 0:
        raise RankError("the pieces have no cells")
    vertex_ids, at = np.unique(numbered.ids, return_index=True)
    own_ids = sum(counts[: comm.rank]) + np.arange(counts[comm.rank])
    owned = Cells(own_ids, numbered.ids[part.tets], vertex_ids, part.points[at], part.tensors[at])
    names = {name for name in comm.allgather(part.tensor_name) if name}
    if len(names) > 1:
        raise RankError(f"the pieces' tensors have several names: {', '.join(sorted(names))}")
    certified = None
    if certify and not in_parts:
        is_first = numbered.is_first
        first = Cells(own_ids, owned.tets, owned.vertex_ids, part.points[is_first], part.tensors[is_first])
        sha256 = _field_hash(comm, owned, first, numbered.starts, whole)
        if sha256 is not None:
            certified = CertifiedField(int(numbered.starts[-1]), sha256, names.pop())

    kind = curve_kind(mode)
    for layers in range(1, _MOST_LAYERS + 1):
        held = with_ghosts(comm, owned, numbered, layers)

        def extract(held: Cells = held) -> Union[PieceSurface, PieceCurves, None]:
            is_owned = np.isin(held.ids, own_ids, assume_unique=True)
            if not is_owned.any():
                return None
            local = np.searchsorted(held.vertex_ids, held.tets)
            field = Field(held.points, held.tensors, local, vertex_ids=held.vertex_ids, cell_ids=held.ids)
            if kind is not None:
                return extract_curve_piece(field, kind, is_owned, held.vertex_ids, whole, resolution=resolution)
            return extract_piece(field, mode, is_owned, held.vertex_ids, whole, resolution=resolution,
                                 all_samples=all_samples, certify=certify)  # fmt: skip

        own = together(comm, extract)
        merged = None
        numbers: Union[WholeNumbers, WholeCurves, None] = None
        if in_parts:
            if kind is not None:
                numbers, differ = number_curves(comm, own if isinstance(own, PieceCurves) else None)
            else:
                numbers, differ = number_components(comm, own if isinstance(own, PieceSurface) else None)
        else:
            gathered = comm.gather(own)
            merged, differ = together(comm, partial(_merged, gathered, certified, mode))
            differ = comm.bcast(differ)
        if differ is None:
            pieces = RankPieces(
                part.files, part.points, part.tensors, part.tets, numbered.ids, own_ids, own
            )
            return Extracted(pieces, merged, numbers)
    raise RankError(f"{differ} (with {_MOST_LAYERS} layers)")


def _merged(
    gathered: Optional[list[Any]], certified: Optional[CertifiedField], mode: Any
) -> tuple[Union[MergedSurface, MergedCurves, None], Optional[str]]:
    """The whole where the pieces were gathered, or why they need more layers."""
    if gathered is None:
        return None, None
    pieces = [piece for piece in gathered if piece is not None]
    try:
        if curve_kind(mode) is not None:
            return merge_curve_pieces(pieces, certify=certified), None
        return merge_pieces(pieces, certify=certified, mode=mode), None
    except PiecesDiffer as error:
        return None, str(error)


def _options(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tensortopo.mpi", description="Mode surface or degenerate curves of a field in pieces, on ranks of MPI"
    )
    parser.add_argument("input", nargs="+", type=Path, help="a .pvtu, or its pieces (.vtu) in order")
    parser.add_argument("-o", "--output", required=True, type=Path, help="surface or curves: .vtp, or .pvtp with a .vtp for each piece")
    parser.add_argument("--mode", required=True, help="0.5 or 1/2; 1 and -1: the degenerate curves")
    parser.add_argument("--certify", type=Path, metavar="CERT", help="also write a certificate (.json)")
    parser.add_argument("--tensor", help="the array of the points, if there are several")
    parser.add_argument("--components", help="the order of six components, if the files do not name it")
    parser.add_argument("--resolution", type=float, default=4, help="samples per radian of turning")
    parser.add_argument("--all-samples", action="store_true", help="keep all samples of face curves")
    parser.add_argument("--cells", type=int, help="how many cells the whole mesh has: notices missing pieces")
    return parser.parse_args(arguments)


def _in_parts(options: argparse.Namespace) -> bool:
    return str(options.output.suffix).lower() == ".pvtp"


def _require_names(options: argparse.Namespace) -> None:
    if options.output.suffix.lower() not in (".vtp", ".pvtp"):
        raise ValueError(f"{options.output}: the name of the surface must end in .vtp or .pvtp")
    if _in_parts(options) and options.certify is not None and not is_pvtu(options.input):
        raise ValueError(f"{options.certify}: a certificate of parts is about a .pvtu; give one as input")
    if options.certify is not None and options.certify.suffix.lower() != ".json":
        raise ValueError(f"{options.certify}: the name of the certificate must end in .json")
    if curve_kind(options.mode) is not None:
        if options.all_samples:
            raise ValueError("--all-samples: is about surfaces; curves have all samples")
    elif len(mode_texts(options.mode)) != 1:
        raise ValueError("mode: one is extracted at a time")


def _sources(options: argparse.Namespace) -> list[str]:
    sources = piece_sources(options.input)
    if _in_parts(options) and options.certify is not None:
        for source in sources:
            require_below(options.input[0], source)
    return sources


def run(comm: Any, options: argparse.Namespace) -> None:
    """All of it; files appear together or not at all."""
    together(comm, lambda: _require_names(options))
    sources = together(comm, lambda: _sources(options))
    folder = options.input[0].parent if is_pvtu(options.input) else Path()
    files = [folder / source for source in sources]
    part = together(
        comm, lambda: read_part(files, comm.rank, comm.size, options.tensor, options.components)
    )
    made = extracted(
        comm,
        part,
        options.mode,
        certify=options.certify is not None,
        resolution=options.resolution,
        all_samples=options.all_samples,
        cells=options.cells,
        in_parts=_in_parts(options),
    )
    surface = made.merged
    own = made.pieces.surface
    unresolved = comm.gather([] if own is None else own.unresolved)
    if isinstance(made.whole, WholeCurves):
        text = {"linear": "1", "planar": "-1"}[curve_kind(options.mode) or ""]
        write_curve_parts(comm, options.output, options.certify, made.pieces, made.whole, text, sources)
    elif made.whole is not None:
        write_parts(comm, options.output, options.certify, made.pieces, made.whole, options.mode, sources)
    elif surface is not None:
        outputs = {options.output: output_bytes(surface)}
        if options.certify is not None:
            outputs[options.certify] = getattr(surface, "certificate", None) or b""
        together(comm, partial(write_whole, outputs))
    else:
        together(comm, lambda: None)
    left_out = sorted(cell for rank in unresolved or [] for cell in rank)
    if left_out:
        cell, reason = left_out[0]
        print(
            f"tensortopo.mpi: {len(left_out)} cells are left out, the first is cell {cell}: {reason}",
            file=sys.stderr,
        )


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """The command; its exit status."""
    options = _options(arguments)
    try:
        from mpi4py import MPI
    except ImportError:
        print("tensortopo.mpi: needs mpi4py (Debian: python3-mpi4py)", file=sys.stderr)
        return 3
    comm = MPI.COMM_WORLD
    try:
        run(comm, options)
    except RankError as error:
        if comm.rank == 0:
            print(f"tensortopo.mpi: {error}", file=sys.stderr)
        return 3
    except BaseException as error:
        # The other ranks wait for this one.
        print(f"tensortopo.mpi: rank {comm.rank}: {error!r}", file=sys.stderr, flush=True)
        comm.Abort(4)
        raise
    return 0


if __name__ == "__main__":
    sys.exit(main())
