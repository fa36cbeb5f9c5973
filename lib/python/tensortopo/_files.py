# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Fields from files, and outputs to files, without VTK."""
from __future__ import annotations

import operator
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._curve_pieces import MergedCurves
from ._errors import FileError, MeshError
from ._field import Field
from ._partition import MergedSurface
from ._surface import Curves, Surface, _Output
from ._tensors import COMPONENT_ORDERS, tensor_rows
from ._vtk_xml import XmlArray, XmlPiece, piece_text, read_piece, write_whole

# What the program reads beyond plain .vtu; lib/io has the table.
_PROGRAMS_FORMATS = (".pvtu", ".vtk", ".vti", ".pvd", ".frd", ".e", ".exo", ".nii", ".nii.gz")
_VERTEX, _TETRA = 1, 10
_GHOST = 1 | 32  # bits of vtkGhostType: another piece's cell, and one that is hidden
_FLAT = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 21, 22, 23, 28, 30, 34, 35, 36}  # points, lines, faces
_LINEAR_NAMES = {11: "voxels", 12: "hexahedra", 13: "wedges", 14: "pyramids"}


def has_program() -> bool:
    """Whether `find_program` finds one."""
    return bool(os.environ.get("TENSORTOPO_PROGRAM") or shutil.which("tensortopo"))


def find_program(path: Optional[str] = None) -> str:
    """The program: as given, else what TENSORTOPO_PROGRAM names, else tensortopo on the path."""
    found = path or os.environ.get("TENSORTOPO_PROGRAM") or shutil.which("tensortopo")
    if found is None:
        raise FileError(
            "tensortopo: the program is not on the path; pass program=, or set TENSORTOPO_PROGRAM"
        )
    return found


def _tensors(arrays: dict[str, XmlArray]) -> dict[str, XmlArray]:
    return {
        name: array
        for name, array in arrays.items()
        if array.values.ndim == 2 and array.values.shape[1] in (6, 9)
    }


def _pick(path: Path, sections: dict[str, dict[str, XmlArray]],
          tensor: Optional[str]) -> tuple[str, XmlArray]:  # fmt: skip
    found = _tensors(sections.get("PointData", {}))
    on_cells = _tensors(sections.get("CellData", {}))
    if tensor is not None:
        if tensor not in found:
            raise FileError(f"{path}: no point array '{tensor}' of 6 or 9 components")
        return tensor, found[tensor]
    if len(found) != 1:
        if not found and on_cells:
            raise FileError(f"{path}: tensors belong to cells ({', '.join(on_cells)}); "
                            'options=["--cell-to-point"] averages them to the points')  # fmt: skip
        if not found:
            raise FileError(f"{path}: has no point array of 6 or 9 components; six arrays of one are "
                            "joined by tensor='NAME_{xx,yy,zz,xy,yz,xz}'")  # fmt: skip
        names = ", ".join(found)
        raise FileError(f"{path}: point arrays of 6 or 9 components: {names}; name one (tensor=...)")
    return next(iter(found.items()))


def _order(path: Path, name: str, array: XmlArray, asked: Optional[str]) -> str:
    """The order of the components: obeyed if the file names one, else the one asked for, else VTK's."""
    count = array.values.shape[1]
    if count == 9 and asked is not None:
        raise FileError(f"{path}: an order of components is of six, '{name}' has nine")
    try:
        return _core.decide_order(name, list(array.names), count, asked)
    except RuntimeError as error:
        raise FileError(f"{path}: {error}") from error


class Grid(NamedTuple):
    """The tetrahedra of a file, and the tensors at its points."""

    points: Any
    tensors: Any  # rows in VTK's order
    tets: Any
    cells: Any  # which of the file's cells the tetrahedra are
    tensor_name: str
    order: str  # of the components in the file


