# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Ranks of MPI write a surface in parts: each those of its pieces."""
from __future__ import annotations

import os
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Optional, TypeVar, Union

import numpy as np

from ._curve_pieces import PieceCurves
from ._errors import FileError
from ._modes import mode_texts
from ._partition import CertifiedField, FieldHash, PieceSurface, PiecesDiffer
from ._parts import (
    SURFACE_ARRAYS,
    PartArrays,
    certificate_of_parts,
    new_folder,
    part_bytes,
    part_surface,
    put_in_place,
    pvtp_bytes,
    require_below,
    require_folder,
    sha256_of,
)
from ._ranks import Array, PieceFile, together
from ._seams import JoinedSeams, join_seams, piece_components, seam_of

Written = TypeVar("Written")
Piece = TypeVar("Piece")
Seam = TypeVar("Seam")
Joined = TypeVar("Joined")


@dataclass(frozen=True)
class RankPieces:
    """What a rank has of the mesh, and of the surface.

    Attributes
    ----------
    files : sequence of PieceFile
    points, tensors, tets : ndarray
        Of all of its files.
    vertex_ids, cell_ids : ndarray of int64
        In the whole mesh.
    surface : PieceSurface, PieceCurves or None
        What was extracted; None if the rank has no cells.
    """

    files: Sequence[PieceFile]
    points: Array
    tensors: Array
    tets: Array
    vertex_ids: Array
    cell_ids: Array
    surface: Union[PieceSurface, PieceCurves, None]


@dataclass(frozen=True)
class WholeNumbers:
    """What a rank knows of the whole surface.

    Attributes
    ----------
    component : ndarray of int32
        Of each triangle of the rank's surface, its component in the whole.
    counts : dict of str to int
        What a certificate of parts claims of the whole; on the first rank, else empty.
    """

    component: Array
    counts: dict[str, int]


def _counts_of(joined: JoinedSeams) -> dict[str, int]:
    return {
        "vertices": int(joined.vertices.sum()),
        "triangles": int(joined.triangles.sum()),
        "components": len(joined.triangles),
        "euler_characteristic": int(joined.euler_characteristic.sum()),
        "boundary_loops": int(joined.boundary_loops.sum()),
    }


def join_on_first(
    comm: Any, own: Optional[Piece], seam_of_piece: Callable[[Piece], Seam], join: Callable[[list[Seam]], Joined]
) -> tuple[Optional[Joined], Array, Optional[str]]:
    """What the seams of all ranks say of the whole, on the first rank; the numbers of this rank's components; or why
    the ranks do not agree. Ranks exchange no more than seams.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    own : PieceSurface, PieceCurves or None
        What this rank has; None if it has no cells.
    seam_of_piece : callable
        Its seam.
    join : callable
        Puts seams together: the result has ``numbers`` of each.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    gathered = comm.gather(together(comm, lambda: None if own is None else seam_of_piece(own)))

    def joined_seams() -> tuple[Any, Optional[str]]:
        if gathered is None:
            return None, None
        try:
            return join([seam for seam in gathered if seam is not None]), None
        except PiecesDiffer as error:
            return None, str(error)

    joined, differ = together(comm, joined_seams)
    differ = comm.bcast(differ)
    if differ is not None:
        return None, np.empty(0, np.int32), differ
    shares = None
    if joined is not None:
        left = iter(joined.numbers)
        shares = [None if seam is None else next(left) for seam in gathered]
    return joined, comm.scatter(shares), None


def number_components(comm: Any, own: Optional[PieceSurface]) -> tuple[Optional[WholeNumbers], Optional[str]]:
    """The components of the whole surface, for which ranks exchange no more than seams; or why they do not agree.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    own : PieceSurface or None
        The surface of this rank, if it has cells.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    joined, numbers, differ = join_on_first(comm, own, seam_of, join_seams)
    if differ is not None:
        return None, differ
    component = np.empty(0, np.int32) if own is None else numbers[piece_components(own)]
    return WholeNumbers(component, {} if joined is None else _counts_of(joined)), None


