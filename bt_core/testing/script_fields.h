// Reads what leaves do from the JSON of scenarios (docs/testing.md).
#ifndef COPPICE_BT_CORE_TESTING_SCRIPT_FIELDS_H_
#define COPPICE_BT_CORE_TESTING_SCRIPT_FIELDS_H_

#include <vector>

#include "bt_core/testing/json_fields.h"

namespace coppice {

class ScriptFields : public JsonFields {
 public:
  using JsonFields::JsonFields;

 protected:
  /// "leaves": scripts by pattern.
  std::vector<PlacedRule> ReadRules(const JsonValue& json);

 private:
  MockScript ReadScript(const JsonValue& json);
  void ReadOutputs(const JsonValue& json, MockScript& script);
  Chances ReadChances(const JsonValue& json);
  double ReadShare(const JsonValue& json);
  void ReadRange(const JsonValue& json, Duration& shortest, Duration& longest);
  std::vector<Status> ReadResults(const JsonValue& json);
  Status ReadResult(const JsonValue& json);
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_SCRIPT_FIELDS_H_
