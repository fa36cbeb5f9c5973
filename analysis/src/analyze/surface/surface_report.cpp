// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analyze/surface/surface_command.hpp"

#include "append_format.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kMostRows = 20;

/// JSON has no infinity.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json json_of(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

Json json_of(const Quantiles& q) {
  return {{"least", q.least},
          {"5%", q.low},
          {"median", q.median},
          {"95%", q.high},
          {"greatest", q.greatest}};
}

Json json_of(const Histogram& histogram) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < histogram.bounds.size(); ++i)
    rows.push_back({{"up_to", number(histogram.bounds[i])}, {"triangles", histogram.counts[i]}});
  return rows;
}

Json json_of(const CurvatureReport& report) {
  return {{"vertices", report.vertices},
          {"first_principal", json_of(report.first)},
          {"second_principal", json_of(report.second)},
          {"mean", json_of(report.mean)},
          {"gauss", json_of(report.gauss)},
          {"total_gauss", report.total_gauss}};
}

Json json_of(const SampledDistance& distance) {
  if (distance.samples == 0) return nullptr;
  return {{"samples", distance.samples},
          {"largest", distance.largest},
          {"mean", distance.mean},
          {"root_mean_square", distance.root_mean_square},
          {"where", json_of(distance.where)}};
}

Json hausdorff_of(const SampledDistance& forth, const SampledDistance& back) {
  if (forth.samples == 0 || back.samples == 0) return nullptr;
  return std::max(forth.largest, back.largest);
}

Json json_of(const std::vector<Umbilic>& umbilics) {
  Json rows = Json::array();
  for (const Umbilic& u : umbilics)
    rows.push_back({{"index", u.twice_index / 2.0},
                    {"curvature", u.curvature},
                    {"triangle", u.triangle},
                    {"point", json_of(u.point)}});
  return rows;
}

std::string text_of(const std::vector<Umbilic>& umbilics) {
  const auto wedges = std::count_if(umbilics.begin(), umbilics.end(),
                                    [](const Umbilic& u) { return u.twice_index > 0; });
  return fmt::format("  umbilics: {} of index 1/2, {} of index -1/2\n", wedges,
                     static_cast<std::ptrdiff_t>(umbilics.size()) - wedges);
}

constexpr std::array<const char*, 2> kRidgeKinds{"ridges", "valleys"};
constexpr std::array<const char*, kRidgeEnds> kRidgeEndNames{"boundary", "face", "turn",
                                                             "umbilic",  "flat", "undefined"};

Json json_of(const RidgeReport& report) {
  Json json{{"output", report.output.string()},
            {"least_strength", report.filter.least_strength},
            {"least_length", report.filter.least_length}};
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const RidgeLines::Sum& sum = report.sums[kind];
    Json ends;
    for (std::size_t i = 0; i < kRidgeEnds; ++i) ends[kRidgeEndNames[i]] = sum.ends[i];
    ends["rim"] = sum.ends[0];  // deprecated
    json[kRidgeKinds[kind]] = {
        {"lines", sum.lines},
        {"closed", sum.closed},
        {"length", sum.length},
        {"crest_length", sum.crest_length},
        {"greatest_strength", sum.strongest},
        {"left_out", {{"lines", sum.left_out}, {"length", sum.left_out_length}}},
        {"strength_of_all_lines", json_of(report.strength[kind])},
        {"bridges", sum.bridges},
        {"bridge_length", sum.bridge_length},
        {"ends", std::move(ends)},
        {"flat_triangles", sum.flat_triangles}};
  }
  json["skipped_triangles"] = {{"umbilic", report.umbilic_triangles},
                               {"undefined", report.undefined_triangles}};
  return json;
}

