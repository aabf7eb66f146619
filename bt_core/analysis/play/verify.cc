#include "bt_core/analysis/play/verify.h"

#include <algorithm>
#include <map>

#include "bt_core/analysis/play/played_nodes.h"
#include "bt_core/frames/follower.h"

namespace coppice {
namespace {

std::vector<Event> EventsIn(EventWords words) {
  std::vector<Event> events;
  EventReader reader(words);
  for (Event event; reader.Next(event);) events.push_back(event);
  return events;
}

// Where the root does not run, no node remembers anything. (SKIPPED would keep something.)
bool RemembersNothing(const std::vector<Status>& statuses) {
  return statuses[0] == Status::kIdle || IsCompleted(statuses[0]);
}

// Nodes that stop late (OnDraining): in which entries the record shows that they have stopped. It
// does so at the beginning of a tick, by what the engine says about it or by the reset of a node
// that the tree waits for.
class Drains {
 public:
  explicit Drains(const Recording& run) : run_(run) {
    for (std::size_t i = 0; i < run.ticks().size(); ++i) Look(i);
  }

  /// Whether a node that was halted in entry `at`, and has been followed to its end, stops late.
  bool StopsLate(StoppingNode node, std::size_t at) const {
    const auto found = stops_.find(node.node());
    if (found == stops_.end()) return false;
    for (std::size_t i = at + 1; i <= found->second; ++i) {
      bool is_head = run_.ticks()[i].result != Status::kIdle;
      for (const Event& event : EventsIn(run_.EventsOf(i).words)) {
        is_head &= IsHead(event, i);
        const bool is_stop =
            is_head && event.code != EventCode::kDelivery && event.index == node.node();
        if (is_stop && (node.is_waited_for() || IsAboutStopping(event))) return true;
        if (!node.Follow(event)) return false;
      }
    }
    return false;
  }

 private:
  // Of what stands before everything else in a tick.
  bool IsHead(const Event& event, std::size_t entry) const {
    if (event.code == EventCode::kDelivery) return true;
    if (event.code != EventCode::kReset && !IsAboutStopping(event)) return false;
    const TreeDescription& tree = run_.trees()[run_.TreeOf(entry)];
    return tree.nodes[event.index].category == NodeCategory::kAction;
  }

  void Look(std::size_t entry) {
    if (run_.ticks()[entry].result == Status::kIdle) return;
    for (const Event& event : EventsIn(run_.EventsOf(entry).words)) {
      if (!IsHead(event, entry)) return;
      if (event.code != EventCode::kDelivery) stops_[event.node()] = entry;
    }
  }

  const Recording& run_;
  std::map<NodeIndex, std::size_t> stops_;  // the last entry for each node
};

// Ends of ticks without a result of the root: an exception has ended them.
bool HasAbortedTicks(const Recording& run) {
  for (std::size_t i = 0; i < run.ticks().size(); ++i) {
    const TickEvents events = run.EventsOf(i);
    if (events.result != Status::kFailure || !events.is_whole) continue;
    bool has_root = false;
    for (const Event& event : EventsIn(events.words)) {
      has_root |= event.is_result() && event.index == 0;
    }
    if (!has_root) return true;
  }
  return false;
}

std::vector<NodeIndex> InjectedNodes(const Recording& run) {
  std::vector<NodeIndex> nodes;
  for (std::size_t i = 0; i < run.ticks().size(); ++i) {
    for (const Event& event : EventsIn(run.EventsOf(i).words)) {
      if (event.code != EventCode::kText || event.text != EventText::kInjected) continue;
      if (std::find(nodes.begin(), nodes.end(), event.node()) == nodes.end()) {
        nodes.push_back(event.node());
      }
    }
  }
  return nodes;
}

class Verifier {
 public:
  Verifier(const Recording& run, const RegistryMaker& make_registry, Diagnostics& diagnostics)
      : run_(run),
        make_registry_(make_registry),
        diagnostics_(diagnostics),
        drains_(run),
        injected_(InjectedNodes(run)) {
    if (HasAbortedTicks(run)) options_.on_exception = ExceptionPolicy::kHaltTree;
    prompter_.set_will_drain([this](StoppingNode node) { return drains_.StopsLate(node, at_); });
  }

  Verification Run() {
    trees_.resize(run_.trees().size());
    const std::vector<Recording::Section>& sections = run_.sections();
    for (std::size_t i = 0; i < sections.size() && !prompter_.divergence(); ++i) {
      const bool is_last = i + 1 == sections.size();
      Enter(sections[i]);
      PlaySection(sections[i], is_last ? run_.ticks().size() : sections[i + 1].first_tick,
                  is_last ? nullptr : &sections[i + 1]);
    }
    Stop();
    result_.events = prompter_.events();
    result_.divergence = prompter_.divergence();
    return std::move(result_);
  }

 private:
  const RecordedTree& TreeOf(std::size_t number) {
    std::unique_ptr<RecordedTree>& tree = trees_[number];
    if (!tree) {
      tree = std::make_unique<RecordedTree>(CompileRecorded(
          run_.trees()[number], make_registry_ ? make_registry_() : std::make_shared<Registry>(),
          diagnostics_));
      if (!tree->program) Remark("the tree cannot be compiled again, so it cannot be played");
    }
    return *tree;
  }

