# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Files of other programs, which the program converts."""
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import tensortopo as tt

FORMATS = Path(__file__).resolve().parents[2] / "examples" / "formats"


@pytest.fixture(name="found", autouse=True)
def found_program(program):
    return program  # skips without it


def test_calculix_results_are_read_by_step(program, tmp_path):
    program("convert", FORMATS / "plate.frd", "-o", tmp_path / "p.vtu", "--quiet")
    last, plain = tt.read(FORMATS / "plate.frd"), tt.read(tmp_path / "p.vtu")
    assert last.tensor_name == "STRESS"
    assert len(last.tets) == 8 * 494
    assert last.sha256 == plain.sha256
    first = tt.read(FORMATS / "plate.frd", step=1)
    assert np.array_equal(first.points, last.points)
    assert not np.array_equal(first.tensors, last.tensors)
    corners = tt.read(FORMATS / "plate.frd", options=["--quadratic", "corners"])
    assert len(corners.tets) == 494


def test_images_within_a_mask():
    whole = tt.read(FORMATS / "tensor.nii.gz", components="mrtrix")
    masked = tt.read(FORMATS / "tensor.nii.gz", components="mrtrix", mask=FORMATS / "mask.nii.gz")
    assert len(whole.points) == 14 * 12 * 10
    assert len(masked.points) < len(whole.points)
    surface = masked.mode_surface(0)
    assert len(surface.triangles) > 100


def test_certificates_are_about_what_convert_makes(program, tmp_path):
    field, surface, proof = (tmp_path / name for name in ("p.vtu", "p.vtp", "p.json"))
    program("convert", FORMATS / "plate.frd", "--step", 1, "-o", field, "--quiet")
    program("extract", field, "--mode", "1/2", "-o", surface, "--certify", proof, "--quiet")
    program("check", field, surface, proof)
    for words in (["extract", "--mode", "1/2", "-o", "x.vtp", "--certify", "x.json", FORMATS / "plate.frd"],
                  ["check", FORMATS / "plate.frd", surface, proof]):  # fmt: skip
        done = subprocess.run([os.environ["TENSORTOPO_PROGRAM"], *map(str, words)], cwd=tmp_path,
                              capture_output=True, text=True, check=False)
        assert done.returncode in (2, 3)
        assert "tensortopo convert" in done.stderr and len(done.stderr.splitlines()) == 1
        assert not (tmp_path / "x.vtp").exists()


def test_errors_are_those_of_the_program(tmp_path):
    with pytest.raises(tt.FileError, match="--components"):
        tt.read(FORMATS / "tensor.nii.gz")
    with pytest.raises(tt.FileError, match="--components.*here: the argument components"):
        tt.read(FORMATS / "tensor.nii.gz", components="foo")
    with pytest.raises(tt.FileError, match="here: the argument step"):
        tt.read(FORMATS / "plate.frd", step=0)
    with pytest.raises(tt.FileError, match="steps 1 to 2"):
        tt.read(FORMATS / "plate.frd", step=7)
    (tmp_path / "f.frd").write_text("hello\n")
    with pytest.raises(tt.FileError, match=r"f\.frd: has a line that is none of a \.frd file"):
        tt.read(tmp_path / "f.frd")
