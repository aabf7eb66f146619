// Reads the members of JSON that people write: what is missing or wrong is said with its place, and
// the reading goes on, so that all errors are told at once.
#ifndef COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_
#define COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/testing/json_text.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

/// Each function returns something harmless where there is an error.
class JsonFields {
 public:
  explicit JsonFields(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

 protected:
  /// True if it is of that kind.
  bool Require(const JsonText& json, JsonText::Kind kind);
  void Unknown(const JsonText& member, const std::vector<std::string>& known);
  void Error(const JsonText& json, const std::string& message, const std::string& hint = {}) {
    diagnostics_.Error(json.where, message, hint);
  }

  const std::vector<JsonText>& ListOf(const JsonText& json);
  const std::vector<JsonText>& MembersOf(const JsonText& json);

  bool ReadBool(const JsonText& json);
  std::string ReadText(const JsonText& json);
  int ReadCount(const JsonText& json);
  /// Not negative.
  double ReadNumber(const JsonText& json, double most, const char* expected);
  std::uint64_t ReadSeed(const JsonText& json);
  Duration ReadMilliseconds(const JsonText& json);
  Status ReadStatus(const JsonText& json);
  KeyValue ReadValue(const JsonText& json);
  std::vector<KeyValue> ReadValues(const JsonText& json);
  /// A value, or a list of them: all with the key of `json`.
  std::vector<KeyValue> ReadChoice(const JsonText& json);

 private:
  Diagnostics& diagnostics_;
  const std::vector<JsonText> none_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_JSON_FIELDS_H_
