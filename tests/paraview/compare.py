# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""compare.py OUT: the pieces' triangles together are those of the whole field, bit for bit."""
import sys
from pathlib import Path

import numpy as np

from tensortopo._vtk_xml import read_piece

out = Path(sys.argv[1])
expected = np.load(out / "expected.npz")["corners"]
parts = []
for file in sorted(out.glob("surface/surface_*.vtp")):
    sections = read_piece(file).sections
    points = next(iter(sections["Points"].values())).values
    triangles = sections["Polys"]["connectivity"].values.reshape(-1, 3)
    parts.append(points[triangles])
assert len(parts) == 2 and min(map(len, parts)) > 500, [len(p) for p in parts]


def rows(corners):
    flat = np.ascontiguousarray(corners.reshape(-1, 9))
    return sorted(row.tobytes() for row in flat)


together = np.concatenate(parts)
assert together.dtype == expected.dtype == np.float64
assert rows(together) == rows(expected)
print(f"two ranks: {len(parts[0])} and {len(parts[1])} triangles, together the whole's {len(expected)}")