def certified_part(pieces: RankPieces, file: PieceFile) -> CertifiedField:
    """What the certificate of a part says of its piece."""
    points, tets = slice(*file.points), slice(*file.tets)
    numbers = FieldHash(file.points[1] - file.points[0], file.tets[1] - file.tets[0])
    numbers.add_points(pieces.points[points])
    numbers.add_tensors(pieces.tensors[points])
    numbers.begin_cells()
    numbers.add_cells(pieces.tets[tets] - file.points[0])
    order = {"mrtrix": "abaqus", "dipy": "nifti"}.get(file.order, file.order)
    return CertifiedField(file.points[1] - file.points[0], numbers.sha256(), file.tensor_name, order)


@dataclass(frozen=True)
class WrittenPart:
    """Name and SHA-256 of the files of a part."""

    output: tuple[str, str]
    certificate: Optional[tuple[str, str]]
    field: tuple[str, str]


@dataclass(frozen=True)
class OutputKind:
    """What is in parts: how a certificate of parts calls it, and its arrays."""

    role: str
    arrays: PartArrays


def file_numbers(pieces: RankPieces, file: PieceFile) -> tuple[Array, Array]:
    """Of the cells and of the points of a file: ids in the whole mesh, and numbers in the file."""
    points, tets = slice(*file.points), slice(*file.tets)
    cells = np.column_stack([pieces.cell_ids[tets], file.cells])
    vertices = np.column_stack([pieces.vertex_ids[points], np.arange(file.points[1] - file.points[0])])
    return cells, vertices


def write_part_files(
    folder: Path, name: str, file: PieceFile, data: bytes, certificate: Optional[bytes]
) -> WrittenPart:
    """Writes a part, and its certificate if there is one."""
    stem = f"{name}_{file.number}"
    (folder / f"{stem}.vtp").write_bytes(data)
    if certificate is None:
        return WrittenPart((f"{stem}.vtp", sha256_of(data)), None, (str(file.path), ""))
    (folder / f"{stem}.json").write_bytes(certificate)
    return WrittenPart(
        (f"{stem}.vtp", sha256_of(data)),
        (f"{stem}.json", sha256_of(certificate)),
        (str(file.path), sha256_of(file.path.read_bytes())),
    )


def _write_part(folder: Path, name: str, pieces: RankPieces, file: PieceFile, components: Array,
                mode: str, certify: bool) -> WrittenPart:  # fmt: skip
    cells, vertices = file_numbers(pieces, file)
    if not isinstance(pieces.surface, PieceSurface):
        raise FileError(f"{file.path}: has no tetrahedra, so there is no part of it; leave it out")
    certified = certified_part(pieces, file) if certify else None
    try:
        part = part_surface(pieces.surface, cells, vertices, components, certified, mode)
    except ValueError as error:
        raise ValueError(f"{file.path}: {error}") from error
    return write_part_files(folder, name, file, part_bytes(part), part.surface.certificate)


