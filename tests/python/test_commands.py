# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Sweeps, generated fields and statements."""
import json

import numpy as np
import pytest

import tensortopo as tt


def test_generated_fields_are_those_of_the_program(program, tmp_path):
    compared = 0
    for kind in ("linear", "planar-extrema", "nongeneric", "complex"):
        assert kind in tt.field_kinds()
        program("generate", kind, "-o", tmp_path / "f.vtu", "--field-only", "--seed", 3)
        made = tt.generate(kind, seed=3)
        assert made.field.sha256 == tt.read(tmp_path / "f.vtu").sha256
        assert made.note and made.modes
        compared += 1
    assert compared == 4
    with pytest.raises(ValueError, match="no 'other'; there are linear, "):
        tt.generate("other")


def test_a_sweep_is_that_of_the_program(program, tmp_path):
    field = tt.generate("complex", seed=1).field
    tt.write(tmp_path / "f.vtu", field)
    theirs = json.loads(program("analyze", tmp_path / "f.vtu", "--sweep=-0.5:0.5:3", "--json", "--quiet"))
    ours = field.sweep(-0.5, 0.5, 3)
    assert len(ours.events) > 3 and not ours.contradictions
    assert ours.complete == theirs["complete"]
    assert len(ours.events) == len(theirs["events"])
    for mine, other in zip(ours.events, theirs["events"]):
        assert (mine.low, mine.high) == (other["low"], other["high"])
        assert [p.change for p in mine.points] == [p["change"] for p in other["points"]]
    assert len(ours.intervals) == len(ours.events) + 1
    lows = [event.low for event in ours.events]
    assert lows == sorted(lows)
    # Between events the Euler characteristic changes by what the events say.
    compared = 0
    for before, event, after in zip(ours.intervals, ours.events, ours.intervals[1:]):
        if None not in (before.euler_characteristic, event.euler_change, after.euler_characteristic):
            change = after.euler_characteristic - before.euler_characteristic
            assert change == event.euler_change
            compared += 1
    assert compared > 3


def test_persistence_is_that_of_the_program(program, slab, slab_file):
    theirs = json.loads(program("analyze", slab_file, "--persistence", "--json", "--quiet"))
    ours = slab.persistence()
    assert len(ours.pairs) == len(theirs["pairs"]) > 50
    assert ours.complete == theirs["complete"]
    for pair, other in zip(ours.pairs, theirs["pairs"]):
        for key in (
            "dimension", "kind", "birth", "death", "survives", "birth_tet", "death_tet", "curve",
            "lasting", "tie", "certain",
        ):
            assert getattr(pair, key) == other[key]
        low, high = pair.birth_range
        assert low <= pair.birth <= high
    assert {pair.dimension for pair in ours.pairs} >= {0, 2}
    assert len(ours.loops) == len(theirs["loops"]) > 50
    for event, other in zip(ours.loops, theirs["loops"]):
        for key in ("kind", "event", "mode", "count", "paired", "tet", "curve", "tie"):
            assert getattr(event, key) == other[key]
    for kind in ("superlevel", "sublevel"):
        intervals = getattr(ours, kind + "_betti")
        assert len(intervals) == len(theirs["betti"][kind]) > 50
        for interval, other in zip(intervals, theirs["betti"][kind]):
            assert (interval.low, interval.high) == (other["from"], other["to"])
            assert list(interval.betti) == other["betti"]
    assert list(ours.mesh_betti) == theirs["betti"]["mesh"]
    assert len(ours.curves) == len(theirs["curves"]) > 5
    for curve, other in zip(ours.curves, theirs["curves"]):
        assert (curve.mode, curve.component, curve.pair) == (other["mode"], other["component"], other["pair"])
        assert ours.pairs[curve.pair].birth == curve.mode or ours.pairs[curve.pair].kind == "extended"


def test_bad_sweeps_are_value_errors(slab):
    for arguments in ((0.5, 0.1), (0, 0.5, 1), ("x", 1)):
        with pytest.raises(ValueError):
            slab.sweep(*arguments)


def test_conformance(program, slab):
    ours = slab.mode_surface("1/2")
    score = tt.conformance(slab, "1/2", ours.points, ours.triangles)
    assert score["conforms"] and score["components"]["matched"] == len(ours.components)
    # Without its first component's triangles something is missed.
    rest = ours.triangles[ours.component != 0]
    assert tt.conformance(slab, "1/2", ours)["conforms"] == score["conforms"]
    score = tt.conformance(slab, "1/2", ours.points, rest)
    assert not score["conforms"] and len(score["components"]["missed"]) == 1
    with pytest.raises(ValueError, match="does not exist"):
        tt.conformance(slab, "1/2", ours.points[:5], ours.triangles)
    with pytest.raises(tt.FileError, match="nowhere"):
        tt.conformance(slab, "1/2", ours.points, ours.triangles, program="/nowhere/tensortopo")


def test_statements():
    ids = ["characteristic-tensor", "complex-domain-vectors"]
    tried = tt.verify(ids, fields=5)
    assert [statement.id for statement in tried] == ids
    for statement in tried:
        assert statement.verdict in ("holds", "corrected") and statement.claim and statement.tried > 0
    with pytest.raises(ValueError, match="no 'nothing'"):
        tt.verify("nothing")


def test_statements_have_the_papers_numbers():
    by_number, by_text = tt.verify(1, fields=5), tt.verify(["1"], fields=5)
    assert [s.id for s in by_number] == [s.id for s in by_text]
    assert by_number and {s.paper for s in by_number}


def test_linear_fields_from_numpy(tetrahedron):
    """A field that numpy makes has the mode that numpy computes on its surface."""
    rng = np.random.default_rng(5)
    points, _, tets = tetrahedron
    compared = 0
    for _ in range(20):
        tensors = rng.normal(size=(4, 6))
        surface = tt.Field(points, tensors, tets).mode_surface(0.3)
        if not len(surface.points):
            continue
        p = surface.points
        weights = np.column_stack([1 - p.sum(axis=1), p])
        assert np.allclose(tt.mode(weights @ tensors), 0.3, atol=1e-9)
        compared += len(p)
    assert compared > 100
