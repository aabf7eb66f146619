// JSON: reading with the place of every value and a limit on depth, and writing.
//
//   JsonObject().AddText("node", path).Add("ticks", 17u).Finish()   // {"node":"...","ticks":17}
#ifndef COPPICE_BT_CORE_BASE_JSON_H_
#define COPPICE_BT_CORE_BASE_JSON_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"

namespace coppice {

/// What is nested deeper is refused wherever JSON is read.
inline constexpr int kMaxJsonDepth = 100;
/// More is refused wherever JSON is read: each takes a hundred times what its text does.
inline constexpr std::size_t kMostJsonValues = 400'000;
/// For ReadFile, of a file of JSON that people write [bytes].
inline constexpr std::size_t kLongestJson = std::size_t{16} << 20;

/// A text of JSON, taken apart. Members keep the order of the text.
struct JsonValue {
  enum class Kind : std::uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;
  std::string key;   ///< of a member of an object
  std::string text;  ///< of a string what it says; else as it is written: "true", "-1.5", "null"
  SourceLocation where;
  std::vector<JsonValue> children;  ///< elements or members
  std::size_t end = 0;              ///< of an array or object: offset behind its last bracket

  bool is(Kind other) const { return kind == other; }

  /// The member of that name, or null.
  const JsonValue* Find(std::string_view name) const;
};

/// Of a file that people write: comments (// and /* */) are allowed, a name that is given twice is
/// an error. Nothing if the text is no JSON; then the reason is in `diagnostics`.
std::optional<JsonValue> ParseJson(const std::string& text, const std::string& file,
                                   Diagnostics& diagnostics);

/// Of what programs say to each other: JSON and nothing else.
std::optional<JsonValue> ParseJson(std::string_view text);

/// The value as text, as people would write it: what fits into a line of 100 characters is one
/// line. `indent`: spaces before its further lines. A number is written as it is in `text`.
std::string PrintJson(const JsonValue& json, std::size_t indent = 0);

/// The text in quotes, as JSON wants it. Bytes that are not UTF-8 become U+FFFD.
std::string JsonString(std::string_view text);

/// Seconds with nine digits behind the point.
std::string JsonSeconds(Duration time);

/// Writes one object on one line.
class JsonObject {
 public:
  JsonObject& Add(std::string_view key, const std::string& json);
  JsonObject& Add(std::string_view key, std::uint64_t number);
  JsonObject& AddBool(std::string_view key, bool value) {
    return Add(key, value ? "true" : "false");
  }
  JsonObject& AddText(std::string_view key, std::string_view text);
  std::string Finish() const { return text_ + "}"; }

 private:
  JsonObject& Add(std::string_view key, const char* json) { return Add(key, std::string(json)); }

  std::string text_ = "{";
};

template <class List, class ToJson>
std::string JsonArray(const List& list, ToJson to_json) {
  std::string json = "[";
  for (const auto& item : list) json += (json.size() > 1 ? "," : "") + to_json(item);
  return json + "]";
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_JSON_H_
