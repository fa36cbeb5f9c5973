// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/page/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "bench/bench_command.hpp"
#include "bench/methods.hpp"
#include "bench/page/arithmetic.hpp"
#include "bench/page/machine.hpp"
#include "bench/page/program_runs.hpp"
#include "bench/scaling.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/temporary_folder.hpp"

namespace tensortopo {
namespace {

/// Extracts to files that the next step reads, whatever group of files there is around.
ExtractReport run_now(const ExtractCommand& command) {
  FileGroup read_below(FileGroup::Bond::apart);
  ExtractReport report = run_extract(command);
  read_below.commit();
  return report;
}

/// "±1/2", "0".
std::string both_signs(const ModeValue& mode) {
  return (mode.sign() == 0 ? "" : "±") + short_text(mode);
}

class Page {
 public:
  Page(const MeasurementsCommand& command, const Progress& progress)
      : command_(command), progress_(progress), budget_(command.budget, weight_of_all()) {}

  std::string text() {
    heading();
    // First, while there is little in memory.
    text_ += programs_table(command_, budget_, progress_);
    times();
    costs();
    costs_of_tetrahedra();
    serial_shares();
    several_modes();
    curves();
    next_to_ends();
    if (has_other_methods()) other_methods();
    return text_ + fmt::format("\nLoad at the end: {}.\n", load_text());
  }

 private:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
  }
  static std::string name(const std::filesystem::path& field) { return field.stem().string(); }
  void tell(std::string_view stage) {
    if (progress_) progress_(stage, std::min(1.0, 0.02 * static_cast<double>(++told_)));
  }

  bool has_other_methods() const { return command_.all || !command_.only.empty(); }

  // What parts of the page take, about, compared with each other: of each field and mode, and of
  // each field.
  static constexpr double kTimesWeight = 3, kMethodsWeight = 9;
  static constexpr double kThreadsWeight = 2, kModesWeight = 3, kCurvesWeight = 0.5;

  struct End {
    const char* mode;
    double weight;
  };
  static constexpr std::array kEnds{End{"9999/10000", 1}, End{"999999/1000000", 4},
                                    End{"999999999/1000000000", 20}};

  double times_weight() const { return kTimesWeight + (has_other_methods() ? kMethodsWeight : 0); }
  double weight_of_all() const {
    const double of_mode = kProgramsWeight + times_weight();
    double of_field = kThreadsWeight + kModesWeight + kCurvesWeight;
    for (const End& end : kEnds) of_field += end.weight;
    return static_cast<double>(command_.inputs.size()) *
           (of_field + of_mode * static_cast<double>(command_.modes.size()));
  }

  void heading() {
    add("# Measurements\n\nWritten by `tensortopo bench --report`, not by hand.\n\n"
        "| | |\n| --- | --- |\n");
    add("| machine | {} |\n| load at the start | {} |\n| commit | {} |\n| date | {} |\n",
        machine_text(), load_text(), commit_text(), date_text());
    add("| `tests/run --all` passed last | {} |\n", tested_text());
    add("| repetitions | up to {}, interleaved; medians are reported |\n"
        "| budget | {:g} s |\n\n",
        command_.repeat, command_.budget);
    add("The load is the number of processes that want to run. Where it is larger than the number "
        "of "
        "threads, others took part of the time: seconds are too long, and ratios of short to long "
        "times as well. Counts do not depend on it.\n");
  }

  /// Null if it was not run.
  static const BenchSeries* series_of(const BenchReport& report, std::string_view name) {
    const auto found = std::find_if(report.series.begin(), report.series.end(),
                                    [&](const BenchSeries& s) { return s.name == name; });
    return found != report.series.end() ? &*found : nullptr;
  }

  void times() {
    add("\n## Extraction\n\nSeconds without reading and writing, by stage and for all, and of "
        "`vtkContourGrid`, which contours the modes of the vertices linearly; "
        "`vtkContour3DLinearGrid` is VTK's threaded filter.\n\n"
        "| field | tetrahedra | modes | repetitions | triangles | edges | faces | "
        "tetrahedra | assembly | all | "
        "with certificate | vtkContourGrid | all over it | certified over it | all over "
        "vtkContour3DLinearGrid |\n|{}\n",
        dashes(15));
    for (const auto& input : command_.inputs)
      for (const ModeValue& mode : command_.modes) {
        tell("timing " + name(input));
        BenchCommand bench;
        bench.input = input;
        bench.read = command_.read;
        bench.modes = {mode};
        bench.repeat = command_.repeat;
        bench.longest = budget_.take(times_weight());
        bench.all = command_.all;
        bench.only = comparisons_at(mode);
        reports_.push_back(run_bench(bench));
        const BenchReport& r = reports_.back();
        const auto median = [&](std::string_view series) {
          const BenchSeries* found = series_of(r, series);
          return found != nullptr ? found->median() : std::nan("");
        };
        const double ours = median("extract"), certified = median("certified"),
                     vtk = median("vtk_contour");
        add("| {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | "
            "{:.3f} | {:.1f} | {:.1f} | {:.0f} |\n",
            name(input), r.tetrahedra, both_signs(mode), r.series.front().seconds.size(),
            r.series.front().triangles, r.stages.at("edges"), r.stages.at("faces"),
            r.stages.at("tets"), r.stages.at("stitch"), ours, certified, vtk, ours / vtk,
            certified / vtk, ours / median("vtk_contour_3d_linear_grid"));
      }
  }

