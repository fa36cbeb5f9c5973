# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""The lessons run."""
import os
import runpy
from pathlib import Path

import pytest

FOLDER = Path(os.environ["TENSORTOPO_EXAMPLES"])
LESSONS = sorted(FOLDER.glob("*.py"))


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda path: path.stem)
def test_lesson(lesson, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(lesson), run_name="__main__")
    assert capsys.readouterr().out


def test_there_are_lessons():
    assert len(LESSONS) == 3 and all(lesson.name in (FOLDER / "README.md").read_text() for lesson in LESSONS)
