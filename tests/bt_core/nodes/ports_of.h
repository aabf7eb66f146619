// The ports of built-in nodes as one line of text: "name=default" of each, "?" for an optional one.
#ifndef COPPICE_TESTS_BT_CORE_NODES_PORTS_OF_H_
#define COPPICE_TESTS_BT_CORE_NODES_PORTS_OF_H_

#include <string>
#include <utility>
#include <vector>

#include "bt_core/nodes/node_type.h"

namespace coppice {

class PortsOf {
 public:
  explicit PortsOf(std::vector<BuiltIn> nodes) : nodes_(std::move(nodes)) {}

  std::string operator()(const std::string& id) const {
    for (const BuiltIn& node : nodes_) {
      if (node.manifest.id == id) return Print(node.manifest.ports);
    }
    return "there is no " + id;
  }

 private:
  static std::string Print(const std::vector<PortDeclaration>& ports) {
    std::string text;
    for (const PortDeclaration& port : ports) {
      if (port.direction == PortDirection::kMailbox) continue;
      text += (text.empty() ? "" : " ") + port.name;
      if (port.default_text) {
        text += "=" + *port.default_text;
      } else if (!port.required) {
        text += "?";
      }
    }
    return text;
  }

  std::vector<BuiltIn> nodes_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_NODES_PORTS_OF_H_
