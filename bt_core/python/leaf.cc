#include "bt_core/python/leaf.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "bt_core/python/values.h"

namespace coppice::python {
namespace {

thread_local Interruption* interruption = nullptr;
thread_local const PythonNode* called = nullptr;  // whose methods may use the tree now

// A signal that waits for Python's handler would be raised in the leaf, however little that has to
// do with it, and keep it from being halted in order.
void TakeSignals() {
  if (!interruption || PyErr_CheckSignals() == 0) return;
  const py::error_already_set raised;
  Interruption::Keep(raised.value());
}

constexpr std::size_t Number(Method method) { return static_cast<std::size_t>(method); }

}  // namespace

Interruption::Interruption(Runner* runner)
    : outer_(std::exchange(interruption, this)), runner_(runner) {}
Interruption::~Interruption() { interruption = outer_; }

void Interruption::Raise() const {
  CollectDropped();
  if (!exception_) return;
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception_.get().ptr())),
                  exception_.get().ptr());
  throw py::error_already_set();
}

void Interruption::Keep(py::object exception) {
  if (!interruption) return;
  if (!interruption->exception_) interruption->exception_ = Object(std::move(exception));
  if (interruption->runner_) interruption->runner_->RequestStop();
}

void PythonPort::Write(Value value) {
  if (!slot_) return;  // left out in the XML
  slot_->value = std::move(value);
  slot_->CountWrite(*now_);
}

