// nonstd::expected: a value or the reason why there is none, as std::expected of C++23.
//
//   nonstd::expected<int, std::string> Half(int n) {
//     if (n % 2) return nonstd::make_unexpected("odd");
//     return n / 2;
//   }
#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

namespace nonstd {

template <class E>
class unexpected_type {
 public:
  explicit unexpected_type(E error) : error_(std::move(error)) {}
  const E& value() const& { return error_; }
  const E& error() const& { return error_; }
  E&& value() && { return std::move(error_); }

 private:
  E error_;
};

template <class E>
using unexpected = unexpected_type<E>;

/// The error of an expected, whatever its value would be.
template <class E>
unexpected_type<std::decay_t<E>> make_unexpected(E&& error) {
  return unexpected_type<std::decay_t<E>>(std::forward<E>(error));
}
inline unexpected_type<std::string> make_unexpected(const char* error) {
  return unexpected_type<std::string>(error);
}

template <class E>
class bad_expected_access : public std::exception {
 public:
  explicit bad_expected_access(E error) : error_(std::move(error)) {}
  const E& error() const { return error_; }
  const char* what() const noexcept override {
    if constexpr (std::is_convertible_v<E, std::string>) {
      return error_.c_str();
    } else {
      return "there is no value";
    }
  }

 private:
  E error_;
};

template <class T, class E>
class expected {
 public:
  using value_type = T;
  using error_type = E;

  expected() : value_(), has_value_(true) {}
  expected(const T& value) : value_(value), has_value_(true) {}
  expected(T&& value) : value_(std::move(value)), has_value_(true) {}
  template <class U, class = std::enable_if_t<std::is_convertible_v<U, T> &&
                                              !std::is_same_v<std::decay_t<U>, expected>>>
  expected(U&& value) : value_(std::forward<U>(value)), has_value_(true) {}
  template <class G>
  expected(const unexpected_type<G>& error) : error_(error.value()), has_value_(false) {}
  template <class G>
  expected(unexpected_type<G>&& error) : error_(std::move(error).value()), has_value_(false) {}

  expected(const expected& other) : has_value_(other.has_value_) { Take(other); }
  expected(expected&& other) noexcept : has_value_(other.has_value_) { Take(std::move(other)); }
  expected& operator=(const expected& other) {
    if (this == &other) return *this;
    Destroy();
    has_value_ = other.has_value_;
    Take(other);
    return *this;
  }
  expected& operator=(expected&& other) noexcept {
    if (this == &other) return *this;
    Destroy();
    has_value_ = other.has_value_;
    Take(std::move(other));
    return *this;
  }
  ~expected() { Destroy(); }

  bool has_value() const noexcept { return has_value_; }
  explicit operator bool() const noexcept { return has_value_; }

  const T& value() const& {
    Check();
    return value_;
  }
  T& value() & {
    Check();
    return value_;
  }
  T&& value() && {
    Check();
    return std::move(value_);
  }
  /// Undefined without a value.
  const T& operator*() const& { return value_; }
  T& operator*() & { return value_; }
  T&& operator*() && { return std::move(value_); }
  const T* operator->() const { return &value_; }
  T* operator->() { return &value_; }

  /// Undefined with a value.
  const E& error() const& { return error_; }
  E& error() & { return error_; }

  template <class U>
  T value_or(U&& otherwise) const& {
    return has_value_ ? value_ : static_cast<T>(std::forward<U>(otherwise));
  }
  template <class U>
  T value_or(U&& otherwise) && {
    return has_value_ ? std::move(value_) : static_cast<T>(std::forward<U>(otherwise));
  }

 private:
  void Check() const {
    if (!has_value_) throw bad_expected_access<E>(error_);
  }
  void Destroy() {
    if (has_value_) {
      value_.~T();
    } else {
      error_.~E();
    }
  }
  template <class Other>
  void Take(Other&& other) {
    if (has_value_) {
      new (&value_) T(std::forward<Other>(other).value_);
    } else {
      new (&error_) E(std::forward<Other>(other).error_);
    }
  }

  union {
    T value_;
    E error_;
  };
  bool has_value_;
};

template <class T1, class E1, class T2, class E2>
bool operator==(const expected<T1, E1>& a, const expected<T2, E2>& b) {
  if (a.has_value() != b.has_value()) return false;
  return a.has_value() ? *a == *b : a.error() == b.error();
}
template <class T1, class E1, class T2, class E2>
bool operator!=(const expected<T1, E1>& a, const expected<T2, E2>& b) {
  return !(a == b);
}
/// What has no value is less than what has one.
template <class T, class E>
bool operator<(const expected<T, E>& a, const expected<T, E>& b) {
  return b.has_value() && (!a.has_value() || *a < *b);
}
template <class T, class E>
bool operator>(const expected<T, E>& a, const expected<T, E>& b) {
  return b < a;
}
template <class T, class E>
bool operator<=(const expected<T, E>& a, const expected<T, E>& b) {
  return !(b < a);
}
template <class T, class E>
bool operator>=(const expected<T, E>& a, const expected<T, E>& b) {
  return !(a < b);
}
/// False without a value.
template <class T1, class E, class T2>
bool operator==(const expected<T1, E>& a, const T2& value) {
  return a.has_value() && *a == value;
}
template <class T1, class E, class T2>
bool operator==(const T2& value, const expected<T1, E>& a) {
  return a == value;
}
template <class T1, class E, class T2>
bool operator!=(const expected<T1, E>& a, const T2& value) {
  return !(a == value);
}
template <class T1, class E, class T2>
bool operator!=(const T2& value, const expected<T1, E>& a) {
  return !(a == value);
}

}  // namespace nonstd
