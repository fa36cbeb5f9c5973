# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Modes as exact numbers."""
from __future__ import annotations

import math
import numbers
from decimal import Decimal
from fractions import Fraction
from typing import Any, Sequence, Union

from . import _core

Mode = Union[str, int, float, Fraction, Decimal]


def mode_text(mode: Any) -> str:
    """The text of a mode, which the library reads exactly."""
    if isinstance(mode, str):
        return _core.parse_mode(mode.strip())
    if isinstance(mode, bool) or type(mode).__name__ in ("bool_", "bool"):
        raise ValueError("mode: a truth value is no mode")
    if isinstance(mode, numbers.Rational):
        return _core.parse_mode(f"{mode.numerator}/{mode.denominator}")
    if isinstance(mode, Decimal):
        if not mode.is_finite():
            raise ValueError(f"mode: {mode} is no mode")
        numerator, denominator = mode.as_integer_ratio()
        return _core.parse_mode(f"{numerator}/{denominator}")
    if isinstance(mode, numbers.Real):
        if not math.isfinite(mode):
            raise ValueError(f"mode: {mode} is no mode")
        # The shortest decimal that reads back as this number of its own type.
        return _core.parse_mode(str(mode))
    raise TypeError(f"mode: expected str, int, float, Fraction or Decimal, not {type(mode).__name__}")


def exact_mode(mode: Mode) -> Fraction:
    """A mode as the exact fraction that the library computes with.

    Parameters
    ----------
    mode : str, int, float, Fraction or Decimal
        Text as the program takes it (``"0.5"``, ``"-9/10"``, ``"1e-6"``), an exact number, or a float.
        A float stands for its shortest decimal: ``0.1`` is one tenth, as it is written, and not the
        binary number next to it. For that one, pass ``Fraction(0.1)``.

    Returns
    -------
    Fraction
        In [-1, 1].

    Raises
    ------
    ValueError
        For text that is no number, numbers outside [-1, 1], not a number, infinities, truth values,
        and modes that no double tells from 1 or -1.
    """
    return Fraction(mode_text(mode))


def mode_texts(modes: Union[Mode, Sequence[Mode]]) -> list[str]:
    """The texts of one mode or of several."""
    if not isinstance(modes, str) and getattr(modes, "shape", None) == ():
        modes = modes[()]  # the number in an array of dimension 0
    if isinstance(modes, (str, numbers.Number, Decimal)) or not hasattr(modes, "__iter__"):
        return [mode_text(modes)]
    return [mode_text(mode) for mode in modes]
