# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Tensors of cells, averaged to nodes."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._field import _ids, _index_array
from ._tensors import real_array, tensor_rows


class NodalAverage(NamedTuple):
    """Tensors at nodes, as `nodal_average` gives them.

    Attributes
    ----------
    points : ndarray, shape (n, 3)
        The places of the nodes: those given, then those added between materials.
    tensors : ndarray, shape (n, 6)
        xx, yy, zz, xy, yz, xz at each node; zero at nodes without a cell.
    cells : ndarray of int, shape (m, k)
        The nodes of each cell, with the nodes added.
    origin : ndarray of int, shape (n,)
        The given node whose place each node has.
    """

    points: npt.NDArray[np.float64]
    tensors: npt.NDArray[np.float64]
    cells: npt.NDArray[np.int64]
    origin: npt.NDArray[np.int64]


def _volumes(place: npt.NDArray[np.float64], nodes: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
    if nodes.shape[1] not in (4, 10):
        raise ValueError(
            f"weights: the volume of cells with {nodes.shape[1]} nodes is not known here; "
            "give one number for each cell"
        )
    corners = place[nodes[:, :4]]
    edges = corners[:, 1:] - corners[:, :1]
    volumes: npt.NDArray[np.float64] = np.abs(np.linalg.det(edges)) / 6
    return volumes


def nodal_average(
    points: Any,
    cells: Any,
    tensors: Any,
    *,
    at: str,
    weights: Any = None,
    materials: Any = None,
    components: str = "vtk",
) -> NodalAverage:
    """Means at nodes of tensors at integration points, or at the nodes of elements.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        The places of the nodes.
    cells : array_like of int, shape (m, k)
        The nodes of each cell, of any kind of cell.
    tensors : array_like, shape (m, p, 6) or (m, p, 3, 3)
        The p symmetric tensors of each cell.
    at : {"nodes", "integration points"}
        Whether the tensors of a cell are at its nodes, in their order (then p = k), or at integration
        points, of which a cell has the plain mean first.
    weights : "volume" or array_like, shape (m,), optional
        What cells count for: their volumes (of tetrahedra with 4 or 10 nodes), or one positive number
        for each. Without it all count the same.
    materials : array_like of int, shape (m,), optional
        The material of each cell. Means are never taken over several: a node between materials
        becomes one for each. Without it all cells are of one material.
    components : str, default "vtk"
        The order of six components, as in `Field`.

    Returns
    -------
    NodalAverage
        ``points``, ``tensors`` and ``cells`` are what `Field` takes where cells are tetrahedra.

    Raises
    ------
    ValueError
        For arrays of another shape, nodes that do not exist, weights that are not positive, or numbers
        that are not finite.

    Examples
    --------
    >>> import tensortopo as tt
    >>> points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
    >>> average = tt.nodal_average(points, [[0, 1, 2, 3], [1, 2, 3, 4]],
    ...                            [[[2, -1, -1, 0, 0, 0]], [[0, 1, -1, 0, 0, 0]]],
    ...                            at="integration points")
    >>> average.tensors[1:, 0]
    array([1., 1., 1., 0.])
    """
    place = real_array(points, "points")
    if place.ndim != 2 or place.shape[1] != 3:
        raise ValueError(f"points: expected shape (n, 3), not {place.shape}")
    nodes = _index_array(cells, "cells")
    if nodes.ndim != 2 or nodes.shape[1] == 0:
        raise ValueError(f"cells: expected shape (m, k), not {nodes.shape}")
    if nodes.size > 0 and not (0 <= nodes.min() and nodes.max() < len(place)):
        raise ValueError(f"cells: nodes are numbered from 0 to {len(place) - 1}")
    if at not in ("nodes", "integration points"):
        raise ValueError(f"at: expected 'nodes' or 'integration points', not {at!r}")
    rows = tensor_rows(tensors, components)
    if rows.ndim != 3 or len(rows) != len(nodes) or rows.shape[1] == 0:
        raise ValueError(f"tensors: expected shape ({len(nodes)}, p, 6), not {rows.shape}")
    if at == "nodes" and rows.shape[1] != nodes.shape[1]:
        raise ValueError(
            f"tensors: cells have {nodes.shape[1]} nodes and {rows.shape[1]} tensors each"
        )
    weight: Optional[npt.NDArray[np.float64]] = None
    if isinstance(weights, str):
        if weights != "volume":
            raise ValueError(f"weights: expected 'volume' or numbers, not {weights!r}")
        weight = _volumes(place, nodes)
    elif weights is not None:
        weight = real_array(weights, "weights")
    if weight is not None and (weight.shape != (len(nodes),) or not (weight > 0).all()):
        raise ValueError(f"weights: expected {len(nodes)} positive numbers")
    for name, values in (("points", place), ("tensors", rows), ("weights", weight)):
        if values is not None and not np.isfinite(values).all():
            raise ValueError(f"{name}: a number is not finite")
    material = None if materials is None else _ids(materials, len(nodes), "materials")
    means, own, origin = _core.nodal_average(
        len(place), nodes, rows.reshape(-1, 6), rows.shape[1], at == "nodes", weight, material
    )
    return NodalAverage(place[origin], means, own.reshape(nodes.shape), origin)
