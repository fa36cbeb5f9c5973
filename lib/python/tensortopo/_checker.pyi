# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Callable, Optional

class Malformed(ValueError): ...

def check(
    input: str,
    surface: str,
    certificate: str,
    modes: list[str],
    tensor: str,
    complete: bool,
    progress: Optional[Callable[[str, float], Any]],
) -> dict[str, Any]: ...
