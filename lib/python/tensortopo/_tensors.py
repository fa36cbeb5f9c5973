# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Symmetric tensors as rows of numbers."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core

Array = npt.NDArray[np.float64]

# What each order's six numbers are.
COMPONENT_ORDERS = {
    "vtk": ("xx", "yy", "zz", "xy", "yz", "xz"),
    "voigt": ("xx", "yy", "zz", "yz", "xz", "xy"),
    "abaqus": ("xx", "yy", "zz", "xy", "xz", "yz"),
    "mrtrix": ("xx", "yy", "zz", "xy", "xz", "yz"),
    "nifti": ("xx", "xy", "yy", "xz", "yz", "zz"),
    "dipy": ("xx", "xy", "yy", "xz", "yz", "zz"),
    "fsl": ("xx", "xy", "xz", "yy", "yz", "zz"),
}
_ASYMMETRY = 1e-9  # of the norm: rounding by whoever wrote the tensors


def real_array(values: Any, name: str) -> Array:
    """Real numbers as doubles, exactly."""
    if np.ma.is_masked(values):
        raise ValueError(f"{name}: some are masked; leave them out, or fill them")
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: expected real numbers, not {array.dtype}")
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        raise ValueError(f"{name}: {array.dtype} holds more than a double")
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        large = array[(array > 2**53) | (array < -(2**53))].tolist()
        inexact = next((x for x in large if int(float(x)) != x), None)
        if inexact is not None:
            raise ValueError(f"{name}: no double is {inexact}; round what is to be rounded yourself")
    return np.ascontiguousarray(array, dtype=np.float64)


def _from_matrices(matrices: Array, symmetrize: bool) -> Array:
    norms = np.sqrt(np.einsum("...ij,...ij", matrices, matrices))
    gaps = np.abs(matrices - np.swapaxes(matrices, -1, -2)).max(axis=(-1, -2), initial=0)
    bad = gaps > _ASYMMETRY * norms
    if bad.any() and not symmetrize:
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        if not where:
            raise ValueError("tensors: the matrix is not symmetric")
        index = where[0] if len(where) == 1 else where
        raise ValueError(f"tensors: the matrix {index} is not symmetric (symmetrize=True takes means)")
    rows = np.empty(matrices.shape[:-2] + (6,))
    for k, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))):
        a, b = matrices[..., i, j], matrices[..., j, i]
        rows[..., k] = np.where(a == b, a, a / 2 + b / 2)
    return rows


def tensor_rows(tensors: Any, components: str = "vtk", symmetrize: bool = False) -> Array:
    """Tensors of shape (..., 6) or (..., 3, 3) as rows xx, yy, zz, xy, yz, xz."""
    array = real_array(tensors, "tensors")
    if array.ndim >= 2 and array.shape[-2:] == (3, 3):
        if components != "vtk":
            raise ValueError(f"components: '{components}' is an order of six, and these are matrices")
        return _from_matrices(array, symmetrize)
    if array.ndim < 1 or array.shape[-1] != 6:
        raise ValueError("tensors: expected shape (..., 6) or (..., 3, 3), not " + str(array.shape))
    if not isinstance(components, str) or components not in COMPONENT_ORDERS:
        known = ", ".join(COMPONENT_ORDERS)
        raise ValueError(f"components: there is no order '{components}'; there are {known}")
    order = COMPONENT_ORDERS[components]
    if order == COMPONENT_ORDERS["vtk"]:
        return array
    return np.ascontiguousarray(array[..., [order.index(c) for c in COMPONENT_ORDERS["vtk"]]])


def _flat(tensors: Any, components: str) -> tuple[Array, tuple[int, ...]]:
    rows = tensor_rows(tensors, components)
    return rows.reshape(-1, 6), rows.shape[:-1]


def mode(tensors: Any, *, components: str = "vtk") -> Array:
    """The mode ``3 sqrt(6) det(D) / |D|^3`` of each tensor's deviator D.

    Parameters
    ----------
    tensors : array_like, shape (..., 6) or (..., 3, 3)
        Symmetric tensors.
    components : str, default "vtk"
        The order of six components: ``vtk`` (xx yy zz xy yz xz), ``voigt``, ``abaqus`` = ``mrtrix``,
        ``nifti`` = ``dipy``, or ``fsl``.

    Returns
    -------
    ndarray, shape (...)
        In [-1, 1]; not a number for isotropic tensors, which have no mode.

    Notes
    -----
    Invariant under rotations and positive factors; the opposite tensor has the opposite mode. Next to
    1 and -1 it cannot separate tensors that are closer to degenerate than 1e-8: see `lode_angle`.

    Examples
    --------
    >>> import tensortopo as tt
    >>> tt.mode([2, -1, -1, 0, 0, 0])
    array(1.)
    """
    rows, shape = _flat(tensors, components)
    return _core.mode(rows).reshape(shape)


def lode_angle(tensors: Any, *, components: str = "vtk") -> Array:
    """The Lode angle arccos(mode) / 3 of each tensor, in radians.

    Parameters
    ----------
    tensors : array_like, shape (..., 6) or (..., 3, 3)
        Symmetric tensors.
    components : str, default "vtk"
        As in `mode`.

    Returns
    -------
    ndarray, shape (...)
        In [0, pi/3], accurate to a few units in the last place of 1; not a number for isotropic tensors.
    """
    rows, shape = _flat(tensors, components)
    return _core.lode_angle(rows).reshape(shape)


def deviator(tensors: Any, *, components: str = "vtk") -> Array:
    """The deviators T - (trace T / 3) I.

    Parameters
    ----------
    tensors : array_like, shape (..., 6) or (..., 3, 3)
        Symmetric tensors.
    components : str, default "vtk"
        As in `mode`; the result has the same order.

    Returns
    -------
    ndarray
        Of the same shape.
    """
    rows, shape = _flat(tensors, components)
    result = _core.deviator(rows).reshape(shape + (6,))
    if np.ndim(tensors) >= 2 and np.shape(tensors)[-2:] == (3, 3):
        return result[..., [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(shape + (3, 3))
    order = COMPONENT_ORDERS[components]
    return np.ascontiguousarray(result[..., [COMPONENT_ORDERS["vtk"].index(c) for c in order]])


def eigen(tensors: Any, *, components: str = "vtk") -> tuple[Array, Array]:
    """Eigenvalues in descending order, with eigenvectors.

    Parameters
    ----------
    tensors : array_like, shape (..., 6) or (..., 3, 3)
        Symmetric tensors.
    components : str, default "vtk"
        As in `mode`.

    Returns
    -------
    values : ndarray, shape (..., 3)
        The major, medium and minor eigenvalue.
    vectors : ndarray, shape (..., 3, 3)
        ``vectors[..., k, :]`` is the unit eigenvector of ``values[..., k]``; right-handed. The first two
        have their component of largest magnitude positive.
    """
    rows, shape = _flat(tensors, components)
    values, vectors = _core.eigen(rows)
    return values.reshape(shape + (3,)), vectors.reshape(shape + (3, 3))
