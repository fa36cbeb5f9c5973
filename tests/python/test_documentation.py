# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Everything public is documented, parameters included."""
import inspect

import pytest

import tensortopo as tt

PUBLIC = [name for name in tt.__all__ if inspect.isclass(getattr(tt, name)) or callable(getattr(tt, name))]


def require_parameters(function, text):
    for name in inspect.signature(function).parameters:
        if name not in ("self", "cls", "args", "kwargs", "options"):
            assert name in text, f"{function.__qualname__}: {name}"


@pytest.mark.parametrize("name", PUBLIC)
def test_documented(name):
    entity = getattr(tt, name)
    text = inspect.getdoc(entity)
    assert text, name
    if inspect.isfunction(entity):
        require_parameters(entity, text)
        return
    for method, value in vars(entity).items():
        if method.startswith("_") or not (inspect.isfunction(value) or isinstance(value, property)):
            continue
        inner = inspect.getdoc(value)
        assert inner, f"{name}.{method}"
        if inspect.isfunction(value):
            require_parameters(value, inner)


def test_there_is_something_to_document():
    assert len(PUBLIC) > 35
