# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A field in pieces gives the surface of the whole."""
import pickle

import numpy as np
import pytest
from conftest import FAR, pieces_of

import tensortopo as tt


def surface_pieces(field, owner, mode, far=FAR, **options):
    return pieces_of(field, owner, lambda piece, *about: tt.extract_piece(piece, mode, *about, **options), far)


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
    merged = tt.merge_pieces(reversed(list(surface_pieces(field, owner, mode))))
    assert len(whole.triangles) > 1000
    for name in ("points", "triangles", "normals", "medium_eigenvectors", "dominant_eigenvectors", "mode",
                 "residual", "component"):  # fmt: skip
        assert getattr(merged, name).tobytes() == getattr(whole, name).tobytes(), name
    assert np.array_equal(merged.cell_ids, FAR + whole.tet)
    assert merged.not_embedded == [FAR + tet for tet in whole.levels[0].not_embedded]


@pytest.mark.parametrize("mode", ["0", "-99/100"])
def test_seams_number_the_components_of_the_whole(slab, mode):
    owner = np.random.default_rng(3).integers(0, 3, len(slab.tets))
    whole = slab.mode_surface(mode)
    pieces = list(surface_pieces(slab, owner, mode))
    seams = [pickle.loads(pickle.dumps(tt.seam_of(piece))) for piece in pieces]
    joined = tt.join_seams(seams)
    (level,) = whole.levels
    assert len(joined.triangles) == len(level.components) == whole.component.max() + 1
    assert joined.vertices.sum() == len(whole.points)
    for name in ("euler_characteristic", "boundary_loops", "triangles"):
        assert getattr(joined, name).tolist() == [getattr(part, name) for part in level.components]
    of_cells = {}
    for tet, number in zip(whole.tet.tolist(), whole.component.tolist()):
        of_cells.setdefault(tet, []).append(number)
    compared = 0
    for piece, numbers in zip(pieces, joined.numbers):
        own = numbers[tt.piece_components(piece)]
        ids = piece.arrays["cell_ids"][piece.arrays["tet"]] - FAR
        for cell in np.unique(ids).tolist():
            assert own[ids == cell].tolist() == of_cells[cell]
            compared += 1
    assert compared == len(of_cells) > 500


def test_seams_that_do_not_fit_are_refused(slab):
    middle = np.median(slab.mode_surface("0").points[:, 1])  # the surface crosses the seam
    owner = (slab.points[slab.tets].mean(axis=1)[:, 1] > middle).astype(int)
    first, second = (tt.seam_of(piece) for piece in surface_pieces(slab, owner, "0"))
    _, other = (tt.seam_of(piece) for piece in surface_pieces(slab, owner, "1/100"))
    assert len(tt.join_seams([first, second]).triangles) > 0
    with pytest.raises(ValueError, match="a piece is missing"):
        tt.join_seams([first])
    with pytest.raises(ValueError, match="is owned by two pieces"):
        tt.join_seams([first, first, second])
    with pytest.raises(tt.PiecesDiffer, match="do not meet|they differ|treated alike"):
        tt.join_seams([first, other])
    with pytest.raises(ValueError, match="seam are not what they should be"):
        tt.join_seams([first, tt.SurfaceSeam(second.numbers[:-1])])


def test_the_certificate_is_that_of_the_whole(slab):
    owner = np.random.default_rng(4).integers(0, 3, len(slab.tets))
    whole = slab.mode_surface("1/2", certify=True)
    pieces = list(surface_pieces(slab, owner, "1/2", far=0, certify=True))
    known = tt.CertifiedField(len(slab.points), slab.sha256, slab.tensor_name)
    merged = tt.merge_pieces(pieces, certify=known, mode="1/2")
    assert len(merged.certificate) > 100_000
    assert merged.certificate == whole.certificate
    assert tt.check(slab, merged).refuted == 0
    far = list(surface_pieces(slab, owner, "1/2", certify=True))  # ids of 41 bits
    assert str(FAR).encode()[:4] in tt.merge_pieces(far, certify=known, mode="1/2").certificate
    with pytest.raises(ValueError, match="keep_topology"):
        tt.merge_pieces(surface_pieces(slab, owner, "1/2"), certify=known, mode="1/2")
    proofs = pieces[0].arrays["proofs"]
    for wrong in (proofs[:-1], np.append(proofs, 0), np.where(proofs > 2, 10**6, proofs)):
        broken = tt.PieceSurface({**pieces[0].arrays, "proofs": wrong.astype(np.int32)})
        with pytest.raises(ValueError, match="not what they should be"):
            tt.merge_pieces([broken, *pieces[1:]])


def test_the_hash_of_a_field_in_pieces(slab):
    half = len(slab.points) // 2
    hashed = tt.FieldHash(len(slab.points), len(slab.tets))
    for rows in (slice(half), slice(half, None)):
        hashed.add_points(slab.points[rows])
    hashed.add_tensors(slab.tensors)
    hashed.begin_cells()
    for rows in (slice(100), slice(100, None)):
        hashed.add_cells(slab.tets[rows])
    assert hashed.sha256() == slab.sha256


def test_pieces_that_do_not_fit_are_refused(slab):
    field = slab
    middle = np.median(field.mode_surface("0").points[:, 1])  # the surface crosses the seam
    owner = (field.points[field.tets].mean(axis=1)[:, 1] > middle).astype(int)
    first, second = surface_pieces(field, owner, "0")
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
