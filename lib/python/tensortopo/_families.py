# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Fields whose mode surfaces are known or certifiable."""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from . import _core
from ._field import Field


@dataclass(frozen=True)
class Generated:
    """A generated field.

    Attributes
    ----------
    field : Field
    modes : tuple of Fraction
        Levels worth a look.
    note : str
        What this member of the family is.
    """

    field: Field
    modes: tuple[Fraction, ...]
    note: str


def field_kinds() -> tuple[str, ...]:
    """The families that `generate` knows."""
    return tuple(_core.family_kinds())


def generate(
    kind: str, *, seed: int = 1, member: int = 0, members: int = 1, tetrahedra: int = 0
) -> Generated:
    """A member of a family of fields, as ``tensortopo generate`` makes it.

    Parameters
    ----------
    kind : str
        One of `field_kinds`.
    seed : int, default 1
    member, members : int
        Which member of a family of how many.
    tetrahedra : int, default 0
        At least so many, where a mesh is made; 0 for the kind's default.

    Returns
    -------
    Generated
        The same numbers for the same arguments everywhere. The truth about a mode surface is
        ``field.mode_surface(mode, certify=True)``: its ``components``, and for every edge, face and
        tetrahedron its ``certificate``.
    """
    if min(seed, member, tetrahedra) < 0 or members < 1:
        raise ValueError("seed, member, tetrahedra: at least 0; members: at least 1")
    mesh, modes, note = _core.family_member(kind, seed, member, members, tetrahedra)
    return Generated(Field._of(mesh, "tensor"), tuple(Fraction(mode) for mode in modes), note)
