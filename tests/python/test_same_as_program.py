# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The same surfaces, curves and certificates as the program writes, bit for bit."""
import json
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import tried

import tensortopo as tt
from tensortopo._vtk_xml import read_piece

NAMES = {
    "mode": "mode",
    "medium_eigenvector": "medium_eigenvectors",
    "dominant_eigenvector": "dominant_eigenvectors",
    "normal": "normals",
    "residual": "residual",
    "separation": "separation",
    "crossing_instability": "crossing_instability",
    "crossing_stable": "crossing_stable",
}


def bits(array):
    array = np.ascontiguousarray(array)
    return array.dtype.str, array.shape, array.tobytes()


def require_same(output, file, section):
    piece = read_piece(file)
    assert bits(output.points) == bits(piece.sections["Points"]["Points"].values)
    compared = 0
    for name, array in piece.sections["PointData"].items():
        assert bits(getattr(output, NAMES[name])) == bits(array.values), name
        compared += 1
    assert np.array_equal(output.cell_ids, piece.sections["CellData"]["tet"].values)
    assert np.array_equal(output.component, piece.sections["CellData"]["component"].values)
    cells = output.triangles.ravel() if section == "Polys" else output.connectivity
    assert np.array_equal(cells, piece.sections[section]["connectivity"].values)
    assert compared >= 4 and len(output.points) > 100


@pytest.mark.parametrize(
    "flags, options",
    tried([
        (["--mode", "0.5", "--generalized"], dict(mode=0.5, generalized=True)),
        (["--mode", "0"], dict(mode=0)),
        (["--mode", "9/10", "--improve"], dict(mode="9/10", improve=True)),
        (["--mode", "-0.9", "--all-samples", "--resolution", "6"],
         dict(mode=-0.9, all_samples=True, resolution=6)),
        (["--mode", "0.3", "--max-error", "3"], dict(mode=0.3, max_error=3)),
    ]),
)  # fmt: skip
def test_surfaces(program, slab, slab_file, tmp_path, flags, options):
    file = tmp_path / "s.vtp"
    # 1: --max-error is not reached everywhere.
    program("extract", slab_file, "-o", file, "--quiet", *flags, statuses=(0, 1))
    require_same(slab.mode_surface(**options), file, "Polys")


def test_surface_and_certificate(program, slab, slab_file, tmp_path):
    file, certificate = tmp_path / "s.vtp", tmp_path / "s.json"
    program("extract", slab_file, "-o", file, "--quiet", "--mode", "1/2", "--certify", certificate)
    surface = slab.mode_surface("1/2", certify=True)
    require_same(surface, file, "Polys")
    assert surface.certificate == certificate.read_bytes()


def test_uncertain_surface_and_certificate(program, slab, slab_file, tmp_path):
    file, certificate = tmp_path / "s.vtp", tmp_path / "s.json"
    report = json.loads(
        program("extract", slab_file, "-o", file, "--mode", "0", "--uncertainty", "1%",
                "--certify", certificate, "--json")
    )  # fmt: skip
    surface = slab.mode_surface(0, certify=True, uncertainty="1%")
    require_same(surface, file, "Polys")
    cells = read_piece(file).sections["CellData"]
    assert bits(surface.stable) == bits(cells["stable"].values)
    assert bits(surface.instability) == bits(cells["instability"].values)
    assert 0 < surface.stable.sum() < len(surface.stable)
    assert set(np.unique(surface.crossing_stable)) == {-1, 0, 1}
    assert surface.certificate == certificate.read_bytes()
    assert len(surface.levels[0].not_embedded) == report["surfaces"][0]["not_embedded"]
    expected = report["surfaces"][0]["stability"]
    assert surface.levels[0].stability == {
        key: value for key, value in expected.items() if key not in ("radius", "seconds")
    }
    assert tt.check(slab, surface).status == "certified"
    tt.write(tmp_path / "w.vtp", surface)
    assert tt.check(slab, tmp_path / "w.vtp", certificate).status == "certified"


