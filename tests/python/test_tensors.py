# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Laws of the vectorised tensor functions."""
import numpy as np
import pytest

import tensortopo as tt


def random_matrices(count=1000, seed=1):
    m = np.random.default_rng(seed).normal(size=(count, 3, 3))
    return m + np.swapaxes(m, 1, 2)


def random_rotations(count, seed=2):
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(count, 3, 3)))
    return q


def test_the_mode_is_what_its_definition_says():
    t = random_matrices()
    d = t - np.trace(t, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    expected = 3 * np.sqrt(6) * np.linalg.det(d) / np.linalg.norm(d, axis=(1, 2)) ** 3
    assert np.allclose(tt.mode(t), expected, atol=1e-13)
    assert np.allclose(tt.lode_angle(t), np.arccos(np.clip(expected, -1, 1)) / 3, atol=1e-6)
    assert np.allclose(tt.deviator(t), d, atol=1e-14)


def test_rotations_factors_and_traces_do_not_change_the_mode():
    t = random_matrices()
    q = random_rotations(len(t))
    turned = q @ t @ np.swapaxes(q, 1, 2)
    turned = (turned + np.swapaxes(turned, 1, 2)) / 2
    assert np.allclose(tt.mode(turned), tt.mode(t), atol=1e-12)
    assert np.array_equal(tt.mode(4 * t), tt.mode(t))
    assert np.array_equal(tt.mode(-t), -tt.mode(t))


@pytest.mark.parametrize("power", [-1000, 1022])
def test_tensors_of_any_size_have_a_mode(power):
    t = random_matrices()
    t /= np.abs(t).max(axis=(1, 2))[:, None, None]
    factor = 2.0**power
    assert np.array_equal(tt.mode(factor * t), tt.mode(t))
    assert np.array_equal(tt.lode_angle(factor * t), tt.lode_angle(t))
    assert np.array_equal(tt.deviator(factor * t), factor * tt.deviator(t))


def test_eigensystems():
    t = random_matrices()
    values, vectors = tt.eigen(t)
    assert np.allclose(values, np.linalg.eigvalsh(t)[:, ::-1], atol=1e-13)
    assert np.allclose(np.einsum("nk,nki,nkj->nij", values, vectors, vectors), t, atol=1e-13)
    assert np.allclose(np.linalg.det(vectors), 1)


@pytest.mark.parametrize("order", tt.COMPONENT_ORDERS)
def test_orders_are_the_same_tensor(order):
    t = random_matrices(50)
    place = {"x": 0, "y": 1, "z": 2}
    rows = np.stack([t[:, place[c[0]], place[c[1]]] for c in tt.COMPONENT_ORDERS[order]], axis=1)
    assert np.array_equal(tt.mode(rows, components=order), tt.mode(t))
    d = np.stack(
        [tt.deviator(t)[:, place[c[0]], place[c[1]]] for c in tt.COMPONENT_ORDERS[order]], axis=1
    )
    assert np.array_equal(tt.deviator(rows, components=order), d)


def test_shapes_follow_the_input():
    assert tt.mode(np.zeros((2, 5, 6))).shape == (2, 5)
    assert tt.mode([2, -1, -1, 0, 0, 0]) == 1
    assert tt.eigen(np.eye(3))[1].shape == (3, 3)
    assert tt.mode(np.zeros((0, 6))).shape == (0,)


def test_isotropic_and_infinite_tensors_have_no_mode():
    assert np.isnan(tt.mode([1, 1, 1, 0, 0, 0]))
    assert np.isnan(tt.lode_angle(7 * np.eye(3)))
    assert np.isnan(tt.mode([np.inf, 1, 1, 0, 0, 0]))


def test_what_is_no_tensor_is_refused():
    for bad in (np.zeros(5), np.zeros((3, 2)), "text", np.zeros((2, 6), complex)):
        with pytest.raises(ValueError):
            tt.mode(bad)
    with pytest.raises(ValueError, match="not symmetric"):
        tt.mode([[0, 1, 0], [0, 0, 0], [0, 0, 1]])
    with pytest.raises(ValueError, match="an order of six"):
        tt.mode(np.eye(3), components="voigt")
    with pytest.raises(ValueError, match="no order"):
        tt.mode(np.zeros(6), components="other")
    masked = np.ma.array([[1.0, 0, -1, 0, 0, 0], [9, 1, 2, 3, 4, 5]], mask=[[0] * 6, [1] * 6])
    with pytest.raises(ValueError, match="masked"):
        tt.mode(masked)
    assert tt.mode(masked[:1])[0] == 0


def test_integers_are_taken_exactly_or_refused():
    exact = [0, 2**53, -(2**53), 2**60, -(2**63), 3 * 2**61]
    inexact = [2**53 + 1, -(2**53) - 1, 2**60 + 1, 2**63 - 1]
    for number in exact:
        tensor = np.array([[number, 0, 0, 0, 0, 0]], dtype=np.int64 if number < 2**62 else np.uint64)
        assert tt.mode(tensor).shape == (1,)
    for number in inexact:
        with pytest.raises(ValueError, match=f"no double is {number}"):
            tt.mode(np.array([[number, 0, 0, 1, 0, 0]], dtype=np.int64))
    with pytest.raises(ValueError, match="no double is 18446744073709551615"):
        tt.mode(np.array([[2**64 - 1, 0, 0, 1, 0, 0]], dtype=np.uint64))
