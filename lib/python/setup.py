# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A wheel: CMake builds the extension modules, from the sources that this folder lies in.

TENSORTOPO_BUILD names a build that has them already.
"""
import os
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCES = Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    """Builds all modules at once, and puts each where setuptools wants it."""

    def run(self):
        ready = os.environ.get("TENSORTOPO_BUILD")
        build = Path(ready or self.build_temp).resolve()
        if not ready:
            self.compile(build)
        for extension in self.extensions:
            target = Path(self.get_ext_fullpath(extension.name))
            target.parent.mkdir(parents=True, exist_ok=True)
            name = extension.name.rsplit(".", 1)[1]
            (made,) = (build / "python" / "tensortopo").glob(f"{name}.*.so")
            self.copy_file(str(made), str(target))

    def compile(self, build):
        build.mkdir(parents=True, exist_ok=True)
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            "-DTENSORTOPO_BUILD_PYTHON=ON",
            "-DTENSORTOPO_BUILD_PROOFS=ON",
            "-DTENSORTOPO_BUILD_ANALYSIS=OFF",
            "-DTENSORTOPO_BUILD_TESTS=OFF",
            "-DTENSORTOPO_INSTALL=OFF",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]
        subprocess.check_call(["cmake", "-G", "Ninja", "-S", SOURCES, "-B", build, *options])
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(
            ["cmake", "--build", build, "--target", "tensortopo_python", "-j", jobs]
        )


setup(
    packages=["tensortopo"],
    package_data={"tensortopo": ["py.typed", "*.pyi"]},
    ext_modules=[Extension(f"tensortopo.{name}", []) for name in ("_core", "_checker", "_theory")],
    cmdclass={"build_ext": CMakeBuild},
)
