# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""run_commands.py SOURCE BUILD HEADING: the commands of a section of README.md run as they stand.

Runs the first shell block below HEADING in a folder that looks like the project after a build, and
fails with the first command that fails.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def main():
    source, build, heading = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    section = (source / "README.md").read_text().split(f"## {heading}\n", 1)[1]
    commands = re.search(r"```sh\n(.*?)```", section, re.DOTALL).group(1)
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(source / "examples", f"{folder}/examples")
        os.mkdir(f"{folder}/build")
        os.symlink(build, f"{folder}/build/release")
        done = subprocess.run(["bash", "-euc", commands], cwd=folder, check=False)
        written = [p.name for p in pathlib.Path(folder).iterdir() if p.is_file()]
        print("written:", ", ".join(sorted(written)))
        sys.exit(done.returncode or (0 if written else 1))


if __name__ == "__main__":
    main()
