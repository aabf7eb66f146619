// A child by the value of a variable. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include <cstddef>
#include <string>

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

namespace internal {
template <std::size_t cases>
struct SwitchId {
  static_assert(cases >= 2 && cases <= 6, "there are Switch2 to Switch6");
  static constexpr char kText[] = {'S', 'w', 'i', 't', 'c', 'h', static_cast<char>('0' + cases), 0};
};
}  // namespace internal

template <std::size_t cases>
class SwitchNode : public internal::BuiltIn<ControlNode> {
 public:
  using BuiltInClass = SwitchNode;
  static constexpr const char* kBuiltInId = internal::SwitchId<cases>::kText;
  explicit SwitchNode(const std::string& name, const NodeConfig& config = {})
      : BuiltIn(name, config) {}
};

}  // namespace BT
