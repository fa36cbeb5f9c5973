# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""compare.py OUT: the pieces' triangles and components together are those of the whole field, bit for bit."""
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from tensortopo._vtk_xml import read_piece

out = Path(sys.argv[1])
expected = np.load(out / "expected.npz")
parts, components = [], []
for file in sorted(out.glob("surface/surface_*.vtp")):
    sections = read_piece(file).sections
    points = next(iter(sections["Points"].values())).values
    triangles = sections["Polys"]["connectivity"].values.reshape(-1, 3)
    parts.append(points[triangles])
    components.append(sections["CellData"]["component"].values)
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput().GetFieldData()
    mode, *counts = (
        vtk_to_numpy(data.GetArray(name))
        for name in ("surface_mode", "components", "euler_characteristic", "boundary_loops")
    )
    assert np.array_equal(np.stack(counts, axis=1), expected["counts"]), counts
    assert mode.tolist() == [0.5, -0.5]
assert len(parts) == 2 and min(map(len, parts)) > 500, [len(p) for p in parts]
shared = np.intersect1d(*components)
assert len(shared) > 0, "no component lies on both ranks"


def rows(corners, numbers):
    flat = np.ascontiguousarray(corners.reshape(-1, 9))
    return sorted((row.tobytes(), number) for row, number in zip(flat, numbers.tolist()))


together, numbers = np.concatenate(parts), np.concatenate(components)
assert together.dtype == expected["corners"].dtype == np.float64
assert rows(together, numbers) == rows(expected["corners"], expected["components"])
print(
    f"two ranks: {len(parts[0])} and {len(parts[1])} triangles, together the whole's {len(expected['corners'])}; "
    f"{len(shared)} of {expected['counts'][:, 0].sum()} components lie on both"
)
