// Leaves of one line: a function, with typed ports by its parameters.
//
//   registry.Condition("IsNight", [] { return Hour() < 6; });
//   registry.Condition("IsDark", {"lux"}, [](double lux) { return lux < 10; });
//   registry.Action("Add", {"a", "b", "sum"}, [](double a, double b, Output<double>& sum) {
//     sum.Set(a + b);
//     return Status::kSuccess;
//   });
//
// The names belong to the parameters in their order; a wrong number of them does not compile. The
// parameter's type says what port it is:
//
//   T, const T&        an input that must have a value
//   const Input<T>&    an input that the XML may leave out: ask has_value()
//   Output<T>&         an output
//   InOut<T>&          both
//
// Every node gets its own copy of the function, so what a mutable lambda captures by value belongs
// to one node. It is called on the ticking thread and must return soon. To fail with a reason,
// throw: the text becomes the node's message.
#ifndef COPPICE_BT_CORE_NODES_LAMBDA_LEAF_H_
#define COPPICE_BT_CORE_NODES_LAMBDA_LEAF_H_

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bt_core/nodes/leaf.h"

namespace coppice {

/// Name and description of the port that belongs to a parameter. `default_text` is the value of an
/// input that the XML leaves out, written as in XML.
struct LambdaPort {
  LambdaPort(const char* name, const char* description = "") : LambdaPort(name, description, {}) {}
  LambdaPort(const char* name, const char* description, std::optional<std::string> default_text)
      : name(name), description(description), default_text(std::move(default_text)) {}
  std::string name;
  std::string description;
  std::optional<std::string> default_text;
};

namespace internal {

/// What stands behind a parameter: made from a LambdaPort, gives the argument.
template <class T>
class LambdaArgument : public PortBase {
 public:
  explicit LambdaArgument(const LambdaPort& port)
      : PortBase({port.name, PortDirection::kInput, &TypeOf<T>(), port.description,
                  !port.default_text, port.default_text}) {}
  const T& argument() const {
    if (!slot_ || !slot_->value.has_value()) throw UnsetInput(slot_);
    return slot_->value.template Get<T>();
  }
};

template <class T>
class LambdaArgument<Input<T>> {
 public:
  explicit LambdaArgument(const LambdaPort& port)
      : port_(nullptr, port.name, port.description, kOptional) {}
  Input<T>& argument() { return port_; }

 private:
  Input<T> port_;
};

template <class Port>
class LambdaWriter {
 public:
  explicit LambdaWriter(const LambdaPort& port) : port_(nullptr, port.name, port.description) {}
  Port& argument() { return port_; }

 private:
  Port port_;
};

template <class T>
class LambdaArgument<Output<T>> : public LambdaWriter<Output<T>> {
 public:
  using LambdaWriter<Output<T>>::LambdaWriter;
};

template <class T>
class LambdaArgument<InOut<T>> : public LambdaWriter<InOut<T>> {
 public:
  using LambdaWriter<InOut<T>>::LambdaWriter;
};

template <std::size_t k, class T>
class NumberedArgument : public LambdaArgument<T> {
 public:
  using LambdaArgument<T>::LambdaArgument;
};

// Arguments are bases, because those are made in their order: that is the order of the ports.
template <class Numbers, class... Parameters>
class LambdaArguments;
template <std::size_t... k, class... Parameters>
class LambdaArguments<std::index_sequence<k...>, Parameters...>
    : NumberedArgument<k, std::decay_t<Parameters>>... {
 public:
  explicit LambdaArguments([[maybe_unused]] const LambdaPort* ports)
      : NumberedArgument<k, std::decay_t<Parameters>>(ports[k])... {}
  template <class Function>
  auto Call(Function& function) {
    return function(NumberedArgument<k, std::decay_t<Parameters>>::argument()...);
  }
};

/// A function with its ports.
template <class Function, class Result, class... Parameters>
class LambdaCall {
 public:
  using ResultType = Result;
  static constexpr std::size_t kArity = sizeof...(Parameters);

  LambdaCall(const LambdaPort* ports, const Function& function)
      : function_(function), arguments_(ports) {}

  Result operator()() { return arguments_.Call(function_); }

 private:
  Function function_;
  LambdaArguments<std::index_sequence_for<Parameters...>, Parameters...> arguments_;
};

// The LambdaCall of a function type, found by the signature of its call operator.
template <class Function, class Signature>
struct LambdaCallOf;
template <class Function, class Result, class... Parameters>
struct LambdaCallOf<Function, Result(Parameters...)> {
  using Type = LambdaCall<Function, Result, Parameters...>;
};
template <class Result, class... Parameters>
auto SignatureOf(Result (*)(Parameters...)) -> Result (*)(Parameters...);
template <class Function, class Result, class... Parameters>
auto SignatureOf(Result (Function::*)(Parameters...)) -> Result (*)(Parameters...);
template <class Function, class Result, class... Parameters>
auto SignatureOf(Result (Function::*)(Parameters...) const) -> Result (*)(Parameters...);

template <class Function>
constexpr auto PointerToCall() {
  if constexpr (std::is_pointer_v<Function>) {
    return Function();
  } else {
    return &Function::operator();
  }
}

template <class Function>
using LambdaCallFor = typename LambdaCallOf<
    Function, std::remove_pointer_t<decltype(SignatureOf(PointerToCall<Function>()))>>::Type;

}  // namespace internal

/// What Registry::Condition registers.
template <class Function>
class LambdaCondition final : public Condition {
 public:
  using Call = internal::LambdaCallFor<Function>;
  static_assert(std::is_same_v<typename Call::ResultType, bool>, "a condition returns bool");

  LambdaCondition(const std::vector<LambdaPort>& ports, const Function& function)
      : call_(ports.data(), function) {}
  bool Check() override { return call_(); }

 private:
  Call call_;
};

/// What Registry::Action registers.
template <class Function>
class LambdaAction final : public SyncAction {
 public:
  using Call = internal::LambdaCallFor<Function>;
  static_assert(std::is_same_v<typename Call::ResultType, Status>, "an action returns Status");

  LambdaAction(const std::vector<LambdaPort>& ports, const Function& function)
      : call_(ports.data(), function) {}
  Status Run() override { return call_(); }

 private:
  Call call_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_LAMBDA_LEAF_H_