def grid_of(path: Path, piece: XmlPiece, tensor: Optional[str], components: Optional[str],
            symmetrize: bool) -> Grid:  # fmt: skip
    """What a .vtu holds, without the cells that are marked as another piece's."""
    try:
        points = next(iter(piece.sections["Points"].values())).values
        cells = piece.sections["Cells"]
        connectivity, offsets, types = (
            cells[name].values for name in ("connectivity", "offsets", "types")
        )
    except (KeyError, StopIteration) as error:
        raise FileError(f"{path}: points or cells are missing") from error
    ends = offsets.astype(np.int64)
    starts = np.zeros_like(ends)
    starts[1:] = ends[:-1]
    if len(types) != len(ends) or (ends < starts).any() or (len(ends) and ends[-1] > len(connectivity)):
        raise FileError(f"{path}: the cells are not what their offsets say")
    tetra = types == _TETRA
    other = sorted({int(t) for t in types[~tetra]} - _FLAT)
    if other:
        what = ", ".join(_LINEAR_NAMES.get(t, f"cells of VTK's type {t}") for t in other)
        linear = all(t in _LINEAR_NAMES for t in other)
        how = '"--tetrahedralize"' if linear else '"--quadratic", "split"'
        raise FileError(f"{path}: has {what}; options=[{how}] splits them into tetrahedra")
    if (ends[tetra] - starts[tetra] != 4).any():
        raise FileError(f"{path}: a tetrahedron has not four vertices")
    ghosts = piece.sections.get("CellData", {}).get("vtkGhostType")
    if ghosts is not None:
        if ghosts.values.shape != types.shape:
            raise FileError(f"{path}: the array 'vtkGhostType' has not one number for each cell")
        tetra = tetra & (ghosts.values.astype(np.int64) & _GHOST == 0)
    tets = connectivity[starts[tetra][:, None] + np.arange(4)]
    name, array = _pick(path, piece.sections, tensor)
    if len(array.values) != len(points):
        raise FileError(f"{path}: the array '{name}' has not one tensor for each point")
    order = _order(path, name, array, components)
    tensors: Any = array.values
    is_full = tensors.shape[1] == 9
    if is_full:
        tensors, order = tensors.reshape(-1, 3, 3), "vtk"
    try:
        rows = tensor_rows(tensors, order, symmetrize)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    return Grid(points, rows, tets, np.flatnonzero(tetra), name, "full" if is_full else order)


def _field_of(path: Path, piece: XmlPiece, tensor: Optional[str], components: Optional[str],
              symmetrize: bool) -> Field:  # fmt: skip
    grid = grid_of(path, piece, tensor, components, symmetrize)
    try:
        return Field(grid.points, grid.tensors, grid.tets, cell_ids=grid.cells,
                     tensor_name=grid.tensor_name)  # fmt: skip
    except MeshError as error:
        raise MeshError(error.defects, str(path)) from error


def _with_argument(problem: str) -> str:
    """What the program says of an option, with the argument of `read` that stands for it."""
    said = f" {problem}"
    for name in ("step", "mask", "components", "tensor", "symmetrize"):
        if re.search(rf" --{name}\b", said):
            return f"{problem} (here: the argument {name})"
    return f"{problem} (here: options=[...])" if " --" in said else problem


