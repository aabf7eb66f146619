// Reads the members of JSON that people write: what is missing or wrong is said with its place, and
// the reading goes on, so that all errors are told at once.
#ifndef COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_
#define COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/json.h"
#include "bt_core/base/status.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

/// Each function returns something harmless where there is an error.
class JsonFields {
 public:
  explicit JsonFields(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

 protected:
  /// True if it is of that kind.
  bool Require(const JsonValue& json, JsonValue::Kind kind);
  void Unknown(const JsonValue& member, const std::vector<std::string>& known);
  void Error(const JsonValue& json, const std::string& message, const std::string& hint = {}) {
    diagnostics_.Error(json.where, message, hint);
  }

  const std::vector<JsonValue>& ListOf(const JsonValue& json);
  const std::vector<JsonValue>& MembersOf(const JsonValue& json);

  bool ReadBool(const JsonValue& json);
  std::string ReadText(const JsonValue& json);
  int ReadCount(const JsonValue& json);
  /// Not negative.
  double ReadNumber(const JsonValue& json, double most, const char* expected);
  std::uint64_t ReadSeed(const JsonValue& json);
  Duration ReadMilliseconds(const JsonValue& json);
  Status ReadStatus(const JsonValue& json);
  KeyValue ReadValue(const JsonValue& json);
  std::vector<KeyValue> ReadValues(const JsonValue& json);
  /// A value, or a list of them: all with the key of `json`.
  std::vector<KeyValue> ReadChoice(const JsonValue& json);

 private:
  Diagnostics& diagnostics_;
  const std::vector<JsonValue> none_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_
