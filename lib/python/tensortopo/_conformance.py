# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Other programs' surfaces, scored by the program."""
from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Optional

import numpy as np

from ._errors import FileError
from ._field import Field
from ._files import write
from ._modes import Mode, mode_text
from ._files import find_program
from ._surface import Surface
from ._tensors import real_array
from ._vtk_xml import piece_text, write_whole


def conformance(
    field: Field,
    mode: Mode,
    points: Any,
    triangles: Any = None,
    *,
    merge: float = 0,
    resolution: float = 8,
    program: Optional[str] = None,
) -> dict[str, Any]:
    """What is wrong with a surface that claims to be a mode's.

    It is compared with the certified surface by ``tensortopo conformance``, which must be there.

    Parameters
    ----------
    field : Field
    mode : str, int, float, Fraction or Decimal
        Strictly between -1 and 1.
    points : array_like, shape (k, 3), or Surface
    triangles : array_like of int, shape (t, 3)
        The surface; None with a `Surface`.
    merge : float, default 0
        Merge points within boxes of this size; 0 for equal ones.
    resolution : float, default 8
        Samples per radian of the certified surface.
    program : str, optional
        The program; by default what ``TENSORTOPO_PROGRAM`` names, or ``tensortopo`` on the path.

    Returns
    -------
    dict
        What the program prints with ``--json``: ``conforms``, ``components``, ``holes``,
        ``crossings``, ``distance`` and so on.

    Raises
    ------
    FileError
        If the program is not there, or refuses.
    ValueError
        For arrays that are no triangles.
    """
    if triangles is None:
        if not isinstance(points, Surface):
            raise ValueError("triangles: needed with points that are no Surface")
        points, triangles = points.points, points.triangles
    place = real_array(points, "points")
    corners = np.asarray(triangles)
    if place.ndim != 2 or place.shape[1] != 3:
        raise ValueError(f"points: expected shape (k, 3), not {place.shape}")
    if corners.size == 0:
        corners = np.empty((0, 3), dtype=np.int64)
    if corners.dtype.kind not in "iu" or corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError("triangles: expected integers of shape (t, 3)")
    if corners.size and not (0 <= corners.min() and corners.max() < len(place)):
        raise ValueError("triangles: a vertex does not exist")
    command = [find_program(program), "conformance", f"--mode={mode_text(mode)}", "--json", "--quiet",
               f"--resolution={float(resolution)!r}"]  # fmt: skip
    if merge > 0:
        command.append(f"--merge={float(merge)!r}")
    with tempfile.TemporaryDirectory(prefix="tensortopo-") as folder:
        surface = Path(folder) / "surface.vtp"
        text = piece_text(
            "PolyData",
            {"NumberOfPoints": len(place), "NumberOfPolys": len(corners)},
            {
                "Points": {"Points": place},
                "Polys": {
                    "connectivity": corners.astype(np.int64).ravel(),
                    "offsets": np.arange(3, 3 * len(corners) + 1, 3, dtype=np.int64),
                },
            },
        )
        write_whole({surface: text.encode("utf-8")})
        write(Path(folder) / "field.vtu", field)
        command += ["--surface", str(surface), "--input", str(Path(folder) / "field.vtu")]
        try:
            done = subprocess.run(command, capture_output=True, text=True)
        except OSError as error:
            raise FileError(f"{command[0]}: {error.strerror or error}") from error
    if not done.stdout:
        raise FileError(done.stderr.strip() or f"{command[0]}: says nothing")
    score: dict[str, Any] = json.loads(done.stdout)
    return score