def _converted(file: Path, words: Sequence[str], tensor: Optional[str], components: Optional[str],
               symmetrize: bool) -> Field:  # fmt: skip
    """The field that ``tensortopo convert`` makes of a file."""
    command = [find_program(), "convert", str(file), "--quiet", *words]
    command += [] if tensor is None else ["--tensor", tensor]
    command += [] if components is None else ["--components", components]
    command += ["--symmetrize"] if symmetrize else []
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "field.vtu"
        done = subprocess.run([*command, "-o", str(made)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f"{file}: tensortopo convert failed"]
            raise FileError(_with_argument(lines[-1].removeprefix("tensortopo: ")))
        piece = read_piece(made)
    return _field_of(file, piece, None, None, False)


def read(
    path: Union[str, os.PathLike[str]],
    tensor: Optional[str] = None,
    components: Optional[str] = None,
    *,
    symmetrize: bool = False,
    step: Optional[int] = None,
    mask: Optional[Union[str, os.PathLike[str]]] = None,
    options: Sequence[str] = (),
) -> Field:
    """The field in a file.

    A .vtu of linear tetrahedra in one piece is read here: text, inline and appended binary,
    uncompressed or by zlib. Other formats of the program (.pvtu, .vtk, .vti, .pvd, .frd, .e, .exo,
    .nii, .nii.gz) are read by ``tensortopo convert``, if the program is found: what
    ``TENSORTOPO_PROGRAM`` names, or ``tensortopo`` on the path. Further names, and these without the
    program, go to meshio, where it is installed.

    Parameters
    ----------
    path : str or path
    tensor : str, optional
        The point array; by default the only one of 6 or 9 components.
    components : str, optional
        The order of six components, as in `Field`; by default what the file says, or VTK's. Refused
        if the file names another one.
    symmetrize : bool, default False
        As in `Field`.
    step : int, optional
        Of a file of several steps: which, from 1; by default the last.
    mask : str or path, optional
        Of a NIfTI image: an image that is not 0 where voxels are taken.
    options : sequence of str
        Further options of ``tensortopo convert``, such as ``["--cell-to-point"]``.

    Returns
    -------
    Field
        With the numbers exactly as in the file; ``cell_ids`` count its cells from 0, or the
        tetrahedra that the program made of them.

    Raises
    ------
    FileError
        For files that cannot be read, or are not what they should be.
    ValueError, MeshError
        As `Field`.
    """
    file = Path(path)
    if isinstance(options, str):
        raise TypeError(f"options: a list of words is expected, as {options.split()}")
    words = [*options]
    words += [] if step is None else ["--step", str(operator.index(step))]
    words += [] if mask is None else ["--mask", os.fspath(mask)]
    if words:
        return _converted(file, words, tensor, components, symmetrize)
    if tensor is not None and "{" in tensor and has_program():  # several arrays, which it joins
        return _converted(file, words, tensor, components, symmetrize)
    if file.suffix.lower() == ".vtu":
        piece = read_piece(file)
        if piece.kind != "UnstructuredGrid":
            raise FileError(f"{file}: holds no unstructured grid")
        return _field_of(file, piece, tensor, components, symmetrize)
    if file.name.lower().endswith(_PROGRAMS_FORMATS) and has_program():
        return _converted(file, words, tensor, components, symmetrize)
    try:
        import meshio
    except ImportError as error:
        formats = ", ".join(_PROGRAMS_FORMATS)
        raise FileError(
            f"{file}: fields are read from .vtu, {formats}, and with meshio from its formats"
            if has_program()
            else f"{file}: only .vtu is read without the program and meshio; put tensortopo on the "
            "path, or name it with TENSORTOPO_PROGRAM"
        ) from error
    from ._bridges import from_meshio

    try:
        mesh = meshio.read(file)
    except Exception as error:  # of many kinds, from many readers
        without = "" if has_program() else (
            "; with tensortopo on the path, or named by TENSORTOPO_PROGRAM, its formats are read, too")
        raise FileError(f"{file}: meshio does not read it ({error}){without}") from error
    return from_meshio(mesh, tensor, components, symmetrize=symmetrize)


def _field_text(field: Field, at: npt.NDArray[np.int64], count: int) -> str:
    """Of tetrahedra that are the cells `at` of so many; all others are points."""
    sizes, types = np.ones(count, dtype=np.int64), np.full(count, _VERTEX, dtype=np.uint8)
    sizes[at], types[at] = 4, _TETRA
    offsets = np.cumsum(sizes)
    connectivity = np.zeros(sizes.sum(), dtype=np.int64)
    connectivity[(offsets[at] - 4)[:, None] + np.arange(4)] = field.tets
    cells: dict[str, Any] = {"connectivity": connectivity, "offsets": offsets, "types": types}
    return piece_text(
        "UnstructuredGrid",
        {"NumberOfPoints": len(field.points), "NumberOfCells": count},
        {
            "PointData": {field.tensor_name: field.tensors},
            "Points": {"Points": field.points},
            "Cells": cells,
        },
        marks={"Tensors": field.tensor_name},
        names={field.tensor_name: tuple(name.upper() for name in COMPONENT_ORDERS["vtk"])},
    )


def write_at_ids(path: Path, field: Field) -> None:
    """Writes a field so that its tetrahedra are the cells that `Field.cell_ids` says.

    Raises
    ------
    ValueError
        If they are not in this order, or so large that the file would mostly be other cells.
    """
    ids = field.cell_ids
    count = int(ids[-1]) + 1 if len(ids) else 0
    if np.any(np.diff(ids) <= 0) or np.any(ids < 0) or count > 16 * len(ids) + 1_000_000:
        raise ValueError("field: its cell_ids are not those of cells of a file in ascending order; "
                         "check the file, or leave cell_ids out")  # fmt: skip
    path.write_text(_field_text(field, ids, count), encoding="utf-8")


def _output_text(output: Union[_Output, MergedSurface, MergedCurves]) -> str:
    point_data: dict[str, Any] = {"mode": output.mode}
    cell_data: dict[str, Any] = {"tet": output.cell_ids, "component": output.component}
    counts = {"NumberOfPoints": len(output.points), "NumberOfVerts": 0}
    if isinstance(output, (Surface, MergedSurface)):
        point_data["medium_eigenvector"] = output.medium_eigenvectors
        point_data["dominant_eigenvector"] = output.dominant_eigenvectors
        point_data["normal"] = output.normals
        point_data["residual"] = output.residual
        n = len(output.triangles)
        connectivity = output.triangles.astype(np.int64).ravel()
        offsets = np.arange(3, 3 * n + 1, 3, dtype=np.int64)
        section, counts["NumberOfPolys"] = "Polys", n
    elif isinstance(output, (Curves, MergedCurves)):
        point_data["dominant_eigenvector"] = output.dominant_eigenvectors
        point_data["residual"] = output.residual
        point_data["separation"] = output.separation
        connectivity = output.connectivity.astype(np.int64)
        offsets = output.offsets[1:]
        section, counts["NumberOfLines"] = "Lines", len(output)
    else:
        raise TypeError(f"nothing is written of a {type(output).__name__}")
    if isinstance(output, _Output) and output.stable is not None:
        cell_data["instability"], cell_data["stable"] = output.instability, output.stable
        point_data["crossing_instability"] = output.crossing_instability
        point_data["crossing_stable"] = output.crossing_stable
    return piece_text(
        "PolyData",
        counts,
        {
            "PointData": point_data,
            "CellData": cell_data,
            "Points": {"Points": output.points},
            section: {"connectivity": connectivity, "offsets": offsets},
        },
        marks={"Scalars": "mode"} | ({} if section == "Lines" else {"Normals": "normal"}),
    )


def output_bytes(output: Union[_Output, MergedSurface, MergedCurves]) -> bytes:
    """What `write` puts into a .vtp."""
    return _output_text(output).encode("utf-8")


def write(
    path: Union[str, os.PathLike[str]], what: Union[Field, Surface, MergedSurface, Curves, MergedCurves]
) -> None:
    """Writes a field (.vtu), or a surface or curves (.vtp), whole or not at all.

    The arrays of a .vtp are those that the program writes, with the same names and numbers, so that
    ``tensortopo check`` takes it. Tensors are in VTK's order, which the names of their components spell.
    A field's tetrahedra are numbered from 0, whatever its ``cell_ids``: certificates made before of
    a field with others are not about that file.

    Parameters
    ----------
    path : str or path
        Ends in .vtu for a field, else in .vtp.
    what : Field, Surface, MergedSurface, Curves or MergedCurves

    Raises
    ------
    FileError
        If the file cannot be written.
    ValueError
        For another extension.
    """
    file = Path(path)
    wanted = ".vtu" if isinstance(what, Field) else ".vtp"
    if file.suffix.lower() != wanted:
        raise ValueError(f"{file}: the name of a {type(what).__name__} must end in {wanted}")
    if isinstance(what, Field):
        n = len(what.tets)
        data = _field_text(what, np.arange(n), n).encode("utf-8")
    else:
        data = output_bytes(what)
    write_whole({file: data})
