// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/render_command.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "render/display_server.hpp"
#include "render/domain_boundary.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

constexpr int kSmallest = 16, kLargest = 4096;

// Two numbers and what stands between them; nothing if the text is anything else.
template <class Number>
std::optional<std::pair<Number, Number>> two_numbers(std::string_view text, char between) {
  Number first{}, second{};
  const char* const end = text.data() + text.size();
  const auto one = std::from_chars(text.data(), end, first);
  if (one.ec != std::errc() || one.ptr == end || *one.ptr != between) return std::nullopt;
  const auto two = std::from_chars(one.ptr + 1, end, second);
  if (two.ec != std::errc() || two.ptr != end) return std::nullopt;
  return std::pair{first, second};
}

std::string png_bytes(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace

void parse_size(std::string_view text, View& view) {
  const auto size = two_numbers<int>(text, 'x');
  const auto fits = [](int n) { return n >= kSmallest && n <= kLargest; };
  if (!size || !fits(size->first) || !fits(size->second)) {
    throw UsageError(fmt::format("--size {}: must be WIDTHxHEIGHT, each from {} to {}", text,
                                 kSmallest, kLargest));
  }
  std::tie(view.width, view.height) = *size;
}

void parse_view(std::string_view text, View& view) {
  const auto angles = two_numbers<double>(text, ',');
  if (!angles || !std::isfinite(angles->first) || !(std::abs(angles->second) <= 90)) {
    throw UsageError(fmt::format(
        "--view {}: must be AZIMUTH,ELEVATION in degrees, elevation from -90 to 90", text));
  }
  std::tie(view.azimuth, view.elevation) = *angles;
}

RenderReport run_render(const RenderCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (command.output.extension() != ".png") {
    throw UsageError(command.output.string() + ": the name must end in .png");
  }
  if (command.surfaces.empty() && !command.mesh) throw UsageError("nothing to draw");

  if (progress) progress("reading", 0);
  std::vector<Sheet> sheets;
  for (const auto& file : command.surfaces) {
    for (Sheet& sheet : read_sheets(file)) sheets.push_back(std::move(sheet));
  }
  vtkSmartPointer<vtkPolyData> domain;
  if (command.mesh) domain = domain_boundary(read_mesh(*command.mesh).mesh);

  if (progress) progress("drawing", 0.3);
  vtkSmartPointer<vtkImageData> image;
  try {
    const DisplayServer display;
    image = draw(sheets, domain, command.view);
  } catch (const std::runtime_error& problem) {
    throw IoError(IoError::Kind::unwritable, command.output, problem.what());
  }
  if (progress) progress("writing", 0.9);
  const std::string bytes = png_bytes(image);
  write_text(command.output, bytes);

  RenderReport report;
  for (const Sheet& sheet : sheets) {
    if (sheet.mode) report.modes.push_back(*sheet.mode);
  }
  report.bytes = bytes.size();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
