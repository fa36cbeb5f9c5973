# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Diffusion-weighted signals of two bundles of fibres that cross: signal, mask and gradients."""
import nibabel
import numpy as np

rng = np.random.default_rng(1)
size = (14, 12, 10)
x, y, z = (
    2 * index / (count - 1) - 1
    for index, count in zip(np.meshgrid(*map(np.arange, size), indexing="ij"), size)
)


def bundle(direction, along, across):
    d = np.stack(direction, -1)
    d /= np.linalg.norm(d, axis=-1, keepdims=True)
    return across * np.eye(3) + (along - across) * d[..., :, None] * d[..., None, :]


one = np.ones_like(x)
first = bundle((one, 0.8 * x, 0.3 * z), 1.7e-3, 0.3e-3)
second = bundle((0.2 * y, one, 0.6 * x), 1.5e-3, 0.4e-3)
w1 = np.exp(-(((y - 0.4 * x * x) / 0.5) ** 2) - (z / 0.6) ** 2)[..., None, None]
w2 = np.exp(-(((x + 0.2 * y) / 0.5) ** 2) - ((z - 0.2) / 0.6) ** 2)[..., None, None]
diffusion = (w1 * first + w2 * second + 0.25 * 0.7e-3 * np.eye(3)) / (w1 + w2 + 0.25)

g = rng.normal(size=(24, 3))
g = np.vstack([np.zeros((2, 3)), g / np.linalg.norm(g, axis=1, keepdims=True)])
b = np.r_[0, 0, np.full(24, 1000.0)]
signal = 1000 * np.exp(-b * np.einsum("ni,...ij,nj->...n", g, diffusion, g))
signal = np.hypot(signal + rng.normal(0, 8, signal.shape), rng.normal(0, 8, signal.shape))

turn = np.array([[1, 0, 0], [0, 0.99, 0.14106735979665885], [0, -0.14106735979665885, 0.99]])
to_space = np.eye(4)
to_space[:3, :3] = 2 * turn
to_space[:3, 3] = (-13, -11, -9)
nibabel.save(nibabel.Nifti1Image(signal.astype(np.float32), to_space), "signal.nii.gz")
mask = (x * x + y * y + z * z < 1.15).astype(np.uint8)
nibabel.save(nibabel.Nifti1Image(mask, to_space), "mask.nii.gz")
np.savetxt("gradients.b", np.c_[g, b], fmt="%.6f")