std::string text_of(const RidgeReport& report) {
  std::string text = "\nridges and valleys\n";
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const RidgeLines::Sum& sum = report.sums[kind];
    text += fmt::format(
        "  {:<8} {} lines, {} closed, length {:.6g} ({:.6g} of crests); {} bridges\n",
        kRidgeKinds[kind], sum.lines, sum.closed, sum.length, sum.crest_length, sum.bridges);
    text += fmt::format("  {:<8} ends:", "");
    for (std::size_t i = 0; i < kRidgeEnds; ++i)
      text += fmt::format(" {} {}", kRidgeEndNames[i], sum.ends[i]);
    text += fmt::format("; {} triangles flat\n", sum.flat_triangles);
    text += fmt::format("  {:<8} strength of lines: median {:.4g}, 95 % up to {:.4g}", "",
                        report.strength[kind].median, report.strength[kind].high);
    text += sum.left_out == 0 ? "\n"
                              : fmt::format("; left out: {} lines, length {:.6g}\n", sum.left_out,
                                            sum.left_out_length);
  }
  return text + fmt::format("  skipped: {} triangles at umbilics, {} undefined\n  {}\n",
                            report.umbilic_triangles, report.undefined_triangles,
                            report.output.string());
}

std::string row_of(const std::string& name, const Quantiles& q) {
  return fmt::format("  {:<18} {:>11.4g} {:>11.4g} {:>11.4g} {:>11.4g} {:>11.4g}\n", name, q.least,
                     q.low, q.median, q.high, q.greatest);
}

std::string text_of(const std::string& title, const CurvatureReport& report) {
  return fmt::format("\n{:<20} {:>11} {:>11} {:>11} {:>11} {:>11}\n", title, "least", "5 %",
                     "median", "95 %", "greatest") +
         row_of("first principal", report.first) + row_of("second principal", report.second) +
         row_of("mean", report.mean) + row_of("Gauss", report.gauss) +
         fmt::format("  integral of the Gauss curvature: {:.6g}\n", report.total_gauss);
}

std::string text_of(const std::string& title, const Histogram& histogram, std::size_t all) {
  std::string text = title + '\n';
  double from = histogram.bounds.front() > 1 ? 1 : 0;
  for (std::size_t i = 0; i < histogram.bounds.size(); ++i) {
    const double share =
        all == 0 ? 0 : static_cast<double>(histogram.counts[i]) / static_cast<double>(all);
    const double to = histogram.bounds[i];
    const std::string range =
        std::isfinite(to) ? fmt::format("{:g} to {:g}", from, to) : fmt::format("over {:g}", from);
    text += fmt::format("  {:<12} {:>9} {:>6.2f} % {}\n", range, histogram.counts[i], 100 * share,
                        std::string(static_cast<std::size_t>(std::lround(50 * share)), '#'));
    from = to;
  }
  return text;
}

std::string text_of(const std::string& title, const SampledDistance& d) {
  if (d.samples == 0) return fmt::format("  {:<6} none: a surface has no triangles\n", title);
  return fmt::format("  {:<6} largest {:.6g}, mean {:.6g}, root mean square {:.6g} ({} samples)\n",
                     title, d.largest, d.mean, d.root_mean_square, d.samples);
}

}  // namespace

