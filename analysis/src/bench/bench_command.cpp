// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_command.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "bench/methods.hpp"
#include "contours/vtk_contours.hpp"
#include "counted.hpp"
#include "peak_memory.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/subdivide.hpp"

namespace tensortopo {
namespace {

constexpr int kFewest = 5;
constexpr std::size_t kLargestSubdivided = 4'000'000;  // tetrahedra
constexpr std::array<double, 9> kResolutions{1, 1.4, 2, 2.8, 4, 5.7, 8, 11.3, 16};

std::string resolution_text(double resolution) {
  return fmt::format("resolution {:g}", resolution);
}

/// Collects contenders, and the ratios to make of their medians.
class Bench {
 public:
  Bench(const BenchCommand& command, const TetMesh& mesh, const Progress& progress)
      : command_(command),
        mesh_(mesh),
        modes_(with_opposites(command.modes)),
        values_(approximations(modes_)),
        progress_(progress) {}

  BenchReport run() {
    report_.threads = threads_in_use();
    (void)our_surfaces(mesh_, modes_, resolution_, &stages_);
    report_.peak_memory_bytes = peak_memory();
    vtk_ = std::make_unique<VtkContours>(mesh_, static_cast<int>(report_.threads));
    vtk_->contour_grid(values_);
    vtk_->contour_3d_linear_grid(values_);
    add("extract",
        [this] { return triangles_of(our_surfaces(mesh_, modes_, resolution_, &stages_)); });
    add("vtk_contour", [this] { return vtk_->contour_grid(values_); });
    add("vtk_contour_3d_linear_grid", [this] { return vtk_->contour_3d_linear_grid(values_); });
    compare("extract", "vtk_contour", "");
    compare("extract", "vtk_contour_3d_linear_grid", "");

    add_certified();
    add_manifold();
    if (is_wanted("errors") || is_wanted("a_patches") || is_wanted("vtk_subdivided")) judge();
    add_a_patches();
    add_hybrid();
    add_vtk_subdivided();
    time();
    if (command_.curves) report_.curves = error_curves(mesh_, modes_, command_.repeat, progress_);
    return std::move(report_);
  }

 private:
  struct Pair {
    std::string ratio, over, under, note;
  };

  bool is_wanted(const std::string& comparison) const {
    if (command_.all) return true;
    if (command_.only)
      return std::find(command_.only->begin(), command_.only->end(), comparison) !=
             command_.only->end();
    return comparison == "certified";
  }

  void add(const std::string& name, std::function<std::size_t()> run) {
    contenders_.push_back({name, std::move(run)});
  }
  void compare(const std::string& over, const std::string& under, const std::string& note) {
    pairs_.push_back({over + "_over_" + under, over, under, note});
  }
  void leave_out(const std::string& ratio, const std::string& why) {
    pairs_.push_back({ratio, "", "", why});
  }
  void tell(double fraction) const {
    if (progress_) progress_("measuring errors", fraction);
  }
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// Whether half of the time is over, which is all that looking for settings may take.
  bool is_late() const { return seconds() > command_.longest / 2; }

  void judge() {
    tell(0);
    judge_ = std::make_unique<Judge>(mesh_, modes_);
    report_.undecided = judge_->undecided();
    report_.errors.push_back(judge_->reference());
    tell(0.3);
    const auto ours = our_surfaces(mesh_, modes_, resolution_);
    report_.errors.push_back(judge_->errors("extract", resolution_text(resolution_), ours, mesh_));
    our_error_ = report_.errors.back().distance.root_mean_square();
    if (is_wanted("manifold"))
      report_.errors.push_back(
          judge_->errors("manifold", resolution_text(resolution_), on_manifold(), mesh_));
    tell(0.5);
    report_.errors.push_back(judge_->errors("vtk_contour", "the mesh as it is",
                                            baseline_surfaces(Baseline::marching, mesh_, modes_),
                                            mesh_));
  }

  void add_certified() {
    if (!is_wanted("certified"))
      return leave_out("certified_over_vtk_contour", BenchReport::not_asked());
    add("certified", [this] { return certify_all(mesh_, modes_, resolution_); });
    compare("certified", "vtk_contour", "");
  }

