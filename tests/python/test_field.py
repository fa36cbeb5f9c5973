# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Fields, what is wrong with them, and what comes out of them."""
import gc
import os
import signal
import threading
import time
from fractions import Fraction

import numpy as np
import pytest

import tensortopo as tt


def test_repr(slab, tetrahedron):
    assert repr(slab).startswith("Field(") and "tetrahedra" in repr(slab)
    assert "Surface(mode=1/2:" in repr(slab.mode_surface(0.5))
    assert "Curves(mode=1, -1:" in repr(slab.degenerate_curves())


def test_defects_are_data(tetrahedron):
    points, tensors, tets = tetrahedron
    with pytest.raises(tt.MeshError) as caught:
        tt.Field(points, tensors, [[0, 1, 2, 2], [0, 1, 2, 7]], cell_ids=[10, 20])
    kinds = {(d.kind, d.where) for d in caught.value.defects}
    assert {("repeated_vertex", 10), ("index_out_of_range", 20)} <= kinds
    assert caught.value.defects[0].text in str(caught.value)
    with pytest.raises(tt.MeshError) as caught:
        tt.Field(points, tensors, tets * 2)
    assert caught.value.defects[0].kind == "duplicated_cell"
    tensors[2] = [float("nan")] * 6
    with pytest.raises(tt.MeshError) as caught:
        tt.Field(points, tensors, tets, vertex_ids=[5, 6, 700, 8])
    assert [(d.kind, d.where) for d in caught.value.defects] == [("non_finite_tensor", 700)]
    assert "700" in str(caught.value)


@pytest.mark.parametrize(
    "change",
    [
        dict(points=np.zeros((4, 2))),
        dict(points=np.zeros((4, 3), complex)),
        dict(tensors=np.zeros((3, 6))),
        dict(tensors=np.zeros((4, 7))),
        dict(tets=[[0, 1, 2]]),
        dict(tets=[[0.0, 1, 2, 3]]),
        dict(tets=np.array([[True, False, True, True]])),
        dict(components="unknown"),
        dict(cell_ids=[1, 2]),
        dict(vertex_ids=[1, 2]),
    ],
)
def test_wrong_arrays_are_value_errors(tetrahedron, change):
    points, tensors, tets = tetrahedron
    arguments = dict(points=points, tensors=tensors, tets=tets)
    arguments.update(change)
    with pytest.raises(ValueError):
        tt.Field(**arguments)


def test_wrong_options_are_value_errors(slab):
    for options in (dict(resolution=0), dict(resolution=float("nan")), dict(max_error=-1),
                    dict(max_error=True), dict(max_error="2"), dict(max_error=10**400),
                    dict(max_error=[2]), dict(method="other"), dict(max_error=1, improve=True)):  # fmt: skip
        with pytest.raises(ValueError):
            slab.mode_surface(0.5, **options)
    with pytest.raises(ValueError):
        slab.mode_surface([])
    with pytest.raises(ValueError):
        slab.degenerate_curves("other")


def test_strict_asks_for_the_distance(slab):
    assert slab.mode_surface(0.5, max_error=1e-30).levels[0].tets_farther > 0
    with pytest.raises(tt.UnresolvedError, match="max_error"):
        slab.mode_surface(0.5, max_error=1e-30, strict=True)


def test_a_cell_of_negative_volume_is_turned_around(tetrahedron):
    points, tensors, _ = tetrahedron
    field = tt.Field(points, tensors, [[0, 1, 3, 2]])
    assert field.reoriented == 1
    assert len(field.mode_surface("1/2").triangles) > 0


def test_types_and_layouts_of_the_input_do_not_matter(tetrahedron):
    points, tensors, tets = tetrahedron
    plain = tt.Field(points, tensors, tets).mode_surface("1/2")
    wide = np.zeros((4, 6), dtype=np.float32)
    wide[:, ::2] = points
    matrices = np.array(tensors)[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3)
    other = tt.Field(wide[:, ::2], matrices, np.array(tets, dtype=np.uint8)).mode_surface("1/2")
    assert plain.points.tobytes() == other.points.tobytes() and len(plain.points) > 3


def test_arrays_are_read_only_views_that_outlive_their_owners(tetrahedron):
    field = tt.Field(*tetrahedron)
    surface = field.mode_surface("1/2")
    points, triangles, place = surface.points, surface.triangles, field.points
    copies = points.copy(), triangles.copy(), place.copy()
    for array in (points, triangles, place, surface.cell_ids, surface.carrier):
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array[0] = 0
    assert not points.flags.owndata and not place.flags.owndata
    del field, surface
    gc.collect()
    for array, copy in zip((points, triangles, place), copies):
        assert np.array_equal(array, copy)


def test_carriers_hold_their_vertices(slab):
    surface = slab.mode_surface(0.5)
    on_edges = surface.carrier == tt.CARRIERS.index("edge")
    assert on_edges.sum() > 100
    ends = surface.carrier_vertices[on_edges]
    assert (ends[:, 2:] == -1).all()
    a, b = slab.points[ends[:, 0]], slab.points[ends[:, 1]]
    p = surface.points[on_edges]
    detour = np.linalg.norm(p - a, axis=1) + np.linalg.norm(p - b, axis=1)
    assert np.allclose(detour, np.linalg.norm(b - a, axis=1), rtol=1e-12)


