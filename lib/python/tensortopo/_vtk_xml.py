# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""VTK's XML files as arrays, both ways."""
from __future__ import annotations

import base64
import binascii
import os
import struct
import tempfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from ._errors import FileError

Array = npt.NDArray[Any]

_TYPES = {
    "Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4",
    "Int64": "i8", "UInt64": "u8", "Float32": "f4", "Float64": "f8",
}  # fmt: skip
_NAMES = {value: name for name, value in _TYPES.items()}
_BLOCK = 1 << 20  # bytes that are compressed together


@dataclass
class XmlArray:
    """An array of a file.

    Attributes
    ----------
    values : ndarray
        Of one dimension, or a row a tuple.
    names : tuple of str
        The names of the components, empty where the file has none.
    """

    values: Array
    names: tuple[str, ...] = ()


@dataclass
class XmlPiece:
    """The one piece of a file, by section and array."""

    kind: str
    sections: dict[str, dict[str, XmlArray]] = field(default_factory=dict)


class _Reader:
    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            data = path.read_bytes()
        except OSError as error:
            raise FileError(f"{path}: {error.strerror or error}") from error
        self.appended: Optional[bytes] = None
        self.raw = False
        start = data.find(b"<AppendedData")
        if start >= 0:
            # What is appended may be no XML: it begins after the first underscore.
            head = data.find(b">", start)
            mark = data.find(b"_", head)
            end = data.rfind(b"</AppendedData>")
            if head < 0 or mark < 0 or end < mark:
                raise self.error("the appended data are cut off")
            self.raw = b'"raw"' in data[start:head] or b"'raw'" in data[start:head]
            self.appended = data[mark + 1 : end]
            data = data[: head + 1] + b"</AppendedData></VTKFile>"
        try:
            self.root = ElementTree.fromstring(data)
        except ElementTree.ParseError as error:
            raise self.error(f"is no XML ({error})") from error
        if self.root.tag != "VTKFile":
            raise self.error("is no VTK file")
        self.order = ">" if self.root.get("byte_order") == "BigEndian" else "<"
        self.header = "Q" if self.root.get("header_type") == "UInt64" else "I"
        compressor = self.root.get("compressor", "")
        if compressor not in ("", "vtkZLibDataCompressor"):
            raise self.error(
                f"is compressed by {compressor}; rewrite it with: tensortopo convert {path} -o OUT.vtu"
            )
        self.compressed = compressor != ""

    def error(self, problem: str) -> FileError:
        return FileError(f"{self.path}: {problem}")

    def _decoded(self, text: bytes, size: int) -> bytes:
        """The first bytes of base64 text that is padded at its end."""
        try:
            return base64.b64decode(text[: (size + 2) // 3 * 4], validate=True)
        except binascii.Error as error:
            raise self.error(f"is no base64 ({error})") from error

    def _unpack(self, data: bytes, count: int) -> tuple[int, ...]:
        size = struct.calcsize(self.order + self.header)
        if len(data) < size * count:
            raise self.error("an array is cut off")
        return struct.unpack_from(f"{self.order}{count}{self.header}", data)

    def _block(self, data: bytes, is_raw: bool) -> bytes:
        """The bytes of an array, from its header on."""
        word = struct.calcsize(self.order + self.header)

        def take(start: int, size: int) -> bytes:
            if is_raw:
                return data[start : start + size]
            return self._decoded(data[start:], size)[:size]

        def length(size: int) -> int:
            return size if is_raw else (size + 2) // 3 * 4

        if not self.compressed:
            (size,) = self._unpack(take(0, word), 1)
            block = take(0, word + size)[word:]
            if len(block) != size:
                raise self.error("an array is cut off")
            return block
        (blocks,) = self._unpack(take(0, word), 1)
        if blocks == 0:
            return b""
        if blocks > len(data):
            raise self.error("an array is cut off")
        head = self._unpack(take(0, word * (3 + blocks)), 3 + blocks)
        sizes = head[3:]
        block = take(length(word * (3 + blocks)), sum(sizes))
        parts, at = [], 0
        for i, size in enumerate(sizes):
            whole = head[2] if i == blocks - 1 and head[2] > 0 else head[1]
            try:
                unpacker = zlib.decompressobj()
                part = unpacker.decompress(block[at : at + size], whole + 1)
            except zlib.error as error:
                raise self.error(f"an array does not decompress ({error})") from error
            if len(part) != whole:
                raise self.error("an array does not decompress to its declared size")
            parts.append(part)
            at += size
        return b"".join(parts)

    def _numbers(self, element: ElementTree.Element, dtype: np.dtype[Any]) -> Array:
        form = element.get("format", "ascii")
        if form == "ascii":
            words = (element.text or "").split()
            try:
                if dtype.kind == "f":
                    return np.array([float(w) for w in words], dtype=np.float64).astype(dtype)
                return np.array([int(w) for w in words], dtype=np.int64).astype(dtype)
            except (ValueError, OverflowError) as error:
                raise self.error(f"an array has text that is no number ({error})") from error
        if form == "binary":
            data = self._block("".join((element.text or "").split()).encode("ascii", "replace"), False)
        elif form == "appended" and self.appended is not None:
            offset = int(element.get("offset", "-1"))
            if not 0 <= offset <= len(self.appended):
                raise self.error("an array begins outside of the file")
            data = self._block(self.appended[offset:], self.raw)
        else:
            raise self.error(f"has an array of unknown format '{form}'")
        if len(data) % dtype.itemsize:
            raise self.error("an array ends within a number")
        return np.frombuffer(data, dtype).astype(dtype.newbyteorder("="))

    def array(self, element: ElementTree.Element) -> XmlArray:
        name = element.get("type", "")
        if name not in _TYPES:
            raise self.error(f"has an array of unknown type '{name}'")
        values = self._numbers(element, np.dtype(self.order + _TYPES[name]))
        width = int(element.get("NumberOfComponents", "1") or "1")
        if width < 1 or len(values) % width:
            raise self.error(f"the array '{element.get('Name')}' is not of full rows")
        labels = [element.get(f"ComponentName{i}") for i in range(width)]
        names = tuple(label or "" for label in labels)
        return XmlArray(values.reshape(-1, width) if width > 1 else values, names)


def read_piece(path: Path) -> XmlPiece:
    """The arrays of a .vtu or .vtp of one piece.

    Raises
    ------
    FileError
        For anything else, with the file's name.
    """
    reader = _Reader(path)
    kind = reader.root.get("type", "")
    grid = reader.root.find(kind) if kind.isidentifier() else None
    pieces = [] if grid is None else grid.findall("Piece")
    if len(pieces) != 1:
        raise reader.error(f"has {len(pieces)} pieces; one is read here")
    piece = XmlPiece(kind)
    for section in pieces[0]:
        arrays = piece.sections.setdefault(section.tag, {})
        for number, element in enumerate(section.findall("DataArray")):
            arrays[element.get("Name") or str(number)] = reader.array(element)
    return piece


def _encoded(values: Array) -> str:
    data = values.tobytes()
    blocks = [data[i : i + _BLOCK] for i in range(0, len(data), _BLOCK)]
    packed = [zlib.compress(block) for block in blocks]
    last = len(blocks[-1]) % _BLOCK if blocks else 0
    head = struct.pack(f"<{3 + len(blocks)}Q", len(blocks), _BLOCK, last, *map(len, packed))
    return (base64.b64encode(head) + base64.b64encode(b"".join(packed))).decode("ascii")


def escaped(text: str) -> str:
    """As the value of an attribute."""
    for a, b in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        text = text.replace(a, b)
    return text


def piece_text(
    kind: str,
    counts: dict[str, int],
    sections: dict[str, dict[str, Array]],
    *,
    marks: Optional[Mapping[str, str]] = None,
    names: Optional[Mapping[str, tuple[str, ...]]] = None,
) -> str:
    """A .vtu or .vtp, inline binary, which VTK and ParaView of all versions read.

    Parameters
    ----------
    kind, counts, sections
        The grid's type, the piece's attributes, and arrays by section and name.
    marks : mapping of str to str
        Which point array is the points' ``Tensors``, ``Normals``, ``Scalars``.
    names : mapping of str to tuple of str
        The names of components, by point array.
    """
    lines = [
        '<?xml version="1.0"?>',
        f'<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
        'compressor="vtkZLibDataCompressor">',
        f"<{kind}>",
        "<Piece " + " ".join(f'{name}="{count}"' for name, count in counts.items()) + ">",
    ]
    for section, arrays in sections.items():
        is_points = section == "PointData"
        attributes = [f' {mark}="{escaped(name)}"' for mark, name in (marks or {}).items() if is_points]
        lines.append(f"<{section}{''.join(attributes)}>")
        for name, values in arrays.items():
            flat = np.ascontiguousarray(values)
            flat = flat.astype(flat.dtype.newbyteorder("<"), copy=False)
            width = flat.shape[1] if flat.ndim == 2 else 1
            number = _NAMES[flat.dtype.kind + str(flat.dtype.itemsize)]
            labels = names.get(name, ()) if names and is_points else ()
            spelled = "".join(f'ComponentName{i}="{label}" ' for i, label in enumerate(labels))
            lines.append(
                f'<DataArray type="{number}" Name="{escaped(name)}" NumberOfComponents="{width}" {spelled}'
                f'format="binary">{_encoded(flat)}</DataArray>'
            )
        lines.append(f"</{section}>")
    lines += ["</Piece>", f"</{kind}>", "</VTKFile>", ""]
    return "\n".join(lines)


def write_whole(files: Mapping[Path, bytes]) -> None:
    """Writes files whole, all of them or none."""
    made: dict[Path, str] = {}
    path = Path()
    try:
        for path, data in files.items():
            handle, made[path] = tempfile.mkstemp(dir=path.parent, prefix=".tensortopo-")
            with os.fdopen(handle, "wb") as stream:
                stream.write(data)
            os.chmod(made[path], 0o666 & ~_umask())
        for path in list(made):
            os.replace(made.pop(path), path)
    except OSError as error:
        raise FileError(f"{path}: cannot be written ({error.strerror or error})") from error
    finally:
        for temporary in made.values():
            os.unlink(temporary)


def _umask() -> int:
    mask = os.umask(0o022)
    os.umask(mask)
    return mask
