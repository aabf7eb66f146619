// How settings stand in JSON: the parts that the user's settings and those of a project share, and
// the ways to read members. What cannot be right is said, and leaves the value as it was.
#ifndef COPPICE_EDITOR_SETTINGS_SETTINGS_JSON_H_
#define COPPICE_EDITOR_SETTINGS_SETTINGS_JSON_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/json.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

class SettingsReader {
 public:
  explicit SettingsReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void Wrong(const JsonValue& value, const std::string& expected);

  void Take(const JsonValue& json, const char* name, bool& value);
  void Take(const JsonValue& json, const char* name, std::string& value);
  void Take(const JsonValue& json, const char* name, double low, double high, int& value);
  void Take(const JsonValue& json, const char* name, double low, double high, float& value);
  void Take(const JsonValue& json, const char* name, Tiles& tiles);
  void Take(const JsonValue& json, const char* name, Splits& splits);
  void Take(const JsonValue& json, const char* name, LayoutStyle& style);

 private:
  Diagnostics& diagnostics_;
};

/// The member of that name; one without children if there is none.
const JsonValue& PartOf(const JsonValue& json, const char* name);

JsonValue MakeJson(JsonValue::Kind kind, std::string key, std::string text = {});
JsonValue MakeJson(std::string key, bool value);
JsonValue MakeJson(std::string key, double value);
JsonValue MakeJson(std::string key, const Tiles& tiles);
JsonValue MakeJson(std::string key, const Splits& splits);
JsonValue MakeJson(std::string key, const LayoutStyle& style);
JsonValue MakeText(std::string key, std::string text);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SETTINGS_SETTINGS_JSON_H_
