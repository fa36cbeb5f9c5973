# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The paper's statements, tried."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Optional, Sequence, Union


@dataclass(frozen=True)
class Statement:
    """What trying a statement has given.

    Attributes
    ----------
    id, paper, claim : str
        Its name here and in the paper, and what the paper says.
    corrected : str
        What is true instead; empty if the claim is.
    verdict : str
        ``holds``, ``corrected``, ``refuted`` or ``undecided``.
    tried : int
        Fields that satisfied the hypotheses.
    witness : str
        Of a refutation.
    seconds : float
    """

    id: str
    paper: str
    claim: str
    corrected: str
    verdict: str
    tried: int
    witness: str
    seconds: float


def verify(
    theorems: Union[None, str, int, Sequence[Union[str, int]]] = None,
    *,
    fields: int = 100,
    seed: int = 1,
    scalar: str = "rational",
    progress: Optional[Callable[[str, float], Any]] = None,
) -> list[Statement]:
    """Tries the paper's statements on random linear fields, as ``tensortopo verify`` does.

    Parameters
    ----------
    theorems : str, int or sequence of these, optional
        Ids of statements, or the paper's numbers 1 to 6; all by default.
    fields : int, default 100
        How many random fields.
    seed : int, default 1
    scalar : {"rational", "interval", "real100", "double"}
        What to compute with.
    progress : callable, optional
        As in `Field.mode_surface`; some statements take long, and end at their end only.

    Returns
    -------
    list of Statement
        In the order asked for.
    """
    from . import _theory

    if fields < 1 or seed < 0:
        raise ValueError("fields: at least 1; seed: at least 0")
    known = {statement[0]: statement[1:] for statement in _theory.statements()}
    if isinstance(theorems, (str, int)):
        theorems = [theorems]
    ids = list(known) if theorems is None else []
    for name in theorems or ():
        called = _theory.statements_called(str(name))
        if not called:
            raise ValueError(
                f"theorems: there is no '{name}'; there are the paper's numbers 1 to 6, and "
                + ", ".join(known)
            )
        ids += called
    tried = _theory.verify(ids, fields, seed, scalar, progress)
    return [
        Statement(id, *known[id], verdict, count, witness, seconds)
        for id, verdict, count, witness, seconds in tried
    ]
