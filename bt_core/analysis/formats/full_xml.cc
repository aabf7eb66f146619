#include "bt_core/analysis/formats/full_xml.h"

#include <optional>
#include <string_view>
#include <vector>

#include "bt_core/engine/compile/models.h"
#include "bt_core/model/document.h"

namespace coppice {
namespace {

class Writer {
 public:
  explicit Writer(const TreeDescription& tree) : tree_(tree), children_(tree.nodes.size()) {
    Diagnostics ignored;  // they were read before
    for (const DescribedDocument& document : tree.documents) {
      documents_.push_back(Document::FromText(document.text, document.file, ignored));
    }
    for (NodeIndex node{1}; node < tree.nodes.size(); ++node) {
      children_[tree.nodes[node].parent].push_back(node);
    }
  }

  std::string Write() {
    std::string xml =
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"" + EscapeXml(tree_.main_tree) + "\">\n";
    AddInstance(tree_.main_tree, "", kRootNode, xml);
    for (NodeIndex node{0}; node < tree_.nodes.size(); ++node) {
      if (tree_.nodes[node].category != NodeCategory::kSubTree || children_[node].empty()) continue;
      AddInstance(tree_.nodes[node].id, tree_.nodes[node].path, children_[node].front(), xml);
    }
    return xml + Models() + "</root>\n";
  }

 private:
  void AddInstance(const std::string& id, const std::string& path, NodeIndex root,
                   std::string& xml) {
    xml += "  <BehaviorTree ID=\"" + EscapeXml(id) + "\" _fullpath=\"" + EscapeXml(path) + "\">\n";
    AddNode(root, 4, xml);
    xml += "  </BehaviorTree>\n";
  }

  // Trees are not so deep that the stack could be too small: the compiler refuses those.
  void AddNode(NodeIndex node, std::size_t indent, std::string& xml) {
    const DescribedNode& described = tree_.nodes[node];
    const bool is_subtree = described.category == NodeCategory::kSubTree;
    const std::string tag = is_subtree ? "SubTree" : described.id;
    xml += std::string(indent, ' ') + "<" + tag;
    if (is_subtree) xml += " ID=\"" + EscapeXml(described.id) + "\"";
    AddAttributes(described, xml);
    xml += " _uid=\"" + std::to_string(node + 1) + "\"";
    if (is_subtree) xml += " _fullpath=\"" + EscapeXml(described.path) + "\"";
    if (is_subtree || children_[node].empty()) {
      xml += "/>\n";
      return;
    }
    xml += ">\n";
    for (const NodeIndex child : children_[node]) AddNode(child, indent + 2, xml);
    xml += std::string(indent, ' ') + "</" + tag + ">\n";
  }

  void AddAttributes(const DescribedNode& node, std::string& xml) const {
    if (node.document >= documents_.size() || !documents_[node.document]) return;
    const Document& document = *documents_[node.document];
    if (node.element >= document.elements().size()) return;
    const Element& element = document.element(node.element);
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (a->name == "ID" || a->name == "_uid" || a->name == "_fullpath") continue;
      xml += " " + std::string(a->name) + "=\"" + EscapeXml(a->value) + "\"";
    }
  }

  std::string Models() const {
    const std::size_t begin = tree_.models.find("<TreeNodesModel>");
    constexpr std::string_view kEnd = "</TreeNodesModel>";
    const std::size_t end = tree_.models.find(kEnd);
    if (begin == std::string::npos || end == std::string::npos) return {};
    return "  " + tree_.models.substr(begin, end + kEnd.size() - begin) + "\n";
  }

  const TreeDescription& tree_;
  std::vector<std::optional<Document>> documents_;
  std::vector<std::vector<NodeIndex>> children_;
};

}  // namespace

std::string FullXml(const TreeDescription& tree) { return Writer(tree).Write(); }

}  // namespace coppice
