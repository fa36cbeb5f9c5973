# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""prepare.py FIELD OUT: a field whole and in two pieces with global ids, and what to expect of it."""
import sys
from pathlib import Path

import numpy as np

import tensortopo as tt
from tensortopo._vtk_xml import piece_text

field = tt.read(sys.argv[1])
out = Path(sys.argv[2])
tt.write(out / "field.vtu", field)

name = field.tensor_name
left = field.points[field.tets].mean(axis=1)[:, 0] < np.median(field.points[:, 0])
for piece, own in enumerate((left, ~left)):
    assert own.sum() > 1000
    points, corners = np.unique(field.tets[own], return_inverse=True)
    n = int(own.sum())
    text = piece_text(
        "UnstructuredGrid",
        {"NumberOfPoints": len(points), "NumberOfCells": n},
        {
            "PointData": {name: field.tensors[points], "GlobalPointIds": points.astype(np.int64)},
            "CellData": {"GlobalCellIds": np.flatnonzero(own)},
            "Points": {"Points": field.points[points]},
            "Cells": {
                "connectivity": corners.astype(np.int64),
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
    (out / f"piece_{piece}.vtu").write_text(text)

(out / "field.pvtu").write_text(f"""<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PUnstructuredGrid GhostLevel="0">
<PPointData GlobalIds="GlobalPointIds">
<PDataArray type="Float64" Name="{name}" NumberOfComponents="6"/>
<PDataArray type="Int64" IdType="1" Name="GlobalPointIds"/></PPointData>
<PCellData GlobalIds="GlobalCellIds"><PDataArray type="Int64" IdType="1" Name="GlobalCellIds"/></PCellData>
<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>
<Piece Source="piece_0.vtu"/><Piece Source="piece_1.vtu"/>
</PUnstructuredGrid></VTKFile>
""")

surface = field.mode_surface("1/2", generalized=True)
curves = field.degenerate_curves()
every = field.mode_surface("1/2", all_samples=True)
np.savez(
    out / "expected.npz",
    points=surface.points,
    triangles=surface.triangles,
    medium_eigenvector=surface.medium_eigenvectors,
    normal=surface.normals,
    residual=surface.residual,
    tet=surface.cell_ids,
    component=surface.component,
    curve_points=curves.points,
    curve_separation=curves.separation,
    corners=every.points[every.triangles],
    unresolved=len(surface.unresolved) + len(curves.unresolved),
)
print(field, surface, curves)
