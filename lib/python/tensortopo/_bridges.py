# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Meshes of other packages, where these are installed. None is imported before it is needed."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._field import Field
from ._surface import Curves, Surface


def _only(candidates: dict[str, Any], tensor: Optional[str]) -> str:
    def width(values: Any) -> int:
        return int(np.prod(np.shape(values)[1:]))

    names = [name for name, values in candidates.items() if width(values) in (6, 9)]
    if tensor is not None:
        if tensor not in names:
            raise ValueError(f"tensor: no point array '{tensor}' of 6 or 9 components")
        return tensor
    if len(names) != 1:
        found = ", ".join(names) or "none"
        raise ValueError(f"tensor: expected one point array of 6 or 9 components, found: {found}")
    return names[0]


def _field(points: Any, values: Any, tets: Any, components: Optional[str], ids: Any, name: str,
           symmetrize: bool) -> Field:  # fmt: skip
    array = np.asarray(values)
    if array.ndim == 2 and array.shape[1] == 9:
        array = array.reshape(-1, 3, 3)
    return Field(points, array, tets, components or "vtk", cell_ids=ids, tensor_name=name,
                 symmetrize=symmetrize)  # fmt: skip


def from_meshio(
    mesh: Any,
    tensor: Optional[str] = None,
    components: Optional[str] = None,
    *,
    symmetrize: bool = False,
) -> Field:
    """The field of a ``meshio.Mesh``.

    Parameters
    ----------
    mesh : meshio.Mesh
        Of linear tetrahedra; points, lines and faces are passed over, other cells refused.
    tensor : str, optional
        The point array; by default the only one of 6 or 9 components.
    components : str, optional
        The order of six components, as in `Field`; VTK's by default.
    symmetrize : bool, default False
        As in `Field`.

    Returns
    -------
    Field
        Its ``cell_ids`` count the cells of all blocks from 0.
    """
    flat = {"vertex", "line", "line3", "triangle", "triangle6", "quad", "quad8", "quad9", "polygon"}
    tets, ids, first = [], [], 0
    for block in mesh.cells:
        if block.type == "tetra":
            tets.append(np.asarray(block.data))
            ids.append(np.arange(first, first + len(block.data)))
        elif block.type not in flat:
            raise ValueError(f"mesh: has cells of type '{block.type}'; only linear tetrahedra are taken")
        first += len(block.data)
    if not tets:
        raise ValueError("mesh: has no tetrahedra")
    points = np.asarray(mesh.points)
    name = _only(mesh.point_data, tensor)
    return _field(points, mesh.point_data[name], np.concatenate(tets), components,
                  np.concatenate(ids), name, symmetrize)  # fmt: skip


def from_pyvista(
    grid: Any,
    tensor: Optional[str] = None,
    components: Optional[str] = None,
    *,
    symmetrize: bool = False,
) -> Field:
    """The field of a ``pyvista.UnstructuredGrid`` of linear tetrahedra.

    Parameters
    ----------
    grid : pyvista.UnstructuredGrid
    tensor, components, symmetrize
        As in `from_meshio`.

    Returns
    -------
    Field
    """
    other = set(grid.cells_dict) - {10, 1, 3, 5, 9}
    if other:
        raise ValueError(f"grid: has cells of VTK's types {sorted(int(t) for t in other)}; "
                         "only linear tetrahedra are taken")  # fmt: skip
    if 10 not in grid.cells_dict:
        raise ValueError("grid: has no tetrahedra")
    ids = np.flatnonzero(np.asarray(grid.celltypes) == 10)
    arrays = {name: np.asarray(grid.point_data[name]) for name in grid.point_data.keys()}
    name = _only(arrays, tensor)
    return _field(np.asarray(grid.points), arrays[name], grid.cells_dict[10], components, ids, name,
                  symmetrize)  # fmt: skip


def _not_an_output(value: Any) -> TypeError:
    return TypeError(f"expected a Surface or Curves, not {type(value).__name__}")


