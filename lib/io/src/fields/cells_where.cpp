// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/cells_where.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include <vtkCommand.h>
#include <vtkExprTkFunctionParser.h>
#include <vtkNew.h>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::detail {
namespace {

/// Longer expressions are refused: the parser calls itself for each parenthesis.
constexpr std::size_t most_characters = 4096;

/// Of an expression in a message.
constexpr std::size_t most_shown = 200;

/// Keeps the first message of the parser, which would print it.
class FirstError : public vtkCommand {
 public:
  static FirstError* New() { return new FirstError; }
  void Execute(vtkObject*, unsigned long, void* text) override {
    if (!message.empty() || text == nullptr) return;
    message = static_cast<const char*>(text);
    // "ERROR: In FILE, line N\nCLASS (ADDRESS): message"
    if (const auto begin = message.find("): "); begin != std::string::npos)
      message.erase(0, begin + 3);
    // Of several in brackets, which name the expression again, the first message.
    if (const auto said = message.find("Msg: "); said != std::string::npos)
      message = message.substr(said + 5, message.find_first_of("\r\n", said) - said - 5);
    std::replace_if(message.begin(), message.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    while (!message.empty() && message.back() == ' ') message.pop_back();
  }
  std::string message;
};

/// A number at each point, or in each cell, of one piece.
struct Quantity {
  std::string name;
  bool on_points = true;
  std::function<std::vector<double>()> values;
  bool is_of_field_too = false;  ///< an array with the name of what tensors or places give
};

/// Frobenius norm, without overflow on the way.
double norm(const SymmetricTensor<double>& t) {
  const double shear = std::sqrt(2.0) * elementary::hypot(t.xy, t.yz, t.xz);
  return elementary::hypot(elementary::hypot(t.xx, t.yy, t.zz), shear);
}

double deviator_norm(const SymmetricTensor<double>& t) { return norm(to_tensor(deviator(t))); }

/// Arrays of the file, then what the tensors and places give.
std::vector<Quantity> quantities(const RawGrid& grid, const TensorChoice* choice,
                                 const std::vector<SymmetricTensor<double>>& tensors) {
  std::vector<Quantity> list;
  const auto add_arrays = [&](const std::vector<ArraySource>& arrays, bool on_points) {
    for (const ArraySource& array : arrays)
      if (array.components == 1) list.push_back({array.name, on_points, array.values, false});
  };
  add_arrays(grid.point_data, true);
  add_arrays(grid.cell_data, false);
  const auto add = [&](const char* name, bool on_points, auto value, std::size_t count) {
    const auto array =
        std::find_if(list.begin(), list.end(), [&](const auto& q) { return q.name == name; });
    if (array != list.end()) {
      array->is_of_field_too = true;
      return;
    }
    list.push_back({name, on_points,
                    [value, count] {
                      std::vector<double> all(count);
                      for (std::size_t i = 0; i < count; ++i) all[i] = value(i);
                      return all;
                    },
                    false});
  };
  for (std::size_t k = 0; k < 3; ++k)
    add(
        std::array{"x", "y", "z"}[k], true,
        [&grid, k](std::size_t p) { return grid.coordinates[3 * p + k]; }, grid.points());
  if (choice == nullptr || choice->per_cell != 1 || choice->values != CellValues::one) return list;
  const auto add_of_tensor = [&](const char* name, auto value) {
    add(
        name, !choice->on_cells, [&tensors, value](std::size_t i) { return value(tensors[i]); },
        tensors.size());
  };
  add_of_tensor("magnitude", norm);
  add_of_tensor("deviator_magnitude", deviator_norm);
  add_of_tensor("anisotropy",
                [](const SymmetricTensor<double>& t) { return deviator_norm(t) / norm(t); });
  add_of_tensor("mode", [](const SymmetricTensor<double>& t) {
    return mode_if_defined(deviator(t)).value_or(std::numeric_limits<double>::quiet_NaN());
  });
  return list;
}

bool is_plain(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || c == '_' || (c >= '0' && c <= '9'); });
}

/// The parser drops spaces, so that words between operands run into them: `and` and `or` become
/// the operators of the same meaning, but for names between quotation marks.
std::string with_operators(const std::string& text) {
  std::string result;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                                 text[end] == '_' || text[end] == '.'))
      ++end;
    const std::string word = end > i ? text.substr(i, end - i) : text.substr(i, 1);
    is_quoted = is_quoted != (word == "\"");
    result += is_quoted ? word : word == "and" ? "&" : word == "or" ? "|" : word;
    i += word.size();
  }
  return result;
}

/// Whether an expression does more than compare numbers: the parser's language has variables,
/// statements and loops.
bool is_program(const std::string& text) {
  bool is_quoted = false;
  char before = ' ';
  for (const char c : text) {
    is_quoted = is_quoted != (c == '"');
    if (is_quoted) continue;
    const bool is_assignment = c == '=' && std::string(":+-*/%").find(before) != std::string::npos;
    if (is_assignment || c == ';' || c == '{' || c == '[') return true;
    before = c;
  }
  return false;
}

