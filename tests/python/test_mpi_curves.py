# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Degenerate curves on MPI have the bytes of one process, as a whole and in parts."""
import importlib.util
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
    extract(tmp_path, "curves.vtp", mode, 2)
    assert len(curves) > 20
    assert (tmp_path / "curves.vtp").read_bytes() == (tmp_path / "serial.vtp").read_bytes()


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
        extract(tmp_path, "curves.pvtp", "1", ranks)
        files = [tmp_path / "curves.pvtp", *(tmp_path / "curves" / f"curves_{k}.vtp" for k in range(3))]
        made.append([file.read_bytes() for file in files])
    assert made[0] == made[1]
    parts = [line for file in files[1:] for line in lines_of(file)]
    whole = lines_of(tmp_path / "whole.vtp")
    assert len(whole) > 20
    assert sorted(parts) == whole
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
    for words, text in ((("--certify", tmp_path / "c.json"), "curves in pieces have no certificate"),
                        (("--all-samples",), "is about surfaces")):  # fmt: skip
        done = mpirun(2, tmp_path / "field.pvtu", "-o", tmp_path / "curves.vtp", "--mode", "1", *words)
        assert done.returncode == 3 and text in done.stderr, done.stderr
        assert not (tmp_path / "curves.vtp").exists()
