# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""How many threads the library uses."""
from contextlib import contextmanager
from typing import Iterator

from . import _core


@contextmanager
def limit_threads(count: int) -> Iterator[None]:
    """A context in which the library uses at most so many threads.

    Results are the same, bit for bit, whatever the number. The checker of certificates has threads of its
    own, one for each processor that the process may use (`taskset`).

    Parameters
    ----------
    count : int
        One at least.

    Raises
    ------
    ValueError
        If it is less than one.

    Examples
    --------
    >>> import tensortopo as tt
    >>> field = tt.generate("linear", seed=3).field
    >>> with tt.limit_threads(1):
    ...     surface = field.mode_surface("1/2")
    """
    if count < 1:
        raise ValueError(f"limit_threads: {count} is less than one thread")
    limit = _core.ThreadLimit(count)
    try:
        yield
    finally:
        del limit
