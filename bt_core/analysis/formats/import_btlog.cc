#include "bt_core/analysis/formats/import_btlog.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>

#include "bt_core/analysis/formats/btlog.h"
#include "bt_core/model/document.h"
#include "bt_core/nodes/node_type.h"

namespace coppice {
namespace {

constexpr std::int64_t kSameTick = 1000;  // [us]
constexpr std::size_t kMaxDepth = 1000;

bool RunsOneChild(std::string_view id) {
  for (const BuiltIn& node : BuiltIns()) {
    if (node.manifest.id == id) return coppice::RunsOneChild(node.type);
  }
  return false;
}

// The nodes of the tree in preorder, and their numbers in it by _uid.
class TreeReader {
 public:
  TreeReader(const Document& document, TreeDescription& tree) : document_(document), tree_(tree) {}

  /// What is wrong with the tree, or nothing.
  std::string Read() {
    const Element& root = document_.element(kRootElement);
    ElementIndex main = kNoElement;
    tree_.main_tree = Value(root, "main_tree_to_execute");
    for (ElementIndex i = root.first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      const Element& element = document_.element(i);
      if (element.tag != "BehaviorTree") continue;
      const std::string path = Value(element, "_fullpath");
      instances_.emplace(path, i);
      const bool is_main = tree_.main_tree.empty() || Value(element, "ID") == tree_.main_tree;
      if (main == kNoElement && path.empty() && is_main) main = i;
    }
    if (main == kNoElement) return "has no main tree";
    tree_.main_tree = Value(document_.element(main), "ID");
    AddNode(document_.element(main).first_child, kRootNode, "", 0);
    return problem_;
  }

  const std::map<std::uint16_t, NodeIndex>& numbers() const { return numbers_; }

 private:
  std::string Value(const Element& element, std::string_view name) const {
    return std::string(document_.AttributeValue(element, name));
  }

  void AddNode(ElementIndex index, NodeIndex parent, const std::string& instance,
               std::size_t depth) {
    if (index == kNoElement || depth > kMaxDepth) {
      problem_ = index == kNoElement ? "has an empty tree" : "is too deep";
      return;
    }
    const Element& element = document_.element(index);
    const auto number = static_cast<NodeIndex>(tree_.nodes.size());
    const std::string uid = Value(element, "_uid");
    const long value = std::strtol(uid.c_str(), nullptr, 10);
    if (value <= 0 || value > UINT16_MAX) {
      problem_ = "has a node without _uid: <" + std::string(element.tag) + ">";
      return;
    }
    if (!numbers_.emplace(static_cast<std::uint16_t>(value), number).second) {
      problem_ = "has two nodes with _uid " + uid;
      return;
    }
    tree_.nodes.push_back(Describe(element, index, parent, instance, uid));
    if (tree_.nodes.back().category == NodeCategory::kSubTree) {
      const std::string path = Value(element, "_fullpath");
      const auto found = instances_.find(path);
      if (path.empty() || found == instances_.end()) return;
      AddNode(document_.element(found->second).first_child, number, path, depth + 1);
      return;
    }
    for (ElementIndex child = element.first_child; child != kNoElement && problem_.empty();
         child = document_.element(child).next_sibling) {
      AddNode(child, number, instance, depth + 1);
    }
  }

  DescribedNode Describe(const Element& element, ElementIndex index, NodeIndex parent,
                         const std::string& instance, const std::string& uid) const {
    DescribedNode node;
    const std::optional<NodeCategory> explicit_form = CategoryFromTag(element.tag);
    node.id = explicit_form ? Value(element, "ID") : std::string(element.tag);
    node.category = explicit_form.value_or(CategoryOf(element));
    node.runs_one_child = RunsOneChild(node.id);
    node.parent = parent;
    node.element = index;
    const std::string name = Value(element, "name");
    node.path = name.empty() ? node.id + "::" + uid : name;
    if (!instance.empty()) node.path = instance + "/" + node.path;
    if (node.category == NodeCategory::kSubTree && !Value(element, "_fullpath").empty()) {
      node.path = Value(element, "_fullpath");
    }
    return node;
  }