  /// Of the fields and modes of `times`.
  void costs() {
    add("\n## Cost of a triangle\n\nMicroseconds of processors for each triangle: seconds of a "
        "stage times threads, over triangles. `vtkContourGrid` runs on one thread; its triangles "
        "are its own.\n\n"
        "| field | modes | edges | faces | tetrahedra | assembly | all | vtkContourGrid | all over "
        "it |\n|{}\n",
        dashes(9));
    for (const BenchReport& r : reports_) {
      const BenchSeries *ours = series_of(r, "extract"), *vtk = series_of(r, "vtk_contour");
      if (ours == nullptr || vtk == nullptr || ours->triangles == 0 || vtk->triangles == 0)
        continue;
      const double each =
          1e6 * static_cast<double>(r.threads) / static_cast<double>(ours->triangles);
      const double all = each * ours->median();
      const double of_vtk = 1e6 * vtk->median() / static_cast<double>(vtk->triangles);
      add("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n",
          name(r.input), both_signs(r.modes.front()), each * r.stages.at("edges"),
          each * r.stages.at("faces"), each * r.stages.at("tets"), each * r.stages.at("stitch"),
          all, of_vtk, all / of_vtk);
    }
  }

  /// Of the fields and modes of `times`.
  void costs_of_tetrahedra() {
    add("\n## Cost of a tetrahedron, and of its arithmetic\n\nMicroseconds of processors for each "
        "tetrahedron that holds the surface: seconds of a stage times threads, over tetrahedra; "
        "and "
        "what its arithmetic takes on one thread: a proved crossing of each edge, a proof for each "
        "face and each tetrahedron with vertices on both sides, in lanes, on arrays that are there "
        "already. Stages do more: edges screens the whole mesh, faces samples arcs, tetrahedra "
        "makes "
        "triangles and improves them.\n\n"
        "| field | modes | tetrahedra | edges | arithmetic | faces | arithmetic | tetrahedra | "
        "arithmetic | all | all over arithmetic |\n|{}\n",
        dashes(11));
    TetMesh mesh;
    const BenchReport* last = nullptr;  // those of one field follow each other
    for (const BenchReport& r : reports_) {
      tell("arithmetic of " + name(r.input));
      if (last == nullptr || last->input != r.input) mesh = read_mesh(r.input, command_.read).mesh;
      last = &r;
      const Arithmetic arithmetic = measure_arithmetic(mesh, with_opposites(r.modes));
      const BenchSeries* ours = series_of(r, "extract");
      if (ours == nullptr || arithmetic.crossed == 0) continue;
      const double one = 1e6 / static_cast<double>(arithmetic.crossed);
      const double each = one * static_cast<double>(r.threads);
      const double sum = one * (arithmetic.edges + arithmetic.faces + arithmetic.tets);
      const double all = each * ours->median();
      add("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} "
          "|\n",
          name(r.input), both_signs(r.modes.front()), arithmetic.crossed,
          each * r.stages.at("edges"), one * arithmetic.edges, each * r.stages.at("faces"),
          one * arithmetic.faces, each * r.stages.at("tets"), one * arithmetic.tets, all,
          all / sum);
    }
  }

  ScalingCommand scaling_of(const std::filesystem::path& input, ScalingOver over, double weight) {
    ScalingCommand scaling;
    scaling.over = over;
    scaling.input = input;
    scaling.read = command_.read;
    scaling.repeat = command_.repeat;
    scaling.longest = budget_.take(weight);
    return scaling;
  }

  void several_modes() {
    add("\n## Several modes in one run\n\nSeconds without reading and writing, over those of one "
        "mode (`bench --scaling modes`). The modes are spread evenly, so that other tetrahedra "
        "hold each surface.\n\n| field | seconds for 1 | 2 | 4 | 8 | 16 |\n|{}\n",
        dashes(6));
    for (const auto& input : command_.inputs) {
      tell("several modes on " + name(input));
      const ScalingCommand scaling = scaling_of(input, ScalingOver::modes, kModesWeight);
      const ScalingReport report = run_scaling(scaling);
      const double one = report.points.front().seconds;
      add("| {} | {:.2f} |", name(input), one);
      for (std::size_t i = 1; i < report.points.size(); ++i)
        add(" {:.1f} |", report.points[i].seconds / one);
      add("\n");
    }
  }

