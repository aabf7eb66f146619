// A value of the blackboard that nobody else touches meanwhile.
#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "behaviortree_cpp/utils/safe_any.hpp"

namespace BT {
namespace internal {

/// Takes the value off the blackboard and puts it back when it goes.
class Loan {
 public:
  virtual ~Loan() = default;
  Any value;
};

}  // namespace internal

/// Null if there is no such key. To be kept for a moment only: the tree waits.
template <class T>
class LockedPtr {
 public:
  LockedPtr() = default;
  explicit LockedPtr(std::unique_ptr<internal::Loan> loan) : loan_(std::move(loan)) {}
  LockedPtr(LockedPtr&&) noexcept = default;
  LockedPtr& operator=(LockedPtr&&) noexcept = default;

  operator bool() const { return loan_ != nullptr; }
  const T* get() const { return loan_ ? &loan_->value : nullptr; }
  T* get() { return loan_ ? &loan_->value : nullptr; }
  const T* operator->() const { return get(); }
  T* operator->() { return get(); }

  /// Throws std::runtime_error if this is null or holds a value of another kind.
  template <class Other>
  void assign(const Other& value) {
    if (!loan_) throw std::runtime_error("Empty LockedPtr reference");
    if constexpr (std::is_same_v<T, Other>) {
      value.copyInto(loan_->value);
    } else {
      Any(value).copyInto(loan_->value);
    }
  }

 private:
  std::unique_ptr<internal::Loan> loan_;
};

}  // namespace BT
