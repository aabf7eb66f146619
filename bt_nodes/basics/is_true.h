// IsTrue: asks a key that is fed from outside.
#ifndef COPPICE_BT_NODES_BASICS_IS_TRUE_H_
#define COPPICE_BT_NODES_BASICS_IS_TRUE_H_

#include "bt_core/nodes/leaf.h"

namespace coppice::leaves {

class IsTrue : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is a key true? What nobody has written yet is not; a script would fail with a message.";
  Input<bool> value{this, "value", "the key", kOptional};
  bool Check() override { return value.has_value() && *value; }
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_BASICS_IS_TRUE_H_
