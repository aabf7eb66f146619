// The control nodes of the oracle.
#include <algorithm>
#include <map>
#include <optional>

#include "tests/conformance/oracle.h"

namespace coppice::conformance {
namespace {

constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSkipped = Status::kSkipped;

Status Opposite(Status result) { return result == kSuccess ? kFailure : kSuccess; }

// Sequence: ends at the first FAILURE. Fallback: ends at the first SUCCESS. Those that are async
// stop after a child that took one tick to give the other result.
class WithMemory : public OracleNode {
 public:
  WithMemory(World& world, const Shape& shape, Status ends_at, bool yields)
      : OracleNode(world, shape), ends_at_(ends_at), yields_(yields) {}

 private:
  Status Run() override {
    while (index_ < count()) {
      OracleNode& current = *children[static_cast<std::size_t>(index_)];
      const bool took_longer = current.status() == kRunning;
      const Status result = current.Tick();
      if (result == kRunning) return result;
      if (result == ends_at_) return End(result);
      if (result == kSkipped) ++skipped_;
      ++index_;
      if (yields_ && result != kSkipped && !took_longer && index_ < count()) {
        world_.tick_again = true;
        return kRunning;
      }
    }
    return End(skipped_ == count() ? kSkipped : Opposite(ends_at_));
  }
  void Forget() override { index_ = skipped_ = 0; }

  const Status ends_at_;
  const bool yields_;
  int index_ = 0;
  int skipped_ = 0;
};

// Steele, Lea, Flood 2014: the output function of SplitMix64, and the next state before it.
std::uint64_t NextOfSplitMix(std::uint64_t state) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
  std::uint64_t z = state + kGolden;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// RandomSequence, RandomSelector: as Sequence and Fallback, over children that are sorted anew for
// each activation.
class Shuffled : public OracleNode {
 public:
  Shuffled(World& world, const Shape& shape, Status ends_at)
      : OracleNode(world, shape), ends_at_(ends_at) {}

 private:
  Status Run() override {
    if (to_do_.empty()) Shuffle();
    while (!to_do_.empty()) {
      const Status result = to_do_.front()->Tick();
      if (result == kRunning) return result;
      if (result == ends_at_) return End(result);
      if (result == kSkipped) ++skipped_;
      to_do_.erase(to_do_.begin());
    }
    return End(skipped_ == count() ? kSkipped : Opposite(ends_at_));
  }
  void Shuffle() {
    ++activations_;
    const auto seed = static_cast<std::uint64_t>(shape_.Number("seed", 0));
    const std::uint64_t key = NextOfSplitMix(NextOfSplitMix(seed) + activations_);
    std::map<std::uint64_t, OracleNode*> by_hash;
    for (std::uint64_t k = 0; k < children.size(); ++k) {
      by_hash[NextOfSplitMix(key + k)] = children[k].get();
    }
    for (const auto& [hash, one] : by_hash) to_do_.push_back(one);
  }
  void Forget() override {
    to_do_.clear();
    skipped_ = 0;
  }

  const Status ends_at_;
  std::uint64_t activations_ = 0;
  std::vector<OracleNode*> to_do_;
  int skipped_ = 0;
};

// SequenceWithMemory: what is behind a success or a skip stays behind.
class KeepsPlace : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    if (!was_running()) began_at_ = place_;
    while (place_ < count()) {
      OracleNode& current = *children[static_cast<std::size_t>(place_)];
      const bool took_longer = current.status() == kRunning;
      const Status result = current.Tick();
      if (result == kRunning) return result;
      if (result == kFailure) return FailInPlace();
      ++place_;
      if (result == kSkipped) {
        ++skipped_;
      } else if (!took_longer && place_ < count()) {
        world_.tick_again = true;
        return kRunning;
      }
    }
    place_ = 0;
    return End(began_at_ == 0 && skipped_ == count() ? kSkipped : kSuccess);
  }
  Status FailInPlace() {
    for (int k = place_; k < count(); ++k) children[static_cast<std::size_t>(k)]->Halt();
    LeaveChildren();
    return kFailure;
  }
  void Forget() override { skipped_ = 0; }

  int place_ = 0;
  int began_at_ = 0;
  int skipped_ = 0;
};

class Reactive : public OracleNode {
 public:
  Reactive(World& world, const Shape& shape, Status ends_at)
      : OracleNode(world, shape), ends_at_(ends_at) {}