  void serial_shares() {
    add("\n## Threads\n\nThe share of the time of one thread that more threads do not shorten, by "
        "Amdahl's law (`bench --scaling threads`).\n\n"
        "| field | modes | threads | seconds with one | with all | serial share |\n|{}\n",
        dashes(6));
    for (const auto& input : command_.inputs) {
      tell("threads on " + name(input));
      ScalingCommand scaling = scaling_of(input, ScalingOver::threads, kThreadsWeight);
      scaling.modes = {command_.modes.size() > 1 ? command_.modes[1] : command_.modes[0]};
      const ScalingReport report = run_scaling(scaling);
      add("| {} | {} | {} | {:.2f} | {:.2f} | {} |\n", name(input), both_signs(scaling.modes[0]),
          report.threads, report.points.front().seconds, report.points.back().seconds,
          std::isnan(report.serial_share) ? "unknown"
                                          : fmt::format("{:.0f} %", 100 * report.serial_share));
    }
  }

  /// The comparisons that are made at a mode.
  std::vector<std::string> comparisons_at(const ModeValue& mode) const {
    std::vector<std::string> result{"certified"};
    constexpr double kLargestOfPatches = 0.5;  // of A-patches
    for (const std::string& method : command_.only)
      if (method == "hybrid"
              ? mode.sign() == 0
              : method != "a_patches" || std::abs(mode.approx()) <= kLargestOfPatches)
        result.push_back(method);
    return result;
  }

  void curves() {
    add("\n## Degenerate curves\n\n| field | linear: curves (closed) | planar: curves (closed) | "
        "unresolved tetrahedra | seconds |\n|{}\n",
        dashes(5));
    for (const auto& input : command_.inputs) {
      tell("curves of " + name(input));
      (void)budget_.take(kCurvesWeight);
      TemporaryFolder folder;
      const ExtractReport report = run_now(extraction(input, ModeValue::parse("1"), folder));
      add("| {} ", name(input));
      for (const CurveReport& curve : report.curves)
        add("| {} ({}) ", curve.invariants.components, curve.invariants.closed_components);
      add("| {} | {:.2f} |\n", report.unresolved.size(), report.seconds_extract);
    }
  }

  void next_to_ends() {
    add("\n## Next to modes 1 and -1\n\nTetrahedra that hold the surface, those left unresolved, "
        "those in which doubles do not show its shape (`not_embedded`), and seconds without "
        "reading and writing.\n\n| field |");
    for (const End& end : kEnds) add(" ±{} |", short_text(ModeValue::parse(end.mode)));
    add("\n|{}\n", dashes(std::size(kEnds) + 1));
    for (const auto& input : command_.inputs) {
      add("| {} |", name(input));
      double last = 0;
      for (const End& end : kEnds) {
        if (budget_.take(end.weight) < last) {
          add(" no time left |");
          continue;
        }
        tell("next to the ends of " + name(input));
        TemporaryFolder folder;
        const ExtractReport report = run_now(extraction(input, ModeValue::parse(end.mode), folder));
        last = report.seconds_extract;
        std::size_t crossed = 0, not_embedded = 0;
        for (const SurfaceReport& s : report.surfaces)
          crossed += s.statistics.tets_crossed, not_embedded += s.not_embedded.value_or(0);
        add(" {}, {}, {}, {:.2f} s |", crossed, report.unresolved.size(), not_embedded,
            report.seconds_extract);
      }
      add("\n");
    }
  }

  void other_methods() {
    add("\n## Other methods, at equal error\n\nTheir seconds over ours at the lowest resolution at "
        "which our error is not larger (`analysis/src/bench/README.md`).\n\n"
        "| field | modes | ratio | value | |\n|{}\n",
        dashes(5));
    for (const BenchReport& r : reports_)
      for (const BenchRatio& ratio : r.ratios) {
        if (ratio.name.rfind("extract_over", 0) == 0 || ratio.name.rfind("certified", 0) == 0)
          continue;
        if (!command_.all && !ratio.value && ratio.note == BenchReport::not_asked()) continue;
        add("| {} | {} | {} | {} | {} |\n", name(r.input), both_signs(r.modes.front()), ratio.name,
            ratio.value ? fmt::format("{:.2f}", *ratio.value) : "none", ratio.note);
      }
  }

  static std::string dashes(std::size_t columns) {
    std::string text;
    for (std::size_t i = 0; i < columns; ++i) text += " --- |";
    return text;
  }

  /// The surfaces, or curves, of both signs.
  ExtractCommand extraction(const std::filesystem::path& input, const ModeValue& mode,
                            TemporaryFolder& folder) const {
    ExtractCommand extract;
    extract.input = input;
    extract.read = command_.read;
    extract.modes = {mode};
    extract.generalized = true;
    extract.output = folder.file("s.vtp");
    return extract;
  }

  const MeasurementsCommand& command_;
  const Progress& progress_;
  TimeBudget budget_;
  std::string text_;
  std::vector<BenchReport> reports_;
  int told_ = 0;
};

}  // namespace

std::string measurements_page(const MeasurementsCommand& command, const Progress& progress) {
  return Page(command, progress).text();
}

}  // namespace tensortopo
