# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess
from pathlib import Path

import pytest

import tensortopo as tt


@pytest.fixture(scope="session")
def data():
    return Path(os.environ["TENSORTOPO_DATA"])


@pytest.fixture(scope="session")
def slab_file(data):
    return data / "s4_slab_small_C3D8I.vtu"


@pytest.fixture(scope="session")
def slab(slab_file):
    return tt.read(slab_file)


@pytest.fixture(scope="session")
def program():
    """Runs the program; its output."""
    path = os.environ.get("TENSORTOPO_PROGRAM")
    if path is None:
        pytest.skip("the program is not built")

    def run(*arguments, statuses=(0,)):
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode in statuses, done.stderr
        return done.stdout

    return run


@pytest.fixture
def tetrahedron():
    """Points, tensors and the cell of one tetrahedron."""
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    tensors = [[2, -1, -1, 0, 0, 0], [1, 1, -2, 0, 0, 0], [1, 1, -2, 0, 0, 1], [1, 0, -1, 0, 1, 0]]
    return points, tensors, [[0, 1, 2, 3]]
