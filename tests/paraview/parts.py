# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""parts.py OUT PROGRAM: the certificates of parts that `certified.py` wrote in OUT/certified.

They are certified, have the bytes that the driver on MPI writes for the same pieces, and are refuted if a part is altered.
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

import tensortopo as tt
from tensortopo._vtk_xml import read_piece

out, program = Path(sys.argv[1]), sys.argv[2]
certified, driver = out / "certified", out / "driver"
expected = np.load(out / "expected.npz")
shutil.rmtree(driver, ignore_errors=True)
driver.mkdir()
for file in ("field.pvtu", "field_0.vtu", "field_1.vtu"):
    shutil.copy(out / file, driver)


def files_of(folder, name):
    """What `check` takes."""
    return [folder / f"{name}_field.pvtu", folder / f"{name}.pvtp", folder / f"{name}.json"]


def without_inputs(path):
    document = json.loads(path.read_text())
    for part in document["parts"]:
        del part["input"]
    return document


def require_same_as_the_drivers(name, mode, *options):
    command = ["mpirun", "-n", "1", sys.executable, "-m", "tensortopo.mpi", driver / "field.pvtu", f"--mode={mode}", *options]
    subprocess.run([*command, "-o", driver / f"{name}.pvtp", "--certify", driver / f"{name}.json"], check=True)
    parts = [f"{name}/{name}_{part}.{ending}" for part in (0, 1) for ending in ("vtp", "json")]
    for file in [f"{name}.pvtp", *parts]:
        assert (driver / file).read_bytes() == (certified / file).read_bytes(), file
    assert without_inputs(driver / f"{name}.json") == without_inputs(certified / f"{name}.json")


def require_whole_field(name):
    """The fields of the parts are the field's tetrahedra, each once, by their global ids."""
    ids = []
    for part in (0, 1):
        sections = read_piece(certified / name / f"{name}_field_{part}.vtu").sections
        original = read_piece(out / f"field_{part}.vtu").sections
        for section, array in (("PointData", "GlobalPointIds"), ("CellData", "GlobalCellIds"), ("Points", "Points")):
            assert np.array_equal(sections[section][array].values, original[section][array].values), array
        ids.append(sections["CellData"]["GlobalCellIds"].values)
    assert np.array_equal(np.sort(np.concatenate(ids)), np.arange(expected["tets"]))


claims = []
for name, mode, options in (("surface", "1/2", ["--all-samples"]), ("linear", "1", []), ("planar", "-1", [])):
    verdict = tt.check(*files_of(certified, name), expect_complete=mode == "1/2")
    assert verdict, verdict.text
    done = subprocess.run([program, "check", *files_of(certified, name)], capture_output=True, text=True, check=True)
    assert "certified:" in done.stdout, done.stdout
    require_same_as_the_drivers(name, mode, *options)
    require_whole_field(name)
    claims.append(verdict.certified)

# A part that is altered, another piece's part, and a part that is missing.
forged = out / "forged"


def refuted(alter, text):
    shutil.rmtree(forged, ignore_errors=True)
    shutil.copytree(certified, forged)
    alter()
    verdict = tt.check(*files_of(forged, "surface"))
    assert verdict.status == "refuted", verdict.text
    assert text in verdict.text, verdict.text


def append(file):
    with open(forged / "surface" / file, "a") as stream:
        stream.write(" ")


def lose_the_second():
    for file in files_of(forged, "surface")[:2]:
        lines = file.read_text().splitlines(keepends=True)
        file.write_text("".join(line for line in lines if "_1." not in line))
    document = json.loads((forged / "surface.json").read_text())
    del document["parts"][1]
    (forged / "surface.json").write_text(json.dumps(document))


for file in ("surface_0.vtp", "surface_1.json", "surface_field_1.vtu"):
    refuted(lambda name=file: append(name), "sha256")
refuted(lambda: shutil.copy(forged / "surface/surface_0.vtp", forged / "surface/surface_1.vtp"), "sha256")
refuted(lose_the_second, "whole, tetrahedra")
print(f"certificates of parts: {', '.join(map(str, claims))} claims are certified, the bytes are those of the driver on MPI")
