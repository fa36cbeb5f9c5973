# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Degenerate curves on MPI have the bytes of one process, as a whole and in parts."""
import hashlib
import importlib.util
import json
import shutil

import numpy as np
import pytest
from conftest import tried
from test_mpi import mpirun, write_pieces

import tensortopo as tt
from tensortopo._vtk_xml import read_piece

pytestmark = pytest.mark.skipif(
    shutil.which("mpirun") is None or importlib.util.find_spec("mpi4py") is None,
    reason="needs mpirun and mpi4py",
)


@pytest.fixture
def pieces(slab, tmp_path):
    return write_pieces(slab, np.random.default_rng(7).integers(0, 3, len(slab.tets)), tmp_path)


def extract(folder, output, mode, ranks, *words):
    done = mpirun(ranks, folder / "field.pvtu", "-o", folder / output, f"--mode={mode}", *words)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("mode, kind", tried([("1", "linear"), ("-1", "planar")]))
def test_curves_have_the_bytes_of_one_process(pieces, program, tmp_path, mode, kind):
    program("convert", tmp_path / "field.pvtu", "-o", tmp_path / "whole.vtu", "--quiet")
    curves = tt.read(tmp_path / "whole.vtu").degenerate_curves(kind)
    tt.write(tmp_path / "serial.vtp", curves)
    extract(tmp_path, "curves.vtp", mode, 2, "--certify", tmp_path / "curves.json")
    assert len(curves) > 20
    assert (tmp_path / "curves.vtp").read_bytes() == (tmp_path / "serial.vtp").read_bytes()
    program("extract", tmp_path / "whole.vtu", "-o", tmp_path / "again.vtp", f"--mode={mode}", "--certify",
            tmp_path / "serial.json", "--quiet")  # fmt: skip
    assert (tmp_path / "curves.json").read_bytes() == (tmp_path / "serial.json").read_bytes()
    assert tt.check(tmp_path / "whole.vtu", tmp_path / "curves.vtp", tmp_path / "curves.json")


def lines_of(path):
    """By the coordinates of their points, whatever their direction: numbers at points, and the component."""
    sections = read_piece(path).sections
    points = next(iter(sections["Points"].values())).values.reshape(-1, 3)
    values = [sections["PointData"][name].values.reshape(len(points), -1)
              for name in ("mode", "dominant_eigenvector", "residual", "separation")]  # fmt: skip
    ends = sections["Lines"]["offsets"].values
    cells = sections["CellData"]
    component = cells["whole_component" if "whole_component" in cells else "component"].values
    lines = []
    for line, number in zip(np.split(sections["Lines"]["connectivity"].values, ends[:-1]), component):
        rows = [tuple(np.concatenate([points[v], *(value[v] for value in values)]).tolist()) for v in line]
        lines.append((min(rows, rows[::-1]), int(number)))
    return sorted(lines)


def test_parts_are_the_whole_curves_on_any_number_of_ranks(pieces, program, tmp_path):
    program("convert", tmp_path / "field.pvtu", "-o", tmp_path / "whole.vtu", "--quiet")
    program("extract", tmp_path / "whole.vtu", "-o", tmp_path / "whole.vtp", "--mode", "1", "--quiet")
    made = []
    for ranks in (1, 2):
        extract(tmp_path, "curves.pvtp", "1", ranks, "--certify", tmp_path / "curves.json")
        files = [tmp_path / "curves.pvtp", *(tmp_path / "curves" / f"curves_{k}.vtp" for k in range(3))]
        certificates = [tmp_path / "curves.json", *(file.with_suffix(".json") for file in files[1:])]
        made.append([file.read_bytes() for file in files + certificates])
    assert made[0] == made[1]
    parts = [line for file in files[1:] for line in lines_of(file)]
    whole = lines_of(tmp_path / "whole.vtp")
    assert len(whole) > 20
    assert sorted(parts) == whole
    for piece, file in zip(pieces, files[1:]):
        verdict = tt.check(piece, file, file.with_suffix(".json"), expect_complete=True)
        assert verdict, verdict.text
    assert "certified:" in program("check", tmp_path / "field.pvtu", *files[:1], *certificates[:1], "--expect-complete")
    # Cells are those of the pieces' files.
    for file, piece in zip(files[1:], pieces):
        sections, field = read_piece(file).sections, tt.read(piece)
        points = next(iter(sections["Points"].values())).values.reshape(-1, 3)
        ends = sections["Lines"]["offsets"].values
        for line, tet in zip(np.split(sections["Lines"]["connectivity"].values, ends[:-1]),
                             sections["CellData"]["tet"].values):  # fmt: skip
            corners = field.points[field.tets[tet]]
            for vertex in line:
                weights = np.linalg.solve(np.vstack([corners.T, np.ones(4)]), np.append(points[vertex], 1))
                assert weights.min() > -1e-9


def test_what_curves_do_not_have_is_refused(pieces, tmp_path):
    words = ("-o", tmp_path / "curves.vtp", "--mode", "1", "--all-samples")
    done = mpirun(2, tmp_path / "field.pvtu", *words)
    assert done.returncode == 3 and "is about surfaces" in done.stderr, done.stderr
    assert not (tmp_path / "curves.vtp").exists()


def test_parts_of_another_run_are_not_certified(pieces, slab, tmp_path):
    extract(tmp_path, "curves.pvtp", "1", 2, "--certify", tmp_path / "curves.json")
    names = [tmp_path / name for name in ("field.pvtu", "curves.pvtp", "curves.json")]
    verdict = tt.check(*names)
    assert verdict, verdict.text
    document = json.loads(names[2].read_text())
    for key in document["whole"]:
        changed = {**document, "whole": {**document["whole"], key: document["whole"][key] + 1}}
        names[2].write_text(json.dumps(changed))
        assert tt.check(*names).status == "refuted", key
    # Those of the other kind, in the place of one part.
    names[2].write_text(json.dumps(document))
    (tmp_path / "other").mkdir()
    write_pieces(slab, np.random.default_rng(7).integers(0, 3, len(slab.tets)), tmp_path / "other")
    extract(tmp_path / "other", "curves.pvtp", "-1", 2, "--certify", tmp_path / "other" / "curves.json")
    for suffix in ("vtp", "json"):
        shutil.copy(tmp_path / "other" / "curves" / f"curves_1.{suffix}", tmp_path / "curves" / f"curves_1.{suffix}")
    verdict = tt.check(*names)
    assert verdict.status == "refuted", verdict.text
    for role, suffix in (("polylines", "vtp"), ("certificate", "json")):
        data = (tmp_path / "curves" / f"curves_1.{suffix}").read_bytes()
        document["parts"][1][role]["sha256"] = hashlib.sha256(data).hexdigest()
    names[2].write_text(json.dumps(document))
    verdict = tt.check(*names)
    assert verdict.status == "refuted", verdict.text
    assert any("part 1's level" in finding.entity for finding in verdict.refutations)