/// A condition on the quantities of one piece.
class Condition {
 public:
  Condition(const RawGrid& grid, const std::string& text, const std::vector<Quantity>& known)
      : grid_(grid), text_(text) {
    const bool is_name =
        std::any_of(known.begin(), known.end(), [&](const Quantity& q) { return q.name == text; });
    if (text.size() > most_characters) fail("is too long");
    if (!is_name && is_program(text))
      fail("is no condition: it may compare numbers, not assign them (== for =, and for ;)");
    // In an expression a name that is no identifier stands between quotation marks.
    const auto spelled = [](const std::string& name) {
      return is_plain(name) ? name : '"' + name + '"';
    };
    parser_->AddObserver(vtkCommand::ErrorEvent, error_.Get());
    // What is not a number is false.
    parser_->ReplaceInvalidValuesOn();
    parser_->SetReplacementValue(0);
    for (const Quantity& q : known)
      if (!q.name.empty() && q.name.find('"') == std::string::npos)
        parser_->SetScalarVariableValue(spelled(q.name), 1.0);
    parser_->SetFunction((is_name ? spelled(text) : with_operators(text)).c_str());
    const bool is_number = parser_->IsScalarResult() != 0;
    if (!is_number || !error_->message.empty()) fail(problem(known));
    for (const Quantity& q : known) {
      const int variable = parser_->GetScalarVariableIndex(spelled(q.name));
      if (variable < 0 || !parser_->GetScalarVariableNeeded(variable)) continue;
      if (q.is_of_field_too)
        fail("`" + q.name + "` is an array of the file, and what the field has by this name; " +
             "rename the array");
      if (std::any_of(used_.begin(), used_.end(),
                      [&](const Used& u) { return u.variable == variable; }))
        fail("there are two arrays `" + q.name + "`");
      used_.push_back({variable, q.on_points, q.values()});
      if (used_.back().values.size() != (q.on_points ? grid.points() : grid.cells()))
        throw IoError(IoError::Kind::invalid, grid.file,
                      "array `" + q.name + "` has not one number each");
    }
  }

  bool uses(bool points) const {
    return std::any_of(used_.begin(), used_.end(),
                       [&](const Used& u) { return u.on_points == points; });
  }

  /// Not where a number is none. Points and cells that it does not use may be any.
  bool holds(std::size_t point, std::size_t cell) {
    for (const Used& u : used_)
      parser_->SetScalarVariableValue(u.variable, u.values[u.on_points ? point : cell]);
    const double result = parser_->GetScalarResult();
    if (!error_->message.empty()) fail(error_->message);
    return result != 0 && !std::isnan(result);
  }

 private:
  struct Used {
    int variable;
    bool on_points;
    std::vector<double> values;
  };

  std::string problem(const std::vector<Quantity>& known) const {
    std::string names;
    for (const Quantity& q : known) names += (names.empty() ? "" : ", ") + q.name;
    return "is no condition" +
           (error_->message.empty() ? std::string() : " (" + error_->message + ")") +
           "; it may use, with one number each: " + names;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::string shown =
        text_.size() <= most_shown ? text_ : text_.substr(0, most_shown) + "...";
    throw IoError(IoError::Kind::inapplicable, grid_.file, "--where '" + shown + "': " + what);
  }

  const RawGrid& grid_;
  std::string text_;
  vtkNew<FirstError> error_;
  vtkNew<vtkExprTkFunctionParser> parser_;
  std::vector<Used> used_;
};

std::vector<char> select(const RawGrid& grid, Condition& condition) {
  const bool of_points = condition.uses(true), of_cells = condition.uses(false);
  std::vector<char> at_point;
  if (of_points && !of_cells)
    for (std::size_t p = 0; p < grid.points(); ++p) at_point.push_back(condition.holds(p, 0));
  std::vector<char> taken(grid.cells());
  for (std::size_t c = 0; c < grid.cells(); ++c) {
    if (!of_points) {
      taken[c] = condition.holds(0, c);
      continue;
    }
    const auto corners = grid.connectivity.begin();
    taken[c] = std::all_of(corners + grid.offsets[c], corners + grid.offsets[c + 1],
                           [&](std::int64_t corner) {
                             const auto p = static_cast<std::size_t>(corner);
                             return of_cells ? condition.holds(p, c) : at_point[p] != 0;
                           });
  }
  return taken;
}

}  // namespace

CellSelection cells_where(const std::vector<RawGrid>& pieces, const std::string& condition,
                          const TensorChoice* choice,
                          const std::vector<std::vector<SymmetricTensor<double>>>& tensors) {
  CellSelection selection(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].cells() == 0) continue;
    const std::vector<SymmetricTensor<double>> none;
    Condition here(pieces[k], condition,
                   quantities(pieces[k], choice, choice != nullptr ? tensors[k] : none));
    selection[k] = select(pieces[k], here);
  }
  return selection;
}

}  // namespace tensortopo::detail
