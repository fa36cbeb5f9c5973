# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The page that the program writes, read without a browser (tests/report has one)."""
import base64
import gzip
import hashlib
import json
import re

import numpy as np

import tensortopo as tt


def part(text, name):
    return re.search(rf'<script[^>]* id="{name}">(.*?)</script>', text, re.S)[1]


def test_the_page_holds_the_surfaces_that_it_shows(program, slab, slab_file, tmp_path):
    file = tmp_path / "r.html"
    out = program("report", slab_file, "--mode", "0.5", "--generalized", "-o", file, "--json", "--quiet",
                  "--sweep=-0.2:0.2:2")  # fmt: skip
    summary = json.loads(out)
    assert summary["certificate"] == "certified" and summary["certified"] == summary["claims"] > 100
    text = file.read_text()
    facts = json.loads(part(text, "facts"))
    bytes_ = gzip.decompress(base64.b64decode(part(text, "geometry")))
    kinds = {"f4": np.float32, "u4": np.uint32, "i1": np.int8}

    def array(place):
        kind, offset, length = place
        return np.frombuffer(bytes_, kinds[kind], length, offset)

    corners = slab.points[np.unique(slab.tets)]
    low, high = corners.min(axis=0), corners.max(axis=0)
    centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    assert [level["mode"] for level in facts["surfaces"]] == ["-1/2", "1/2"]
    for level, mode in zip(facts["surfaces"], (-0.5, 0.5)):
        surface = slab.mode_surface(mode)
        arrays = level["arrays"]
        assert np.array_equal(array(arrays["triangles"]).reshape(-1, 3), surface.triangles)
        assert np.array_equal(array(arrays["component"]), surface.component)
        shown = array(arrays["points"]).reshape(-1, 3) * radius + centre
        assert np.allclose(shown, surface.points, atol=1e-6 * radius)
        assert level["euler_characteristic"] == surface.euler_characteristic
        assert [p["triangles"] for p in level["parts"]] == [c.triangles for c in surface.components]
    curves = slab.degenerate_curves()
    segments = sum(len(line) - 1 for line in curves.lines)
    assert sum(facts["lines"][kind][2] for kind in ("linear", "planar")) == 6 * segments
    assert len(facts["sweep"]["events"]) == len(slab.sweep(-0.2, 0.2).events) > 3


def test_the_page_loads_nothing_and_runs_only_its_own_script(program, slab_file, tmp_path):
    file = tmp_path / "r.html"
    program("report", slab_file, "--mode", "0.5", "-o", file, "--quiet", "--no-sweep", "--no-curves",
            "--no-certificate")  # fmt: skip
    text = file.read_text()
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)[1]
    assert policy.startswith("default-src 'none';") and "unsafe" not in policy
    (script,) = re.findall(r"<script>(.*?)</script>", text, re.S)
    (style,) = re.findall(r"<style>(.*?)</style>", text, re.S)
    for source, content in (("script-src", script), ("style-src", style)):
        digest = base64.b64encode(hashlib.sha256(content.encode()).digest()).decode()
        assert f"{source} 'sha256-{digest}'" in policy
    assert not re.search(r"(src|href)\s*=", re.sub(r"<script.*?</script>", "", text, flags=re.S))
    assert "@" not in re.sub(r"<(script|style).*?</\1>", "", text, flags=re.S)


def test_cells_that_are_left_out_are_listed_and_outlined(program, tetrahedron, tmp_path):
    points, _, tets = tetrahedron
    # The mode is constant.
    tt.write(tmp_path / "f.vtu", tt.Field(points, [[1, 0, -1, 0, 0, 0]] * 4, tets))
    program("report", tmp_path / "f.vtu", "--mode", "0", "--mode", "1/2", "-o", tmp_path / "r.html",
            "--no-sweep", "--quiet", statuses=(0, 1))  # fmt: skip
    facts = json.loads(part((tmp_path / "r.html").read_text(), "facts"))
    assert [(u["cell"], u["reason"], u["mode"]) for u in facts["unresolved"]] == [
        (0, "level_constant_in_cell", "0")
    ]
    assert facts["unresolved"][0]["centre"] == [0.25] * 3 and facts["unresolved_count"] == 1
    assert facts["lines"]["unresolved"][2] == 6 * 2 * 3
    assert [level["unresolved"] for level in facts["surfaces"]] == [1, 0]


def test_names_are_text(program, tetrahedron, tmp_path):
    name = "a<b>&\"c</script>"
    file = tmp_path / "f&<b>.vtu"
    tt.write(file, tt.Field(*tetrahedron, tensor_name=name))
    program("report", file, "--mode", "0.1", "-o", tmp_path / "r.html", "--quiet", "--no-sweep")
    text = (tmp_path / "r.html").read_text()
    assert "a&lt;b&gt;&amp;&quot;c&lt;/script&gt;" in text and "f&amp;&lt;b&gt;.vtu" in text
    assert "<b>" not in text


def test_wrong_usage_writes_nothing(program, slab_file, tmp_path):
    for arguments in (["--mode", "1"], ["--mode", "0.5", "-o", tmp_path / "r.txt"], [],
                      ["--mode", "0.5", "--sweep", "1:2"]):  # fmt: skip
        program("report", slab_file, "-o", tmp_path / "r.html", *arguments, statuses=(2,))
    assert list(tmp_path.iterdir()) == []
