# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # A field of your own, from arrays
#
# Boxes cut in tetrahedra, a formula for the tensors, and the mode at which the topology changes.

# %%
import itertools

import numpy as np

import tensortopo as tt

n = 6  # boxes along each edge of the cube
index = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
steps = np.linspace(-1, 1, n + 1)
points = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3)

# %% [markdown]
# Each box is cut in six tetrahedra around its diagonal, one for each order of the axes, so that neighbours agree.

# %%
tets = []
for axes in itertools.permutations(range(3)):
    corner = np.zeros(3, int)
    path = [corner.copy()]
    for axis in axes:
        corner[axis] = 1
        path.append(corner.copy())
    tets.append(np.stack([index[tuple(slice(c, c + n) for c in p)].ravel() for p in path], axis=1))
tets = np.concatenate(tets)

# %% A symmetric 3x3 matrix at each point.
x, y, z = points.T
tensors = np.zeros((len(points), 3, 3))
tensors[:, 0, 0], tensors[:, 1, 1] = 1 + x, 1 - x + z * z / 2
tensors[:, 2, 2] = -2 - y * z
tensors[:, 0, 1] = tensors[:, 1, 0] = y
tensors[:, 1, 2] = tensors[:, 2, 1] = z * x / 3
print(tt.mode(tensors).min(), tt.mode(tensors).max())

# %%
field = tt.Field(points, tensors, tets)
print(field, field.neutral_surface())

# %% [markdown]
# Where does the topology change? The sweep finds every such mode in a range, with what happens there.

# %%
sweep = field.sweep("1/10", "9/10", samples=5)
print(sweep)
for event in sweep.events[:5]:
    print(f"{event.low:.6f}", [point.change for point in event.points], event.euler_change)
assert not sweep.contradictions

# %% [markdown]
# What is wrong with a mesh comes as data.

# %%
try:
    tt.Field(points, tensors, np.vstack([tets, tets[:1]]))
except tt.MeshError as error:
    print(error.defects)
else:
    raise AssertionError("a cell given twice was taken")