def test_uncertainty_of_each_vertex(slab):
    plain = slab.mode_surface(0)
    assert plain.stable is None and plain.levels[0].stability is None
    radius = 100.0
    one = slab.mode_surface(0, uncertainty=radius)
    each = slab.mode_surface(0, uncertainty=np.full(len(slab.points), radius))
    assert np.array_equal(one.instability, each.instability)
    assert one.levels[0].stability == each.levels[0].stability
    for wrong in (-1.0, float("nan"), "many", "-1%", [1.0, 2.0]):
        with pytest.raises(ValueError, match="uncertainty|neither"):
            slab.mode_surface(0, uncertainty=wrong)


def test_curves_and_certificate(program, slab, slab_file, tmp_path):
    file, certificate = tmp_path / "c.vtp", tmp_path / "c.json"
    program("extract", slab_file, "-o", file, "--quiet", "--mode", "1", "--mode", "-1",
            "--certify", certificate)  # fmt: skip
    curves = slab.degenerate_curves(certify=True)
    require_same(curves, file, "Lines")
    assert curves.certificate == certificate.read_bytes()
    assert [len(line) for line in curves.lines] == list(np.diff(curves.offsets))


def test_report(program, slab, slab_file, tmp_path):
    text = program("extract", slab_file, "-o", tmp_path / "s.vtp", "--quiet", "--mode", "0.5", "--json")
    theirs = json.loads(text)["surfaces"][0]
    ours = slab.mode_surface(0.5)
    assert len(ours.components) == theirs["components"]
    assert ours.euler_characteristic == theirs["euler_characteristic"]
    assert ours.boundary_loops == theirs["boundary_loops"]
    assert ours.area == pytest.approx(theirs["area"], rel=1e-12)


def test_order_of_requests_does_not_matter(slab_file):
    field, fresh = tt.read(slab_file), tt.read(slab_file)
    for mode in (0.1, 0.7):
        field.mode_surface(mode)
    assert bits(field.mode_surface(0.4).points) == bits(fresh.mode_surface(0.4).points)


def test_what_is_written_is_read_and_checked_by_the_program(program, slab, tmp_path):
    tt.write(tmp_path / "f.vtu", slab)
    surface = slab.mode_surface(0.6, certify=True)
    tt.write(tmp_path / "s.vtp", surface)
    (tmp_path / "c.json").write_bytes(surface.certificate)
    verdict = json.loads(program("check", tmp_path / "f.vtu", tmp_path / "s.vtp", tmp_path / "c.json",
                                 "--json", "--quiet"))  # fmt: skip
    assert verdict["status"] == "certified"
    program("extract", tmp_path / "f.vtu", "-o", tmp_path / "t.vtp", "--quiet", "--mode", "0.6")
    require_same(surface, tmp_path / "t.vtp", "Polys")


def test_active_attributes_and_names_of_components(program, slab, slab_file, tmp_path):
    def told(file):
        data = ElementTree.parse(file).getroot().find(".//PointData")
        arrays = {
            array.get("Name"): [array.get(f"ComponentName{i}") for i in range(int(array.get("NumberOfComponents", 1)))]
            for array in data
        }  # fmt: skip
        return dict(data.attrib), arrays

    program("convert", slab_file, "-o", tmp_path / "program.vtu")
    tt.write(tmp_path / "python.vtu", slab)
    marks, names = told(tmp_path / "python.vtu")
    assert (marks, names) == told(tmp_path / "program.vtu")
    assert names == {"stress": ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]} and marks == {"Tensors": "stress"}
    program("extract", slab_file, "-o", tmp_path / "program.vtp", "--quiet", "--mode", "0")
    tt.write(tmp_path / "python.vtp", slab.mode_surface(0))
    marks, _ = told(tmp_path / "python.vtp")
    assert marks == told(tmp_path / "program.vtp")[0] == {"Scalars": "mode", "Normals": "normal"}
