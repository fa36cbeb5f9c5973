# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Tensors of cells become tensors of nodes."""
import numpy as np
import pytest

import tensortopo as tt


def mesh_of(seed=3):
    field = tt.generate("complex").field
    stresses = np.random.default_rng(seed).normal(size=(len(field.tets), 4, 6))
    return np.array(field.points), np.array(field.tets, dtype=np.int64), stresses


def means(points, cells, values, weights):
    """At each node, by sums of numpy."""
    sums, total = np.zeros((len(points), 6)), np.zeros(len(points))
    np.add.at(sums, cells, weights[:, None, None] * values)
    np.add.at(total, cells, weights[:, None])
    return sums / total[:, None]


@pytest.mark.parametrize("at", ["nodes", "integration points"])
@pytest.mark.parametrize("weights", [None, "volume"])
def test_means_are_those_of_numpy(at, weights):
    points, cells, stresses = mesh_of()
    average = tt.nodal_average(points, cells, stresses, at=at, weights=weights)
    values = stresses if at == "nodes" else stresses.mean(axis=1, keepdims=True).repeat(4, axis=1)
    corners = points[cells]
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    expected = means(points, cells, values, np.ones(len(cells)) if weights is None else volumes)
    assert np.allclose(average.tensors, expected, atol=1e-13)
    assert np.array_equal(average.cells, cells) and np.array_equal(average.points, points)
    assert len(tt.Field(average.points, average.tensors, average.cells).points) == len(points)


def test_no_mean_is_taken_over_two_materials():
    points, cells, stresses = mesh_of()
    material = (points[cells].mean(axis=(1, 2)) > points.mean()).astype(int)
    average = tt.nodal_average(points, cells, stresses, at="nodes", materials=material)
    owners = [set(material[(average.cells == v).any(axis=1)]) for v in range(len(average.points))]
    assert all(len(owner) == 1 for owner in owners)
    assert len(average.points) > len(points)
    assert np.array_equal(average.points, points[average.origin])
    for m in (0, 1):
        own = material == m
        alone = tt.nodal_average(points, cells[own], stresses[own], at="nodes")
        nodes = average.cells[own]
        assert np.array_equal(average.tensors[nodes], alone.tensors[alone.cells])


def test_orders_and_matrices_are_taken_as_elsewhere():
    points, cells, stresses = mesh_of()
    names = ("xx", "yy", "zz", "xy", "yz", "xz")
    voigt = stresses[..., [names.index(c) for c in tt.COMPONENT_ORDERS["voigt"]]]
    one = tt.nodal_average(points, cells, stresses, at="nodes").tensors
    assert np.array_equal(
        one, tt.nodal_average(points, cells, voigt, at="nodes", components="voigt").tensors
    )
    matrices = stresses[..., [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(len(cells), 4, 3, 3)
    assert np.array_equal(one, tt.nodal_average(points, cells, matrices, at="nodes").tensors)


@pytest.mark.parametrize(
    "change, says",
    [
        (dict(at="gauss"), "at: expected"),
        (dict(tensors=np.zeros((2, 4, 6))), "tensors: expected shape"),
        (dict(tensors=np.full((1, 4, 6), np.nan)), "tensors: a number is not finite"),
        (dict(tensors=np.zeros((1, 3, 6))), "cells have 4 nodes and 3 tensors"),
        (dict(cells=[[0, 1, 2, 4]]), "numbered from 0 to 3"),
        (dict(cells=[[0, 1, 2, -1]]), "numbered from 0 to 3"),
        (dict(weights=[0.0]), "positive"),
        (dict(weights="mass"), "'volume'"),
        (dict(materials=[1, 2]), "materials: expected shape"),
    ],
)
def test_what_cannot_be_averaged_is_refused(change, says):
    one = dict(
        points=[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
        cells=[[0, 1, 2, 3]],
        tensors=np.zeros((1, 4, 6)),
        at="nodes",
    )
    tt.nodal_average(**one)
    with pytest.raises(ValueError, match=says):
        tt.nodal_average(**{**one, **change})
