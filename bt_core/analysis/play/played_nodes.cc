#include "bt_core/analysis/play/played_nodes.h"

#include <chrono>
#include <deque>
#include <stdexcept>
#include <utility>

#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

// Longer than any run.
constexpr Duration kUntilItHasStopped = std::chrono::hours(24 * 365 * 50);

class PlayedPort final : public PortBase {
 public:
  explicit PlayedPort(const PortDeclaration& declaration) : PortBase(declaration) {}

  SlotIndex index() const { return index_; }
  void Write(Value value) {
    slot_->value = std::move(value);
    slot_->CountWrite(*now_);
  }

 private:
  void OnBound(SlotIndex index, const std::shared_ptr<Inbox>&) override { index_ = index; }

  SlotIndex index_ = kNoSlot;
};

// What leaves and inner nodes have in common.
class Part {
 public:
  Part(const Registry::Entry& original, Prompter& prompter) : prompter_(prompter) {
    for (const PortDeclaration& port : original.declarations) ports_.emplace_back(port);
  }

  Prompter& prompter() const { return prompter_; }

  // Scripts of the node write other slots; the engine runs them.
  void Write(const Event& event) {
    for (PlayedPort& port : ports_) {
      if (port.index() == event.index) return port.Write(prompter_.ValueOf(event));
    }
  }

  /// Performs the writes and messages from `event` on. Returns the event behind them.
  const Event* PlayOwn(LeafHost& host, const Event* event) {
    const NodeIndex node = host.current_node();
    const std::string* thrown = nullptr;
    std::string text;
    for (; event != prompter_.end(); ++event) {
      if (event->code == EventCode::kWrite && event->writer == node) {
        Write(*event);
      } else if (event->code == EventCode::kText && event->index == node) {
        if (event->text == EventText::kInjected) break;
        text = event->bytes;
        if (event->text == EventText::kException) {
          thrown = &text;
          continue;
        }
        host.AddMessage(text);
      } else {
        break;
      }
    }
    if (thrown) throw std::runtime_error(*thrown);
    return event;
  }

  /// True if the node needs time to stop. What stands behind its reset is of its hook.
  bool PlayHalt(LeafHost& host) {
    if (!prompter_.Sync()) return false;
    const NodeIndex node = host.current_node();
    const Event* event = prompter_.begin();
    while (event != prompter_.begin_of_change() && event->index != node) ++event;
    return prompter_.WillDrain(node, PlayOwn(host, event));
  }

  /// Asked at the beginning of a tick: true if what comes next is that the node has stopped.
  bool PlayStopping(LeafHost& host) {
    const NodeIndex node = host.current_node();
    if (!prompter_.Sync() || !prompter_.is_in_tick()) return false;
    if (prompter_.begin() == prompter_.end()) return false;
    const Event& next = *prompter_.begin();
    if (next.index != node) return false;
    if (IsAboutStopping(next)) host.AddMessage(std::string(next.bytes));
    return IsAboutStopping(next) || (next.code == EventCode::kReset && prompter_.IsRunning(node));
  }

 private:
  Prompter& prompter_;
  std::deque<PlayedPort> ports_;
};

class PlayedLeaf final : public Leaf {
 public:
  PlayedLeaf(const Registry::Entry& original, Prompter& prompter) : part_(original, prompter) {}

  Status Tick(bool) override {
    if (!part_.prompter().Sync()) return Status::kFailure;
    const NodeIndex node = host().current_node();
    const Event* event = part_.PlayOwn(host(), part_.prompter().begin_of_change());
    const bool is_own = event != part_.prompter().end() && event->is_result();
    return is_own && event->index == node ? event->status() : Status::kFailure;
  }
  void Halt() override {
    if (part_.PlayHalt(host())) DrainFor(kUntilItHasStopped);
  }
  bool HasStopped() override { return part_.PlayStopping(host()); }

 private:
  Part part_;
};

class PlayedControl final : public UserControl {
 public:
  PlayedControl(const Registry::Entry& original, Prompter& prompter) : part_(original, prompter) {}

  Status Tick(Children& children, bool) override {
    const NodeIndex node = host().current_node();
    while (part_.prompter().Sync()) {
      const Event* event = part_.PlayOwn(host(), part_.prompter().begin_of_change());
      if (event == part_.prompter().end()) break;
      if (event->is_result() && event->index == node) return event->status();
      if (!PlayChild(children, node, event)) break;
    }
    return Status::kFailure;
  }
  void OnHalted() override { part_.PlayHalt(host()); }

 private:
  // Ticks or halts the child whose event that is.
  bool PlayChild(Children& children, NodeIndex node, const Event* event) {
    const TreeShape& shape = part_.prompter().shape();
    const NodeIndex of = event->code == EventCode::kWrite ? event->writer : event->node();
    if (of <= node || of >= shape[node].end) return false;
    std::uint32_t k = 0;
    NodeIndex child = node + 1;
    for (; shape[child].end <= of; child = shape[child].end) ++k;
    const auto is_about_child = [child](const Event& e) {
      return e.index == child && (e.is_status() || IsInjected(e));
    };
    while (event != part_.prompter().end() && !is_about_child(*event)) ++event;
    if (event == part_.prompter().end()) return false;
    if (event->code == EventCode::kReset) {
      children.Halt(k);
    } else {
      children.Tick(k);
    }
    return true;
  }

  Part part_;
};

// A copy in which the nodes of the user have entries of their own.
class PlayedProgram final : public Program {
 public:
  PlayedProgram(const Program& program, Prompter& prompter) : Program(program) {
    for (const LeafRecord& leaf : leaves) {
      const bool is_leaf = nodes[leaf.node].type == NodeType::kLeaf;
      Registry::Entry& entry =
          entries_.emplace_back(info[leaf.node].entry ? *info[leaf.node].entry : Registry::Entry());
      entry.tick = &Registry::TickVirtually;
      entry.build = [&entry, &prompter, is_leaf]() -> std::unique_ptr<UserNode> {
        if (is_leaf) return std::make_unique<PlayedLeaf>(entry, prompter);
        return std::make_unique<PlayedControl>(entry, prompter);
      };
      info[leaf.node].entry = &entry;
    }
  }

 private:
  std::deque<Registry::Entry> entries_;
};

}  // namespace

std::shared_ptr<const Program> WithPlayedNodes(const Program& program, Prompter& prompter) {
  return std::make_shared<const PlayedProgram>(program, prompter);
}

}  // namespace coppice