def test_topology_is_that_of_the_triangles(slab):
    surface = slab.mode_surface("1/2", generalized=True)
    edges = np.sort(surface.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    distinct = len(np.unique(edges, axis=0))
    used = len(np.unique(surface.triangles))
    assert surface.euler_characteristic == used - distinct + len(surface.triangles)
    assert surface.modes == (Fraction(1, 2), Fraction(-1, 2))
    assert sum(level.triangles for level in surface.levels) == len(surface.triangles)
    assert surface.component.max() + 1 == len(surface.components)


def test_unresolved_cells_have_reasons(tetrahedron):
    points, _, tets = tetrahedron
    # The mode is constant.
    field = tt.Field(points, [[1, 0, -1, 0, 0, 0]] * 4, tets, cell_ids=[77])
    surface = field.mode_surface(0)
    assert [(u.cell_id, u.tet, u.mode) for u in surface.unresolved] == [(77, 0, 0)]
    assert surface.unresolved[0].reason == "level_constant_in_cell"
    with pytest.raises(tt.UnresolvedError) as caught:
        field.mode_surface(0, strict=True)
    assert caught.value.unresolved == surface.unresolved


def test_strict_refuses_torn_meshes_and_fields_without_a_mode(tetrahedron):
    points, tensors, tets = tetrahedron
    points = np.array(points, float)
    # A copy mirrored at the face opposite the first vertex: the faces lie on each other, unshared.
    mirrored = np.vstack([points[1:].sum(axis=0) * 2 / 3 - points[0], points[1:]])
    torn = tt.Field(
        np.vstack([points, mirrored]), np.vstack([tensors, tensors]), [[0, 1, 2, 3], [4, 5, 6, 7]]
    )
    assert len(torn.mode_surface(0.5).unresolved) == 0
    with pytest.raises(tt.MeshError) as caught:
        torn.mode_surface(0.5, strict=True)
    assert [(d.kind, d.where) for d in caught.value.defects] == [("torn_faces", 0)]
    with pytest.raises(tt.MeshError, match="lie on others"):
        torn.degenerate_curves(strict=True)
    isotropic = tt.Field(points, [np.eye(3)] * 4, tets)
    with pytest.raises(tt.MeshError, match="no mode"):
        isotropic.mode_surface(0, strict=True)


def test_progress_is_reported_and_cancels(slab):
    calls = []

    def stop(stage, fraction):
        calls.append((stage, fraction, threading.get_ident()))
        return False

    modes = [Fraction(k, 101) for k in range(-90, 90)]
    with pytest.raises(tt.Cancelled):
        slab.mode_surface(modes, progress=stop)
    assert len(calls) == 1 and calls[0][0].startswith("mode ")
    assert 0 <= calls[0][1] <= 1 and calls[0][2] == threading.get_ident()

    def interrupt(stage, fraction):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        slab.mode_surface(modes, progress=interrupt)
    assert len(slab.mode_surface(0.5).points) > 100


def test_ctrl_c_ends_an_extraction(slab):
    modes = [Fraction(k, 1001) for k in range(-900, 900)]
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        slab.mode_surface(modes)
    timer.join()


def test_other_threads_run_meanwhile(slab):
    ticks, stop = [0], threading.Event()

    def tick():
        while not stop.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        before = ticks[0]
        slab.mode_surface([0.1, 0.2, 0.3, 0.4])
        assert ticks[0] > before
    finally:
        stop.set()
        thread.join()


def test_several_threads_use_one_field(slab):
    expected = {mode: slab.mode_surface(mode).points.tobytes() for mode in (0.2, 0.5)}
    found = []

    def extract(mode):
        found.append(slab.mode_surface(mode).points.tobytes() == expected[mode])

    threads = [threading.Thread(target=extract, args=(mode,)) for mode in (0.2, 0.5, 0.2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [True] * 3


def test_a_field_can_be_pickled(slab):
    import pickle

    again = pickle.loads(pickle.dumps(slab))
    assert again.sha256 == slab.sha256 and again.tensor_name == slab.tensor_name
    assert np.array_equal(again.cell_ids, slab.cell_ids)
    named = tt.Field(slab.points, slab.tensors, slab.tets, vertex_ids=7 + np.arange(len(slab.points)))
    assert np.array_equal(pickle.loads(pickle.dumps(named)).vertex_ids, named.vertex_ids)


def test_any_number_of_threads_gives_the_same_bits(slab):
    surfaces = []
    for count in (1, 2, 5):
        with tt.limit_threads(count):
            surfaces.append(slab.mode_surface("1/2"))
    for surface in surfaces[1:]:
        assert np.array_equal(surface.points, surfaces[0].points)
        assert np.array_equal(surface.triangles, surfaces[0].triangles)
    with pytest.raises(ValueError, match="less than one"):
        with tt.limit_threads(0):
            pass