  // What the section begins with. A keyframe changes nothing; a swap of the tree is played.
  void Enter(const Recording::Section& section) {
    follower_ =
        std::make_unique<HistoryFollower>(ShapeOf(run_.trees()[section.tree]), section.state);
    if (FollowsOn(section) && executor_) return;
    const bool swaps = section.state.cause == HistoryState::Cause::kJump && executor_ &&
                       section.tree != tree_ && TreeOf(section.tree).program;
    if (swaps) return Swap(section);
    if (executor_) {
      Remark("events are missing or the tree was given another state behind tick " +
             std::to_string(section.state.tick));
    }
    Stop();
    tree_ = section.tree;
  }

  void Swap(const Recording::Section& section) {
    tree_ = section.tree;
    const RecordedTree& tree = TreeOf(tree_);
    executor_->Reload(WithPlayedNodes(*tree.program, prompter_));
    if (!FinishEntry(Status::kIdle)) return;
    prompter_.Begin(tree, section.state.statuses);
    executor_->SetHooks(&prompter_, injected_);
    Remark("the tree was swapped behind tick " + std::to_string(section.state.tick));
  }

  void PlaySection(const Recording::Section& section, std::size_t end,
                   const Recording::Section* next) {
    for (at_ = section.first_tick; at_ < end && !prompter_.divergence(); ++at_) {
      const TickEvents events = run_.EventsOf(at_);
      if (!executor_) Start();
      // What ends with a tree is halted by the swap itself.
      const bool is_swap = next && at_ + 1 == end && events.result == Status::kIdle &&
                           next->state.cause == HistoryState::Cause::kJump &&
                           next->tree != section.tree;
      if (!events.is_whole) LeaveUnfinished(events);
      if (executor_) {
        prompter_.Expect(events);
        is_open_ = true;
        if (!is_swap) Play(events);
      } else {
        ++result_.skipped_ticks;
      }
      follower_->Apply(events);
    }
  }

  // Nobody knows what came behind the breakpoint.
  void LeaveUnfinished(const TickEvents& events) {
    Remark("tick " + std::to_string(events.tick) + " stands at a breakpoint to its end");
    Stop();
  }

  // Only a tree that does not run is known whole.
  void Start() {
    const RecordedTree& tree = TreeOf(tree_);
    if (!tree.program || !RemembersNothing(follower_->statuses())) return;
    if (at_ > 0) Remark("begins at tick " + std::to_string(run_.ticks()[at_].number));
    prompter_.Begin(tree, {});
    clock_.Advance(follower_->time() - clock_.Now());
    executor_ =
        std::make_unique<Executor>(WithPlayedNodes(*tree.program, prompter_), clock_, options_);
    SetValues(tree);
    executor_->AddSink(&prompter_);
    executor_->SetHooks(&prompter_, injected_);
    prompter_.set_executor(executor_.get());
  }

  void SetValues(const RecordedTree& tree) {
    TreeState state = executor_->Save();
    std::string bytes;
    for (SlotIndex i{0}; i < state.blackboard.size(); ++i) {
      if (tree.recorded_slots[i] == kNoSlot) continue;
      Event event;
      event.index = i;
      event.bytes = follower_->values()[tree.recorded_slots[i]];
      state.blackboard[i].value = prompter_.ValueOf(event);
    }
    executor_->Restore(state);
  }

  void Play(const TickEvents& events) {
    clock_.Advance(events.start - clock_.Now());
    StopInjecting();
    Deliver();
    Status result = Status::kIdle;
    if (events.result != Status::kIdle) {
      result = executor_->Tick();
    } else {
      executor_->ServeDrains();
      executor_->Halt();
    }
    if (FinishEntry(result)) ++result_.ticks;
  }

  // A node whose injected RUNNING was taken back between two ticks is idle before the tick.
  void StopInjecting() {
    std::vector<NodeIndex> left = injected_;
    for (const Event* event = prompter_.begin(); event != prompter_.end(); ++event) {
      if (event->code != EventCode::kReset || !prompter_.IsPretending(event->node())) break;
      if (prompter_.InjectedNext(event->node())) break;  // is halted for that
      left.erase(std::find(left.begin(), left.end(), event->node()));
    }
    if (left.size() == injected_.size()) return;
    executor_->SetHooks(&prompter_, left);
    executor_->SetHooks(&prompter_, injected_);
  }

  void Deliver() {
    for (const Event* event = prompter_.begin(); event != prompter_.end(); ++event) {
      if (event->code != EventCode::kDelivery) continue;
      executor_->inbox()->Post(event->slot(), 0, prompter_.ValueOf(*event));
    }
  }

  bool FinishEntry(Status result) {
    if (is_open_) prompter_.Finish(result);
    is_open_ = false;
    return !prompter_.divergence();
  }

  void Stop() {
    if (!executor_) return;
    executor_->RemoveSink(&prompter_);
    executor_.reset();
  }

  void Remark(std::string text) { result_.remarks.push_back(std::move(text)); }

  const Recording& run_;
  const RegistryMaker& make_registry_;
  Diagnostics& diagnostics_;
  Drains drains_;
  const std::vector<NodeIndex> injected_;
  ExecutorOptions options_;
  SimulatedClock clock_;
  Prompter prompter_;
  std::vector<std::unique_ptr<RecordedTree>> trees_;
  std::unique_ptr<Executor> executor_;
  std::unique_ptr<HistoryFollower> follower_;
  std::size_t tree_ = 0;
  std::size_t at_ = 0;
  bool is_open_ = false;  // the prompter expects something
  Verification result_;
};

}  // namespace

Verification Verify(const Recording& run, const RegistryMaker& make_registry,
                    Diagnostics& diagnostics) {
  return Verifier(run, make_registry, diagnostics).Run();
}

}  // namespace coppice