  /// Ours, meshed on the medium eigenvector manifold.
  std::vector<SurfaceMesh> on_manifold() const {
    return our_surfaces(mesh_, modes_, resolution_, nullptr, MeshingMethod::manifold);
  }

  void add_manifold() {
    if (!is_wanted("manifold")) return leave_out("manifold_over_extract", BenchReport::not_asked());
    add("manifold", [this] { return triangles_of(on_manifold()); });
    compare("manifold", "extract", "");
  }

  /// The lowest resolution at which our error is at most this one.
  std::optional<double> matching_resolution(const Judge& judge, const std::vector<ModeValue>& modes,
                                            double error, double* ours) const {
    for (const double resolution : kResolutions) {
      if (is_late()) return std::nullopt;
      *ours = judge.distance(our_surfaces(mesh_, modes, resolution)).root_mean_square();
      if (*ours <= error) return resolution;
    }
    return std::nullopt;
  }

  struct Setting {
    std::string text;
    BaselineOptions options;
  };

  /// Times a baseline, and ours with an error no larger: at the first of its settings (defaults
  /// first, then coarser ones) at which there is such a resolution.
  void add_matched(const std::string& name, const std::string& ratio, const Judge& judge,
                   const std::vector<ModeValue>& modes, Baseline method,
                   const std::vector<Setting>& settings) {
    double error = 0, ours = 0;
    std::optional<double> resolution;
    Setting chosen;
    for (const Setting& setting : settings) {
      if (is_late()) return leave_out(ratio, BenchReport::no_time());
      chosen = setting;
      error = judge.distance(baseline_surfaces(method, mesh_, modes, setting.options))
                  .root_mean_square();
      resolution = matching_resolution(judge, modes, error, &ours);
      if (resolution) break;
    }
    if (!resolution && is_late()) return leave_out(ratio, BenchReport::no_time());
    report_.errors.push_back(judge.errors(
        name, chosen.text, baseline_surfaces(method, mesh_, modes, chosen.options), mesh_));
    add(name, [this, modes, method, options = chosen.options] {
      return triangles_of(baseline_surfaces(method, mesh_, modes, options));
    });
    if (!resolution)
      return leave_out(ratio,
                       fmt::format("our error does not come down to its {:.3g} at {}: {:.3g} "
                                   "at resolution {:g}",
                                   error, chosen.text, ours, kResolutions.back()));
    const std::string our_name = "extract_for_" + name;
    add(our_name,
        [this, modes, r = *resolution] { return triangles_of(our_surfaces(mesh_, modes, r)); });
    pairs_.push_back({ratio, name, our_name,
                      fmt::format("its error {:.3g} at {}, ours {:.3g} at resolution {:g}", error,
                                  chosen.text, ours, *resolution)});
  }

  void add_a_patches() {
    if (!is_wanted("a_patches"))
      return leave_out("a_patches_over_extract", BenchReport::not_asked());
    tell(0.6);
    std::vector<Setting> settings;
    for (const int samples : {2, 1}) {
      settings.push_back({counted(samples, "sample"), {}});
      settings.back().options.samples = samples;
    }
    add_matched("a_patches", "a_patches_over_extract", *judge_, modes_, Baseline::a_patches,
                settings);
  }

  void add_hybrid() {
    if (!is_wanted("hybrid")) return leave_out("hybrid_over_neutral", BenchReport::not_asked());
    if (is_late()) return leave_out("hybrid_over_neutral", BenchReport::no_time());
    tell(0.7);
    const std::vector<ModeValue> neutral{ModeValue()};
    const Judge judge(mesh_, neutral);
    std::vector<Setting> settings;
    for (const int parts : {32, 8, 2, 1}) {
      settings.push_back({fmt::format("flatness 1/{}", parts), {}});
      settings.back().options.flatness = 1.0 / parts;
    }
    add_matched("hybrid", "hybrid_over_neutral", judge, neutral, Baseline::hybrid, settings);
  }

