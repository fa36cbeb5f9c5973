# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""mpirun -n 2 pvbatch parallel.py PLUGIN OUT KIND [CELLS]: the surfaces and curves of a field in pieces, written in pieces.

Ends with status 1 if a filter fails, which leaves its output without the field array `components`. KIND `alone`
is `field` without ghosts.
"""
import sys

from paraview.simple import *

plugin, out, kind, *cells = sys.argv[1:]
LoadPlugin(plugin, remote=True, ns=globals())
file = "field" if kind == "alone" else kind
pieces = XMLPartitionedUnstructuredGridReader(FileName=[f"{out}/{file}.pvtu"])
if kind != "alone":
    pieces = GhostCellsGenerator(Input=pieces, BuildIfRequired=0, MinimumNumberOfGhosts=1)
surface = TensorModeSurface(Input=pieces, Modes="1/2", Generalized=1, NumberOfCells=int(cells[0]) if cells else 0)
surface.UpdatePipeline()
if "components" not in surface.FieldData.keys():
    sys.exit(1)
SaveData(f"{out}/surface.pvtp", proxy=ProcessIdScalars(Input=surface), DataMode="Binary", CompressorType="None")
curves = TensorDegenerateCurves(Input=pieces)
curves.UpdatePipeline()
if "components" not in curves.FieldData.keys():
    sys.exit(1)
SaveData(f"{out}/curves.pvtp", proxy=curves, DataMode="Binary", CompressorType="None")