def put_parts(
    comm: Any,
    output: Path,
    pieces: RankPieces,
    begin: Callable[[], None],
    write: Callable[[Path, int], Written],
    finish: Callable[[list[Written]], dict[Path, bytes]],
) -> None:
    """Writes a file in parts, one for each file of the pieces: all files or none. All ranks call it.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    output : Path
        The .pvtp. The parts go into a folder of its name without the ending.
    pieces : RankPieces
    begin : callable
        What is required before; on the first rank.
    write : callable
        Writes a part into a folder, of one of the rank's files.
    finish : callable
        What goes beside the folder, from what ``write`` gave for all parts in order; on the first rank.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    folder = output.with_suffix("")

    def start() -> Optional[Path]:
        for file in pieces.files:
            if file.tets[0] == file.tets[1]:
                raise FileError(f"{file.path}: has no tetrahedra, so there is no part of it; leave it out")
        if len(orders) > 1:
            raise FileError(f"{output}: the pieces have tensors in several orders: {', '.join(sorted(orders))}")
        if comm.rank != 0:
            return None
        begin()
        require_folder(folder)
        return new_folder(folder)

    orders = {order for own in comm.allgather([f.order for f in pieces.files]) for order in own}
    made = together(comm, start)
    filled: Path = comm.bcast(made)
    try:

        def write_all() -> list[Written]:
            try:
                return [write(filled, number) for number in range(len(pieces.files))]
            except OSError as error:
                if isinstance(error, FileError):
                    raise
                raise FileError(f"{folder}: cannot be written ({error.strerror or error})") from error

        gathered = comm.gather(together(comm, write_all))

        def end() -> None:
            if comm.rank == 0:
                put_in_place(filled, folder, finish([part for rank in gathered for part in rank]))

        together(comm, end)
    finally:
        if comm.rank == 0:
            shutil.rmtree(filled, ignore_errors=True)


def write_output_parts(
    comm: Any,
    output: Path,
    certificate: Optional[Path],
    pieces: RankPieces,
    kind: OutputKind,
    write: Callable[[Path, int], WrittenPart],
    mode: str,
    counts: dict[str, int],
    sources: Sequence[str],
) -> None:
    """Writes a surface or curves in parts, all files or none. All ranks call it.

    Parameters
    ----------
    comm, output, certificate, pieces, sources
        As for `write_parts`.
    kind : OutputKind
    write : callable
        Writes a part into a folder, of one of the rank's files.
    mode : str
        Exactly.
    counts : dict of str to int
        What a certificate of parts claims of the whole besides tetrahedra; on the first rank.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    folder = output.with_suffix("")
    beside = ""
    if certificate is not None:
        beside = os.path.relpath(folder, certificate.parent).replace(os.sep, "/")
    cells = comm.reduce(len(pieces.tets))

    def begin() -> None:
        if certificate is not None:
            require_below(certificate, beside)

    def finish(parts: list[WrittenPart]) -> dict[Path, bytes]:
        files = {output: pvtp_bytes([f"{folder.name}/{part.output[0]}" for part in parts], kind.arrays)}
        if certificate is not None:
            listed = [
                {
                    "input": (source, part.field[1]),
                    kind.role: (f"{folder.name}/{part.output[0]}", part.output[1]),
                    "certificate": (f"{beside}/{part.certificate[0]}", part.certificate[1]),
                }
                for source, part in zip(sources, parts)
                if part.certificate is not None
            ]
            files[certificate] = certificate_of_parts(mode, listed, {"tetrahedra": cells, **counts})
        return files

    put_parts(comm, output, pieces, begin, write, finish)


def write_parts(
    comm: Any,
    output: Path,
    certificate: Optional[Path],
    pieces: RankPieces,
    whole: WholeNumbers,
    mode: Any,
    sources: Sequence[str],
) -> None:
    """Writes a surface in parts, all files or none. All ranks call it.

    Parameters
    ----------
    comm : mpi4py.MPI.Comm
    output : Path
        The .pvtp. The parts go into a folder of its name without the ending.
    certificate : Path or None
        The certificate of parts. Those of the parts go into the folder.
    pieces : RankPieces
    whole : WholeNumbers
    mode : any
    sources : sequence of str
        The pieces, as the .pvtu names them.

    Raises
    ------
    RankError
        On all ranks, if something is wrong on one.
    """
    (text,) = mode_texts(mode)

    def write(filled: Path, number: int) -> WrittenPart:
        return _write_part(filled, output.stem, pieces, pieces.files[number], whole.component, text,
                           certificate is not None)  # fmt: skip

    write_output_parts(
        comm, output, certificate, pieces, OutputKind("surface", SURFACE_ARRAYS), write, text, whole.counts, sources
    )
