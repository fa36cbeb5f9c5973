# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""What 1,000 ranks and 10^9 tetrahedra take, from counts and from runs of single parts.

scale.py [--tets N] [--part N]: counts the ghosts of one rank's block, runs a part of that size, counts how
unevenly the surface of Kelvin's field is spread over 10 x 10 x 10 blocks of a mesh of N tetrahedra, weighs what
eight blocks of it send each other, and prints tables. lib/partition/SCALE.md explains them.
"""
import argparse
import pickle
import resource
import time

import numpy as np

import tensortopo as tt

RANKS, WHOLE = 1000, 10**9
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]])
WALKS = [np.array(order) for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))]


def lattice(low, high):
    """The corners of Kuhn's tetrahedra of the cubes from low to high: lattice points, shape (m, 4, 3)."""
    cubes = np.stack(np.meshgrid(*[np.arange(low, high)] * 3, indexing="ij"), -1).reshape(-1, 1, 3)
    return np.concatenate([cubes + CORNERS[:, np.argsort(walk)] for walk in WALKS])


def ghosts(n, layers):
    """Owned and ghost tetrahedra, and owned and ghost vertices, of a block of n^3 cubes inside a lattice."""
    counts = []
    near = lambda points, by: ((points >= -by) & (points <= n + by)).all(-1)
    tets = lattice(-layers, n + layers)
    owned = ((tets.min(1) >= 0) & (tets.max(1) <= n)).all(-1)
    held = owned
    for _ in range(layers):
        side = n + 2 * layers + 1
        code = ((tets[..., 0] + layers) * side + tets[..., 1] + layers) * side + tets[..., 2] + layers
        has = np.zeros(side**3, bool)
        has[code[held].ravel()] = True
        held = has[code].any(1)
    counts = (int(owned.sum()), int((held & ~owned).sum()))
    has[:] = False
    has[code[held].ravel()] = True
    return *counts, (n + 1) ** 3, int(has.sum()) - (n + 1) ** 3


def pieces_of(field, cuts, mode):
    """The pieces of a cube of so many blocks along each axis, with a layer of ghosts."""
    centres = field.points[field.tets].mean(1)
    block = np.clip(((centres + 1) * cuts / 2).astype(int), 0, cuts - 1) @ [cuts * cuts, cuts, 1]
    for own in range(cuts**3):
        near = np.zeros(len(field.points), bool)
        near[field.tets[block == own].ravel()] = True
        cells = np.flatnonzero(near[field.tets].any(axis=1))
        vertices, local = np.unique(field.tets[cells], return_inverse=True)
        piece = tt.Field(field.points[vertices], field.tensors[vertices], local.reshape(-1, 4), cell_ids=cells)
        yield tt.extract_piece(piece, mode, block[cells] == own, vertices, len(field.tets))


def seams(field):
    """What the ranks of 2 x 2 x 2 blocks send of their surfaces: all of them, or seams."""
    print("\n| mode | triangles | surfaces, MB | seams, MB | components | joined, ms | seams at 10^9, MB |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for mode in ("0", "1/2", "99/100"):
        parts = list(pieces_of(field, 2, mode))
        sent = [tt.seam_of(part) for part in parts]
        start = time.perf_counter()
        joined = tt.join_seams(sent)
        seconds = time.perf_counter() - start
        size = sum(seam.numbers.nbytes for seam in sent) / 1e6
        # Nine planes along each axis, not one, and finer triangles along each.
        scaled = size * 9 * (WHOLE / len(field.tets)) ** (1 / 3)
        surfaces = sum(len(pickle.dumps(part)) for part in parts) / 1e6
        print(f"| {mode} | {joined.triangles.sum():,} | {surfaces:.1f} | {size:.2f} | {len(joined.triangles)} | "
              f"{seconds * 1e3:.1f} | {scaled:.0f} |")  # fmt: skip


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tets", type=int, default=1_000_000, help="of the mesh whose surface is counted by block")
    parser.add_argument("--part", type=int, default=200_000, help="tetrahedra of the part that is run")
    options = parser.parse_args()

    n = round((WHOLE / RANKS / 6) ** (1 / 3))
    print(f"| layers | owned | ghosts | ghost vertices | MB received |\n| --- | --- | --- | --- | --- |")
    for layers in (1, 2):
        owned, around, _, vertices = ghosts(n, layers)
        # A cell: its id and four of vertices; a vertex: id, place, tensor.
        received = (around * 5 * 8 + vertices * (8 + 24 + 48)) / 1e6
        print(f"| {layers} | {owned:,} | {around:,} ({around / owned:.1%}) | {vertices:,} | {received:.1f} |")

    side = round((options.part / 6) ** (1 / 3))
    field = tt.generate("kelvin", tetrahedra=options.part).field
    ids, all_owned = np.arange(len(field.points)), np.ones(len(field.tets), bool)
    before = resource.getrusage(resource.RUSAGE_SELF)
    part = tt.extract_piece(field, "1/2", all_owned, ids, len(field.tets), certify=True)
    after = resource.getrusage(resource.RUSAGE_SELF)
    seconds = after.ru_utime - before.ru_utime
    sent = len(pickle.dumps(part))
    start = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    known = tt.CertifiedField(len(field.points), field.sha256)
    tt.merge_pieces([part], certify=known, mode="1/2")
    merging = resource.getrusage(resource.RUSAGE_SELF).ru_utime - start
    triangles = len(part.triangles)
    print(f"\npart of {len(field.tets):,} tetrahedra ({side}^3 cubes): {seconds:.1f} s of processor, "
          f"peak {after.ru_maxrss / 1e3:.0f} MB, {triangles:,} triangles, {sent / 1e6:.1f} MB to the first rank, "
          f"merged and certified in {merging:.1f} s")  # fmt: skip
    print(f"per triangle: {sent / triangles:.0f} bytes sent, {merging / triangles * 1e6:.1f} us of the first rank")

    field = tt.generate("kelvin", tetrahedra=options.tets).field
    print(f"\n| mode | triangles at 10^9 | of the fullest of {RANKS} blocks, of the mean | blocks without |")
    print("| --- | --- | --- | --- |")
    for mode in ("0", "1/2", "99/100"):
        surface = field.mode_surface(mode)
        centres = field.points[field.tets[surface.tet]].mean(1)
        block = np.clip(((centres + 1) * 5).astype(int), 0, 9) @ [100, 10, 1]
        count = np.bincount(block, minlength=RANKS)
        scaled = len(surface.triangles) * (WHOLE / len(field.tets)) ** (2 / 3)
        print(f"| {mode} | {scaled / 1e6:.1f} million | {count.max() / count.mean():.1f} | {(count == 0).sum()} |")
    seams(field)


if __name__ == "__main__":
    main()
