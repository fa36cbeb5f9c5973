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
SaveData(f"{out}/surface.pvtp", proxy=surface, DataMode="Binary", CompressorType="None")
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
shown = Show(ProcessIdScalars(Input=surface), view)
ColorBy(shown, ("POINTS", "ProcessId"))
view.ResetCamera()
GetActiveCamera().Azimuth(35)
GetActiveCamera().Elevation(25)
SaveScreenshot(f"{out}/ranks.png", view)