  static NodeCategory CategoryOf(const Element& element) {
    if (element.child_count == 0) return NodeCategory::kAction;
    return element.child_count == 1 ? NodeCategory::kDecorator : NodeCategory::kControl;
  }

  const Document& document_;
  TreeDescription& tree_;
  std::map<std::string, ElementIndex> instances_;  // by _fullpath
  std::map<std::uint16_t, NodeIndex> numbers_;
  std::string problem_;
};

// Of transitions that belong together, the words.
class TickMaker {
 public:
  TickMaker(const std::map<std::uint16_t, NodeIndex>& numbers, Recording& run)
      : numbers_(numbers), run_(run) {}

  /// False if there is no such node.
  bool Add(const BtlogTransition& transition) {
    const auto node = numbers_.find(transition.uid);
    if (node == numbers_.end()) return false;
    if (!words_.empty() && transition.time - last_ > kSameTick) Finish();
    if (words_.empty()) first_ = transition.time;
    last_ = transition.time;
    if (node->second == 0 && transition.status != Status::kIdle) root_ = transition.status;
    if (transition.status == Status::kIdle) {
      words_.Reset(node->second);
    } else {
      words_.Status(node->second, transition.status);
    }
    return true;
  }

  void Finish() {
    if (words_.empty()) return;
    const std::int64_t duration = std::max<std::int64_t>(last_ - first_, 0);  // a clock set back
    run_.OnTick({++tick_, TimeFromNanoseconds(first_ * 1000), Duration(duration * 1000), root_,
                 true, words_.words()});
    words_.Clear();
  }

  std::uint64_t ticks() const { return tick_; }
  Time last() const { return TimeFromNanoseconds(last_ * 1000); }

 private:
  const std::map<std::uint16_t, NodeIndex>& numbers_;
  Recording& run_;
  EventWriter words_;
  std::uint64_t tick_ = 0;
  std::int64_t first_ = 0;  // [us]
  std::int64_t last_ = 0;
  Status root_ = Status::kRunning;
};

}  // namespace

std::optional<Recording> FromBtlog(const std::string& bytes, const std::string& file,
                                   Diagnostics& diagnostics) {
  const std::optional<Btlog> log = ReadBtlog(bytes, file, diagnostics);
  if (!log) return std::nullopt;
  const std::optional<Document> document = Document::FromText(log->xml, file, diagnostics);
  if (!document) return std::nullopt;
  TreeDescription tree;
  tree.writer = "BehaviorTree.CPP FileLogger2";
  tree.documents.push_back({file + ".xml", log->xml});
  tree.models = log->xml;
  tree.info.run = MakeRunId();
  tree.info.clock = "wall";
  tree.info.metadata.emplace_back(kChangesOnly);
  const Duration start(log->transitions.empty() ? 0 : log->transitions.front().time * 1000);
  tree.info.start = Time(start);
  tree.info.wall_start = WallTime(start);
  TreeReader reader(*document, tree);
  const std::string problem = reader.Read();
  if (!problem.empty()) {
    diagnostics.Error({file}, "the tree in it " + problem);
    return std::nullopt;
  }
  Recording run;
  run.OnTree(tree);
  HistoryState state;
  state.time = tree.info.start;
  state.statuses.assign(tree.nodes.size(), Status::kIdle);
  state.last = state.statuses;
  run.OnState(state);
  TickMaker ticks(reader.numbers(), run);
  for (const BtlogTransition& transition : log->transitions) {
    if (ticks.Add(transition)) continue;
    diagnostics.Error({file}, "has a transition of uid " + std::to_string(transition.uid) +
                                  ", which is not in its tree");
    return std::nullopt;
  }
  ticks.Finish();
  run.OnEnd({HistoryEnd::Cause::kClosed, ticks.last(), ticks.ticks()});
  return run;
}

}  // namespace coppice
