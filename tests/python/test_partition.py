# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A field in pieces gives the surface of the whole."""
import pickle

import numpy as np
import pytest

import tensortopo as tt

FAR = 2**40  # ids need 64 bits


def pieces_of(field, owner, mode):
    """As processes would have them: numbered by themselves, and sent as bytes."""
    random = np.random.default_rng(5)
    for part in np.unique(owner):
        near = np.zeros(len(field.points), bool)
        near[field.tets[owner == part].ravel()] = True
        cells = random.permutation(np.flatnonzero(near[field.tets].any(axis=1)))
        vertices = random.permutation(np.unique(field.tets[cells]))
        number = np.full(len(field.points), -1)
        number[vertices] = np.arange(len(vertices))
        piece = tt.Field(field.points[vertices], field.tensors[vertices], number[field.tets[cells]], cell_ids=FAR + cells)
        surface = tt.extract_piece(piece, mode, owner[cells] == part, FAR + vertices, len(field.tets))
        yield pickle.loads(pickle.dumps(surface))


def test_what_is_not_embedded_is_kept(tetrahedron):
    field = tt.Field(*tetrahedron)
    made = tt.extract_piece(field, "1/2", [True], np.arange(4), 1)
    marked = tt.PieceSurface({**made.arrays, "not_embedded": [int(field.cell_ids[0])]})
    assert marked.not_embedded == tt.merge_pieces([marked]).not_embedded == [int(field.cell_ids[0])]


@pytest.mark.parametrize("mode", ["0", "-99/100"])
def test_pieces_give_the_surface_of_the_whole(slab, mode):
    field = slab
    owner = np.random.default_rng(3).integers(0, 3, len(field.tets))
    whole = field.mode_surface(mode)
    merged = tt.merge_pieces(reversed(list(pieces_of(field, owner, mode))))
    assert len(whole.triangles) > 1000
    for name in ("points", "triangles", "normals", "medium_eigenvectors", "dominant_eigenvectors", "mode",
                 "residual", "component"):  # fmt: skip
        assert getattr(merged, name).tobytes() == getattr(whole, name).tobytes(), name
    assert np.array_equal(merged.cell_ids, FAR + whole.tet)
    assert merged.not_embedded == [FAR + tet for tet in whole.levels[0].not_embedded]


def test_pieces_that_do_not_fit_are_refused(slab):
    field = slab
    middle = np.median(field.mode_surface("0").points[:, 1])  # the surface crosses the seam
    owner = (field.points[field.tets].mean(axis=1)[:, 1] > middle).astype(int)
    first, second = pieces_of(field, owner, "0")
    with pytest.raises(ValueError, match="a piece is missing"):
        tt.merge_pieces([first])
    with pytest.raises(ValueError, match="is owned by two pieces"):
        tt.merge_pieces([first, first, second])
    broken = tt.PieceSurface({**first.arrays, "triangles": first.triangles + len(first.points)})
    with pytest.raises(ValueError, match="do not fit"):
        tt.merge_pieces([broken, second])
    other = tt.PieceSurface({**first.arrays, "whole_cells": first.arrays["whole_cells"] - 1})
    with pytest.raises(ValueError, match="not of one mesh"):
        tt.merge_pieces([other, second])
    with pytest.raises(ValueError, match="marks of ownership"):
        tt.extract_piece(field, "0", [True], np.arange(len(field.points)), len(field.tets))
    with pytest.raises(ValueError, match="the whole mesh 1$"):
        tt.extract_piece(field, "0", np.ones(len(field.tets)), np.arange(len(field.points)), 1)
