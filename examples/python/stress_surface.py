# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # A stress field and its mode surface
#
# Read a field, extract the surface on which its mode is 1/2, have its certificate checked by code that shares nothing
# with the extractor, and write it for ParaView.

# %%
import os
from pathlib import Path

import tensortopo as tt

data = Path(os.environ.get("TENSORTOPO_DATA", "examples/data"))
field = tt.read(data / "s4_slab_small_C3D8I.vtu")
field

# %% [markdown]
# Modes are exact: `0.5`, `"1/2"` and `Fraction(1, 2)` are the same number.

# %%
surface = field.mode_surface(0.5, certify=True)
surface

# %% The topology, one component after the other.
for component in surface.components:
    print(component.euler_characteristic, component.boundary_loops, component.genus, component.triangles)

# %% What was left out, with its reason. (Nothing, here.)
print(surface.unresolved)

# %% Every claim of the certificate is derived again from the bits of the tensors.
verdict = tt.check(field, surface)
print(verdict)
assert verdict

# %%
tt.write("surface.vtp", surface)

# %% Degenerate curves are polylines.
curves = field.degenerate_curves("both")
print(curves)
print([len(line) for line in curves.lines][:10])
tt.write("curves.vtp", curves)
