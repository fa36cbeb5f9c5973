# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # Diffusion tensors on a grid of voxels
#
# The mode of a diffusion tensor tells fibres (mode 1) from sheets (mode -1); the neutral surface lies between. A
# phantom stands in for a measured volume here; with nibabel, `tensors = nibabel.load("dt.nii.gz").get_fdata()` takes its
# place.

# %%
import numpy as np

import tensortopo as tt

shape = (9, 9, 9)
x, y, z = np.meshgrid(*(np.linspace(-1, 1, k) for k in shape), indexing="ij")
# Fibres along z in the middle, sheets across x outside, as the six volumes that MRtrix writes.
inside = np.exp(-4 * (x**2 + y**2))
zero = np.zeros(shape)
tensors = np.stack([
    0.3 + 0 * x, 0.3 + 0.9 * (1 - inside), 0.3 + 0.9 * inside + 0.8 * (1 - inside),
    0.05 * x * y, 0.04 * z, zero,
], axis=-1)  # fmt: skip

# %% The vectorised functions take volumes as they are.
mode = tt.mode(tensors, components="mrtrix")
print(mode.shape, mode.min(), mode.max())

# %% Voxel centres as points, each box of eight cut in six tetrahedra that match across boxes.
number = np.arange(np.prod(shape)).reshape(shape)
paths = [(1, 2, 4), (1, 4, 2), (2, 1, 4), (2, 4, 1), (4, 1, 2), (4, 2, 1)]


def corner(bits):
    return number[tuple(slice(b, b + s - 1) for b, s in zip((bits & 1, bits >> 1 & 1, bits >> 2), shape))]


tets = np.concatenate([
    np.stack([corner(c).ravel() for c in (0, a, a | b, a | b | c)], axis=1) for a, b, c in paths
])  # fmt: skip
points = np.stack([x, y, z], axis=-1).reshape(-1, 3)

# %%
field = tt.Field(points, tensors.reshape(-1, 6), tets, components="mrtrix")
surface = field.neutral_surface(certify=True)
print(surface)
print(tt.check(field, surface))
