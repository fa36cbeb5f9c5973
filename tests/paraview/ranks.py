# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""pvbatch ranks.py OUT: a picture of the surface that `parallel.py` wrote, by rank.

On one process: ParaView 5.11 with Open MPI 4.1 may wait for ever when two ranks draw together (IceT duplicates
a communicator on one, and the other has left the rendering).
"""
import sys

from paraview.simple import *

out = sys.argv[1]
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
shown = Show(XMLPartitionedPolydataReader(FileName=[f"{out}/surface.pvtp"]), view)
ColorBy(shown, ("POINTS", "ProcessId"))
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(GetColorTransferFunction("ProcessId"), view)
bar.Title, bar.ComponentTitle = "rank", ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.AutomaticLabelFormat = 0
bar.LabelFormat = bar.RangeLabelFormat = "%g"
view.OrientationAxesVisibility = 0
view.ResetCamera()
GetActiveCamera().Azimuth(35)
GetActiveCamera().Elevation(25)
SaveScreenshot(f"{out}/ranks.png", view)
