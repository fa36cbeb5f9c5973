# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""exodus.py IN.vtu OUT.e: an Exodus II file as VTK and ParaView write it (Sandia's library)."""
import sys

from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
writer = vtkExodusIIWriter()
writer.SetInputConnection(reader.GetOutputPort())
writer.SetFileName(sys.argv[2])
if not writer.Write():
    sys.exit(f"{sys.argv[2]}: cannot be written")
