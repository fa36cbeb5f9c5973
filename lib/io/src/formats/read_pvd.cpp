// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_pvd.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "bytes/words.hpp"
#include "tensortopo/io/io_error.hpp"
#include "vtk/xml_document.hpp"

namespace tensortopo::detail {
namespace {

struct PvdStep {
  double time = 0;
  std::string text;
  std::vector<std::filesystem::path> parts;
};

std::vector<PvdStep> list_steps(const std::shared_ptr<const InputFile>& file) {
  return naming_file(file->path, "", [&] {
    const auto document = parse_xml(file, "Collection");
    std::vector<PvdStep> steps;
    std::size_t number = 0;
    for (const pugi::xml_node set : document->root.child("Collection").children("DataSet")) {
      const std::string part = set.attribute("file").value();
      if (part.empty()) throw FormatError(fmt::format("names no file (data set {})", number));
      const std::string_view text = trimmed(set.attribute("timestep").value());
      const double time = text.empty() ? 0 : from_text<double>(text, ElementType::f64);
      auto step = std::find_if(steps.begin(), steps.end(),
                               [&](const PvdStep& known) { return known.time == time; });
      if (step == steps.end()) {
        steps.push_back({time, fmt::format("time {}", text.empty() ? "0" : text), {}});
        step = steps.end() - 1;
      }
      step->parts.push_back(file->path.parent_path() / part);
      ++number;
    }
    if (steps.empty()) throw FormatError("names no data sets");
    return steps;
  });
}

}  // namespace

std::vector<std::string> pvd_steps(const std::shared_ptr<const InputFile>& file) {
  std::vector<std::string> texts;
  for (const PvdStep& step : list_steps(file)) texts.push_back(step.text);
  return texts;
}

std::vector<RawGrid> read_pvd(const FieldSource& source) {
  const std::vector<PvdStep> steps = list_steps(source.file);
  std::vector<std::string> texts;
  for (const PvdStep& step : steps) texts.push_back(step.text);
  const PvdStep& step = steps[chosen_step(source, texts)];
  std::vector<RawGrid> grids;
  for (const auto& path : step.parts) {
    const FieldFormatEntry& entry = format_of(path);
    if (entry.steps != nullptr)
      throw IoError(IoError::Kind::invalid, source.file->path,
                    "names a file that may have steps of its own (" + path.filename().string() +
                        ")");
    const auto part = load(path);
    source.sum.add(part->bytes);
    for (RawGrid& grid : entry.read(FieldSource{part, source.options, source.sum, source.notes}))
      grids.push_back(std::move(grid));
  }
  return grids;
}

}  // namespace tensortopo::detail
