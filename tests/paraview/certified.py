# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""mpirun -n 2 pvbatch certified.py PLUGIN OUT KIND CERT MODE [MASK]: a certificate of parts of the field KIND in OUT.

MODE is the mode of a surface; `linear` and `planar` are degenerate curves, and `both` are both kinds. Ends with status 1
if the filter fails. MASK is the umask, in octal, that the first rank has meanwhile.
"""
import os
import sys

from paraview.simple import *

plugin, out, kind, certificate, mode, *mask = sys.argv[1:]
LoadPlugin(plugin, remote=True, ns=globals())
pieces = XMLPartitionedUnstructuredGridReader(FileName=[f"{out}/{kind}.pvtu"])
ghosts = GhostCellsGenerator(Input=pieces, BuildIfRequired=0, MinimumNumberOfGhosts=1)
kinds = {"linear": "Linear (mode 1)", "planar": "Planar (mode -1)", "both": "Both"}
if mode in kinds:
    filter = TensorDegenerateCurves(Input=ghosts, Kind=kinds[mode], Certificate=certificate)
else:
    filter = TensorModeSurface(Input=ghosts, Modes=mode, AllSamples=1, Certificate=certificate)
if mask:
    ghosts.UpdatePipeline()
    os.umask(int(mask[0], 8))
filter.UpdatePipeline()
if "components" not in filter.FieldData.keys():
    sys.exit(1)
