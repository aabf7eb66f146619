// Leaves and control nodes in Python: nodes of the user whose work is done by an object of Python.
//
// A PythonLeaf or PythonControl lives in the executor and owns its object, which reaches the node
// by a NodeLink: its ports, its messages, the time, its children. The link outlives the node and
// says then that the tree is gone.
//
// All calls of Python take the GIL, which the ticking thread does not have otherwise. An exception
// of Python becomes a PythonError with the traceback as its text; KeyboardInterrupt and SystemExit,
// which are no errors of the leaf, go to the Interruption of the tick.
#ifndef COPPICE_BT_CORE_PYTHON_LEAF_H_
#define COPPICE_BT_CORE_PYTHON_LEAF_H_

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/registry.h"
#include "bt_core/engine/runner.h"
#include "bt_core/nodes/user_control.h"
#include "bt_core/python/object.h"

namespace coppice::python {

/// What a leaf of Python throws. Its text is the traceback.
struct PythonError : std::runtime_error {
  PythonError(const std::string& traceback, Object error)
      : std::runtime_error(traceback), exception(std::move(error)) {}
  Object exception;
};

/// An input without value was read: coppice.UnsetInput.
struct UnsetPort : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Keeps the exception that ends the program rather than the leaf, while this thread ticks.
class Interruption {
 public:
  /// `runner`: is asked to stop; null: there is none.
  explicit Interruption(Runner* runner);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Behind the ticks: raises what was kept. What was dropped meanwhile (the frames of exceptions)
  /// is let go. With the GIL.
  void Raise() const;

  /// Gives it to that of this thread. With the GIL.
  static void Keep(py::object exception);

 private:
  Interruption* const outer_;
  Runner* const runner_;
  Object exception_;
};

/// What the engine asks of a node, in the order of the methods that it is made with.
enum class Method : std::uint8_t { kStart, kRunning, kHalted, kStopped, kCount };

/// What a class of nodes says of itself, once.
struct NodeClass {
  Manifest manifest;
  Object make;        ///< called with the NodeLink, gives a tuple of methods in their order
  bool is_condition;  ///< its one method returns a bool
};

class PythonPort final : public PortBase {
 public:
  explicit PythonPort(const PortDeclaration& declaration)
      : PortBase(declaration), type_(*declaration.type) {}

  const Type& type() const { return type_; }
  Slot* slot() const { return slot_; }
  void Write(Value value);

 private:
  const Type& type_;
};

class PythonNode;

/// What the object in Python has of its node. Its functions raise RuntimeError where they may not
/// be called: all but NewSender's senders and RequestTick belong into the node's own methods.
class NodeLink {
 public:
  explicit NodeLink(PythonNode* node) : node_(node) {}
  void Cut() { node_ = nullptr; }

  py::object Read(std::size_t port) const;
  bool HasValue(std::size_t port) const;
  /// Counts the writes of the key.
  std::uint32_t Writes(std::size_t port) const;
  void Write(std::size_t port, py::handle value) const;
  void Say(const std::string& text) const;
  double Now() const;
  void WakeAt(double seconds) const;
  void WakeAfter(double seconds) const;
  void DrainFor(double seconds) const;
  std::string Path() const;
  Sender<Object> NewSender() const;
  py::object Take() const;
  /// Any thread.
  void RequestTick() const;

  // Of control nodes and decorators. Children are numbered from 0; raise IndexError.
  std::size_t CountChildren() const;
  Status TickChild(std::size_t child) const;
  Status StatusOfChild(std::size_t child) const;
  void HaltChild(std::size_t child) const;

 private:
  PythonNode& Node() const;
  Children& ChildrenWith(std::size_t child) const;

  PythonNode* node_;
};

/// What leaves and control nodes have in common: ports, the object and its methods.
class PythonNode {
 public:
  PythonNode(std::shared_ptr<const NodeClass> node_class, UserNode& node);
  ~PythonNode();
  PythonNode(const PythonNode&) = delete;
  PythonNode& operator=(const PythonNode&) = delete;

  /// Makes the object: with the GIL. Throws what its __init__ raises.
  void Make();

  /// `children`: of a control node, as long as it is ticked.
  Status Tick(bool starting, Children* children = nullptr);
  void Halt();
  bool HasStopped();

 private:
  friend class NodeLink;
  class Call;

  py::object Ask(Method method);
  void Rethrow(py::error_already_set& error);
  Status StatusOf(py::handle result, Method method) const;
  std::string WhyUnset(const Slot* slot) const;
  LeafHost& host() const { return node_.host(); }

  const std::shared_ptr<const NodeClass> class_;
  UserNode& node_;
  std::vector<std::unique_ptr<PythonPort>> ports_;
  Mailbox<Object> mailbox_;
  std::shared_ptr<NodeLink> link_;
  Object methods_[static_cast<std::size_t>(Method::kCount)];
  Children* children_ = nullptr;
  std::exception_ptr aborted_;  // the engine's, on its way through Python
};

class PythonLeaf final : public Leaf {
 public:
  explicit PythonLeaf(std::shared_ptr<const NodeClass> node_class)
      : node_(std::move(node_class), *this) {}

  void set_host(LeafHost* host) override;
  Status Tick(bool starting) override { return node_.Tick(starting); }
  void Halt() override { node_.Halt(); }
  bool HasStopped() override { return node_.HasStopped(); }

 private:
  PythonNode node_;
};

class PythonControl final : public UserControl {
 public:
  explicit PythonControl(std::shared_ptr<const NodeClass> node_class)
      : node_(std::move(node_class), *this) {}

  void set_host(LeafHost* host) override;
  Status Tick(Children& children, bool starting) override {
    return node_.Tick(starting, &children);
  }
  void OnHalted() override { node_.Halt(); }

 private:
  PythonNode node_;
};

/// Adds a class of nodes: a control node or decorator, if its manifest says so, else a leaf. Throws
/// as Registry::Register does.
void AddNodeClass(Registry& registry, NodeClass node_class);

/// Of an exception: its traceback as a text, without the frames of this package.
std::string TracebackOf(py::handle exception);

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_LEAF_H_
