# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Certificates, checked by code that shares nothing with what makes them."""
from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from ._curve_pieces import MergedCurves
from ._errors import FileError
from ._field import Field
from ._files import write, write_at_ids
from ._modes import Mode, mode_texts
from ._partition import MergedSurface
from ._surface import Curves, Surface

PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Finding:
    """A claim that is wrong, or could not be decided: what it is about, claimed and derived."""

    entity: str
    claimed: str
    derived: str


@dataclass(frozen=True)
class Verdict:
    """What came of a certificate's claims, each counted once.

    Attributes
    ----------
    status : str
        ``refuted`` if one claim is, else ``undecided`` if one is, else ``certified``.
    certified, refuted, undecided : int
    refutations, open : tuple of Finding
        The first refuted and the first undecided claims.
    unmet : tuple of str
        What was demanded and is not certified, in words.
    text : str
        The checker's own report.
    """

    status: str
    certified: int
    refuted: int
    undecided: int
    refutations: tuple[Finding, ...] = ()
    open: tuple[Finding, ...] = ()
    unmet: tuple[str, ...] = ()
    text: str = ""

    def __bool__(self) -> bool:
        """Whether all claims are certified, and all demands met."""
        return self.status == "certified" and not self.unmet

    def __repr__(self) -> str:
        claims = self.certified + self.refuted + self.undecided
        unmet = f"; not met: {'; '.join(self.unmet)}" if self.unmet else ""
        return f"Verdict({self.status}: {self.certified} of {claims} claims certified{unmet})"


def check(
    field: Union[Field, PathLike],
    output: Union[Surface, MergedSurface, Curves, MergedCurves, PathLike],
    certificate: Union[bytes, PathLike, None] = None,
    *,
    expect_modes: Optional[Sequence[Mode]] = None,
    expect_tensor: Optional[str] = None,
    expect_complete: bool = False,
    progress: Optional[Callable[[str, float], Any]] = None,
) -> Verdict:
    """Derives every claim of a certificate again, from the bits of the tensors.

    By the code of ``tensortopo_check``, in a module that links nothing of the library. Objects are
    written to temporary files, which it reads.

    Parameters
    ----------
    field : Field or path
        The field, or its file (.vtu, .vtk; .pvtu of a surface in parts).
    output : Surface, MergedSurface, Curves, MergedCurves or path
        The surface or the curves, or their file (.vtp; .pvtp with a certificate of parts).
    certificate : bytes or path, optional
        By default that of ``output``.
    expect_modes : sequence of modes, optional
        What must be certified; by default the modes of `output`, of files nothing.
    expect_tensor : str, optional
        The name that the certificate must have for the tensors.
    expect_complete : bool, default False
        Nothing of the field may be left out.
    progress : callable, optional
        As in `Field.mode_surface`.

    Returns
    -------
    Verdict
        True where a condition is asked for, if all claims are certified.

    Raises
    ------
    FileError
        For files that are not what they should be.
    ValueError
        If there is no certificate; for a `Field` whose ``cell_ids``, by which certificates name its
        tetrahedra, are not those of cells of a file in ascending order.
    """
    from . import _checker

    if certificate is None and isinstance(output, (Surface, MergedSurface, Curves, MergedCurves)):
        certificate = output.certificate
    if certificate is None:
        raise ValueError("certificate: there is none; extract with certify=True")
    if expect_modes is None:
        known = output.levels if isinstance(output, (Surface, Curves)) else ()
        expect_modes = [level.mode for level in known]
    with tempfile.TemporaryDirectory(prefix="tensortopo-") as folder:
        files = []
        for what, name in ((field, "field.vtu"), (output, "output.vtp")):
            if isinstance(what, Field):
                write_at_ids(Path(folder) / name, what)
                files.append(str(Path(folder) / name))
            elif isinstance(what, (Surface, MergedSurface, Curves, MergedCurves)):
                write(Path(folder) / name, what)
                files.append(str(Path(folder) / name))
            else:
                files.append(os.fspath(what))
        if isinstance(certificate, bytes):
            encoding = "json" if certificate.lstrip()[:1] == b"{" else "cbor"
            path = Path(folder) / f"certificate.{encoding}"
            path.write_bytes(certificate)
            files.append(str(path))
        else:
            files.append(os.fspath(certificate))
        try:
            report = _checker.check(
                files[0],
                files[1],
                files[2],
                mode_texts(expect_modes),
                expect_tensor or "",
                expect_complete,
                progress,
            )
        except _checker.Malformed as error:
            raise FileError(str(error)) from error
    for key in ("refutations", "open"):
        report[key] = tuple(Finding(*finding) for finding in report[key])
    report["unmet"] = tuple(report["unmet"])
    return Verdict(**report)


def certify(
    field: Field, mode: Any, **options: Any
) -> tuple[Surface, Verdict]:
    """Extracts a mode surface with a certificate, and checks it.

    Parameters
    ----------
    field : Field
    mode, **options
        As of `Field.mode_surface`.

    Returns
    -------
    surface : Surface
        With its certificate.
    verdict : Verdict
        Of the independent checker.
    """
    surface = field.mode_surface(mode, certify=True, **options)
    return surface, check(field, surface)
