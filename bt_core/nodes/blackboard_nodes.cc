#include "bt_core/nodes/blackboard_nodes.h"

#include <stdexcept>
#include <string>

namespace coppice::internal {

void CopyTo(Slot& slot, const Type* type, const Value& value) {
  if (!type) type = slot.value.type();
  if (!type || type == value.type()) {
    slot.value = value;
  } else {
    Value converted;
    if (!converted.Parse(*type, value.Print())) {
      throw std::invalid_argument("\"" + value.Print() + "\" is not a value of type " + type->name);
    }
    slot.value = converted;
  }
}

}  // namespace coppice::internal
