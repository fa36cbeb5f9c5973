# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Where the program is, for what is not in the modules."""
from __future__ import annotations

import os
import shutil
from typing import Optional

from ._errors import FileError


def has_program() -> bool:
    """Whether `find_program` finds one."""
    return bool(os.environ.get("TENSORTOPO_PROGRAM") or shutil.which("tensortopo"))


def find_program(path: Optional[str] = None) -> str:
    """The program: as given, else what TENSORTOPO_PROGRAM names, else tensortopo on the path."""
    found = path or os.environ.get("TENSORTOPO_PROGRAM") or shutil.which("tensortopo")
    if found is None:
        raise FileError(
            "tensortopo: the program is not on the path; pass program=, or set TENSORTOPO_PROGRAM"
        )
    return found
