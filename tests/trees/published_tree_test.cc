// The monitoring tree is the figure "Structure of the monitoring framework" of Stuede et al.,
// "Sobi", ECMR 2021, as it is printed.
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "bt_core/engine/registry.h"
#include "bt_core/model/document.h"
#include "tests/bt_nodes/fakes.h"
#include "tests/support/folders.h"

namespace coppice {
namespace {

// A node of the figure, or one of the file: its kind is read off the node.
struct Node {
  int depth;
  std::string kind;
  std::string name;

  bool operator==(const Node& other) const {
    return depth == other.depth && kind == other.kind && name == other.name;
  }
};
void PrintTo(const Node& node, std::ostream* stream) {
  *stream << std::string(2 * node.depth, ' ') << node.kind << " " << node.name << "\n";
}

struct Printed {
  int depth;
  const char* kind;
  const char* label;  // as it is printed; empty where the figure has a symbol alone
  const char* name;   // ours
};

// From the top, left to right. The symbols have no names of their own.
constexpr Printed kFigure[] = {
    {0, "Sequence", "", "errors"},
    {1, "SubTree", "Check & Set Configuration", "check_and_set_configuration"},
    {1, "SubTree", "Process Monitors", "process_monitors"},
    {1, "Fallback", "", "handle_errors"},
    {2, "Sequence", "", "node_or_topic"},
    {3, "Fallback", "", "node_or_topic_error"},
    {4, "Condition", "Node error", "node_error"},
    {4, "Condition", "Topic error", "topic_error"},
    {3, "SubTree", "Restart Node", "restart_node"},
    {2, "Sequence", "", "navigation"},
    {3, "Condition", "Nav. error", "navigation_error"},
    {3, "SubTree", "Recover Navigation", "recover_navigation"},
    {2, "Sequence", "", "localization"},
    {3, "Condition", "Loc. error", "localization_error"},
    {3, "SubTree", "Recover Localization", "recover_localization"},
    {2, "SubTree", "...", "added_errors"},
};

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The symbols of the figure have no memory or need none: Reactive and plain are one kind.
std::string KindOf(const std::string& id, const Registry& registry) {
  if (EndsWith(id, "Sequence")) return "Sequence";
  if (EndsWith(id, "Fallback")) return "Fallback";
  if (id == "SubTree") return "SubTree";
  const Registry::Entry* const entry = registry.Find(id);
  const bool is_condition = entry && entry->manifest.category == NodeCategory::kCondition;
  return is_condition ? "Condition" : id;
}

class PublishedTree : public testing::Test {
 protected:
  PublishedTree() {
    leaves::RegisterNodes(registry_, robot_.capabilities());
    Diagnostics diagnostics;
    document_ = Document::FromFile(SourceFolder() + "/trees/monitor/monitor.xml", diagnostics);
  }

  // The nodes of one tree, from the top, left to right.
  std::vector<Node> NodesOf(const std::string& tree) {
    std::vector<Node> nodes;
    for (const Element& element : document_->elements()) {
      const bool is_it = element.tag == "BehaviorTree" && Value(element, "ID") == tree;
      if (is_it) Add(element, -1, nodes);
    }
    return nodes;
  }

  std::string Value(const Element& element, const char* attribute) const {
    return std::string(document_->AttributeValue(element, attribute));
  }

  std::optional<Document> document_;

 private:
  void Add(const Element& parent, int depth, std::vector<Node>& nodes) {
    if (depth >= 0) {
      nodes.push_back({depth, KindOf(std::string(parent.tag), registry_), Value(parent, "name")});
    }
    for (ElementIndex child = parent.first_child; child != kNoElement;
         child = document_->element(child).next_sibling) {
      Add(document_->element(child), depth + 1, nodes);
    }
  }

  leaves::FakeRobot robot_;
  Registry registry_;
};

TEST_F(PublishedTree, IsTheFigureNodeByNode) {
  ASSERT_TRUE(document_);
  std::vector<Node> figure;
  for (const Printed& node : kFigure) figure.push_back({node.depth, node.kind, node.name});
  EXPECT_EQ(NodesOf("MonitoringFramework"), figure);
}

// What the figure does not print stands in trees that say so, and none of them is in front of it.
TEST_F(PublishedTree, ComesFirstAndIsFollowedByWhatWasAdded) {
  ASSERT_TRUE(document_);
  EXPECT_EQ(NodesOf("Monitor"), (std::vector<Node>{{0, "Sequence", "monitor"},
                                                   {1, "ForceSuccess", "never_fails"},
                                                   {2, "SubTree", "as_published"},
                                                   {1, "SubTree", "added_besides"}}));
}

}  // namespace
}  // namespace coppice
