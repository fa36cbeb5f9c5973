# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Piecewise linear tensor fields."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._errors import Defect, MeshError, UnresolvedError
from ._modes import Mode, mode_text, mode_texts
from ._persistence import Persistence, persistence_of
from ._surface import Curves, Surface
from ._sweep import Sweep, sweep_of
from ._tensors import real_array, tensor_rows

Progress = Callable[[str, float], Any]

_OF_VERTICES = ("non_finite_point", "non_finite_tensor")


def _index_array(values: Any, name: str) -> npt.NDArray[np.int64]:
    if np.ma.is_masked(values):
        raise ValueError(f"{name}: some are masked; leave them out")
    array = np.asarray(values)
    if array.size == 0 and array.dtype.kind == "f":
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name}: expected integers, not {array.dtype}")
    if array.dtype == np.uint64 and array.size > 0 and array.max() > np.iinfo(np.int64).max:
        raise ValueError(f"{name}: a number is too large")
    return np.ascontiguousarray(array, dtype=np.int64)


def _ids(values: Any, count: int, name: str) -> npt.NDArray[np.int64]:
    ids = _index_array(values, name)
    if ids.shape != (count,):
        raise ValueError(f"{name}: expected shape ({count},), not {ids.shape}")
    return ids


def _restored(points: Any, tensors: Any, tets: Any, cell_ids: Any, vertex_ids: Any,
              tensor_name: str) -> Field:  # fmt: skip
    return Field(points, tensors, tets, vertex_ids=vertex_ids, cell_ids=cell_ids,
                 tensor_name=tensor_name)  # fmt: skip


