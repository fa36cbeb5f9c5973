# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The driver on MPI gives the bytes of one process, or one clear error and no file."""
import importlib.util
import os
import shutil
import subprocess
import sys
import textwrap

import numpy as np
import pytest
from conftest import tried

import tensortopo as tt

pytestmark = pytest.mark.skipif(
    shutil.which("mpirun") is None or importlib.util.find_spec("mpi4py") is None,
    reason="needs mpirun and mpi4py",
)


def mpirun(ranks, *words, python=("-m", "tensortopo.mpi")):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
                       OMPI_MCA_btl="self,vader")  # fmt: skip
    command = ["mpirun", "-n", str(ranks), sys.executable, *python, *map(str, words)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=240, check=False)


def write_pieces(field, owner, folder):
    """A .pvtu of pieces with points of their own; the pieces' files."""
    files = []
    for part in range(owner.max() + 1):
        cells = field.tets[owner == part]
        used, tets = np.unique(cells, return_inverse=True)
        files.append(folder / f"piece{part}.vtu")
        tt.write(files[-1], tt.Field(field.points[used], field.tensors[used], tets.reshape(-1, 4)))
    lines = ['<?xml version="1.0"?>', '<VTKFile type="PUnstructuredGrid">', "<PUnstructuredGrid>"]
    lines += [f'<Piece Source="{file.name}"/>' for file in files]
    lines += ["</PUnstructuredGrid>", "</VTKFile>"]
    (folder / "field.pvtu").write_text("\n".join(lines))
    return files


@pytest.fixture
def pieces(slab, tmp_path):
    """Pieces at random, so that nearly every cell has neighbours elsewhere."""
    return write_pieces(slab, np.random.default_rng(7).integers(0, 5, len(slab.tets)), tmp_path)


@pytest.fixture
def serial(pieces, program, tmp_path):
    """The whole as a file, its surface and its certificate, by one process."""
    program("convert", tmp_path / "field.pvtu", "-o", tmp_path / "whole.vtu", "--quiet")
    surface = tt.read(tmp_path / "whole.vtu").mode_surface("1/2", certify=True)
    tt.write(tmp_path / "serial.vtp", surface)
    return surface


@pytest.mark.parametrize("ranks", tried([2, 1, 3]))
def test_surface_and_certificate_have_the_bytes_of_one_process(pieces, serial, tmp_path, ranks):
    surface, certificate = tmp_path / "surface.vtp", tmp_path / "surface.json"
    inputs = pieces if ranks == 3 else [tmp_path / "field.pvtu"]
    done = mpirun(ranks, *inputs, "-o", surface, "--mode", "1/2", "--certify", certificate,
                  "--cells", len(tt.read(tmp_path / "whole.vtu").tets))  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert len(serial.triangles) > 1000
    assert surface.read_bytes() == (tmp_path / "serial.vtp").read_bytes()
    assert certificate.read_bytes() == serial.certificate
    if ranks == 2:
        verdict = tt.check(tmp_path / "whole.vtu", surface, certificate)
        assert verdict.refuted == 0 and verdict.certified > 1000


def refused(ranks, text, tmp_path, *words):
    before = set(tmp_path.iterdir())
    done = mpirun(ranks, *words, "-o", tmp_path / "surface.vtp", "--mode", "1/2", "--certify",
                  tmp_path / "surface.json")  # fmt: skip
    assert done.returncode != 0
    assert text in done.stderr, done.stderr
    assert done.stderr.count("tensortopo.mpi:") == 1, done.stderr
    assert set(tmp_path.iterdir()) == before


def test_what_is_missing_or_of_another_mesh_is_refused(slab, pieces, tmp_path):
    refused(2, "is missing", tmp_path, *pieces[:-1], "--cells", len(slab.tets))
    other = tt.read(pieces[3])
    tt.write(pieces[3], tt.Field(other.points, other.tensors * 1.5, other.tets))
    refused(2, "different tensors at the same point", tmp_path, tmp_path / "field.pvtu")
    pieces[3].unlink()
    refused(2, "piece3.vtu: No such file", tmp_path, tmp_path / "field.pvtu")
    refused(2, "names no pieces", tmp_path, write_nothing(tmp_path))


def write_nothing(folder):
    file = folder / "empty.pvtu"
    file.write_text('<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid/></VTKFile>')
    return file


def test_a_rank_that_is_lost_leaves_no_file(pieces, tmp_path):
    script = tmp_path / "lose.py"
    script.write_text(textwrap.dedent("""
        import os, signal, sys
        from mpi4py import MPI
        import tensortopo.mpi as driver
        if MPI.COMM_WORLD.rank == 1:
            driver.extract_piece = lambda *args, **options: os.kill(os.getpid(), signal.SIGKILL)
        sys.exit(driver.main())
    """))
    before = set(tmp_path.iterdir())
    done = mpirun(2, *pieces, "-o", tmp_path / "surface.vtp", "--mode", "1/2", python=(str(script),))
    assert done.returncode != 0
    assert "signal 9" in done.stderr or "Killed" in done.stderr, done.stderr
    assert set(tmp_path.iterdir()) == before