// While a method of the node is called.
class PythonNode::Call {
 public:
  explicit Call(const PythonNode& node) : outer_(std::exchange(called, &node)) {}
  ~Call() { called = outer_; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

 private:
  const py::gil_scoped_acquire gil_;
  const PythonNode* const outer_;
};

PythonNode::PythonNode(std::shared_ptr<const NodeClass> node_class, UserNode& node)
    : class_(std::move(node_class)), node_(node), mailbox_(&node, "mailbox") {
  for (const PortDeclaration& port : class_->manifest.ports) {
    ports_.push_back(std::make_unique<PythonPort>(port));
  }
}

PythonNode::~PythonNode() {
  if (!link_ || !Py_IsInitialized()) return;
  const py::gil_scoped_acquire gil;  // nobody uses the link meanwhile
  link_->Cut();
}

void PythonNode::Make() {
  const py::gil_scoped_acquire gil;
  link_ = std::make_shared<NodeLink>(this);
  const py::object made = py::reinterpret_borrow<py::object>(class_->make.get())(link_);
  const py::tuple methods(made);
  if (methods.size() != std::size(methods_)) {
    throw py::type_error("a node is made with " + std::to_string(std::size(methods_)) +
                         " methods, not " + std::to_string(methods.size()) +
                         ": does its class have _methods of its own?");
  }
  std::transform(methods.begin(), methods.end(), methods_, [](py::handle method) {
    return Object(py::reinterpret_borrow<py::object>(method));
  });
}

void PythonLeaf::set_host(LeafHost* host) {
  Leaf::set_host(host);
  node_.Make();
}

void PythonControl::set_host(LeafHost* host) {
  UserControl::set_host(host);
  node_.Make();
}

// Makes an exception of Python one of the engine's. What ends the program is kept apart; then the
// node counts as RUNNING, so that nothing else is begun in its place and it is halted.
void PythonNode::Rethrow(py::error_already_set& error) {
  if (aborted_) std::rethrow_exception(std::exchange(aborted_, nullptr));
  if (!error.matches(PyExc_Exception)) return Interruption::Keep(error.value());
  if (error.trace()) PyException_SetTraceback(error.value().ptr(), error.trace().ptr());
  throw PythonError(TracebackOf(error.value()), Object(error.value()));
}

Status PythonNode::Tick(bool starting, Children* children) {
  const Call call(*this);
  const Method method = starting ? Method::kStart : Method::kRunning;
  children_ = children;
  try {
    CollectDropped();
    return StatusOf(Ask(method), method);
  } catch (py::error_already_set& error) {
    Rethrow(error);
  } catch (py::builtin_exception& error) {
    throw std::runtime_error(error.what());
  }
  return Status::kRunning;
}

void PythonNode::Halt() {
  const Call call(*this);
  try {
    Ask(Method::kHalted);
  } catch (py::error_already_set& error) {
    Rethrow(error);
  }
}

bool PythonNode::HasStopped() {
  const Call call(*this);
  try {
    return py::cast<bool>(Ask(Method::kStopped));
  } catch (py::error_already_set& error) {
    Rethrow(error);
  }
  return true;
}

py::object PythonNode::Ask(Method method) {
  const py::handle function = methods_[Number(method)].get();
  if (!function || function.is_none()) return py::bool_(true);
  TakeSignals();
  PyObject* const result = PyObject_CallNoArgs(function.ptr());
  if (!result) throw py::error_already_set();
  if (aborted_) {  // the method has caught it: it goes on nevertheless
    Py_DECREF(result);
    std::rethrow_exception(std::exchange(aborted_, nullptr));
  }
  return py::reinterpret_steal<py::object>(result);
}

Status PythonNode::StatusOf(py::handle result, Method method) const {
  if (class_->is_condition) {
    if (PyBool_Check(result.ptr())) {
      return result.ptr() == Py_True ? Status::kSuccess : Status::kFailure;
    }
  } else if (py::isinstance<Status>(result)) {
    return result.cast<Status>();
  }
  const std::string name =
      py::str(py::getattr(methods_[Number(method)].get(), "__qualname__", py::str("a leaf")));
  const bool nothing = result.is_none();
  throw py::type_error(name + "() returned " + std::string(py::repr(result)) + "; expected " +
                       (class_->is_condition ? "True or False" : "a coppice.Status") +
                       (nothing ? " (is there a return on every way?)" : ""));
}

std::string PythonNode::WhyUnset(const Slot* slot) const {
  if (!slot) return {};
  const Executor& executor = dynamic_cast<const Executor&>(host());
  const auto number = static_cast<SlotIndex>(slot - executor.blackboard().data());
  return ": nobody has written key \"" + executor.program().layout.slots[number].key + "\" yet";
}

PythonNode& NodeLink::Node() const {
  if (!node_) throw std::runtime_error("the tree of this leaf is gone");
  if (called != node_) {
    throw std::runtime_error(
        "ports and tree can be used while the tree calls a method of this leaf, and on that thread "
        "only; other threads answer by a sender that new_sender() has made before");
  }
  return *node_;
}

Children& NodeLink::ChildrenWith(std::size_t child) const {
  const PythonNode& node = Node();
  if (!node.children_) throw std::runtime_error("children are ticked and halted in tick() only");
  const std::size_t count = node.children_->size();
  if (child >= count) {
    throw py::index_error("there is no child " + std::to_string(child) + " of " +
                          std::to_string(count) + "; the first one is 0");
  }
  return *node.children_;
}

std::size_t NodeLink::CountChildren() const {
  const PythonNode& node = Node();
  return node.children_ ? node.children_->size() : 0;
}

// What leaves the tick of the whole tree cannot go through Python: it waits in the node.
Status NodeLink::TickChild(std::size_t child) const {
  Children& children = ChildrenWith(child);
  PythonNode& node = Node();
  try {
    return children.Tick(static_cast<std::uint32_t>(child));
  } catch (...) {
    node.aborted_ = std::current_exception();
  }
  throw std::runtime_error("the tick was broken off");
}

Status NodeLink::StatusOfChild(std::size_t child) const {
  return ChildrenWith(child).status(static_cast<std::uint32_t>(child));
}

void NodeLink::HaltChild(std::size_t child) const {
  ChildrenWith(child).Halt(static_cast<std::uint32_t>(child));
}

py::object NodeLink::Read(std::size_t port) const {
  const PythonNode& node = Node();
  const Slot* const slot = node.ports_.at(port)->slot();
  if (slot && slot->value.has_value()) return ToPython(slot->value);
  const PortDeclaration& declared = node.class_->manifest.ports[port];
  const bool may_be_left_out = !declared.required && !declared.default_text;
  if (may_be_left_out || declared.direction == PortDirection::kOutput) return py::none();
  throw UnsetPort("input \"" + declared.name + "\" has no value" + node.WhyUnset(slot));
}

bool NodeLink::HasValue(std::size_t port) const {
  const Slot* const slot = Node().ports_.at(port)->slot();
  return slot && slot->value.has_value();
}

std::uint32_t NodeLink::Writes(std::size_t port) const {
  const Slot* const slot = Node().ports_.at(port)->slot();
  return slot ? slot->writes : 0;
}

void NodeLink::Write(std::size_t port, py::handle value) const {
  PythonNode& node = Node();
  PythonPort& at = *node.ports_.at(port);
  try {
    at.Write(FromPython(&at.type(), value));
  } catch (const py::builtin_exception& error) {
    const std::string what =
        "port \"" + node.class_->manifest.ports[port].name + "\": " + error.what();
    if (dynamic_cast<const py::type_error*>(&error)) throw py::type_error(what);
    throw py::value_error(what);
  }
}

void NodeLink::Say(const std::string& text) const { Node().host().AddMessage(text); }
double NodeLink::Now() const { return ToSeconds(Node().host().now()); }

void NodeLink::WakeAt(double seconds) const { Node().host().WakeAt(Time(FromSeconds(seconds))); }

void NodeLink::WakeAfter(double seconds) const {
  LeafHost& host = Node().host();
  host.WakeAt(host.now() + FromSeconds(seconds));
}

void NodeLink::DrainFor(double seconds) const { Node().host().Drain(FromSeconds(seconds)); }

std::string NodeLink::Path() const {
  auto& executor = dynamic_cast<Executor&>(Node().host());
  return executor.program().Path(executor.current_node());
}

Sender<Object> NodeLink::NewSender() const { return Node().mailbox_.NewSender(); }

py::object NodeLink::Take() const {
  const Object* const answer = Node().mailbox_.Take();
  return answer ? py::reinterpret_borrow<py::object>(answer->get()) : py::none();
}

void NodeLink::RequestTick() const {
  if (node_) dynamic_cast<Executor&>(node_->host()).inbox()->RequestTick();
}

void AddNodeClass(Registry& registry, NodeClass node_class) {
  const auto shared = std::make_shared<const NodeClass>(std::move(node_class));
  switch (shared->manifest.category) {
    case NodeCategory::kControl:
    case NodeCategory::kDecorator: {
      const bool is_decorator = shared->manifest.category == NodeCategory::kDecorator;
      registry.AddBuilder(shared->manifest,
                          is_decorator ? UserDecorator::kChildren : UserControl::kChildren,
                          [shared] { return std::make_unique<PythonControl>(shared); });
      return;
    }
    default:
      registry.AddBuilder(shared->manifest, {0, 0},
                          [shared] { return std::make_unique<PythonLeaf>(shared); });
  }
}

std::string TracebackOf(py::handle exception) {
  return py::str(py::module_::import("coppice.leaf").attr("format_error")(exception));
}

}  // namespace coppice::python
