#include "bt_core/engine/compile/compiler_children.h"

namespace coppice {
namespace {

std::string Range(ChildCount allowed) {
  const std::string min = std::to_string(allowed.min);
  if (allowed.max == 0) return "none";
  if (allowed.max == UINT32_MAX) return "at least " + min;
  if (allowed.max == allowed.min) return "exactly " + min;
  return min + (allowed.max == allowed.min + 1 ? " or " : " to ") + std::to_string(allowed.max);
}

}  // namespace

std::string WrongChildCount(std::string_view id, std::uint32_t count, ChildCount allowed) {
  if (count >= allowed.min && count <= allowed.max) return {};
  return std::string(id) + " has " + std::to_string(count) + (count == 1 ? " child" : " children") +
         ", expected " + Range(allowed);
}

ChildCount ChildrenOf(NodeCategory category) {
  if (category == NodeCategory::kControl) return {1, UINT32_MAX};
  if (category == NodeCategory::kDecorator) return {1, 1};
  return {0, 0};
}

}  // namespace coppice
