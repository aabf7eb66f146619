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
  std::vector<PlacedRule> ReadRules(const JsonText& json);

 private:
  MockScript ReadScript(const JsonText& json);
  void ReadOutputs(const JsonText& json, MockScript& script);
  Chances ReadChances(const JsonText& json);
  double ReadShare(const JsonText& json);
  void ReadRange(const JsonText& json, Duration& shortest, Duration& longest);
  std::vector<Status> ReadResults(const JsonText& json);
  Status ReadResult(const JsonText& json);
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_SCRIPT_FIELDS_H_
