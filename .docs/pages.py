# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""pages.py SOURCE BUILD DOXYGEN STAGED: the tree of pages that Sphinx reads.

Pages stay beside the code: STAGED has links to the project's folders, and what is generated here in
`reference`: the command line from the program's help, the C++ reference by headers, the Python
reference by the package's list of public names, and the keys of reports from their schemas.
"""
import ast
import functools
import json
import pathlib
import re
import subprocess
import sys
from xml.etree import ElementTree

FOLDERS = ("analysis", "examples", "lib", "proofs-check", "tests", "theory", "README.md")
# What Doxygen calls things, and how Sphinx shows them.
DIRECTIVES = {"struct": "doxygenstruct", "class": "doxygenclass", "union": "doxygenunion", "enum": "doxygenenum",
              "typedef": "doxygentypedef", "variable": "doxygenvariable", "define": "doxygendefine",
              "concept": "doxygenconcept"}
# What users meet first comes first.
MODULES = ("modes", "extract", "mesh", "tensor", "io", "vtk", "sweep", "certify", "quadric", "field",
           "manifold", "families", "scalar", "algebra", "hash")
PYTHON_FIRST = ("_field", "_surface", "_check", "_sweep", "_files", "_bridges", "_tensors", "_modes")


def heading(text, mark):
    return f"{text}\n{mark * len(text)}\n\n"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def command_line(program, folder):
    def help_of(*words):
        return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout

    top = help_of()
    names = re.findall(r"^  (\w+) +\w", top.split("Subcommands:\n", 1)[1].split("\n\n", 1)[0], re.MULTILINE)
    page = heading("Command line", "=") + "What the program's ``--help`` says.\n\n"
    for name in ("", *names):
        text = help_of(name) if name else top
        page += heading(f"tensortopo {name}".rstrip(), "-") + "::\n\n"
        page += "".join(f"   {line}".rstrip() + "\n" for line in text.splitlines()) + "\n"
    write(folder / "command-line.rst", page)
    return len(names)


def headers_of(source):
    """Public headers by module: how it is included, and its path below lib."""
    found = {}
    for file in sorted([*source.glob("lib/**/include/tensortopo/*/*.hpp"),
                        *source.glob("lib/*/include/*.h")]):
        module = file.relative_to(source / "lib").parts[0]
        found.setdefault(module, []).append(
            (str(file).rsplit("/include/", 1)[1], str(file.relative_to(source / "lib"))))
    return found


def public_entities(doxygen):
    """What each header declares, in its order: (line, directive) by the header's path below lib."""
    found = {}

    def add(location, directive):
        found.setdefault(location.get("file"), []).append((int(location.get("line")), directive))

    for path in sorted(doxygen.glob("*.xml")):
        compound = ElementTree.parse(path).find("compounddef")
        if compound is None:
            continue
        kind, name = compound.get("kind"), compound.findtext("compoundname")
        if kind in ("struct", "class", "union") and name not in nested(doxygen):
            add(compound.find("location"), f".. {DIRECTIVES[kind]}:: {name}\n   :members:\n")
        if kind == "concept":
            add(compound.find("location"), f".. {DIRECTIVES[kind]}:: {name}\n")
        for member in compound.iter("memberdef") if kind in ("namespace", "file") else ():
            kind_of_member = member.get("kind")
            full = f"{name}::{member.findtext('name')}" if kind == "namespace" else member.findtext("name")
            if kind_of_member == "function":
                types = ("".join(param.find("type").itertext()) for param in member.findall("param"))
                add(member.find("location"), f".. doxygenfunction:: {full}({', '.join(types)})\n")
            else:
                add(member.find("location"), f".. {DIRECTIVES[kind_of_member]}:: {full}\n")
    return found


@functools.cache
def nested(doxygen):
    """Names of the classes within classes, which are shown with these."""
    return {inner.text for path in [*doxygen.glob("struct*.xml"), *doxygen.glob("class*.xml")]
            for inner in ElementTree.parse(path).iter("innerclass")}


def cxx(source, doxygen, folder):
    found = headers_of(source)
    modules = [*(m for m in MODULES if m in found), *(m for m in found if m not in MODULES)]
    entities = public_entities(doxygen)
    shown = 0
    index = heading("C++", "=") + (
        "Every public header, by the target that it belongs to. Programs need ``modes`` or ``extract``, ``mesh``, "
        "``tensor`` and ``io``; the others are what these stand on.\n\n.. toctree::\n   :maxdepth: 1\n\n")
    for module in modules:
        index += f"   {module} <{module}>\n"
        page = heading(f"C++: {module}", "=")
        if (source / f"lib/{module}/README.md").exists():
            page += f"Target ``tensortopo::{module}``; what it is for: :doc:`/lib/{module}/README`.\n\n"
        for header, file in found[module]:
            page += heading(header.removeprefix(f"tensortopo/{module}/"), "-")
            page += f"``#include <{header}>``\n\n"
            declared = sorted(entities.pop(file, []))
            if not declared:
                sys.exit(f"{file}: declares nothing that Doxygen has read")
            shown += len(declared)
            page += "\n".join(directive for _, directive in declared) + "\n"
        write(folder / "cxx" / f"{module}.rst", page)
    write(folder / "cxx" / "index.rst", index)
    if entities:
        sys.exit(f"declared, and not shown: {sorted(entities)}")
    return shown


