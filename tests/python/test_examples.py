# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The lessons run."""
import json
import os
import runpy
import subprocess
from pathlib import Path

import pytest

FOLDER = Path(os.environ["TENSORTOPO_EXAMPLES"])
LESSONS = sorted(FOLDER.glob("*.py"))


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda path: path.stem)
def test_lesson(lesson, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(lesson), run_name="__main__")
    assert capsys.readouterr().out


def test_notebooks(tmp_path, monkeypatch, capsys):
    subprocess.run([FOLDER.parent / "notebooks", tmp_path], check=True, stdout=subprocess.DEVNULL)
    notebooks = sorted(tmp_path.glob("*.ipynb"))
    assert [file.stem for file in notebooks] == [lesson.stem for lesson in LESSONS]
    monkeypatch.chdir(tmp_path)
    for file, lesson in zip(notebooks, LESSONS):
        notebook = json.loads(file.read_text())
        assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 4)
        cells = [(cell["cell_type"], "".join(cell["source"])) for cell in notebook["cells"]]
        text = lesson.read_text()
        assert len(cells) > text.count("# %%") and "# %%" not in "".join(cell for _, cell in cells)
        names = {"__name__": "__main__"}
        for kind, cell in cells:
            if kind == "code":
                exec(compile(cell, file.name, "exec"), names)  # pylint: disable=exec-used
        assert capsys.readouterr().out


def test_there_are_lessons():
    assert len(LESSONS) == 3 and all(lesson.name in (FOLDER / "README.md").read_text() for lesson in LESSONS)
