# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""run_commands.py SOURCE BUILD PAGE [HEADING] [--before COMMANDS]: the commands of a page run as they stand.

Blocks marked `sh` and `python` run one after the other, in a folder that looks like the project after
a build; what one exports or defines the next ones have. A block marked `text` after one of these is what
that one prints: its lines must be there in this order, where `...` stands for anything. Blocks marked
otherwise are not run. With a HEADING, the first `sh` block below it alone. What the page takes for
given (`stress.vtu`) is made by the commands before. Fails with the first command
that fails, and if nothing ran.
"""
import contextlib
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import traceback

BLOCK = re.compile(r"^```(\w+)[^\n]*\n(.*?)^```$", re.DOTALL | re.MULTILINE)


class Page:
    """Runs blocks, in a folder of their own."""

    def __init__(self, folder, build):
        self.folder, self.names, self.output, self.status = folder, {"__name__": "__main__"}, "", 0
        self.state = folder / ".state"
        program = os.pathsep.join([str(build / "analysis"), os.environ["PATH"]])
        self.state.write_text(f'export PATH="{program}" PYTHONPATH="{build / "python"}"\n')
        os.environ["PATH"] = program
        sys.path.insert(0, str(build / "python"))
        os.chdir(folder)

    def sh(self, commands):
        script = f"set -a; . {self.state}; set +a\n{commands}\nexport -p > {self.state}"
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], stdout=subprocess.PIPE, text=True,
                              check=False)  # fmt: skip
        self.output, self.status = done.stdout, done.returncode

    def python(self, code):
        stream = io.StringIO()
        self.status = 0
        try:
            with contextlib.redirect_stdout(stream):
                exec(compile(code, "page", "exec"), self.names)  # pylint: disable=exec-used
        except Exception:  # pylint: disable=broad-except
            traceback.print_exc()
            self.status = 1
        self.output = stream.getvalue()

    def prints(self, text):
        """Whether the last block has printed the lines of a text, in this order."""
        lines = (line.rstrip() for line in self.output.splitlines())
        for wanted in text.splitlines():
            pattern = re.compile(".*".join(re.escape(part) for part in wanted.rstrip().split("...")))
            if wanted.strip() and wanted.strip() != "..." and not any(pattern.fullmatch(line) for line in lines):
                print(f"not printed: {wanted}")
                return False
        return True


def main():
    source, build = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    arguments, before = sys.argv[3:], ""
    if "--before" in arguments:
        before = arguments.pop(arguments.index("--before") + 1)
        arguments.remove("--before")
    text = (source / arguments[0]).read_text()
    blocks = BLOCK.findall(text)
    if len(arguments) > 1:
        blocks = [("sh", BLOCK.search(text.split(f"## {arguments[1]}\n", 1)[1]).group(2))]
    counts = {"sh": 0, "python": 0, "text": 0}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in ("analysis", "examples", "lib", "proofs-check"):
            (folder / part).symlink_to(source / part)
        (folder / "build").mkdir()
        (folder / "build/release").symlink_to(build)
        page = Page(folder, build)
        page.sh(before)
        if page.status:
            sys.exit(f"exit status {page.status} of:\n{before}")
        given, before = {p.name for p in folder.iterdir()}, ""
        for kind, block in blocks:
            if kind in ("sh", "python"):
                getattr(page, kind)(block)
                if page.status:
                    sys.exit(f"exit status {page.status}, after printing:\n{page.output}\nof:\n{block}")
            elif kind == "text" and before in ("sh", "python") and not page.prints(block):
                sys.exit(f"what is printed:\n{page.output}")
            counts[kind] = counts.get(kind, 0) + 1
            before = kind
        written = sorted(p.name for p in folder.iterdir() if p.is_file() and p.name not in given)
        os.chdir(source)
    print(", ".join(f"{kind} {count}" for kind, count in counts.items()), "- written:", ", ".join(written))
    sys.exit(0 if counts["sh"] + counts["python"] and (written or counts["text"]) else 1)


if __name__ == "__main__":
    main()
