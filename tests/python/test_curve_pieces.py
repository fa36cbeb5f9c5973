# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A field in pieces gives the degenerate curves of the whole."""
import pickle

import numpy as np
import pytest
from conftest import FAR, pieces_of

import tensortopo as tt


def curve_pieces(field, owner, kind):
    return pieces_of(field, owner, lambda piece, *about: tt.extract_curve_piece(piece, kind, *about))


@pytest.fixture(scope="module")
def owner(slab):
    return np.random.default_rng(3).integers(0, 3, len(slab.tets))


@pytest.mark.parametrize("kind", ["linear", "planar"])
def test_pieces_give_the_curves_of_the_whole(slab, owner, kind):
    whole = slab.degenerate_curves(kind)
    pieces = list(curve_pieces(slab, owner, kind))
    merged = tt.merge_curve_pieces(reversed(pieces))
    assert merged.certificate is None
    certified = tt.merge_curve_pieces(pieces, certify=tt.CertifiedField(len(slab.points), slab.sha256))
    assert b'"polylines"' in (certified.certificate or b"")
    assert len(whole) > 20
    for name in ("points", "offsets", "connectivity", "dominant_eigenvectors", "mode", "residual", "separation",
                 "carrier", "component"):  # fmt: skip
        assert getattr(merged, name).tobytes() == getattr(whole, name).tobytes(), name
    assert np.array_equal(merged.cell_ids, FAR + whole.tet)
    assert [cell for cell, _ in merged.unresolved] == [FAR + cell.tet for cell in whole.unresolved]
    assert [line.tolist() for line in merged.lines] == [line.tolist() for line in whole.lines]


def test_merged_curves_are_checked(slab, owner):
    pieces = list(pieces_of(slab, owner, lambda piece, *about: tt.extract_curve_piece(piece, "linear", *about), far=0))
    known = tt.CertifiedField(len(slab.points), slab.sha256, slab.tensor_name)
    merged = tt.merge_curve_pieces(pieces, certify=known)
    assert tt.check(slab, merged).status == "certified"
    with pytest.raises(ValueError, match="there is none"):
        tt.check(slab, tt.merge_curve_pieces(pieces))


@pytest.mark.parametrize("kind", ["linear", "planar"])
def test_seams_number_the_components_of_the_whole(slab, owner, kind):
    whole = slab.degenerate_curves(kind)
    pieces = list(curve_pieces(slab, owner, kind))
    joined = tt.join_curve_seams([pickle.loads(pickle.dumps(tt.curve_seam_of(piece))) for piece in pieces])
    (level,) = whole.levels
    assert len(joined.lines) == level.components == whole.component.max() + 1
    assert joined.vertices.sum() == len(whole.points)
    assert joined.closed_components == level.closed_components
    assert np.array_equal(joined.lines, np.bincount(whole.component))
    found = [(cell - FAR, number) for piece, numbers in zip(pieces, joined.numbers)
             for cell, number in zip(piece.cell_ids.tolist(), numbers[piece.component].tolist())]  # fmt: skip
    assert sorted(found) == sorted(zip(whole.tet.tolist(), whole.component.tolist()))


def test_pieces_that_do_not_fit_are_refused(slab, owner):
    first, second, third = curve_pieces(slab, owner, "linear")
    _, planar, _ = curve_pieces(slab, owner, "planar")
    moved = tt.PieceCurves({**second.arrays, "separation": second.arrays["separation"] + 1})
    for put_together in (tt.merge_curve_pieces, lambda all: tt.join_curve_seams(map(tt.curve_seam_of, all))):
        put_together([first, second, third])
        with pytest.raises(ValueError, match="a piece is missing"):
            put_together([first, third])
        with pytest.raises(ValueError, match="is owned by two pieces"):
            put_together([first, second, second, third])
        with pytest.raises(ValueError, match="extract one kind from all"):
            put_together([first, planar, third])
        with pytest.raises(tt.PiecesDiffer, match="at the simplex of vertices"):
            put_together([first, moved, third])
    with pytest.raises(ValueError, match="seam are not what they should be"):
        tt.join_curve_seams([tt.CurveSeam(tt.curve_seam_of(first).numbers[:-1])])
    short = tt.PieceCurves({**second.arrays, "connectivity": second.arrays["connectivity"][:-1]})
    with pytest.raises(ValueError, match="the lines of one are not what they should be"):
        tt.merge_curve_pieces([short])
    far = tt.PieceCurves({**second.arrays, "tet": second.arrays["tet"] + 10**6})
    with pytest.raises(ValueError, match="do not fit each other"):
        tt.merge_curve_pieces([far])
    with pytest.raises(ValueError, match="kind: a piece is of one kind"):
        tt.extract_curve_piece(slab, "both", owner == 0, np.arange(len(slab.points)), len(slab.tets))
