// The semantics of the built-in nodes, written a second time and as plainly as possible: a tree of
// objects that tick their children. It shares no code with the engine. The rules are those of
// docs/semantics.md.
#ifndef COPPICE_TESTS_CONFORMANCE_ORACLE_H_
#define COPPICE_TESTS_CONFORMANCE_ORACLE_H_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"

namespace coppice::conformance {

/// A tree to be tested: what it is made of, apart from how it is run.
struct Shape {
  std::string type;  ///< ID of a built-in node, or "Leaf"
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Shape> children;

  /// The text of an attribute; null without it. Asked many times in a tick.
  const std::string* Find(std::string_view name) const {
    for (const auto& [key, text] : attributes) {
      if (key == name) return &text;
    }
    return nullptr;
  }

  /// The same, or else `otherwise`.
  std::string Text(std::string_view name, const char* otherwise) const;
  int Number(std::string_view name, int otherwise) const;
  Status Result(std::string_view name, Status otherwise) const;
};

/// The world that a tree of the oracle lives in.
struct World {
  Time now{};
  std::uint64_t tick = 0;
  Time wake_at = kNever;
  bool tick_again = false;
  std::function<Status(int leaf, bool starting)> tick_leaf;
  std::function<void(int leaf)> halt_leaf;

  std::map<std::string, std::string> blackboard;  // by the text of a port: "{key}"
  std::map<std::string, int> writes;

  void WakeAt(Time time) {
    if (time < wake_at) wake_at = time;
  }

  /// The value of a port with this text, which is a key in braces or the value itself. Nothing for
  /// an empty key.
  std::optional<std::string> Read(const std::string& text) const;

  /// Nothing empties the key. A port without text is left out.
  void Write(const std::string& text, std::optional<std::string> value);
};

class OracleNode {
 public:
  OracleNode(World& world, const Shape& shape) : world_(world), shape_(shape) {}
  virtual ~OracleNode() = default;

  Status Tick();
  void Halt();
  void LetGo();  // as Halt, but what has nothing to halt keeps its status

  /// What a guard or hook of this name would be: scripts are key == number, key != number and
  /// key += 'text'.
  bool Guard(std::string_view name, bool otherwise) const;
  void Hook(std::string_view name);

  Status status() const { return status_; }
  std::vector<std::unique_ptr<OracleNode>> children;

 protected:
  virtual Status Run() = 0;
  virtual void Forget() {}  // an activation has ended
  virtual void OnHalt() {}
  virtual bool RemembersWhenSkipped() const { return false; }  // if it is SKIPPED now
  void ResetChildren();
  void LeaveChildren();          // makes them idle without ending what they have begun
  Status End(Status result);     // makes the children idle
  Status PassOn(Status result);  // the same, but what a skipped child has begun goes on
  OracleNode& child() { return *children.front(); }
  int count() const { return static_cast<int>(children.size()); }
  bool was_running() const { return status_ == Status::kRunning; }
  bool has_begun() const { return has_begun_; }

  World& world_;
  const Shape& shape_;

 private:
  Status AskGuards();  // IDLE: is to be ticked
  Status TickUnguarded();

  Status status_ = Status::kIdle;
  bool has_begun_ = false;  // and was not ended since: SKIPPED does not end it
  bool is_told_ = false;    // a halt would run the hook
};

/// Builds the tree of a shape, which must outlive it. Leaves are numbered in document order from 0.
std::unique_ptr<OracleNode> MakeOracle(const Shape& shape, World& world);

/// The node of a shape, without its children; null if it is not one of the group.
std::unique_ptr<OracleNode> MakeControl(const Shape& shape, World& world);
std::unique_ptr<OracleNode> MakeDecorator(const Shape& shape, World& world);
std::unique_ptr<OracleNode> MakeBlackboardNode(const Shape& shape, World& world);

}  // namespace coppice::conformance

#endif  // COPPICE_TESTS_CONFORMANCE_ORACLE_H_
