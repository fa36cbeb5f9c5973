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

#include "render/animation.hpp"
#include "render/charts/display_server.hpp"
#include "render/render_subject.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

constexpr int kSmallestPicture = 16, kLargestPicture = 4096;

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

std::optional<Vector3<double>> three_numbers(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto first = two_numbers<double>(std::string(text.substr(0, comma)) + ",0", ',');
  const auto rest = two_numbers<double>(text.substr(comma + 1), ',');
  if (!first || !rest) return std::nullopt;
  return Vector3<double>{first->first, rest->first, rest->second};
}

std::string png_bytes(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void check(const RenderCommand& command) {
  const auto need = [](bool condition, const std::string& problem) {
    if (!condition) throw UsageError(problem);
  };
  const bool modes = !command.modes.empty(), frames = !command.frames.empty();
  need(lower_extension(command.output) == ".png" || (frames && is_film(command.output)),
       command.output.string() + ": the name must end in .png" + (frames ? ", .gif or .mp4" : ""));
  need(!command.surfaces.empty() || command.mesh, "nothing to draw");
  need(std::isfinite(command.view.zoom) && command.view.zoom >= 0.1 && command.view.zoom <= 1000,
       "--zoom: must be from 0.1 to 1000");
  need(!(modes && frames), "--animate gives the modes, so --mode has no meaning");
  need(command.surfaces.empty() || !(modes || frames),
       "--mode and --animate extract from a mesh, but surfaces are given");
  need(command.mesh || command.texture == Texture::none || command.texture == Texture::dominant,
       "--texture needs the field that the surface was extracted from (--mesh)");
  need(!command.recover || (!command.one_tet() && (command.texture == Texture::major ||
                                             command.texture == Texture::minor)),
       "--recover is about --texture major or minor, and not of one tetrahedron");
  need(command.levels.empty() || (command.surfaces.empty() && command.mesh && !modes && !frames &&
                                  !command.one_tet() && command.texture == Texture::none),
       "--invariant extracts from a mesh and is drawn alone, in plain colours");
  if (command.one_tet()) {
    need(command.surfaces.empty(), "--tet takes a mesh, not surfaces");
    need(modes || frames, "--tet needs --mode or --animate");
    need(std::isfinite(command.beyond) && command.beyond >= 1 && command.beyond <= 1000,
         "--beyond: must be from 1 to 1000");
  } else {
    need(command.panels.empty() && command.beyond == 1 && !command.marked,
         "--panels, --beyond and --direction are about one tetrahedron (--tet)");
    need(command.texture == Texture::none || modes || frames || !command.surfaces.empty(),
         "--texture needs surfaces, or --mode");
  }
}

}  // namespace

Vector3<double> parse_direction(std::string_view text) {
  const auto v = three_numbers(text);
  if (!v || !(length(*v) > 0) || !std::isfinite(length(*v)))
    throw UsageError(fmt::format("--direction {}: must be X,Y,Z, not all zero", text));
  return unit(*v);
}

void parse_focus(std::string_view text, View& view) {
  const auto point = three_numbers(text);
  if (!point || !std::isfinite(dot(*point, *point)))
    throw UsageError(fmt::format("--focus {}: must be X,Y,Z", text));
  view.focus = {point->x, point->y, point->z};
}

void parse_size(std::string_view text, View& view) {
  const auto size = two_numbers<int>(text, 'x');
  const auto fits = [](int n) { return n >= kSmallestPicture && n <= kLargestPicture; };
  if (!size || !fits(size->first) || !fits(size->second)) {
    throw UsageError(fmt::format("--size {}: must be WIDTHxHEIGHT, each from {} to {}", text,
                                 kSmallestPicture, kLargestPicture));
  }
  std::tie(view.width, view.height) = *size;
  view.sized = true;
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
  check(command);
  require_folder(command.output);
  if (is_film(command.output)) require_ffmpeg(command.output);
  if (progress) progress("reading", 0);
  const bool is_outline = command.surfaces.empty() && command.modes.empty() &&
                          command.frames.empty() && command.levels.empty();
  RenderSubject subject(command);
  RenderReport report;
  report.mesh_notes = subject.mesh_notes();
  report.empty = subject.empty();
  if (is_outline)
    report.notes.push_back("only the mesh's outline is drawn; --mode M or --surface FILE draw more");
  const std::size_t count = command.frames.empty() ? 1 : command.frames.size();
  std::vector<std::string> pictures;
  try {
    const DisplayServer display;
    for (std::size_t i = 0; i < count; ++i) {
      if (progress)
        progress("drawing", 0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(count));
      const auto modes =
          command.frames.empty() ? command.modes : std::vector<ModeValue>{command.frames[i]};
      const auto image = subject.picture(modes, report);
      std::tie(report.width, report.height) =
          std::pair{image->GetDimensions()[0], image->GetDimensions()[1]};
      pictures.push_back(png_bytes(image));
    }
  } catch (const IoError&) {
    throw;
  } catch (const std::runtime_error& problem) {
    throw IoError(IoError::Kind::unwritable, command.output, problem.what());
  }
  if (progress) progress("writing", 0.9);
  FileGroup files;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto file =
        command.frames.empty() ? command.output : frame_file(command.output, i, pictures.size());
    write_text(file, pictures[i]);
    report.bytes += pictures[i].size();
    if (!command.frames.empty()) report.frames.push_back(file);
  }
  if (is_film(command.output)) report.bytes += write_film(command.output, pictures);
  files.commit();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
