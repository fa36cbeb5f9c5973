# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx' configuration. `make` sets the environment and runs it."""
import os
import sys

BUILD = os.environ["TENSORTOPO_BUILD"]  # of the program and of the Python package
sys.path.insert(0, f"{BUILD}/python")

project = "tensortopo"
copyright = "the tensortopo authors"  # pylint: disable=redefined-builtin
release = version = os.environ["TENSORTOPO_VERSION"]

extensions = ["breathe", "myst_parser", "numpydoc", "sphinx.ext.autodoc", "sphinx.ext.autosummary"]
# What is no page. The staged tree has links to the project's folders.
exclude_patterns = ["**/.*", "**/build*", "**/out", "**/data/*.json", "examples/suite/*.json"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 6

breathe_projects = {"tensortopo": os.environ["TENSORTOPO_DOXYGEN"]}
breathe_default_project = "tensortopo"
breathe_show_include = False
# Sphinx looks these up as names of ours.
nitpick_ignore_regex = [
    (r"cpp:.*", r"(std|boost|Eigen|CGAL|vtk\w*|detail)(::.*)?|tensortopo(::elementary)?"),
    # Index types and enumerators that a class declares for itself.
    (r"cpp:identifier", r"(\w+Mesh::Index|Use(::\w+)?)"),
    (r"cpp:identifier", r"(Scalar|Number|Value|Index|Field|ostream|vtk\w+|\w*_t)"),
    (r"py:.*", r"(numpy|np|npt|fractions|decimal|pathlib|os|typing|optional|array_like|default|callable)\b.*"),
    # numpydoc's words for types, which are no classes.
    (r"py:class", r"(shape|str|int|float|bool|list|tuple|sequence|several|or|of|optional|Fraction|Decimal|\d+|[{(\[].*|.*[)}\]])"),
]
autosummary_generate = False
numpydoc_show_class_members = False
numpydoc_xref_param_type = False
autodoc_typehints = "none"
autodoc_member_order = "bysource"

html_theme = "furo"
html_title = f"tensortopo {release}"
html_static_path = ["static"]
html_css_files = ["pages.css"]
html_copy_source = False
html_domain_indices = False
html_show_sphinx = False
highlight_language = "none"
pygments_style = "friendly"
