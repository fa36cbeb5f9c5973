# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""pvbatch serial.py PLUGIN OUT: the plugin's bits are the library's; pictures of what it shows."""
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

data = servermanager.Fetch(surface)
compared = 0


def require_same(name, array):
    global compared
    found, wanted = vtk_to_numpy(array), expected[name]
    assert found.shape == wanted.shape and np.array_equal(found, wanted), name
    compared += 1


require_same("points", data.GetPoints().GetData())
for name in ("medium_eigenvector", "normal", "residual"):
    require_same(name, data.GetPointData().GetArray(name))
for name in ("tet", "component"):
    require_same(name, data.GetCellData().GetArray(name))
triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
assert np.array_equal(triangles, expected["triangles"]) and len(triangles) > 1000

lines = TensorDegenerateCurves(Input=reader)
lines.UpdatePipeline()
fetched = servermanager.Fetch(lines)
require_same("curve_points", fetched.GetPoints().GetData())
require_same("curve_separation", fetched.GetPointData().GetArray("separation"))
assert OutputPort(surface, 1).GetDataInformation().GetNumberOfPoints() == len(expected["curve_points"])
left_out = OutputPort(surface, 2).GetDataInformation().GetNumberOfCells()
assert left_out == int(expected["unresolved"]), left_out

# The slider's number is the same mode as its text.
slider = TensorModeSurface(Input=reader, UseSlider=1, Slider=0.5)
text = TensorModeSurface(Input=reader, Modes="0.5")
a, b = (servermanager.Fetch(f) for f in (slider, text))
assert np.array_equal(vtk_to_numpy(a.GetPoints().GetData()), vtk_to_numpy(b.GetPoints().GetData()))
compared += 1

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
bar = GetScalarBar(GetColorTransferFunction("mode"), view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]
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
shown.SetScalarBarVisibility(view, False)
SaveScreenshot(f"{out}/components.png", view)
print(f"serial: {compared} arrays and {len(triangles)} triangles are the library's, bit for bit")
