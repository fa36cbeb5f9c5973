# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A recipe for Spack. It has NOT been built: Spack is not in the distribution that the project is
tested on. Whoever packages it fills in what stands in <angle brackets>."""
from spack.package import *


class Tensortopo(CMakePackage):
    """Certified topology of 3D symmetric tensor fields: mode surfaces, neutral surfaces and degenerate
    curves of piecewise linear fields on tetrahedral meshes."""

    homepage = "<address of the project>"
    url = "<address of the release's archive>"

    license("Apache-2.0")

    version("0.1.0", sha256="<its hash>")

    variant("program", default=True, description="The program, and readers and writers of files")
    variant("jets", default=True, description="The program's jets, which are under the GPL")
    variant("python", default=False, description="The Python package")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("boost")
    depends_on("cgal")
    depends_on("eigen@3.4:")
    depends_on("flint")
    depends_on("gmp")
    depends_on("mpfr")
    depends_on("openssl")
    depends_on("tbb")
    with when("+program"):
        depends_on("cli11")
        depends_on("fmt")
        depends_on("libdeflate")
        depends_on("nlohmann-json")
        depends_on("pugixml")
        depends_on("vtk@9.1:")
        depends_on("zlib-api")
    with when("+python"):
        extends("python@3.9:")
        depends_on("py-numpy", type=("build", "run"))
        depends_on("py-pybind11@2.10:", type="build")

    def cmake_args(self):
        return [
            self.define("TENSORTOPO_BUILD_TESTS", False),
            self.define_from_variant("TENSORTOPO_BUILD_ANALYSIS", "program"),
            self.define_from_variant("TENSORTOPO_BUILD_PYTHON", "python"),
            self.define_from_variant("TENSORTOPO_WITH_CGAL_GPL", "jets"),
        ]
