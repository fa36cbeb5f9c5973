# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Topology of 3D symmetric tensor fields, with proofs.

Mode surfaces, neutral surfaces and degenerate curves of piecewise linear fields on tetrahedral meshes.
Arrays go in and out; nothing here needs VTK.

>>> import tensortopo as tt
>>> field = tt.read("stress.vtu")                      # doctest: +SKIP
>>> surface = field.mode_surface("1/2", certify=True)  # doctest: +SKIP
>>> tt.check(field, surface)                           # doctest: +SKIP
Verdict(certified: 3141 of 3141 claims certified)
"""
from __future__ import annotations

from ._bridges import (
    PyVistaAccessor,
    from_meshio,
    from_pyvista,
    register_pyvista,
    to_meshio,
    to_pyvista,
)
from ._check import Finding, Verdict, certify, check
from ._conformance import conformance
from ._curve_pieces import (
    MergedCurves,
    PieceCurves,
    extract_curve_piece,
    merge_curve_pieces,
)
from ._errors import Cancelled, Defect, FileError, MeshError, UnresolvedError
from ._families import Generated, field_kinds, generate
from ._field import Field
from ._files import read, write
from ._modes import exact_mode
from ._nodal import NodalAverage, nodal_average
from ._partition import (
    CertifiedField,
    FieldHash,
    MergedSurface,
    PieceSurface,
    PiecesDiffer,
    extract_piece,
    merge_pieces,
    restrict_piece,
)
from ._persistence import (
    BettiInterval,
    CurvePersistence,
    LoopEvent,
    Persistence,
    PersistencePair,
)
from ._seams import (
    CurveSeam,
    JoinedCurveSeams,
    JoinedSeams,
    SurfaceSeam,
    curve_seam_of,
    join_curve_seams,
    join_seams,
    piece_components,
    seam_of,
)
from ._surface import (
    CARRIERS,
    Component,
    CurveLevel,
    Curves,
    Surface,
    SurfaceLevel,
    Unresolved,
)
from ._sweep import CriticalPoint, Sweep, SweepEvent, SweepInterval, SweepLevel
from ._tensors import COMPONENT_ORDERS, deviator, eigen, lode_angle, mode
from ._threads import limit_threads
from ._verify import Statement, verify

__version__ = "0.1.0"

__all__ = [
    "BettiInterval",
    "CARRIERS",
    "COMPONENT_ORDERS",
    "Cancelled",
    "CertifiedField",
    "Component",
    "CriticalPoint",
    "CurveLevel",
    "CurvePersistence",
    "CurveSeam",
    "Curves",
    "Defect",
    "Field",
    "FieldHash",
    "FileError",
    "Finding",
    "Generated",
    "JoinedCurveSeams",
    "JoinedSeams",
    "LoopEvent",
    "MergedCurves",
    "MergedSurface",
    "MeshError",
    "NodalAverage",
    "Persistence",
    "PersistencePair",
    "PieceCurves",
    "PieceSurface",
    "PiecesDiffer",
    "PyVistaAccessor",
    "Statement",
    "Surface",
    "SurfaceLevel",
    "SurfaceSeam",
    "Sweep",
    "SweepEvent",
    "SweepInterval",
    "SweepLevel",
    "Unresolved",
    "UnresolvedError",
    "Verdict",
    "certify",
    "check",
    "conformance",
    "curve_seam_of",
    "deviator",
    "eigen",
    "exact_mode",
    "extract_curve_piece",
    "extract_piece",
    "field_kinds",
    "from_meshio",
    "from_pyvista",
    "generate",
    "join_curve_seams",
    "join_seams",
    "limit_threads",
    "lode_angle",
    "merge_curve_pieces",
    "merge_pieces",
    "mode",
    "nodal_average",
    "piece_components",
    "read",
    "register_pyvista",
    "restrict_piece",
    "seam_of",
    "to_meshio",
    "to_pyvista",
    "verify",
    "write",
]
