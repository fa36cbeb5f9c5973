// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/xml_arrays.hpp"

#include <string>
#include <utility>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

std::vector<ArraySource> list_arrays(const std::shared_ptr<const XmlDocument>& document,
                                     pugi::xml_node parent, std::size_t tuples) {
  std::vector<ArraySource> sources;
  for (const pugi::xml_node array : parent.children("DataArray")) {
    ArraySource source;
    source.name = array.attribute("Name").value();
    source.components = components_of(array);
    if (source.components > UINT32_MAX)
      throw FormatError("the array " + source.name + " has too many components");
    if (source.components <= most_named_components)
      for (std::size_t i = 0; i < source.components; ++i)
        source.component_names.emplace_back(
            array.attribute(("ComponentName" + std::to_string(i)).c_str()).value());
    source.values = [document, array, tuples, name = source.name, n = source.components] {
      return naming_file(document->file->path, "", [&] {
        return read_array<double>(*document, array, tuples * n, "`" + name + "`");
      });
    };
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace tensortopo::detail
