// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/curves.hpp"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "bench/bench_command.hpp"
#include "bench/methods.hpp"
#include "contours/vtk_contours.hpp"
#include "counted.hpp"
#include "render/charts/line_chart.hpp"
#include "tensortopo/mesh/subdivide.hpp"

namespace tensortopo {
namespace {

constexpr std::size_t kMostSubdivided = 1'000'000;  // tetrahedra of a subdivided mesh

TetMesh subdivided(const TetMesh& mesh, int times) {
  TetMesh fine = mesh;
  for (int i = 0; i < times; ++i) fine = subdivide(fine);
  return fine;
}

class Collector {
 public:
  Collector(const TetMesh& mesh, const std::vector<ModeValue>& modes) : judge_(mesh, modes) {}

  void begin(const std::string& method) { curves_.push_back({method, {}, ""}); }
  void note(const std::string& text) { curves_.back().note = text; }

  void add(const std::string& setting, const std::vector<SurfaceMesh>& surfaces,
           const TetMesh& mesh, std::function<std::size_t()> run) {
    const LevelDistance distance = judge_.distance(surfaces, mesh);
    places_.emplace_back(curves_.size() - 1, curves_.back().points.size());
    curves_.back().points.push_back(
        {setting, 0, distance.root_mean_square(), distance.largest(), 0});
    contenders_.push_back({curves_.back().method + " " + setting, std::move(run)});
  }

  std::vector<ErrorCurve> timed(int repeat, const Progress& progress) {
    const auto series = time_in_turn(contenders_, repeat, [&](std::size_t, double fraction) {
      if (progress) progress("timing", fraction);
    });
    for (std::size_t i = 0; i < series.size(); ++i) {
      ErrorPoint& point = curves_[places_[i].first].points[places_[i].second];
      point.seconds = series[i].median();
      point.triangles = series[i].triangles;
    }
    return std::move(curves_);
  }

 private:
  Judge judge_;
  std::vector<ErrorCurve> curves_;
  std::vector<Contender> contenders_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // curve and point
};

/// A method for people.
std::string shown(const std::string& method) {
  if (method == "extract") return "tensortopo";
  if (method == "a_patches") return "A-patches";
  if (method == "vtk_subdivided") return "VTK, mesh subdivided";
  return method == "hybrid" ? "hybrid method" : method;
}

}  // namespace

std::vector<ErrorCurve> error_curves(const TetMesh& mesh, const std::vector<ModeValue>& modes,
                                     int repeat, const Progress& progress) {
  if (progress) progress("measuring errors", 0);
  Collector all(mesh, modes);
  all.begin("extract");
  for (const double resolution : {1.0, 2.0, 4.0, 8.0, 16.0})
    all.add(fmt::format("R = {:g}", resolution), our_surfaces(mesh, modes, resolution), mesh,
            [&, resolution] { return triangles_of(our_surfaces(mesh, modes, resolution)); });
  if (progress) progress("measuring errors", 0.3);
  all.begin("a_patches");
  for (const int samples : {1, 2, 4, 8}) {
    BaselineOptions options;
    options.samples = samples;
    const auto run = [&, options] {
      return baseline_surfaces(Baseline::a_patches, mesh, modes, options);
    };
    all.add(counted(samples, "sample"), run(), mesh, [run] { return triangles_of(run()); });
  }
  if (progress) progress("measuring errors", 0.6);
  all.begin("vtk_subdivided");
  std::vector<double> values;
  for (const ModeValue& mode : modes) values.push_back(mode.approx());
  std::size_t tetrahedra = mesh.tets.size();
  for (int times = 0; tetrahedra <= kMostSubdivided; ++times, tetrahedra *= 8) {
    const TetMesh fine = subdivided(mesh, times);
    all.add(counted(times, "subdivision"), baseline_surfaces(Baseline::marching, fine, modes), fine,
            [&, times] {
              const TetMesh again = subdivided(mesh, times);
              return VtkContours(again, static_cast<int>(threads_in_use()))
                  .contour_3d_linear_grid(values);
            });
  }
  if (progress) progress("measuring errors", 0.8);
  all.begin("hybrid");
  if (modes.size() == 1 && modes.front().sign() == 0) {
    for (const int parts : {2, 8, 32, 128}) {
      BaselineOptions options;
      options.flatness = 1.0 / parts;
      const auto run = [&, options] {
        return baseline_surfaces(Baseline::hybrid, mesh, modes, options);
      };
      all.add(fmt::format("flat to 1/{}", parts), run(), mesh,
              [run] { return triangles_of(run()); });
    }
  } else {
    all.note("the hybrid method extracts neutral surfaces only: --mode 0");
  }
  return all.timed(repeat, progress);
}

std::string curves_chart(const std::vector<ErrorCurve>& curves, const std::string& title) {
  LineChart chart{title, "seconds", "root mean square distance from the level, two-sided",
                  true,  true,      {}};
  for (const ErrorCurve& curve : curves) {
    if (curve.points.empty()) continue;
    ChartLine line{shown(curve.method), {}, {}};
    for (const ErrorPoint& point : curve.points) {
      line.points.emplace_back(point.seconds, point.root_mean_square);
      line.labels.push_back(point.setting);
    }
    chart.lines.push_back(std::move(line));
  }
  return line_chart(chart);
}

}  // namespace tensortopo
