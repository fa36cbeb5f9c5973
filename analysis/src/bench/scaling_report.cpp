// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "append_format.hpp"
#include "bench/scaling.hpp"
#include "render/charts/line_chart.hpp"

namespace tensortopo {
namespace {

std::string x_title(ScalingOver over) {
  switch (over) {
    case ScalingOver::size:
      return "tetrahedra";
    case ScalingOver::mode:
      return "1 - M (surfaces of M and -M)";
    case ScalingOver::threads:
      return "threads";
    case ScalingOver::modes:
      break;
  }
  return "modes in one run";
}

}  // namespace

std::string_view name_of(ScalingOver over) {
  constexpr std::string_view names[]{"size", "mode", "threads", "modes"};
  return names[static_cast<std::size_t>(over)];
}

std::string to_json(const ScalingReport& report) {
  using Json = nlohmann::ordered_json;
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  Json json;
  json["scaling"] = name_of(report.over);
  json["field"] = report.field;
  json["threads"] = report.threads;
  json["points"] = Json::array();
  for (const ScalingPoint& point : report.points) {
    Json row{{name_of(report.over), point.x},
             {"tetrahedra", point.tetrahedra},
             {"triangles", point.triangles},
             {"extract", point.seconds}};
    if (point.vtk_seconds > 0) {
      row["vtk_contour"] = point.vtk_seconds;
      row["extract_over_vtk_contour"] = point.seconds / point.vtk_seconds;
    }
    json["points"].push_back(std::move(row));
  }
  json["exponent"] = number(report.exponent);
  json["vtk_exponent"] = number(report.vtk_exponent);
  json["serial_share"] = number(report.serial_share);
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const ScalingReport& report) {
  std::string text;
  append_format(text, "{}, {} threads\n{:>12} {:>12} {:>12} {:>12} {:>12}\n", report.field,
                report.threads, name_of(report.over), "tetrahedra", "triangles", "extract",
                "vtk_contour");
  for (const ScalingPoint& point : report.points) {
    const std::string vtk =
        point.vtk_seconds > 0 ? fmt::format("{:.4f}", point.vtk_seconds) : std::string("-");
    append_format(text, "{:>12g} {:>12} {:>12} {:>12.4f} {:>12}\n", point.x, point.tetrahedra,
                  point.triangles, point.seconds, vtk);
  }
  if (std::isfinite(report.exponent))
    append_format(text, "seconds grow like {}^{:.2f}\n", name_of(report.over), report.exponent);
  if (std::isfinite(report.serial_share))
    append_format(text, "serial share {:.1f} % of the time with one thread (Amdahl's law)\n",
                  100 * report.serial_share);
  return text;
}

std::string scaling_chart(const ScalingReport& report) {
  LineChart chart{report.field + fmt::format(", {} threads", report.threads),
                  x_title(report.over),
                  "seconds",
                  true,
                  true,
                  {{"extract", {}, {}}, {"vtk_contour", {}, {}}}};
  if (std::isfinite(report.exponent))
    chart.lines[0].name += fmt::format(": exponent {:.2f}", report.exponent);
  if (std::isfinite(report.vtk_exponent))
    chart.lines[1].name += fmt::format(": exponent {:.2f}", report.vtk_exponent);
  for (const ScalingPoint& point : report.points) {
    const double x = report.over == ScalingOver::mode ? 1 - point.x : point.x;
    chart.lines[0].points.emplace_back(x, point.seconds);
    if (point.vtk_seconds > 0) chart.lines[1].points.emplace_back(x, point.vtk_seconds);
  }
  if (chart.lines[1].points.empty()) chart.lines.pop_back();
  return line_chart(chart);
}

}  // namespace tensortopo
