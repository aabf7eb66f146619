#include "bt_core/nodes/blackboard_nodes.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace coppice::internal {
namespace {

bool Convert(const Value& value, const Type* type, Slot& slot) {
  if (!type || type == value.type()) return false;
  Value converted;
  if (!converted.Parse(*type, value.Print())) return false;
  slot.value = std::move(converted);
  return true;
}

}  // namespace

void CopyTo(Slot& slot, const Type* type, const Value& value) {
  if (Convert(value, type ? type : slot.value.type(), slot)) return;
  if (type && type != value.type()) {
    throw std::invalid_argument("\"" + value.Print() + "\" is not a value of type " + type->name);
  }
  slot.value = value;
}

}  // namespace coppice::internal
