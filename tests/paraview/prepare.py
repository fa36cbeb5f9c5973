# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""prepare.py FIELD OUT PROGRAM: a field whole and in two pieces with global ids, and what to expect of it.

What is expected are the arrays of the files that the program writes. Python gives the same, bit for bit.
"""
import subprocess
import sys
from pathlib import Path

import numpy as np

import tensortopo as tt
from tensortopo._vtk_xml import piece_text, read_piece

field = tt.read(sys.argv[1])
out, program = Path(sys.argv[2]), sys.argv[3]
tt.write(out / "field.vtu", field)

name = field.tensor_name


def write_piece(path, cells, tensors=field.tensors):
    """Some cells of the field, with global ids."""
    points, corners = np.unique(field.tets[cells], return_inverse=True)
    n = len(cells)
    text = piece_text(
        "UnstructuredGrid",
        {"NumberOfPoints": len(points), "NumberOfCells": n},
        {
            "PointData": {name: tensors[points], "GlobalPointIds": points.astype(np.int64)},
            "CellData": {"GlobalCellIds": np.asarray(cells, np.int64)},
            "Points": {"Points": field.points[points]},
            "Cells": {
                "connectivity": corners.astype(np.int64).ravel(),
                "offsets": np.arange(4, 4 * n + 1, 4),
                "types": np.full(n, 10, np.uint8),
            },
        },
    )
    text = text.replace("<PointData>", '<PointData GlobalIds="GlobalPointIds">')
    text = text.replace("<CellData>", '<CellData GlobalIds="GlobalCellIds">')
    # What VTK's filters take for ids.
    for ids in ("GlobalPointIds", "GlobalCellIds"):
        text = text.replace(f'Name="{ids}"', f'IdType="1" Name="{ids}"')
    path.write_text(text)


def write_pieces(kind, pieces, **options):
    """A .pvtu of two pieces."""
    for number, cells in enumerate(pieces):
        write_piece(out / f"{kind}_{number}.vtu", cells, **options)
    (out / f"{kind}.pvtu").write_text(f"""<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PUnstructuredGrid GhostLevel="0">
<PPointData GlobalIds="GlobalPointIds">
<PDataArray type="Float64" Name="{name}" NumberOfComponents="6"/>
<PDataArray type="Int64" IdType="1" Name="GlobalPointIds"/></PPointData>
<PCellData GlobalIds="GlobalCellIds"><PDataArray type="Int64" IdType="1" Name="GlobalCellIds"/></PCellData>
<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>
<Piece Source="{kind}_0.vtu"/><Piece Source="{kind}_1.vtu"/>
</PUnstructuredGrid></VTKFile>
""")


left = field.points[field.tets].mean(axis=1)[:, 0] < np.median(field.points[:, 0])
halves = [np.flatnonzero(left), np.flatnonzero(~left)]
assert min(map(len, halves)) > 1000
write_pieces("field", halves)
# What must be an error on all ranks: a cell is lost, a cell has two owners, a tensor is none on one rank.
write_pieces("lost", [halves[0][:-1], halves[1]])
seam = np.isin(field.tets, field.tets[halves[1]]).any(axis=1) & left
write_pieces("doubled", [halves[0], np.append(halves[1], np.flatnonzero(seam)[0])])
broken = field.tensors.copy()
broken[np.argmax(field.points[:, 0]), 0] = np.nan  # far from the other piece
write_pieces("broken", halves, tensors=broken)


def written(name, *options):
    """The points, arrays and connectivity of the file that the program writes."""
    file = out / f"{name}.vtp"
    # 0 or 1: cells may lack a proof.
    command = [program, "extract", out / "field.vtu", "-o", file, "--quiet", *options]
    assert subprocess.run(command, check=False).returncode in (0, 1)
    sections = read_piece(file).sections
    arrays = {key: array.values for part in ("PointData", "CellData") for key, array in sections[part].items()}
    arrays["points"] = next(iter(sections["Points"].values())).values
    cells = sections["Polys" if name == "surface" else "Lines"]
    arrays["cells"], arrays["offsets"] = cells["connectivity"].values, cells["offsets"].values
    return {f"{name}_{key}": values for key, values in arrays.items()}


expected = {
    **written("surface", "--mode", "1/2", "--generalized"),
    **written("curves", "--mode", "1", "--mode=-1"),
}
surface = field.mode_surface("1/2", generalized=True)
curves = field.degenerate_curves()
python = {
    "surface_points": surface.points,
    "surface_mode": surface.mode,
    "surface_medium_eigenvector": surface.medium_eigenvectors,
    "surface_dominant_eigenvector": surface.dominant_eigenvectors,
    "surface_normal": surface.normals,
    "surface_residual": surface.residual,
    "surface_tet": surface.cell_ids,
    "surface_component": surface.component,
    "surface_cells": surface.triangles.astype(np.int64).ravel(),
    "curves_points": curves.points,
    "curves_mode": curves.mode,
    "curves_dominant_eigenvector": curves.dominant_eigenvectors,
    "curves_residual": curves.residual,
    "curves_separation": curves.separation,
    "curves_tet": curves.cell_ids,
    "curves_component": curves.component,
    "curves_cells": curves.connectivity.astype(np.int64),
}
assert {*python} == {key for key in expected if not key.endswith("offsets")}, {*python} ^ {*expected}
for key, values in python.items():
    assert values.dtype == expected[key].dtype and values.tobytes() == expected[key].tobytes(), key
every = field.mode_surface("1/2", generalized=True, all_samples=True)
np.savez(
    out / "expected.npz",
    **expected,
    corners=every.points[every.triangles],
    components=every.component,
    counts=[
        [len(level.components)]
        + [sum(getattr(part, key) for part in level.components) for key in ("euler_characteristic", "boundary_loops")]
        for level in every.levels
    ],
    curve_counts=[[level.components, level.closed_components] for level in curves.levels],
    tets=len(field.tets),
    unresolved=len(surface.unresolved) + len(curves.unresolved),
)
print(f"python: {len(python)} arrays are the program's, bit for bit: {field}, {surface}, {curves}")
