// JSON with the place of every value, for files that people write: messages name line and column.
//
// Comments (// and /* */) are allowed. Members keep the order of the text; a name that is given
// twice is an error.
#ifndef COPPICE_BT_CORE_TESTING_JSON_TEXT_H_
#define COPPICE_BT_CORE_TESTING_JSON_TEXT_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice {

struct JsonText {
  enum class Kind : std::uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;
  std::string key;   ///< of a member of an object
  std::string text;  ///< of a string what it says; else as it is written: "true", "-1.5", "null"
  SourceLocation where;
  std::vector<JsonText> children;  ///< elements or members
  std::size_t end = 0;             ///< of an array or object: offset behind its last bracket

  bool is(Kind other) const { return kind == other; }

  /// The member of that name, or null.
  const JsonText* Find(std::string_view name) const;
};

/// Nothing if the text is no JSON; then the reason is in `diagnostics`.
std::optional<JsonText> ParseJsonText(const std::string& text, const std::string& file,
                                      Diagnostics& diagnostics);

/// The value as text, as people would write it: what fits into a line of 100 characters is one
/// line. `indent`: spaces before its further lines. A number is written as it is in `text`.
std::string PrintJsonText(const JsonText& json, std::size_t indent = 0);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_JSON_TEXT_H_
