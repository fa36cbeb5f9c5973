# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Modes are exact numbers."""
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import tensortopo as tt


@pytest.mark.parametrize(
    "mode",
    ["1/10", "0.1", " 1e-1 ", 0.1, Fraction(1, 10), Decimal("0.1"), np.float64(0.1), np.float32(0.1)],
)
def test_one_tenth(mode):
    assert tt.exact_mode(mode) == Fraction(1, 10)


def test_whole_numbers_and_binary_values():
    assert tt.exact_mode(0) == 0 and tt.exact_mode(np.int32(-1)) == -1
    assert tt.exact_mode(Fraction(0.1)) == Fraction(0.1) != Fraction(1, 10)
    assert tt.exact_mode(0.1 + 0.2) == Fraction("0.30000000000000004")


@pytest.mark.parametrize("mode", [True, np.bool_(True), float("nan"), float("inf"), 2, -1.5, "half",
                                  "", "1/0", Decimal("NaN"), np.float64("nan"),
                                  Fraction(10**20 - 1, 10**20)])  # fmt: skip
def test_what_is_no_mode_is_a_value_error(mode):
    with pytest.raises(ValueError):
        tt.exact_mode(mode)


@pytest.mark.parametrize("mode", [None, 1j, object()])
def test_what_is_no_number_is_a_type_error(mode):
    with pytest.raises(TypeError):
        tt.exact_mode(mode)


def test_degenerate_modes_are_no_surfaces(slab):
    with pytest.raises(ValueError, match="degenerate curves"):
        slab.mode_surface(1)


def test_an_array_of_dimension_0_is_one_mode(slab):
    assert slab.mode_surface(np.array(0.3)).modes == slab.mode_surface(0.3).modes
    assert slab.mode_surface(np.str_("3/10")).modes == slab.mode_surface("3/10").modes
