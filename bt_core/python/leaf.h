// Leaves in Python: a node of the user whose work is done by an object of Python.
//
// A PythonLeaf lives in the executor and owns its object, which reaches the leaf by a NodeLink: its
// ports, its messages, the time. The link outlives the leaf and says then that the tree is gone.
//
// All calls of Python take the GIL, which the ticking thread does not have otherwise. An exception
// of Python becomes a PythonError with the traceback as its text; KeyboardInterrupt and SystemExit,
// which are no errors of the leaf, go to the Interruption of the tick.
#ifndef COPPICE_BT_CORE_PYTHON_LEAF_H_
#define COPPICE_BT_CORE_PYTHON_LEAF_H_

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/registry.h"
#include "bt_core/engine/runner.h"
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

/// What the engine asks of a leaf, in the order of the methods that it is made with.
enum class Method : std::uint8_t { kStart, kRunning, kHalted, kStopped, kCount };

/// What a class of leaves says of itself, once.
struct LeafClass {
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

class PythonLeaf;

/// What the object in Python has of its leaf. Its functions raise RuntimeError where they may not
/// be called: all but NewSender's senders and RequestTick belong into the leaf's own methods.
class NodeLink {
 public:
  explicit NodeLink(PythonLeaf* leaf) : leaf_(leaf) {}
  void Cut() { leaf_ = nullptr; }

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

 private:
  PythonLeaf& Leaf() const;

  PythonLeaf* leaf_;
};

class PythonLeaf final : public Leaf {
 public:
  explicit PythonLeaf(std::shared_ptr<const LeafClass> leaf_class);
  ~PythonLeaf() override;

  /// Makes the object: with the GIL. Throws what its __init__ raises.
  void set_host(LeafHost* host) override;

  Status Tick(bool starting) override;
  void Halt() override;
  bool HasStopped() override;

 private:
  friend class NodeLink;
  class Call;

  py::object Ask(Method method);
  Status StatusOf(py::handle result, Method method) const;
  std::string WhyUnset(const Slot* slot) const;

  const std::shared_ptr<const LeafClass> class_;
  std::vector<std::unique_ptr<PythonPort>> ports_;
  Mailbox<Object> mailbox_{this, "mailbox"};
  std::shared_ptr<NodeLink> link_;
  Object methods_[static_cast<std::size_t>(Method::kCount)];
};

/// Adds a class of leaves. Throws as Registry::Register does.
void AddLeafClass(Registry& registry, LeafClass leaf_class);

/// Of an exception: its traceback as a text, without the frames of this package.
std::string TracebackOf(py::handle exception);

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_LEAF_H_
