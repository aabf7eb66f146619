#include "bt_core/analysis/why/walk.h"

#include <algorithm>
#include <map>
#include <optional>

namespace coppice {
namespace {

// Makes preorder from the order of completion.
class Builder {
 public:
  Builder(const TreeShape& shape, Walk& walk, const std::vector<Status>* before)
      : shape_(shape), walk_(walk) {
    if (before) statuses_.emplace(shape, *before);
  }

  void Add(const Event& event) {
    const auto number = static_cast<std::uint32_t>(walk_.events.size());
    walk_.events.push_back(event);
    if (event.code == EventCode::kText && event.text == EventText::kInjected) {
      injected_ = event.node();
    }
    if (!event.is_status() || event.index >= shape_.size() || ChangesNothing(event)) return;
    if (statuses_) statuses_->Apply(event);
    Complete(event.node(), event.status(), number);
    entry_ = number + 1;
    if (event.is_result()) injected_ = kNoNode;
  }

  void Finish() {
    walk_.steps.reserve(done_.size());
    for (const std::uint32_t top : open_) Emit(top, kNoStep);
  }

 private:
  struct Done {
    NodeIndex node;
    Status result;
    std::uint32_t entry;
    std::uint32_t event;
    bool is_injected;
    std::vector<std::uint32_t> children;
  };

  bool ChangesNothing(const Event& event) const {
    return statuses_ && !event.is_result() && statuses_->status(event.node()) == Status::kIdle;
  }

  // What was completed below the node and has no parent yet is its own.
  void Complete(NodeIndex node, Status result, std::uint32_t event) {
    const bool is_injected = injected_ == node;
    if (is_injected && !open_.empty() && done_[open_.back()].node == node) {
      Replace(done_[open_.back()], result, event);
      return;
    }
    std::size_t first = open_.size();
    while (first > 0 && IsBelow(done_[open_[first - 1]].node, node)) --first;
    const std::uint32_t entry = first < open_.size() ? done_[open_[first]].entry : entry_;
    const auto children = open_.begin() + Offset(first);
    Done done{node, result, entry, event, is_injected, {children, open_.end()}};
    open_.resize(first);
    open_.push_back(static_cast<std::uint32_t>(done_.size()));
    done_.push_back(std::move(done));
  }

  // It was ticked, and then somebody decided otherwise. If it was halted for that, the reset is the
  // last that is known of it.
  static void Replace(Done& done, Status result, std::uint32_t event) {
    done.result = result;
    done.event = event;
    done.is_injected = true;
  }

  bool IsBelow(NodeIndex below, NodeIndex node) const {
    return below > node && below < shape_[node].end;
  }

  static std::ptrdiff_t Offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

  void Emit(std::uint32_t number, StepIndex parent) {
    const Done& done = done_[number];
    const auto index = static_cast<StepIndex>(walk_.steps.size());
    walk_.steps.push_back(
        {done.node, done.result, parent, 0, done.entry, done.event, done.is_injected});
    for (const std::uint32_t child : done.children) Emit(child, index);
    walk_.steps[index].end = static_cast<StepIndex>(walk_.steps.size());
  }

  const TreeShape& shape_;
  Walk& walk_;
  std::optional<StatusFollower> statuses_;
  std::vector<Done> done_;           // in order of completion
  std::vector<std::uint32_t> open_;  // of these: those that nobody has taken yet
  std::uint32_t entry_ = 0;          // behind the last result or reset
  NodeIndex injected_ = kNoNode;     // whose next result somebody outside has decided
};

// The steps without resets, in order of completion.
std::vector<StepIndex> InOrderOfCompletion(const Walk& walk) {
  std::vector<StepIndex> order;
  for (StepIndex i = 0; i < walk.steps.size(); ++i) {
    if (walk.steps[i].result != Status::kIdle) order.push_back(i);
  }
  std::sort(order.begin(), order.end(),
            [&](StepIndex a, StepIndex b) { return walk.steps[a].event < walk.steps[b].event; });
  return order;
}

}  // namespace

StepIndex Walk::LastStepOf(NodeIndex node) const {
  StepIndex last = kNoStep;
  for (StepIndex i = 0; i < steps.size(); ++i) {
    const WalkStep& step = steps[i];
    if (step.node != node || step.result == Status::kIdle) continue;
    if (last == kNoStep || step.event > steps[last].event) last = i;
  }
  return last;
}

std::vector<StepIndex> Walk::ChildrenOf(StepIndex step) const {
  std::vector<StepIndex> children;
  for (StepIndex i = step + 1; i < steps[step].end; i = steps[i].end) children.push_back(i);
  return children;
}

StepIndex Walk::Decisive(StepIndex step) const {
  StepIndex last = kNoStep;
  StepIndex same = kNoStep;
  for (const StepIndex child : ChildrenOf(step)) {
    if (steps[child].result == Status::kIdle) continue;
    last = child;
    if (steps[child].result == steps[step].result) same = child;
  }
  return same != kNoStep ? same : last;
}

Walk WalkOf(const TreeShape& shape, EventWords words, const std::vector<Status>* before) {
  Walk walk;
  Builder builder(shape, walk, before);
  EventReader reader(words);
  for (Event event; reader.Next(event);) builder.Add(event);
  builder.Finish();
  return walk;
}

StepIndex FirstDifference(const Walk& walk, const Walk& before) {
  std::map<NodeIndex, std::vector<Status>> results;  // of `before`, in order
  for (const StepIndex step : InOrderOfCompletion(before)) {
    results[before.steps[step].node].push_back(before.steps[step].result);
  }
  std::map<NodeIndex, std::size_t> ticked;
  for (const StepIndex index : InOrderOfCompletion(walk)) {
    const WalkStep& step = walk.steps[index];
    const std::vector<Status>& earlier = results[step.node];
    const std::size_t number = ticked[step.node]++;
    if (number >= earlier.size() || earlier[number] != step.result) return index;
  }
  return kNoStep;
}

}  // namespace coppice