class Field:
    """A symmetric tensor at each vertex of a tetrahedral mesh, linear in each tetrahedron.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates. Numbers of other types are taken as the exact values that they hold.
    tensors : array_like, shape (n, 6) or (n, 3, 3)
        A symmetric tensor for each point. Matrices that differ from their transposes by no more
        than 1e-9 of their norms are replaced by the means.
    tets : array_like of int, shape (m, 4)
        The vertices of each tetrahedron. Those of negative volume are turned around.
    components : str, default "vtk"
        The order of six components: ``vtk`` (xx yy zz xy yz xz), ``voigt`` (xx yy zz yz xz xy),
        ``abaqus`` = ``mrtrix`` (xx yy zz xy xz yz), ``nifti`` = ``dipy`` (xx xy yy xz yz zz) or ``fsl``
        (xx xy xz yy yz zz). Without effect on matrices.
    vertex_ids, cell_ids : array_like of int, optional
        What reports call vertices and cells; their numbers by default. They do not change what is
        extracted.
    tensor_name : str, default "tensor"
        What certificates and files call the tensors.
    symmetrize : bool, default False
        Take the means of matrices that are not symmetric, instead of refusing them.

    Raises
    ------
    ValueError
        For arrays of another shape or type.
    MeshError
        For meshes on which no piecewise linear field is defined, with all defects.

    Notes
    -----
    The trace plays no part in the mode; the deviator is taken exactly. A field does not change, and
    may be used by several threads. Its arrays are copies of those given; its attributes are
    read-only views.

    Examples
    --------
    >>> import tensortopo as tt
    >>> field = tt.Field([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ...                  [[2, -1, -1, 0, 0, 0], [1, 1, -2, 0, 0, 0],
    ...                   [1, 1, -2, 0, 0, 1], [1, 0, -1, 0, 1, 0]], [[0, 1, 2, 3]])
    >>> field.mode_surface("1/2")
    Surface(mode=1/2: 7 points, 5 triangles, 1 component, 0 unresolved)
    """

    def __init__(
        self,
        points: Any,
        tensors: Any,
        tets: Any,
        components: str = "vtk",
        vertex_ids: Any = None,
        cell_ids: Any = None,
        *,
        tensor_name: str = "tensor",
        symmetrize: bool = False,
    ) -> None:
        place = real_array(points, "points")
        if place.ndim != 2 or place.shape[1] != 3:
            raise ValueError(f"points: expected shape (n, 3), not {place.shape}")
        rows = tensor_rows(tensors, components, symmetrize)
        if rows.ndim != 2 or len(rows) != len(place):
            raise ValueError(
                f"tensors: expected one for each of {len(place)} points, not shape {rows.shape[:-1]}"
            )
        cells = _index_array(tets, "tets")
        if cells.ndim != 2 or cells.shape[1] != 4:
            raise ValueError(f"tets: expected shape (m, 4), not {cells.shape}")
        ids = np.arange(len(cells)) if cell_ids is None else _ids(cell_ids, len(cells), "cell_ids")
        self._vertex_ids = (
            None if vertex_ids is None else _ids(vertex_ids, len(place), "vertex_ids")
        )
        self.tensor_name: str = tensor_name
        self._take(_core.Mesh(place, rows, cells, ids))

    def _take(self, mesh: _core.Mesh) -> None:
        defects = [Defect(kind, where, text) for kind, where, text in mesh.defects]
        if defects and self._vertex_ids is not None:
            names = self._vertex_ids
            defects = [
                replace(d, where=int(names[d.where]), text=f"{d.text} (id {names[d.where]})")
                if d.kind in _OF_VERTICES
                else d
                for d in defects
            ]
        if defects:
            raise MeshError(defects)
        self._mesh = mesh

    @classmethod
    def _of(cls, mesh: _core.Mesh, tensor_name: str) -> Field:
        field = cls.__new__(cls)
        field._vertex_ids = None
        field.tensor_name = tensor_name
        field._take(mesh)
        return field

    def __reduce__(self) -> tuple[Any, ...]:
        parts = (self.points, self.tensors, self.tets, self.cell_ids, self._vertex_ids)
        return _restored, (*parts, self.tensor_name)

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """Coordinates, shape (n, 3)."""
        return self._mesh.points

    @property
    def tensors(self) -> npt.NDArray[np.float64]:
        """Tensors xx, yy, zz, xy, yz, xz, shape (n, 6)."""
        return self._mesh.tensors

    @property
    def tets(self) -> npt.NDArray[np.int32]:
        """Vertices of each tetrahedron, of positive volume, shape (m, 4)."""
        return self._mesh.tets

    @property
    def cell_ids(self) -> npt.NDArray[np.int64]:
        """What reports call each tetrahedron, shape (m,)."""
        return self._mesh.cell_ids

    @property
    def vertex_ids(self) -> npt.NDArray[np.int64]:
        """What reports call each vertex, shape (n,)."""
        return np.arange(len(self.points)) if self._vertex_ids is None else self._vertex_ids

    @property
    def reoriented(self) -> int:
        """How many tetrahedra were given with negative volume."""
        return self._mesh.reoriented

    @property
    def sha256(self) -> str:
        """The hash of the numbers, by which a certificate names the field."""
        return self._mesh.sha256()

    def mode_surface(
        self,
        mode: Union[Mode, Sequence[Mode]],
        generalized: bool = False,
        resolution: float = 4,
        max_error: Optional[float] = None,
        certify: bool = False,
        uncertainty: Union[None, float, str, npt.ArrayLike] = None,
        progress: Optional[Progress] = None,
        *,
        all_samples: bool = False,
        improve: bool = False,
        method: str = "bisection",
        strict: bool = False,
    ) -> Surface:
        """The surface on which the field has a mode.

        Its topology in every edge, face and tetrahedron is decided by proofs on exact signs. The
        level is mode + 0 where a vertex has the mode exactly.

        Parameters
        ----------
        mode : str, int, float, Fraction or Decimal, or several
            Strictly between -1 and 1, exactly; see `exact_mode`. Of several, all surfaces, one after
            the other, as in a file that the program writes.
        generalized : bool, default False
            After each mode also the opposite one.
        resolution : float, default 4
            Samples per radian of turning of the medium eigenvector.
        max_error : float, optional
            Refine until the distance between triangles and level is proved to be at most this, in the
            unit of the points.
        certify : bool, default False
            Also make a certificate, for `check`. It is about the tensors in VTK's order, in which `write`
            writes them.
        uncertainty : float, str or array_like, shape (n,), optional
            Also say what is the same for every field whose deviators differ by at most so much, in the
            Frobenius norm, at the vertices: in the unit of the tensors; ``"1%"`` of each vertex' own
            deviator; or a radius for each vertex (of which no certificate claims anything). See
            `Surface.stable`.
        progress : callable, optional
            Called as ``progress(stage, fraction)``, some twenty times a second at most; the fraction
            is that of the stage, and begins again where a stage has several passes. If it returns
            False, or raises, the extraction ends.
        all_samples : bool, default False
            Keep samples of face curves that make needles of triangles.
        improve : bool, default False
            Better angles, the same topology.
        method : {"bisection", "manifold"}
            How sheets that turn far are meshed: by bisection of edges, or on the medium eigenvector
            manifold, as in the paper. ("graph" is the old name of the former, deprecated.)
        strict : bool, default False
            Raise if a cell stays unresolved, ``max_error`` is not proved somewhere, the mesh is torn
            (faces lie on others without being shared), or the deviator is zero everywhere, so that
            there is no mode. (The program's ``--strict`` also refuses surfaces that are not embedded;
            nothing here looks for that but ``certify=True``.)

        Returns
        -------
        Surface

        Raises
        ------
        ValueError
            For values that make no sense.
        Cancelled
            If ``progress`` returned False.
        UnresolvedError
            If ``strict``, and cells are left out, or ``max_error`` is not proved.
        MeshError
            If ``strict``, and the mesh is torn or the field has no mode.

        Notes
        -----
        The same bits as ``tensortopo extract`` writes, whatever the number of threads. Python's lock is
        released, and Ctrl-C ends the extraction.
        """
        if method not in ("bisection", "manifold", "graph"):
            raise ValueError(f"method: there is no '{method}'; there are bisection, manifold")
        if strict:
            self._require_mode()
        made = self._mesh.surfaces(
            modes=mode_texts(mode),
            generalized=generalized,
            resolution=float(resolution),
            all_samples=all_samples,
            improve=improve,
            manifold=method == "manifold",
            max_error=0.0 if max_error is None else _positive(max_error, "max_error"),
            certify=certify,
            uncertainty=_uncertainty(uncertainty, len(self.points)),
            tensor=self.tensor_name,
            progress=progress,
        )
        surface = Surface(made, self.cell_ids)
        if strict and surface.unresolved:
            raise UnresolvedError(surface.unresolved)
        farther = sum(level.tets_farther for level in surface.levels) if strict else 0
        if farther:
            raise UnresolvedError((), f"max_error is not proved in {farther} tetrahedra")
        return surface

    def _require_mode(self) -> None:
        cells = self._mesh.torn_cells()
        if cells:
            text = f"faces of {len(cells)} cells lie on others without being shared"
            raise MeshError([Defect("torn_faces", cells[0], f"{text} (the first is cell {cells[0]})")])
        if self._mesh.is_isotropic():
            raise MeshError([Defect("isotropic", 0, "the deviator is zero everywhere: no mode")])

    def neutral_surface(self, **options: Any) -> Surface:
        """The surface of mode 0, with the options of `mode_surface`."""
        return self.mode_surface(0, **options)

    def degenerate_curves(
        self,
        kind: str = "both",
        resolution: float = 4,
        certify: bool = False,
        uncertainty: Union[None, float, str, npt.ArrayLike] = None,
        progress: Optional[Progress] = None,
        *,
        strict: bool = False,
    ) -> Curves:
        """The curves on which two eigenvalues are equal.

        Parameters
        ----------
        kind : {"both", "linear", "planar"}
            Linear: mode 1, the two smaller eigenvalues. Planar: mode -1, the two larger ones.
        resolution : float, default 4
            Samples per radian of turning of the dominant eigenvector.
        certify, uncertainty, progress, strict
            As in `mode_surface`; see `Curves.stable`.

        Returns
        -------
        Curves
            With both kinds, first the linear ones.
        """
        if kind not in ("both", "linear", "planar"):
            raise ValueError(f"kind: there is no '{kind}'; there are both, linear, planar")
        if strict:
            self._require_mode()
        made = self._mesh.curves(
            linear=kind != "planar",
            planar=kind != "linear",
            resolution=float(resolution),
            certify=certify,
            uncertainty=_uncertainty(uncertainty, len(self.points)),
            tensor=self.tensor_name,
            progress=progress,
        )
        curves = Curves(made, self.cell_ids)
        if strict and curves.unresolved:
            raise UnresolvedError(curves.unresolved)
        return curves

    def persistence(self, *, progress: Optional[Progress] = None) -> Persistence:
        """At which modes components, loops and voids of the mode's level sets are born and die.

        Every component of {mode >= m} and {mode <= m}, and with these every degenerate curve, and
        every void, with the relative noise that it survives. Of loops the births and deaths, and
        those pairs that are proved. Values are enclosed, and the paths that join critical points are
        proved.

        Parameters
        ----------
        progress : callable, optional
            As in `mode_surface`.

        Returns
        -------
        Persistence
        """
        return persistence_of(self._mesh.persistence(progress))

    def sweep(
        self,
        start: Mode,
        stop: Mode,
        samples: int = 2,
        *,
        most_levels: int = 250,
        progress: Optional[Progress] = None,
    ) -> Sweep:
        """Every mode at which the topology of the mode surface changes, and what it is between.

        Parameters
        ----------
        start, stop : str, int, float, Fraction or Decimal
            start < stop.
        samples : int, default 2
            Levels extracted at evenly spaced modes, the ends included (but not -1 and 1).
        most_levels : int, default 250
            A level is extracted in each interval between changes if there are no more of them than
            this, else in the widest five.
        progress : callable, optional
            As in `mode_surface`.

        Returns
        -------
        Sweep
        """
        if samples < 2:
            raise ValueError("samples: at least 2")
        if most_levels < 0:
            raise ValueError("most_levels: at least 0")
        made = self._mesh.sweep(mode_text(start), mode_text(stop), samples, most_levels, progress)
        return sweep_of(made)

    def __repr__(self) -> str:
        return f"Field({len(self.points)} points, {len(self.tets)} tetrahedra)"


def _uncertainty(
    value: Union[None, float, str, npt.ArrayLike], vertices: int
) -> Union[None, float, str, list[float]]:
    if value is None or isinstance(value, str):
        return value
    if np.ma.is_masked(value):
        raise ValueError("uncertainty: some are masked; fill them")
    radii = np.asarray(value, dtype=np.float64)
    if radii.ndim == 0:
        return float(radii)
    if radii.shape != (vertices,):
        raise ValueError(f"uncertainty: must be a number, or one for each of {vertices} vertices")
    return [float(radius) for radius in radii]


def _positive(value: float, name: str) -> float:
    error = ValueError(f"{name}: must be a positive number")
    if isinstance(value, (bool, str, bytes)):
        raise error
    try:
        number = float(value)
    except (OverflowError, TypeError):
        raise error from None
    if not 0 < number < float("inf"):
        raise error
    return number