def to_meshio(output: Any) -> Any:
    """A surface or curves as a ``meshio.Mesh`` with the arrays of a .vtp.

    Parameters
    ----------
    output : Surface or Curves

    Returns
    -------
    meshio.Mesh
    """
    import meshio

    if isinstance(output, Surface):
        cells = [("triangle", output.triangles)]
        cell_data = {name: [values] for name, values in _cell_data(output).items()}
    elif isinstance(output, Curves):
        segments = [np.column_stack((line[:-1], line[1:])) for line in output.lines]
        lengths = [len(s) for s in segments]
        cells = [("line", np.concatenate(segments) if segments else np.empty((0, 2), int))]
        cell_data = {
            name: [np.repeat(values, lengths)] for name, values in _cell_data(output).items()
        }
    else:
        raise _not_an_output(output)
    return meshio.Mesh(output.points, cells, point_data=_point_data(output), cell_data=cell_data)


def to_pyvista(output: Any) -> Any:
    """A surface or curves as a ``pyvista.PolyData`` with the arrays of a .vtp.

    Parameters
    ----------
    output : Surface or Curves

    Returns
    -------
    pyvista.PolyData
    """
    import pyvista

    if isinstance(output, Surface):
        threes = np.full((len(output.triangles), 1), 3)
        mesh = pyvista.PolyData(
            np.array(output.points), faces=np.hstack((threes, output.triangles)).ravel()
        )
    elif isinstance(output, Curves):
        lines: list[Any] = [np.insert(line, 0, len(line)) for line in output.lines]
        mesh = pyvista.PolyData(
            np.array(output.points), lines=np.concatenate(lines) if lines else None
        )
    else:
        raise _not_an_output(output)
    for name, values in _point_data(output).items():
        mesh.point_data[name] = np.array(values)
    for name, values in _cell_data(output).items():
        mesh.cell_data[name] = np.array(values)
    return mesh


def _cell_data(output: Any) -> dict[str, Any]:
    data = {"tet": output.cell_ids, "component": output.component}
    if output.stable is not None:
        data["instability"], data["stable"] = output.instability, output.stable
    return data


def _point_data(output: Any) -> dict[str, Any]:
    data = {
        "mode": output.mode,
        "dominant_eigenvector": output.dominant_eigenvectors,
        "residual": output.residual,
    }
    if isinstance(output, Surface):
        data["medium_eigenvector"] = output.medium_eigenvectors
        data["normal"] = output.normals
    else:
        data["separation"] = output.separation
    if output.stable is not None:
        data["crossing_instability"] = output.crossing_instability
        data["crossing_stable"] = output.crossing_stable
    return data


class PyVistaAccessor:
    """The attribute ``tensortopo`` of PyVista's unstructured grids, from PyVista 0.48 on.

    The methods are those of `Field`, and give ``pyvista.PolyData``. PyVista finds the accessor by the
    entry point ``pyvista.accessors`` of the installed package; else call `register_pyvista`.
    """

    def __init__(self, grid: Any) -> None:
        self._grid = grid

    def field(self, tensor: Optional[str] = None, components: Optional[str] = None) -> Field:
        """The grid as a `Field`.

        Parameters
        ----------
        tensor, components
            As of `from_pyvista`.
        """
        return from_pyvista(self._grid, tensor, components)

    def mode_surface(
        self, mode: Any, tensor: Optional[str] = None, components: Optional[str] = None, **options: Any
    ) -> Any:
        """The surface of a mode as ``pyvista.PolyData``.

        Parameters
        ----------
        mode, **options
            As of `Field.mode_surface`.
        tensor, components
            As of `from_pyvista`.
        """
        return to_pyvista(self.field(tensor, components).mode_surface(mode, **options))

    def degenerate_curves(
        self,
        kind: str = "both",
        tensor: Optional[str] = None,
        components: Optional[str] = None,
        **options: Any,
    ) -> Any:
        """The degenerate curves as ``pyvista.PolyData``.

        Parameters
        ----------
        kind, **options
            As of `Field.degenerate_curves`.
        tensor, components
            As of `from_pyvista`.
        """
        return to_pyvista(self.field(tensor, components).degenerate_curves(kind, **options))


def register_pyvista() -> None:
    """Adds ``grid.tensortopo`` to PyVista's unstructured grids.

    Raises
    ------
    ImportError
        If PyVista is not installed.
    """
    import pyvista

    register = getattr(pyvista, "register_dataset_accessor", None)
    if register is not None:
        register("tensortopo", pyvista.UnstructuredGrid)(PyVistaAccessor)
    else:
        pyvista.UnstructuredGrid.tensortopo = property(PyVistaAccessor)
