// JSON as text, written by hand: reports and exports only write it.
//
//   JsonObject().AddText("node", path).Add("ticks", 17u).Finish()   // {"node":"...","ticks":17}
#ifndef COPPICE_BT_CORE_ANALYSIS_JSON_WRITER_H_
#define COPPICE_BT_CORE_ANALYSIS_JSON_WRITER_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/base/clock.h"

namespace coppice {

/// The text in quotes, as JSON wants it. Bytes that are not UTF-8 become U+FFFD.
std::string JsonText(std::string_view text);

/// Seconds with nine digits behind the point.
std::string JsonSeconds(Duration time);

/// One object on one line.
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

#endif  // COPPICE_BT_CORE_ANALYSIS_JSON_WRITER_H_
