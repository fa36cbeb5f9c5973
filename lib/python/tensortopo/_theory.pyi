# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Callable, Optional


def statements() -> list[tuple[str, str, str, str]]: ...
def statements_called(name: str) -> list[str]: ...
def verify(
    ids: list[str],
    fields: int,
    seed: int,
    scalar: str,
    progress: Optional[Callable[[str, float], Any]],
) -> list[tuple[str, str, int, str, float]]: ...
