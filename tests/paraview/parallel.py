# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""mpirun -n 2 pvbatch parallel.py PLUGIN OUT: the surface of a field in pieces, written in pieces."""
import sys

from paraview.simple import *

plugin, out = sys.argv[1:3]
LoadPlugin(plugin, remote=True, ns=globals())
reader = XMLPartitionedUnstructuredGridReader(FileName=[f"{out}/field.pvtu"])
ghosts = GhostCellsGenerator(Input=reader, BuildIfRequired=0, MinimumNumberOfGhosts=1)
surface = TensorModeSurface(Input=ghosts, Modes="1/2")
surface.UpdatePipeline()
SaveData(f"{out}/surface.pvtp", proxy=ProcessIdScalars(Input=surface), DataMode="Binary", CompressorType="None")