 private:
  Status Run() override {
    int skipped = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const Status result = children[i]->Tick();
      if (result == kRunning) {
        for (std::size_t behind = i + 1; behind < children.size(); ++behind) {
          children[behind]->Halt();
        }
        return result;
      }
      if (result == ends_at_) return End(result);
      if (result != kSkipped) continue;
      children[i]->LetGo();
      ++skipped;
    }
    return End(skipped == count() ? kSkipped : Opposite(ends_at_));
  }

  const Status ends_at_;
};

// What the children of a parallel node have done: those that completed are remembered.
class Together : public OracleNode {
 protected:
  using OracleNode::OracleNode;

  Status TickOnce(int k) {
    if (completed_.count(k)) return completed_[k];
    const Status result = children[static_cast<std::size_t>(k)]->Tick();
    if (result == kSuccess || result == kFailure) completed_[k] = result;
    return result;
  }
  int Completed(Status result) const {
    return static_cast<int>(std::count_if(completed_.begin(), completed_.end(),
                                          [&](const auto& one) { return one.second == result; }));
  }
  void Forget() override { completed_.clear(); }

 private:
  std::map<int, Status> completed_;
};

class Parallel : public Together {
  using Together::Together;

  Status Run() override {
    const int success_count = shape_.Number("success_count", -1);
    const int failure_count = shape_.Number("failure_count", 1);
    if (success_count > count() || failure_count > count()) return End(kFailure);
    const auto meaning = [this](int port) { return port < 0 ? count() + 1 + port : port; };
    const int needed = std::max(0, meaning(success_count));
    const int fatal = std::max(0, meaning(failure_count));
    int skipped = 0;
    bool runs = false;
    for (int k = 0; k < count(); ++k) {
      const Status result = TickOnce(k);
      if (result == kSkipped) ++skipped;
      if (result == kRunning) runs = true;
      const int good = Completed(kSuccess) + (success_count < 0 ? skipped : 0);
      if (good >= needed) return End(kSuccess);
      if (Completed(kFailure) == fatal) return End(kFailure);
      if (count() - Completed(kFailure) < needed) return End(kFailure);
    }
    if (runs) return kRunning;
    if (skipped == count()) return PassOn(kSkipped);
    return End(Completed(kFailure) == 0 ? kSuccess : kFailure);
  }
};

class ParallelAll : public Together {
  using Together::Together;

  Status Run() override {
    int fatal = shape_.Number("max_failures", 1);
    if (fatal > count()) return End(kFailure);
    if (fatal < 0) fatal = std::max(0, count() + 1 + fatal);
    std::vector<Status> results;
    for (int k = 0; k < count(); ++k) results.push_back(TickOnce(k));
    const auto has = [&results](Status status) {
      return std::find(results.begin(), results.end(), status) != results.end();
    };
    if (has(kRunning)) return kRunning;
    if (!has(kSuccess) && !has(kFailure)) return PassOn(kSkipped);
    return End(Completed(kFailure) < fatal ? kSuccess : kFailure);
  }
};

// WorstOf, and NonblockingSequence, which stops at the first FAILURE.
class Worst : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    static const std::vector<Status> order = {kSkipped, kSuccess, kRunning, kFailure};
    auto worst = order.begin();
    for (const auto& one : children) {
      worst = std::max(worst, std::find(order.begin(), order.end(), one->Tick()));
      if (*worst == kFailure && shape_.type == "NonblockingSequence") break;
    }
    return *worst == kRunning ? kRunning : End(*worst);
  }
};

class Pipeline : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    int skipped = 0;
    for (int k = 0; k < count(); ++k) {
      const Status result = children[static_cast<std::size_t>(k)]->Tick();
      if (result == kFailure) return End(result);
      if (result == kSkipped) ++skipped;
      if (result != kRunning || k < furthest_) continue;
      furthest_ = k;
      return result;
    }
    return End(skipped == count() ? kSkipped : kSuccess);
  }
  void Forget() override { furthest_ = 0; }

  int furthest_ = 0;
};

class IfThenElse : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    if (!branch_) {
      const Status condition = children[0]->Tick();
      if (condition == kRunning) return condition;
      if (condition == kSkipped) return End(kSkipped);
      if (condition == kFailure && count() == 2) return End(kFailure);
      branch_ = condition == kSuccess ? 1 : 2;
    }
    const Status result = children[*branch_]->Tick();
    return result == kRunning ? result : End(result);
  }
  void Forget() override { branch_.reset(); }

  std::optional<std::size_t> branch_;
};

class WhileDoElse : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const Status condition = children[0]->Tick();
    if (condition == kRunning) return condition;
    if (condition == kSkipped) return End(kSkipped);
    if (condition == kFailure && count() == 2) return End(kFailure);
    if (count() == 3) children[condition == kSuccess ? 2 : 1]->Halt();
    const Status result = children[condition == kSuccess ? 1 : 2]->Tick();
    return result == kRunning ? result : End(result);
  }
};

