# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""pvbatch serial.py PLUGIN OUT: the plugin's bits are the program's; pictures of what it shows."""
import sys

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

plugin, out = sys.argv[1:3]
LoadPlugin(plugin, remote=False, ns=globals())
expected = np.load(f"{out}/expected.npz")

reader = XMLUnstructuredGridReader(FileName=[f"{out}/field.vtu"])
surface = TensorModeSurface(Input=reader, Modes="1/2", Generalized=1, DegenerateCurves="Both")
surface.UpdatePipeline()
print("tensors:", list(surface.Tensors))

compared = 0


def require_same(kind, fetched):
    """Each array of the program's file is there, bit for bit."""
    global compared
    cells = fetched.GetPolys() if kind == "surface" else fetched.GetLines()
    special = {
        "points": fetched.GetPoints().GetData(),
        "cells": cells.GetConnectivityArray(),
        "offsets": cells.GetOffsetsArray(),
    }
    for key in expected.files:
        if not key.startswith(kind + "_"):
            continue
        name = key.removeprefix(kind + "_")
        array = special.get(name) or fetched.GetPointData().GetArray(name) or fetched.GetCellData().GetArray(name)
        found, wanted = vtk_to_numpy(array), expected[key]
        if name == "offsets":  # a file leaves out the first
            found = found[1:]
        assert found.dtype == wanted.dtype and found.shape == wanted.shape, (key, found.dtype, wanted.dtype)
        assert found.tobytes() == wanted.tobytes(), key
        compared += 1


require_same("surface", servermanager.Fetch(surface))
triangles = len(expected["surface_cells"]) // 3
assert triangles > 1000
lines = TensorDegenerateCurves(Input=reader)
lines.UpdatePipeline()
require_same("curves", servermanager.Fetch(lines))
require_same("curves", servermanager.Fetch(surface, idx=1))
left_out = OutputPort(surface, 2).GetDataInformation().GetNumberOfCells()
assert left_out == int(expected["unresolved"]), left_out

# The slider's number is the same mode as its text.
slider = TensorModeSurface(Input=reader, UseSlider=1, Slider=0.5)
text = TensorModeSurface(Input=reader, Modes="0.5")
a, b = (servermanager.Fetch(f) for f in (slider, text))
assert np.array_equal(vtk_to_numpy(a.GetPoints().GetData()), vtk_to_numpy(b.GetPoints().GetData()))

# Uncertainty marks triangles.
uncertain = TensorModeSurface(Input=reader, Modes="1/2", Uncertainty="1%")
stable = vtk_to_numpy(servermanager.Fetch(uncertain).GetCellData().GetArray("stable"))
assert 0 < stable.sum() < len(stable)

# Pictures.
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
outline = Show(reader, view)
outline.Representation = "Outline"
outline.AmbientColor = outline.DiffuseColor = [0.3, 0.3, 0.3]
shown = Show(surface, view)
ColorBy(shown, ("POINTS", "mode"))
shown.SetScalarBarVisibility(view, True)


def style_bar(array):
    """A legend that is read on white, of plain numbers."""
    bar = GetScalarBar(GetColorTransferFunction(array), view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%g"


style_bar("mode")
tubes = Tube(Input=OutputPort(surface, 1))
bounds = reader.GetDataInformation().GetBounds()
tubes.Radius = 0.004 * max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
thick = Show(tubes, view)
thick.ColorArrayName = ["POINTS", ""]
thick.AmbientColor = thick.DiffuseColor = [0.1, 0.1, 0.1]
view.ResetCamera()
camera = GetActiveCamera()
camera.Azimuth(35)
camera.Elevation(25)
view.ResetCamera()
SaveScreenshot(f"{out}/surface.png", view)
ColorBy(shown, ("CELLS", "component"))
shown.SetScalarBarVisibility(view, True)
style_bar("component")
HideUnusedScalarBars(view)
SaveScreenshot(f"{out}/components.png", view)
print(f"serial: {compared} arrays and {triangles} triangles are the program's, bit for bit")
