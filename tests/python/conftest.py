# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
import os
import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest

import tensortopo as tt


def is_short():
    """Is this the short suite, which tries fewer inputs?"""
    return 0 < float(os.environ.get("TENSORTOPO_TEST_MULTIPLIER", 1)) < 1


def tried(inputs):
    """All of a list, or in the short suite every other."""
    return inputs[::2] if is_short() else inputs


FAR = 2**40  # ids need 64 bits


def pieces_of(field, owner, extract, far=FAR):
    """What is extracted, as processes would have it: from pieces numbered by themselves, and sent as bytes.

    extract(piece, owned, vertex_ids, whole_cells): of one piece.
    """
    random = np.random.default_rng(5)
    for part in np.unique(owner):
        near = np.zeros(len(field.points), bool)
        near[field.tets[owner == part].ravel()] = True
        cells = random.permutation(np.flatnonzero(near[field.tets].any(axis=1)))
        vertices = random.permutation(np.unique(field.tets[cells]))
        number = np.full(len(field.points), -1)
        number[vertices] = np.arange(len(vertices))
        piece = tt.Field(field.points[vertices], field.tensors[vertices], number[field.tets[cells]], cell_ids=far + cells)
        made = extract(piece, owner[cells] == part, far + vertices, len(field.tets))
        yield pickle.loads(pickle.dumps(made))


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
def corner(slab):
    """The cells of the slab's lower sixth, where surfaces pass, for what does not depend on a field's size."""
    x = slab.points[slab.tets].mean(axis=1)[:, 0]
    used, tets = np.unique(slab.tets[x < np.quantile(x, 1 / 6)], return_inverse=True)
    return tt.Field(slab.points[used], slab.tensors[used], tets.reshape(-1, 4))


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
