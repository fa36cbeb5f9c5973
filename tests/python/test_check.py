# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Certificates and their checker."""
import json

import numpy as np
import pytest

import tensortopo as tt


def test_surfaces_and_curves_are_certified(slab):
    surface, verdict = tt.certify(slab, "1/2", generalized=True)
    assert verdict and verdict.certified >= surface.claims > 100
    assert verdict.refuted == verdict.undecided == 0
    assert surface.levels[0].distance_bound > 0
    curves = slab.degenerate_curves("linear", certify=True)
    verdict = tt.check(slab, curves)
    assert verdict.status in ("certified", "undecided") and verdict.unmet == ()


def test_a_forged_certificate_is_refuted(slab):
    surface = slab.mode_surface("1/2", certify=True)
    forged = json.loads(surface.certificate)
    text = json.dumps(forged)
    assert tt.check(slab, surface, text.encode())  # the same numbers in other bytes
    level = forged["levels"][0]
    level["components"][0]["euler_characteristic"] += 1
    verdict = tt.check(slab, surface, json.dumps(forged).encode())
    assert not verdict and verdict.status == "refuted" and verdict.refuted >= 1
    assert verdict.refutations


def test_another_surface_is_refuted(slab):
    one, other = (slab.mode_surface(mode, certify=True) for mode in ("1/2", "2/5"))
    assert tt.check(slab, other, one.certificate).status == "refuted"


def test_demands_that_are_not_met_are_told(slab):
    surface = slab.mode_surface("1/2", certify=True)
    assert tt.check(slab, surface, expect_tensor=slab.tensor_name, expect_complete=True)
    other = tt.check(slab, surface, expect_modes=["1/2", "1/3"])
    assert other.status == "certified" and not other and len(other.unmet) == 1
    assert "1/3" in other.unmet[0] and "1/3" in repr(other)
    assert not tt.check(slab, surface, expect_tensor="another")


def test_what_is_no_certificate_is_an_error(slab):
    surface = slab.mode_surface("1/2")
    with pytest.raises(ValueError, match="certify=True"):
        tt.check(slab, surface)
    with pytest.raises(tt.FileError):
        tt.check(slab, surface, b"{}")


@pytest.mark.parametrize("ids", ["spread", "triangles between"])
def test_fields_with_other_cell_ids_are_certified(slab, ids, tmp_path):
    n = len(slab.tets)
    cell_ids = 3 * np.arange(n) + 7 if ids == "spread" else np.arange(n) + 5
    field = tt.Field(slab.points, slab.tensors, slab.tets, cell_ids=cell_ids)
    surface, curves = field.mode_surface("1/2", certify=True), field.degenerate_curves(certify=True)
    assert set(surface.cell_ids) <= set(cell_ids)
    assert tt.check(field, surface, expect_complete=True)
    assert tt.check(field, curves).refuted == 0
    # Of the positions alone nothing would be right.
    plain = tt.Field(slab.points, slab.tensors, slab.tets)
    assert tt.check(plain, surface).status == "refuted"


@pytest.mark.parametrize("cell_ids", [[1, 0], [0, 0], [0, 10**15]])
def test_cell_ids_that_number_no_file_are_refused(slab, cell_ids):
    field = tt.Field(slab.points, slab.tensors, slab.tets[:2], cell_ids=cell_ids)
    surface = field.mode_surface("1/2", certify=True)
    with pytest.raises(ValueError, match="cell_ids"):
        tt.check(field, surface)
