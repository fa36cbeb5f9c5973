# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces in parts, one for each piece of a field: a .pvtp with its .vtp files, and their certificates."""
from __future__ import annotations

import hashlib
import os
import re
import shutil
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._errors import FileError
from ._modes import mode_texts
from ._partition import CertifiedField, MergedSurface, PieceSurface, certified_numbers
from ._vtk_xml import escaped, piece_text, write_whole

Array = npt.NDArray[Any]

# The arrays of a part: name, type, components.
_POINT_ARRAYS = (
    ("mode", "Float64", 1),
    ("medium_eigenvector", "Float64", 3),
    ("dominant_eigenvector", "Float64", 3),
    ("whole_normal", "Float64", 3),
    ("residual", "Float64", 1),
)
_CELL_ARRAYS = (("tet", "Int64", 1), ("component", "Int32", 1), ("whole_component", "Int32", 1))
_MARKS = {"Scalars": "mode", "Normals": "whole_normal"}


@dataclass(frozen=True)
class PartSurface:
    """The part of a surface that lies in a piece, in the numbers of the piece's file.

    Attributes
    ----------
    surface : MergedSurface
        Its normals are those of the whole surface.
    whole_component : ndarray of int32
        Of each triangle its component in the whole surface.
    """

    surface: MergedSurface
    whole_component: npt.NDArray[np.int32]


def part_surface(
    piece: PieceSurface,
    cells: Array,
    vertices: Array,
    components: Array,
    certified: Optional[CertifiedField],
    mode: Any,
) -> PartSurface:
    """What a piece has of the surface in some of its cells.

    Parameters
    ----------
    piece : PieceSurface
    cells, vertices : ndarray of int64 of shape (n, 2)
        Ids in the whole mesh, and numbers in the part's file.
    components : ndarray of int32
        Of each triangle of the piece its component in the whole surface.
    certified : CertifiedField or None
        What the certificate says of the part's file; None makes none.
    mode : any
    """
    (text,) = mode_texts(mode)
    made = _core.surface_part(piece.arrays, cells, vertices, components, certified_numbers(certified, text))
    surface = MergedSurface(**{name: made[name] for name in MergedSurface.__dataclass_fields__})
    return PartSurface(surface, made["whole_component"])


def part_bytes(part: PartSurface) -> bytes:
    """The part's .vtp."""
    surface = part.surface
    n = len(surface.triangles)
    text = piece_text(
        "PolyData",
        {"NumberOfPoints": len(surface.points), "NumberOfVerts": 0, "NumberOfPolys": n},
        {
            "PointData": {
                "mode": surface.mode,
                "medium_eigenvector": surface.medium_eigenvectors,
                "dominant_eigenvector": surface.dominant_eigenvectors,
                "whole_normal": surface.normals,
                "residual": surface.residual,
            },
            "CellData": {
                "tet": surface.cell_ids,
                "component": surface.component,
                "whole_component": part.whole_component,
            },
            "Points": {"Points": surface.points},
            "Polys": {
                "connectivity": surface.triangles.astype(np.int64).ravel(),
                "offsets": np.arange(3, 3 * n + 1, 3, dtype=np.int64),
            },
        },
        marks=_MARKS,
    )
    return text.encode("utf-8")


@dataclass(frozen=True)
class PartArrays:
    """The arrays of parts: name, type and components of each; and which point arrays are marked as what."""

    points: tuple[tuple[str, str, int], ...]
    cells: tuple[tuple[str, str, int], ...]
    marks: Mapping[str, str]


SURFACE_ARRAYS = PartArrays(_POINT_ARRAYS, _CELL_ARRAYS, _MARKS)


