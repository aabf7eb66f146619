// How an action of the robot ended, as a capability reports it to the leaf that started it.
// No Outcome: it walks through the inbox and lies in records, so it is a Value with a text form,
// and one that nobody has filled in has failed.
#ifndef COPPICE_BT_NODES_BASICS_ACTION_RESULT_H_
#define COPPICE_BT_NODES_BASICS_ACTION_RESULT_H_

#include <string>
#include <string_view>

#include "bt_core/data/value.h"

namespace coppice::leaves {

struct ActionResult {
  bool ok = false;
  std::string message;  ///< why it failed; for people
};

}  // namespace coppice::leaves

/// Text form: "ok" or "failed", then a blank and the message.
template <>
struct coppice::ValueTraits<coppice::leaves::ActionResult> {
  static constexpr const char* kName = "ActionResult";
  static bool Parse(std::string_view text, leaves::ActionResult& out);
  static std::string Print(const leaves::ActionResult& value);
};

#endif  // COPPICE_BT_NODES_BASICS_ACTION_RESULT_H_
