#include "bt_core/live/groot2/client_robot_tree.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <utility>

#include "bt_core/engine/events/event_words.h"
#include "bt_core/model/document.h"
#include "bt_core/model/markup.h"
#include "bt_core/nodes/node_type.h"

namespace coppice {
namespace {

constexpr std::size_t kMostNodes = 65535;  // that the protocol can number
constexpr int kDeepest = 2000;             // no tree that somebody has written
constexpr std::size_t kMostPathBytes = std::size_t{32} << 20;

const BuiltIn* FindBuiltIn(std::string_view id) {
  const std::vector<BuiltIn>& all = BuiltIns();
  const auto at =
      std::find_if(all.begin(), all.end(), [id](const BuiltIn& b) { return b.manifest.id == id; });
  return at == all.end() ? nullptr : &*at;
}

class Reader {
 public:
  Reader(const Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  RobotTree Read() {
    Gather();
    if (main_ == kNoElement) {
      diagnostics_.Error({document_.file()}, "the robot sent no tree");
      return {};
    }
    const Element& main = document_.element(main_);
    tree_.description.main_tree = document_.AttributeValue(main, "ID");
    tree_.boards.push_back(tree_.description.main_tree);
    AddChildren(main, {}, kNoNode);
    if (tree_.uids.empty()) diagnostics_.Error({document_.file()}, "the robot's tree has no node");
    return diagnostics_.has_errors() ? RobotTree() : std::move(tree_);
  }

 private:
  // The instances by their path, and the categories of the models.
  void Gather() {
    for (const Element& element : document_.elements()) {
      const auto index = static_cast<ElementIndex>(&element - document_.elements().data());
      if (element.tag == "BehaviorTree") {
        const std::string_view path = document_.AttributeValue(element, "_fullpath");
        if (main_ == kNoElement && path.empty()) main_ = index;
        instances_.emplace(path, index);
      } else if (element.tag == "TreeNodesModel") {
        ReadModels(element);
      }
    }
  }

  void ReadModels(const Element& models) {
    tree_.description.models = "<root BTCPP_format=\"4\">" +
                               document_.text().substr(models.offset, models.end - models.offset) +
                               "</root>";
    for (ElementIndex i = models.first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      const Element& model = document_.element(i);
      const auto category = CategoryFromTag(model.tag);
      if (category) categories_.emplace(document_.AttributeValue(model, "ID"), *category);
    }
  }

  void AddChildren(const Element& element, const std::string& instance, NodeIndex parent) {
    for (ElementIndex i = element.first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      AddNode(i, instance, parent);
    }
  }

  void AddNode(ElementIndex index, const std::string& instance, NodeIndex parent) {
    const Element& element = document_.element(index);
    std::uint16_t uid = 0;
    if (!ReadUid(element, uid) || tree_.uids.size() >= kMostNodes) return;
    if (depth_ >= kDeepest) return Complain(element, "the robot's tree is too deep");
    if (path_bytes_ > kMostPathBytes) return Complain(element, "the paths of nodes are too long");
    ++depth_;
    const auto node = static_cast<NodeIndex>(tree_.uids.size());
    tree_.nodes.emplace(uid, node);
    tree_.uids.push_back(uid);
    const bool is_subtree = element.tag == "SubTree";
    const std::string id(is_subtree ? document_.AttributeValue(element, "ID") : element.tag);
    DescribedNode described;
    described.id = id;
    described.category = is_subtree ? NodeCategory::kSubTree : CategoryOf(id);
    const BuiltIn* const built_in = FindBuiltIn(id);
    described.runs_one_child = built_in && RunsOneChild(built_in->type);
    described.parent = parent == kNoNode ? node : parent;
    described.element = index;
    described.path = is_subtree ? std::string(document_.AttributeValue(element, "_fullpath"))
                                : PathOf(element, id, instance, uid);
    path_bytes_ += described.path.size();
    tree_.description.nodes.push_back(described);
    if (is_subtree) {
      Enter(described.path, node, element);
    } else {
      AddChildren(element, instance, node);
    }
    --depth_;
  }

  // Each instance hangs on one node, so this ends.
  void Enter(const std::string& path, NodeIndex node, const Element& element) {
    const auto at = instances_.find(path);
    if (path.empty() || at == instances_.end()) {
      return Complain(element, "the robot sent no tree for the SubTree \"" + path + "\"");
    }
    const Element& tree = document_.element(at->second);
    instances_.erase(at);
    tree_.boards.push_back(path);
    AddChildren(tree, path, node);
  }

  bool ReadUid(const Element& element, std::uint16_t& uid) {
    const std::string_view text = document_.AttributeValue(element, "_uid");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), uid);
    if (error == std::errc() && end == text.data() + text.size() && tree_.nodes.count(uid) == 0) {
      return true;
    }
    Complain(element, "a node needs a _uid of its own, not \"" + std::string(text) + "\"");
    return false;
  }

  std::string PathOf(const Element& element, const std::string& id, const std::string& instance,
                     std::uint16_t uid) const {
    std::string own(document_.AttributeValue(element, "name"));
    if (own.empty() || own == id) own = id + "::" + std::to_string(uid);
    return instance.empty() ? own : instance + "/" + own;
  }

  NodeCategory CategoryOf(const std::string& id) const {
    const auto at = categories_.find(id);
    if (at != categories_.end()) return at->second;
    const BuiltIn* const built_in = FindBuiltIn(id);
    return built_in ? built_in->manifest.category : NodeCategory::kAction;
  }

  void Complain(const Element& element, std::string message) {
    diagnostics_.Error(document_.Location(element.offset), std::move(message));
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  ElementIndex main_ = kNoElement;
  std::map<std::string, ElementIndex, std::less<>> instances_;  // that no node has taken yet
  std::map<std::string, NodeCategory, std::less<>> categories_;
  RobotTree tree_;
  std::size_t path_bytes_ = 0;
  int depth_ = 0;
};

}  // namespace

NodeIndex RobotTree::Find(std::uint16_t uid) const {
  const auto at = nodes.find(uid);
  return at == nodes.end() ? kNoNode : at->second;
}

RobotTree ReadRobotTree(std::string xml, const std::string& file, Diagnostics& diagnostics) {
  const std::optional<Document> document = Document::FromText(xml, file, diagnostics);
  if (!document) return {};
  RobotTree tree = Reader(*document, diagnostics).Read();
  tree.description.writer = kGroot2Writer;
  tree.description.documents.push_back({file, std::move(xml)});
  return tree;
}

}  // namespace coppice