def pvtp_bytes(sources: Sequence[str], arrays: PartArrays = SURFACE_ARRAYS) -> bytes:
    """A .pvtp of these parts."""

    def listed(section: str, rows: Sequence[tuple[str, str, int]], marks: str = "") -> list[str]:
        named = [f'<PDataArray type="{kind}" Name="{name}" NumberOfComponents="{width}"/>'
                 for name, kind, width in rows]  # fmt: skip
        return [f"<{section}{marks}>", *named, f"</{section}>"]

    lines = [
        '<?xml version="1.0"?>',
        '<VTKFile type="PPolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
        'compressor="vtkZLibDataCompressor">',
        '<PPolyData GhostLevel="0">',
        *listed("PPointData", arrays.points, "".join(f' {k}="{v}"' for k, v in arrays.marks.items())),
        *listed("PCellData", arrays.cells),
        *listed("PPoints", [("Points", "Float64", 3)]),
        *[f'<Piece Source="{escaped(source)}"/>' for source in sources],
        "</PPolyData>",
        "</VTKFile>",
        "",
    ]
    return "\n".join(lines).encode("utf-8")


def require_below(file: Path, name: str) -> None:
    """A file names another as a certificate of parts may: beside it, or in a folder below.

    Raises
    ------
    FileError
    """
    if any(part in ("", ".", "..") for part in name.split("/")):
        raise FileError(
            f"{file}: names {name}, which a certificate of parts cannot be about; move it beside, or below"
        )


def sha256_of(data: bytes) -> str:
    """In hexadecimal."""
    return hashlib.sha256(data).hexdigest()


def certificate_of_parts(
    mode: str, parts: Sequence[Mapping[str, tuple[str, str]]], whole: Mapping[str, int]
) -> bytes:
    """The certificate of a surface in parts.

    Parameters
    ----------
    mode : str
        Exactly.
    parts : sequence of mapping
        Of each part name and SHA-256 of its ``input``, ``surface`` or ``polylines``, and ``certificate``.
    whole : mapping of str to int
        What is claimed of the whole.
    """
    role = "polylines" if "polylines" in next(iter(parts), {}) else "surface"
    listed = [[part["input"], part[role], part["certificate"]] for part in parts]
    return _core.parts_certificate(mode, role, listed, list(whole.items()))


def require_folder(folder: Path) -> None:
    """The folder is not there, or has nothing but parts of a surface, which may be replaced.

    Raises
    ------
    FileError
    """
    if not folder.exists():
        return
    pattern = re.escape(folder.name) + r"_\d+\.(vtp|json)"
    if not folder.is_dir():
        raise FileError(f"{folder}: is in the place of the folder for the parts; remove it")
    for file in folder.iterdir():
        if re.fullmatch(pattern, file.name) is None:
            raise FileError(f"{folder}: has {file.name}, which is no part of a surface; name another output")


def new_folder(folder: Path) -> Path:
    """A hidden folder beside one, to be filled and put in its place.

    Raises
    ------
    FileError
    """
    try:
        made = Path(tempfile.mkdtemp(dir=folder.parent, prefix=".tensortopo-"))
        mask = os.umask(0o022)
        os.umask(mask)
        os.chmod(made, 0o777 & ~mask)
    except OSError as error:
        raise FileError(f"{folder}: cannot be written ({error.strerror or error})") from error
    return made


def put_in_place(filled: Path, folder: Path, files: Mapping[Path, bytes]) -> None:
    """A filled folder takes the place of one, together with files; or all is as before.

    Raises
    ------
    FileError
    """
    before: Optional[Path] = None
    try:
        if folder.exists():
            before = Path(tempfile.mkdtemp(dir=folder.parent, prefix=".tensortopo-"))
            os.rename(folder, before / folder.name)
        os.rename(filled, folder)
        write_whole(files)
    except OSError as error:
        if folder.exists() and not filled.exists():
            os.rename(folder, filled)
        if before is not None and (before / folder.name).exists():
            os.rename(before / folder.name, folder)
        if isinstance(error, FileError):
            raise
        raise FileError(f"{folder}: cannot be written ({error.strerror or error})") from error
    finally:
        if before is not None:
            shutil.rmtree(before, ignore_errors=True)
