// A key of a blackboard: what is known of it and where its value lies. While a tree has it, that is
// a slot of the tree, which its nodes read and write without looking up a name.
#pragma once

#include <pthread.h>

#include <atomic>
#include <memory>
#include <mutex>

#include "behaviortree_cpp/basic_types.h"
#include "bt_core/data/blackboard.h"

namespace BT::internal {

/// Lets one thread at the values of a tree: the one that ticks it, for as long as the tick takes;
/// others in between.
class Gate {
 public:
  /// True on the thread that ticks, which needs no lock.
  bool is_open() const { return owner_.load(std::memory_order_relaxed) == pthread_self(); }
  void Enter() {
    mutex_.lock();
    owner_.store(pthread_self(), std::memory_order_relaxed);
  }
  void Leave() {
    owner_.store(pthread_t{}, std::memory_order_relaxed);
    mutex_.unlock();
  }

 private:
  friend class GateLock;
  std::mutex mutex_;
  std::atomic<pthread_t> owner_{};
};

/// Opens it for this thread.
class OpenGate {
 public:
  explicit OpenGate(Gate& gate) : gate_(gate) { gate_.Enter(); }
  ~OpenGate() { gate_.Leave(); }
  OpenGate(const OpenGate&) = delete;
  OpenGate& operator=(const OpenGate&) = delete;

 private:
  Gate& gate_;
};

class GateLock {
 public:
  explicit GateLock(Gate& gate) : gate_(gate.is_open() ? nullptr : &gate) {
    if (gate_) gate_->mutex_.lock();
  }
  ~GateLock() {
    if (gate_) gate_->mutex_.unlock();
  }
  GateLock(const GateLock&) = delete;
  GateLock& operator=(const GateLock&) = delete;

 private:
  Gate* gate_;
};

struct Cell {
  explicit Cell(const TypeInfo& declared) : info(declared) {}
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  coppice::Slot own;  // while no tree has the key
  coppice::Slot* slot = &own;
  Gate own_gate;
  Gate* gate = &own_gate;
  const coppice::Time* now = nullptr;       // of the tree's tick
  const coppice::Type* demanded = nullptr;  // by built-in nodes of the tree
  const coppice::Type* accepted = nullptr;  // a value of this type is written as it is
  TypeInfo info;                            // as ports have declared it, or the first writer
  bool is_declared = false;  // by a port or by createEntry: it is there without a value

  bool exists() const { return is_declared || slot->value.has_value(); }
};

/// A value on its way to a cell.
struct Written {
  Any value;
  std::type_index type;            // of the C++ type that was written
  StringConverter (*converter)();  // of that type
};

/// Converts the value to what the key holds and writes it. Throws LogicError if it is none.
void Write(Cell& cell, Written written, StringView key);

/// The same, whatever type the key has had.
void Overwrite(Cell& cell, Any value, const TypeInfo& info, StringView key);

/// Counts a write that has just been done.
void CountWrite(Cell& cell);

template <class T>
void WriteTo(Cell& cell, const T& value, StringView key) {
  using Stored = KeptAs<T>;
  if constexpr (std::is_same_v<Stored, T> && !std::is_same_v<T, Any>) {
    if (cell.gate->is_open() && cell.accepted == &TypeFor<T>()) {
      if (cell.slot->value.type() == &TypeFor<T>()) {
        cell.slot->value.template Get<T>() = value;
      } else {
        cell.slot->value.Assign(TypeFor<T>(), &value);
      }
      return cell.slot->CountWrite(*cell.now);  // only a tree has an open gate
    }
  }
  if constexpr (std::is_same_v<T, Any>) {
    Write(cell, {value, typeid(Any), &GetAnyFromStringFunctor<Any>}, key);
  } else {
    using Declared = std::conditional_t<std::is_same_v<Stored, std::string>, std::string, T>;
    Write(cell, {Any(value), typeid(Declared), &GetAnyFromStringFunctor<Declared>}, key);
  }
}

}  // namespace BT::internal
