// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/versions.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <oneapi/tbb/version.h>
#include <vtkVersion.h>
#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

namespace tensortopo {

std::string program_version() { return TENSORTOPO_VERSION; }

std::string version_text() {
  std::string text = "tensortopo " TENSORTOPO_VERSION "\nbuilt on";
  const auto add = [&](std::string_view name, std::string_view version) {
    text += fmt::format("\n  {:<14} {}", name, version);
  };
  add("Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                           BOOST_VERSION % 100));
  add("CLI11", CLI11_VERSION);
  add("Eigen",
      fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add("fmt",
      fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  add("GMP", fmt::format("{}.{}.{}", __GNU_MP_VERSION, __GNU_MP_VERSION_MINOR,
                         __GNU_MP_VERSION_PATCHLEVEL));
  add("MPFR", MPFR_VERSION_STRING);
  add("nlohmann/json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                   NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  add("oneTBB", TBB_VERSION_STRING);
  add("VTK", vtkVersion::GetVTKVersion());
  return text;
}

}  // namespace tensortopo
