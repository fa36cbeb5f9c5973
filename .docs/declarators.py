# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""declarators.py FILE: a header as Doxygen is to read it, on standard output.

Doxygen takes a comment before `double low = 0, high = 0;` for the first variable only: here each has a
declaration of its own, with the comment.
"""
import pathlib
import re
import sys

DECLARATION = re.compile(r"^(\s+)([\w:]+(?:<.*>)?[*&]?) (\w+(?:\{[^{}]*\}| = [^,;]+)?(?:, \w+(?:\{[^{}]*\}| = [^,;]+)?)+);$")


def main():
    comment = []
    for line in pathlib.Path(sys.argv[1]).read_text().split("\n"):
        found = DECLARATION.match(line)
        if found and comment and found[2] not in ("return", "using", "template"):
            indent, kind, names = found.groups()
            first, *others = re.split(r", (?=\w+(?:[{,]| =|$))", names)
            print(f"{indent}{kind} {first};")
            for name in others:
                print("\n".join([*comment, f"{indent}{kind} {name};"]))
        else:
            print(line)
        comment = [*comment, line] if line.lstrip().startswith("///") else []


if __name__ == "__main__":
    main()
