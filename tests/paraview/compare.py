# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""compare.py OUT: the pieces' triangles, lines and components together are those of the whole field, bit for bit."""
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


def lines_of(points, connectivity, offsets, component):
    """By the coordinates of their points, whatever their direction, and their component."""
    lines = [points[line] for line in np.split(connectivity, offsets[:-1])]
    return sorted((min(line.tobytes(), line[::-1].tobytes()), number) for line, number in zip(lines, component.tolist()))


whole = lines_of(*(expected[f"curves_{name}"] for name in ("points", "cells", "offsets", "component")))
parts, components = [], []
for file in sorted(out.glob("curves/curves_*.vtp")):
    sections = read_piece(file).sections
    points = next(iter(sections["Points"].values())).values
    lines, component = sections["Lines"], sections["CellData"]["component"].values
    parts.append(lines_of(points, lines["connectivity"].values, lines["offsets"].values, component))
    components.append(component)
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput().GetFieldData()
    counts = [vtk_to_numpy(data.GetArray(name)) for name in ("components", "closed_components")]
    assert np.array_equal(np.stack(counts, axis=1), expected["curve_counts"]), counts
    assert vtk_to_numpy(data.GetArray("curve_mode")).tolist() == [1, -1]
assert len(parts) == 2 and min(map(len, parts)) > 20, [len(p) for p in parts]
shared = np.intersect1d(*components)
assert len(shared) > 0, "no curve lies on both ranks"
assert sorted(parts[0] + parts[1]) == whole
print(f"two ranks: {len(parts[0])} and {len(parts[1])} lines, together the whole's {len(whole)}; "
      f"{len(shared)} of {expected['curve_counts'][:, 0].sum()} components lie on both")  # fmt: skip