  void add_vtk_subdivided() {
    const std::string ratio = "vtk_subdivided_over_extract";
    if (!is_wanted("vtk_subdivided")) return leave_out(ratio, BenchReport::not_asked());
    if (is_late()) return leave_out(ratio, BenchReport::no_time());
    double error = 0;
    int times = 0;
    for (subdivided_ = mesh_;; subdivided_ = subdivide(subdivided_), ++times) {
      tell(0.8);
      error =
          judge_->distance(baseline_surfaces(Baseline::marching, subdivided_, modes_), subdivided_)
              .root_mean_square();
      if (error <= our_error_ || 8 * subdivided_.tets.size() > kLargestSubdivided) break;
    }
    const std::string reached =
        fmt::format("{} tetrahedra after {} subdivisions: its error {:.3g}, ours {:.3g}",
                    subdivided_.tets.size(), times, error, our_error_);
    report_.errors.push_back(
        judge_->errors("vtk_subdivided", counted(times, "subdivision"),
                       baseline_surfaces(Baseline::marching, subdivided_, modes_), subdivided_));
    vtk_subdivided_ = std::make_unique<VtkContours>(subdivided_, static_cast<int>(report_.threads));
    add("vtk_subdivided", [this] { return vtk_subdivided_->contour_3d_linear_grid(values_); });
    add("vtk_subdivided_whole", [this, times] {
      TetMesh fine = mesh_;
      for (int i = 0; i < times; ++i) fine = subdivide(fine);
      return VtkContours(fine, static_cast<int>(report_.threads)).contour_3d_linear_grid(values_);
    });
    if (error <= our_error_)
      pairs_.push_back({ratio, "vtk_subdivided", "extract", reached});
    else
      leave_out(ratio,
                fmt::format("not reached within {} tetrahedra; {}", kLargestSubdivided, reached));
  }

  void time() {
    std::vector<std::map<std::string, double>> stages;
    if (progress_) progress_("timing", 0);
    report_.series = time_in_turn(
        contenders_, command_.repeat,
        [&](std::size_t contender, double fraction) {
          if (contender == 0) stages.push_back(stages_);
          if (progress_) progress_("timing", fraction);
        },
        command_.longest - seconds());
    report_.stages = stages[median_place(report_.series.front().seconds)];
    for (const Pair& pair : pairs_) {
      BenchRatio ratio{pair.ratio, std::nullopt, pair.note};
      if (!pair.over.empty()) ratio.value = median_of(pair.over) / median_of(pair.under);
      report_.ratios.push_back(ratio);
    }
  }

  double median_of(const std::string& name) const {
    const auto found = std::find_if(report_.series.begin(), report_.series.end(),
                                    [&](const BenchSeries& s) { return s.name == name; });
    return found->median();
  }

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const BenchCommand& command_;
  const TetMesh& mesh_;
  std::vector<ModeValue> modes_;
  std::vector<double> values_;
  const Progress& progress_;
  double resolution_ = Sampling().resolution;
  BenchReport report_;
  std::map<std::string, double> stages_;
  std::unique_ptr<VtkContours> vtk_, vtk_subdivided_;
  std::unique_ptr<Judge> judge_;
  double our_error_ = 0;
  TetMesh subdivided_;
  std::vector<Contender> contenders_;
  std::vector<Pair> pairs_;
};

}  // namespace

const std::vector<std::string>& BenchCommand::comparisons() {
  static const std::vector<std::string> names{"certified", "manifold",       "a_patches",
                                              "hybrid",    "vtk_subdivided", "errors"};
  return names;
}

std::size_t threads_in_use() {
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(allowed, static_cast<std::size_t>(tbb::info::default_concurrency()));
}

BenchReport run_bench(const BenchCommand& command, const Progress& progress) {
  if (command.repeat < kFewest) throw UsageError("--repeat: must be at least 5");
  if (command.modes.empty()) throw UsageError("no mode given (--mode)");
  if (progress) progress("reading", 0);
  const ReadResult read = read_mesh(command.input, command.read);
  BenchReport report = Bench(command, read.mesh, progress).run();
  report.input = command.input;
  report.notes = read.report.all_notes();
  report.modes = command.modes;
  report.tetrahedra = read.mesh.tets.size();
  return report;
}

}  // namespace tensortopo
