# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Callable, Optional, Union

import numpy as np
import numpy.typing as npt

_Doubles = npt.NDArray[np.float64]
_Progress = Optional[Callable[[str, float], Any]]


class Mesh:
    def __init__(
        self,
        points: _Doubles,
        tensors: _Doubles,
        tets: npt.NDArray[np.int64],
        cell_ids: npt.NDArray[np.int64],
    ) -> None: ...
    def torn_cells(self) -> list[int]: ...
    def is_isotropic(self) -> bool: ...
    @property
    def points(self) -> _Doubles: ...
    @property
    def tensors(self) -> _Doubles: ...
    @property
    def tets(self) -> npt.NDArray[np.int32]: ...
    @property
    def cell_ids(self) -> npt.NDArray[np.int64]: ...
    @property
    def defects(self) -> list[tuple[str, int, str]]: ...
    @property
    def reoriented(self) -> int: ...
    def sha256(self) -> str: ...
    def surfaces(
        self,
        modes: list[str],
        generalized: bool,
        resolution: float,
        all_samples: bool,
        improve: bool,
        manifold: bool,
        max_error: float,
        certify: bool,
        uncertainty: Union[None, float, str, list[float]],
        tensor: str,
        progress: _Progress,
    ) -> dict[str, Any]: ...
    def curves(
        self,
        linear: bool,
        planar: bool,
        resolution: float,
        certify: bool,
        uncertainty: Union[None, float, str, list[float]],
        tensor: str,
        progress: _Progress,
    ) -> dict[str, Any]: ...
    def piece(
        self,
        mode: str,
        vertex_ids: npt.NDArray[np.int64],
        owned: npt.NDArray[np.bool_],
        whole_cells: int,
        resolution: float,
        all_samples: bool,
        certify: bool,
        progress: _Progress,
    ) -> dict[str, Any]: ...
    def curve_piece(
        self,
        kind: str,
        vertex_ids: npt.NDArray[np.int64],
        owned: npt.NDArray[np.bool_],
        whole_cells: int,
        resolution: float,
        progress: _Progress,
    ) -> dict[str, Any]: ...
    def persistence(self, progress: _Progress) -> dict[str, Any]: ...
    def sweep(
        self, start: str, stop: str, samples: int, most_levels: int, progress: _Progress
    ) -> dict[str, Any]: ...

class ThreadLimit:
    def __init__(self, count: int) -> None: ...

class PiecesDiffer(ValueError): ...

def merge_pieces(
    pieces: list[dict[str, Any]], certified: Optional[dict[str, Any]]
) -> dict[str, Any]: ...
def surface_part(
    piece: dict[str, Any],
    cells: npt.NDArray[np.int64],
    vertices: npt.NDArray[np.int64],
    components: npt.NDArray[np.int32],
    certified: Optional[dict[str, Any]],
) -> dict[str, Any]: ...
def parts_certificate(
    mode: str, role: str, parts: list[list[tuple[str, str]]], whole: list[tuple[str, int]]
) -> bytes: ...
def restrict_piece(
    piece: dict[str, Any], cells: npt.NDArray[np.int64], vertices: npt.NDArray[np.int64]
) -> dict[str, Any]: ...
def components_of_piece(piece: dict[str, Any]) -> npt.NDArray[np.int32]: ...
def seam_of(piece: dict[str, Any]) -> npt.NDArray[np.int64]: ...
def join_seams(seams: list[npt.NDArray[np.int64]]) -> dict[str, Any]: ...
def merge_curve_pieces(
    pieces: list[dict[str, Any]], certified: Optional[dict[str, Any]]
) -> dict[str, Any]: ...
def curve_part(
    piece: dict[str, Any],
    cells: npt.NDArray[np.int64],
    vertices: npt.NDArray[np.int64],
    components: npt.NDArray[np.int32],
    certified: Optional[dict[str, Any]],
) -> dict[str, Any]: ...
def curve_seam_of(piece: dict[str, Any]) -> npt.NDArray[np.int64]: ...
def join_curve_seams(seams: list[npt.NDArray[np.int64]]) -> dict[str, Any]: ...
def parse_mode(text: str) -> str: ...
def mode(tensors: _Doubles) -> _Doubles: ...
def lode_angle(tensors: _Doubles) -> _Doubles: ...
def deviator(tensors: _Doubles) -> _Doubles: ...
def decide_order(array: str, names: list[str], count: int, asked: Optional[str]) -> str: ...
def eigen(tensors: _Doubles) -> tuple[_Doubles, _Doubles]: ...
def nodal_average(
    node_count: int,
    nodes: npt.NDArray[np.int64],
    tensors: _Doubles,
    tensors_per_cell: int,
    at_nodes: bool,
    weights: Optional[_Doubles],
    materials: Optional[npt.NDArray[np.int64]],
) -> tuple[_Doubles, npt.NDArray[np.int64], npt.NDArray[np.int64]]: ...
def family_kinds() -> list[str]: ...
def family_member(
    kind: str, seed: int, member: int, members: int, tetrahedra: int
) -> tuple[Mesh, list[str], str]: ...