def python(source, folder):
    """Every name in the package's `__all__`, under the heading of the module that defines it."""
    tree = ast.parse((source / "lib/python/tensortopo/__init__.py").read_text())
    public = next(ast.literal_eval(node.value) for node in tree.body
                  if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
    # In the order of the package's imports, but fields first.
    modules = [node.module for node in tree.body if isinstance(node, ast.ImportFrom) and node.level == 1]
    modules.sort(key=lambda module: PYTHON_FIRST.index(module) if module in PYTHON_FIRST else len(PYTHON_FIRST))
    page = heading("Python", "=") + (
        "The package ``tensortopo``: what it does and how to get it is :doc:`a page of its own </lib/python/README>`, "
        "and lessons are :doc:`among the examples </examples/python/README>`.\n\n"
        ".. module:: tensortopo\n\n")
    listed = set()
    for module in modules:
        defined = ast.parse((source / f"lib/python/tensortopo/{module}.py").read_text())
        page += heading(ast.get_docstring(defined).split("\n")[0].split(". ")[0].rstrip("."), "-")
        for node in defined.body:
            if isinstance(node, ast.ClassDef):
                name, kind = node.name, "autoexception" if module == "_errors" and node.name != "Defect" else "autoclass"
            elif isinstance(node, ast.FunctionDef):
                name, kind = node.name, "autofunction"
            elif isinstance(node, (ast.Assign, ast.AnnAssign)):
                target = node.target if isinstance(node, ast.AnnAssign) else node.targets[0]
                name, kind = getattr(target, "id", ""), "autodata"
            else:
                continue
            if name in public and name not in listed:
                listed.add(name)
                page += f".. {kind}:: {name}\n"
                page += "   :members:\n\n" if kind != "autofunction" and kind != "autodata" else "\n"
    if set(public) != listed:
        sys.exit(f"public names without a place in the reference: {sorted(set(public) - listed)}")
    write(folder / "python.rst", page)
    return len(listed)


def keys_of(schema, path=""):
    """(key, type, description) of each key of a schema, nested ones after their own."""
    for name, part in schema.get("properties", {}).items():
        kind = part.get("type", "")
        here = f"{path}.{name}" if path else name
        yield here, ", ".join(kind) if isinstance(kind, list) else kind, part.get("description", "")
        yield from keys_of(part, here)
        if isinstance(part.get("items"), dict):
            yield from keys_of(part["items"], f"{here}[]")


def reports(source, folder):
    names = sorted(path.stem for path in source.glob("analysis/schema/*.json"))
    index = heading("Reports", "=") + (
        "The keys of what ``--json`` prints, by the name that ``schema.name`` has in the report. The schemas are files of "
        "``analysis/schema``; a test holds reports against them.\n\n.. toctree::\n   :maxdepth: 1\n\n")
    for name in names:
        index += f"   {name} <{name}>\n"
        schema = json.loads((source / f"analysis/schema/{name}.json").read_text())
        page = heading(f"Report: {name}", "=") + schema["title"].replace("`", "``") + ".\n\n"
        page += ".. list-table::\n   :header-rows: 1\n   :widths: 35 15 50\n\n   * - key\n     - type\n     - meaning\n"
        for key, kind, text in keys_of(schema):
            meaning = re.sub(r"([*|]|_(?=\W))", r"\\\1", text.replace("`", "``"))
            page += f"   * - ``{key}``\n     - {kind}\n     - {meaning}\n"
        write(folder / "reports" / f"{name}.rst", page)
    write(folder / "reports" / "index.rst", index)
    return len(names)


def main():
    source, build, doxygen, staged = map(pathlib.Path, sys.argv[1:5])
    staged.mkdir(parents=True)
    for name in FOLDERS:
        (staged / name).symlink_to(source / name)
    (staged / "static").symlink_to(source / ".docs/static")
    for page in (source / ".docs").glob("*.md"):
        (staged / page.name).symlink_to(page)
    folder = staged / "reference"
    print(f"{command_line(str(build / 'analysis/tensortopo'), folder)} subcommands, "
          f"{cxx(source, doxygen, folder)} C++ entities, {python(source, folder)} Python names, {reports(source, folder)} schemas")


if __name__ == "__main__":
    main()
