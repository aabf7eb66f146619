#include "bt_core/live/groot2/full_tree.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "bt_core/engine/compile/models.h"
#include "bt_core/model/manifest.h"
#include "bt_core/nodes/guards.h"

namespace coppice {
namespace {

class TreeWriter {
 public:
  explicit TreeWriter(const Program& program) : program_(program) {
    for (const TreeInstance& tree : program.trees) instances_[tree.node] = &tree;
  }

  std::optional<std::string> Write() {
    xml_ = "<root BTCPP_format=\"4\">\n";
    for (const TreeInstance& tree : program_.trees) {
      xml_ += "  <BehaviorTree";
      Attribute("ID", tree.id);
      Attribute("_fullpath", tree.path);
      xml_ += ">\n";
      Node(tree.root, 4);
      xml_ += "  </BehaviorTree>\n";
    }
    if (is_too_long()) return std::nullopt;
    xml_ += WriteModelsElement(*program_.registry) + "</root>\n";
    return is_too_long() ? std::nullopt : std::optional(std::move(xml_));
  }

 private:
  bool is_too_long() const { return is_too_long_ || xml_.size() > kLongestFullTree; }

  void Node(NodeIndex node, std::size_t indent) {
    if (is_too_long()) return;
    xml_.append(indent, ' ');
    if (program_.nodes[node].type == NodeType::kSubTree) {
      SubTree(node);
      return;
    }
    const std::string id = program_.Id(node);
    xml_ += "<" + id;
    Attribute("name", program_.Name(node));
    Attribute("_uid", std::to_string(Uid(node)));
    WrittenAttributes(node);
    if (program_.nodes[node].end == node + 1) {
      xml_ += "/>\n";
      return;
    }
    xml_ += ">\n";
    for (NodeIndex child = node + 1; child < program_.nodes[node].end;
         child = program_.nodes[child].end) {
      Node(child, indent + 2);
    }
    xml_.append(indent, ' ');
    xml_ += "</" + id + ">\n";
  }

  void SubTree(NodeIndex node) {
    const TreeInstance& instance = *instances_.at(node);
    xml_ += "<SubTree";
    Attribute("ID", instance.id);
    Attribute("_fullpath", instance.path);
    Attribute("_uid", std::to_string(Uid(node)));
    WrittenAttributes(node);
    xml_ += "/>\n";
  }

  void WrittenAttributes(NodeIndex node) {
    for (const auto& [name, value] : program_.TagOf(node).attributes) {
      if (!IsReservedAttribute(name) || IsGuardAttribute(name)) Attribute(name, value);
    }
  }

  // One that is much too long is not written first.
  void Attribute(std::string_view name, std::string_view value) {
    if (value.size() > kLongestFullTree - std::min(kLongestFullTree, xml_.size())) {
      is_too_long_ = true;
      return;
    }
    xml_ += " ";
    xml_ += name;
    xml_ += "=\"" + EscapeXml(value) + "\"";
  }

  const Program& program_;
  std::unordered_map<NodeIndex, const TreeInstance*> instances_;  // by the SubTree node
  std::string xml_;
  bool is_too_long_ = false;
};

void AppendInstance(const Program& program, NodeIndex node, std::vector<NodeIndex>& out) {
  out.push_back(node);
  if (program.nodes[node].type == NodeType::kSubTree) return;
  for (NodeIndex child = node + 1; child < program.nodes[node].end;
       child = program.nodes[child].end) {
    AppendInstance(program, child, out);
  }
}

}  // namespace

std::optional<std::string> WriteFullTree(const Program& program) {
  return TreeWriter(program).Write();
}

std::vector<NodeIndex> NodesByInstance(const Program& program) {
  std::vector<NodeIndex> nodes;
  nodes.reserve(program.nodes.size());
  for (const TreeInstance& tree : program.trees) AppendInstance(program, tree.root, nodes);
  return nodes;
}

}  // namespace coppice