class TryCatch : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    while (!catching_ && index_ + 1 < count()) {
      const Status result = children[static_cast<std::size_t>(index_)]->Tick();
      if (result == kRunning) return result;
      if (result == kFailure) {
        ResetChildren();
        catching_ = true;
      }
      if (result == kSkipped) ++skipped_;
      ++index_;
    }
    if (!catching_) return End(skipped_ + 1 == count() ? kSkipped : kSuccess);
    return children.back()->Tick() == kRunning ? kRunning : End(kFailure);
  }
  void OnHalt() override {
    if (!was_running() || catching_) return;
    if (shape_.Text("catch_on_halt", "false") != "true") return;
    for (int k = 0; k + 1 < count(); ++k) children[static_cast<std::size_t>(k)]->Halt();
    children.back()->Tick();
    children.back()->Halt();
  }
  void Forget() override {
    catching_ = false;
    index_ = skipped_ = 0;
  }

  bool catching_ = false;
  int index_ = 0;
  int skipped_ = 0;
};

class Recovery : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    if (!recovering_) {
      const Status result = children[0]->Tick();
      if (result == kRunning) return result;
      if (result != kFailure) return End(result);
      if (retries_ >= shape_.Number("number_of_retries", 1)) return End(kFailure);
      children[0]->Halt();
      recovering_ = true;
    }
    const Status result = children[1]->Tick();
    if (result == kRunning) return result;
    if (result != kSuccess) return End(kFailure);
    children[1]->Halt();
    recovering_ = false;
    ++retries_;
    world_.tick_again = true;
    return kRunning;
  }
  void Forget() override {
    recovering_ = false;
    retries_ = 0;
  }

  bool recovering_ = false;
  int retries_ = 0;
};

class RoundRobin : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const bool wraps = shape_.Text("wrap_around", "false") == "true";
    while (tried_ < count()) {
      const Status result = children[static_cast<std::size_t>(next_)]->Tick();
      if (result == kRunning) return result;
      ++tried_;
      next_ = next_ + 1 == count() ? 0 : next_ + 1;
      if (result == kSuccess) return End(result);
      if (result == kFailure) failed_ = true;
      if (next_ == 0 && !wraps) break;
    }
    next_ = 0;
    return End(failed_ ? kFailure : kSkipped);
  }
  void Forget() override {
    tried_ = 0;
    failed_ = false;
  }
  void OnHalt() override { next_ = 0; }

  int next_ = 0;
  int tried_ = 0;
  bool failed_ = false;
};

}  // namespace

std::unique_ptr<OracleNode> MakeControl(const Shape& shape, World& world) {
  const std::string& type = shape.type;
  const auto memory = [&](Status ends_at, bool yields) {
    return std::make_unique<WithMemory>(world, shape, ends_at, yields);
  };
  if (type == "Sequence") return memory(kFailure, false);
  if (type == "Fallback") return memory(kSuccess, false);
  if (type == "AsyncSequence") return memory(kFailure, true);
  if (type == "AsyncFallback") return memory(kSuccess, true);
  if (type == "SequenceWithMemory") return std::make_unique<KeepsPlace>(world, shape);
  if (type == "RandomSequence") return std::make_unique<Shuffled>(world, shape, kFailure);
  if (type == "RandomSelector") return std::make_unique<Shuffled>(world, shape, kSuccess);
  if (type == "ReactiveSequence") return std::make_unique<Reactive>(world, shape, kFailure);
  if (type == "ReactiveFallback") return std::make_unique<Reactive>(world, shape, kSuccess);
  if (type == "Parallel") return std::make_unique<Parallel>(world, shape);
  if (type == "ParallelAll") return std::make_unique<ParallelAll>(world, shape);
  if (type == "WorstOf" || type == "NonblockingSequence") {
    return std::make_unique<Worst>(world, shape);
  }
  if (type == "PipelineSequence") return std::make_unique<Pipeline>(world, shape);
  if (type == "IfThenElse") return std::make_unique<IfThenElse>(world, shape);
  if (type == "WhileDoElse") return std::make_unique<WhileDoElse>(world, shape);
  if (type == "TryCatch") return std::make_unique<TryCatch>(world, shape);
  if (type == "RecoveryNode") return std::make_unique<Recovery>(world, shape);
  if (type == "RoundRobin") return std::make_unique<RoundRobin>(world, shape);
  return nullptr;
}

}  // namespace coppice::conformance