std::string to_json(const SurfaceAnalysis& analysis) {
  Json json;
  json["surface"] = {{"path", analysis.surface.string()},
                     {"vertices", analysis.vertices},
                     {"triangles", analysis.triangles},
                     {"area", analysis.invariants.area}};
  json["components"] = Json::array();
  for (std::size_t i = 0; i < analysis.invariants.parts.size(); ++i) {
    const auto& part = analysis.invariants.parts[i];
    Json row;
    if (!analysis.part_modes.empty()) row["mode"] = analysis.part_modes[i];
    if (!analysis.part_values.empty()) row["value"] = analysis.part_values[i];
    row["triangles"] = part.triangles;
    row["area"] = part.area;
    row["euler_characteristic"] = part.euler_characteristic;
    row["boundary_loops"] = part.boundary_loops;
    json["components"].push_back(std::move(row));
  }
  const TriangleQuality& quality = analysis.quality;
  // Of no triangles there is no median.
  const auto of_triangles = [&](double x) {
    return analysis.triangles == 0 ? Json(nullptr) : number(x);
  };
  json["quality"] = {{"least_angle", of_triangles(quality.least_angle)},
                     {"median_angle", of_triangles(quality.median_angle)},
                     {"smallest_angle", json_of(quality.smallest_angle)},
                     {"median_aspect_ratio", of_triangles(quality.median_aspect_ratio)},
                     {"largest_aspect_ratio", of_triangles(quality.largest_aspect_ratio)},
                     {"aspect_ratio", json_of(quality.aspect_ratio)},
                     {"flat", quality.flat}};
  if (analysis.curvature) {
    json["curvature"] = json_of(*analysis.curvature);
    json["normal_jump"] = json_of(analysis.normal_jump);
    json["umbilics"] = json_of(analysis.umbilics);
  }
  if (analysis.recovered) {
    json["recovered_curvature"] = json_of(*analysis.recovered);
    json["recovered_umbilics"] = json_of(analysis.recovered_umbilics);
  }
  if (analysis.ridges) json["ridges"] = json_of(*analysis.ridges);
  if (analysis.smooth) json["smooth_curvature"] = json_of(*analysis.smooth);
  if (analysis.median_difference) json["median_difference"] = *analysis.median_difference;
  if (analysis.forth && analysis.back)
    json["distance"] = {{"against", analysis.against.string()},
                        {"forth", json_of(*analysis.forth)},
                        {"back", json_of(*analysis.back)},
                        {"hausdorff", hausdorff_of(*analysis.forth, *analysis.back)}};
  if (!analysis.output.empty()) json["output"] = analysis.output.string();
  json["seconds"] = analysis.seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const SurfaceAnalysis& analysis) {
  std::string text;
  append_format(text, "{}: {} vertices, {} triangles, area {:.6g}\n\n", analysis.surface.string(),
                analysis.vertices, analysis.triangles, analysis.invariants.area);
  append_format(text, "{:>10} {:>10} {:>10} {:>14} {:>8} {:>8}\n", "component",
                analysis.part_values.empty() ? "mode" : "value", "triangles", "area", "Euler",
                "loops");
  const auto& parts = analysis.invariants.parts;
  const auto& numbers = analysis.part_values.empty() ? analysis.part_modes : analysis.part_values;
  for (std::size_t i = 0; i < std::min(parts.size(), kMostRows); ++i)
    append_format(text, "{:>10} {:>10} {:>10} {:>14.6g} {:>8} {:>8}\n", i,
                  numbers.empty() ? "" : fmt::format("{:g}", numbers[i]), parts[i].triangles,
                  parts[i].area, parts[i].euler_characteristic, parts[i].boundary_loops);
  if (parts.size() > kMostRows)
    append_format(text, "{:>10} (--json lists all {})\n", "...", parts.size());
  const TriangleQuality& quality = analysis.quality;
  text += '\n' + text_of(fmt::format("smallest angle of a triangle, degrees (median {:.1f})",
                                     quality.median_angle),
                         quality.smallest_angle, analysis.triangles);
  text += text_of(fmt::format("circumradius over twice the inradius (median {:.2f})",
                              quality.median_aspect_ratio),
                  quality.aspect_ratio, analysis.triangles);
  if (analysis.curvature) {
    text += text_of("curvature (field)", *analysis.curvature);
    text += row_of("normal jump", analysis.normal_jump);
    text += text_of(analysis.umbilics);
  }
  if (analysis.recovered) {
    text += text_of("curvature (recovered)", *analysis.recovered);
    text += text_of(analysis.recovered_umbilics);
  }
  if (analysis.ridges) text += text_of(*analysis.ridges);
  if (analysis.smooth) text += text_of("curvature (fitted)", *analysis.smooth);
  if (analysis.median_difference)
    append_format(text, "  median difference of the mean curvatures: {:.4g}\n",
                  *analysis.median_difference);
  if (analysis.forth && analysis.back)
    text += fmt::format("\ndistance to {}, sampled\n", analysis.against.string()) +
            text_of("forth", *analysis.forth) + text_of("back", *analysis.back);
  if (!analysis.output.empty()) append_format(text, "\n{}\n", analysis.output.string());
  return text;
}

}  // namespace tensortopo
