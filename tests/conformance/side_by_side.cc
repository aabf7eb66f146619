#include "tests/conformance/side_by_side.h"

#include <stdexcept>
#include <utility>

#include "bt_core/engine/program.h"

namespace coppice::conformance {
namespace {

// Kinds of log entries.
enum : std::int64_t {
  kStart = 1000,
  kTicked = 2000,
  kHalted = 3000,
  kResult = 4000,
  kNode = 5000,
  kHook = 6000
};

void AppendXml(const Shape& shape, int& leaf, int& tree, std::string& xml, std::string& trees) {
  xml += "<" + shape.type;
  for (const auto& [name, text] : shape.attributes) xml += " " + name + "=\"" + text + "\"";
  if (shape.type == "Leaf") {
    xml += " name=\"" + std::to_string(leaf++) + "\"/>";
    return;
  }
  if (shape.type == "SubTree") {
    const std::string id = "T" + std::to_string(tree++);
    xml += " ID=\"" + id + "\"/>";
    std::string body;
    AppendXml(shape.children.front(), leaf, tree, body, trees);
    trees += "<BehaviorTree ID=\"" + id + "\">" + body + "</BehaviorTree>\n";
    return;
  }
  xml += ">";
  for (const Shape& child : shape.children) AppendXml(child, leaf, tree, xml, trees);
  xml += "</" + shape.type + ">";
}

void Flatten(OracleNode& node, std::vector<OracleNode*>& nodes) {
  nodes.push_back(&node);
  for (const auto& child : node.children) Flatten(*child, nodes);
}

}  // namespace

std::string ToXml(const Shape& shape) {
  int leaf = 0;
  int tree = 0;
  std::string body;
  std::string trees;
  AppendXml(shape, leaf, tree, body, trees);
  return "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n<BehaviorTree ID=\"Main\">" +
         body + "</BehaviorTree>\n" + trees + "</root>\n";
}

class SideBySide::ScriptedLeaf : public Leaf {
 public:
  ScriptedLeaf(SideBySide& owner, int number) : owner_(owner), number_(number) {}
  Status Tick(bool starting) override {
    owner_.actual_.push_back((starting ? kStart : kTicked) + number_);
    if (owner_.next_choice_ == owner_.choices_.size())
      return Status::kFailure;  // one tick too many
    const int choice = owner_.choices_[owner_.next_choice_++];
    if (choice == kThrow) throw std::runtime_error("on purpose");
    return static_cast<Status>(choice);
  }
  void Halt() override { owner_.actual_.push_back(kHalted + number_); }

 private:
  SideBySide& owner_;
  int number_;
};

SideBySide::SideBySide(const Shape& shape, std::function<int()> choose)
    : shape_(shape), xml_(ToXml(shape)), choose_(std::move(choose)) {
  world_.tick_leaf = [this](int leaf, bool starting) {
    expected_.push_back((starting ? kStart : kTicked) + leaf);
    choices_.push_back(choose_());
    return choices_.back() == kThrow ? Status::kFailure : static_cast<Status>(choices_.back());
  };
  world_.halt_leaf = [this](int leaf) { expected_.push_back(kHalted + leaf); };
  oracle_ = MakeOracle(shape_, world_);
  Flatten(*oracle_, oracle_nodes_);

  auto registry = std::make_shared<Registry>();
  registry->SetFallback([this](const std::string& name) {
    return std::make_unique<ScriptedLeaf>(*this, std::stoi(name));
  });
  Diagnostics diagnostics;
  auto project = Project::FromText(xml_, "shape.xml", diagnostics);
  if (!project) throw std::logic_error(diagnostics.ToString() + xml_);
  const auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  if (!program) throw std::logic_error(diagnostics.ToString() + xml_);
  executor_ = std::make_unique<Executor>(program, clock_);
}

SideBySide::~SideBySide() = default;

void SideBySide::Listen() {
  watcher_.follower.emplace(ShapeOf(executor_->program()), executor_->statuses());
  watcher_.noted = watcher_.follower;
  executor_->AddSink(&watcher_);
}

void SideBySide::Tick() {
  ++world_.tick;
  world_.wake_at = kNever;
  world_.tick_again = false;
  choices_.clear();
  next_choice_ = 0;
  expected_.push_back(kResult + static_cast<int>(oracle_->Tick()));
  actual_.push_back(kResult + static_cast<int>(executor_->Tick()));
  LogStatuses();
  expected_.push_back(world_.tick_again ? 0 : world_.wake_at.time_since_epoch().count());
  actual_.push_back(executor_->next_tick().time_since_epoch().count());
}

void SideBySide::Halt() {
  // From the root, and then whatever its node has left behind.
  for (OracleNode* node : oracle_nodes_) node->Halt();
  executor_->Halt();
  LogStatuses();
}

void SideBySide::LogStatuses() {
  for (const OracleNode* node : oracle_nodes_) {
    expected_.push_back(kNode + static_cast<int>(node->status()));
  }
  const auto& watcher = watcher_.follower;
  for (const Status status : watcher ? watcher->statuses() : executor_->statuses()) {
    actual_.push_back(kNode + static_cast<int>(status));
  }
  if (watcher) {
    StatusFollower noted = *watcher_.noted;  // which itself goes on unsettled
    noted.Settle();
    if (noted.statuses() != watcher->statuses()) actual_.push_back(kNode);
  }
  LogHooks();
}

void SideBySide::LogHooks() {
  const auto append = [](Log& log, std::size_t& done, const std::string& hooks) {
    for (; done < hooks.size(); ++done) log.push_back(kHook + hooks[done]);
  };
  const SlotIndex slot = executor_->program().layout.Find(kMainScope, "hooks");
  if (slot == kNoSlot) return;
  append(expected_, expected_hooks_, world_.Read("{@hooks}").value_or(""));
  const Value& value = executor_->blackboard()[slot].value;
  append(actual_, actual_hooks_, value.has_value() ? value.Get<std::string>() : "");
}

void SideBySide::Advance(Duration duration) {
  world_.now += duration;
  clock_.Advance(duration);
}

std::string SideBySide::Difference() {
  const bool same = expected_ == actual_;
  const std::string text =
      same ? "" : xml_ + "expected " + Print(expected_) + "\nactual   " + Print(actual_);
  expected_.clear();
  actual_.clear();
  return text;
}

std::string SideBySide::Print(const Log& log) const {
  std::string text;
  for (const std::int64_t entry : log) {
    const std::int64_t kind = entry / 1000 * 1000;
    const std::string number = std::to_string(entry - kind);
    const char* status = ToString(static_cast<Status>(entry - kind));
    if (kind == kStart) text += " start " + number;
    if (kind == kTicked) text += " tick " + number;
    if (kind == kHalted) text += " halt " + number;
    if (kind == kResult) text += std::string(" -> ") + status + ";";
    if (kind == kNode) text += std::string(" ") + status[0] + status[1];
    if (kind == kHook) text += std::string(" hook ") + static_cast<char>(entry - kind);
    if (kind < kStart || kind > kHook) text += " next " + std::to_string(entry) + " |";
  }
  return text;
}

}  // namespace coppice::conformance
