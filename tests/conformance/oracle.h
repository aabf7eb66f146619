// The semantics of the built-in nodes, written a second time and as plainly as possible: a tree of
// objects that tick their children. It shares no code with the engine. The rules are those of
// docs/semantics.md.
#ifndef COPPICE_TESTS_CONFORMANCE_ORACLE_H_
#define COPPICE_TESTS_CONFORMANCE_ORACLE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"

namespace coppice::conformance {

/// A tree to be tested: what it is made of, apart from how it is run.
struct Shape {
  std::string type;  ///< ID of a built-in node, or "Leaf"
  std::vector<int> ports;
  std::vector<Shape> children;
};

/// The world that a tree of the oracle lives in.
struct World {
  Time now{0};
  Time wake_at = kNever;
  bool tick_again = false;
  std::function<Status(int leaf, bool starting)> tick_leaf;
  std::function<void(int leaf)> halt_leaf;
};

class OracleNode {
 public:
  explicit OracleNode(World& world) : world_(world) {}
  virtual ~OracleNode() = default;

  Status Tick();
  void Halt();

  Status status() const { return status_; }
  std::vector<std::unique_ptr<OracleNode>> children;

 protected:
  virtual Status Run() = 0;
  virtual void Forget() {}  // an activation has ended
  virtual void OnHalt() {}
  void ResetChildren();
  Status End(Status result);  // makes the children idle
  OracleNode& child() { return *children.front(); }

  World& world_;

 private:
  Status status_ = Status::kIdle;
};

/// Builds the tree of a shape. Leaves are numbered in document order from 0.
std::unique_ptr<OracleNode> MakeOracle(const Shape& shape, World& world);

}  // namespace coppice::conformance

#endif  // COPPICE_TESTS_CONFORMANCE_ORACLE_H_
