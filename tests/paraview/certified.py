# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""mpirun -n 2 pvbatch certified.py PLUGIN OUT KIND CERT MODE [CERT MODE ...]: certificates of parts of a field in pieces.

MODE is that of a surface; `linear` and `planar` are degenerate curves, and `both` are both kinds. KIND `lost` is `field`,
and the second rank ends before it is read. The status says how many filters fail.
"""
import sys

from paraview.simple import *

plugin, out, kind, *pairs = sys.argv[1:]
LoadPlugin(plugin, remote=True, ns=globals())
pieces = XMLPartitionedUnstructuredGridReader(FileName=[f"{out}/field.pvtu"])
field = GhostCellsGenerator(Input=pieces, BuildIfRequired=0, MinimumNumberOfGhosts=1)
if kind == "lost":
    script = """
import os, signal
from vtkmodules.vtkParallelCore import vtkMultiProcessController
if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1:
    os.kill(os.getpid(), signal.SIGKILL)
"""
    field = ProgrammableFilter(Input=field, Script=script, CopyArrays=1)
kinds = {"linear": "Linear (mode 1)", "planar": "Planar (mode -1)", "both": "Both"}
failed = 0
for certificate, mode in zip(pairs[::2], pairs[1::2]):
    if mode in kinds:
        made = TensorDegenerateCurves(Input=field, Kind=kinds[mode], Certificate=certificate)
    else:
        made = TensorModeSurface(Input=field, Modes=mode, AllSamples=1, Certificate=certificate)
    made.UpdatePipeline()
    failed += "components" not in made.FieldData.keys()
if failed:
    sys.exit(failed)
