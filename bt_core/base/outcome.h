// How a function says that it could not do what it was asked for.
//
//   Outcome Save(const Pose2D& pose, const std::string& file);   // done, or a problem
//   Expected<Query> ParseQuery(std::string_view typed);          // a value, or a problem
//
//   Expected<Query> ParseQuery(std::string_view typed) {
//     if (typed.empty()) return Problem{"nothing to search for"};
//     return Query{typed};
//   }
//   ...
//   const Expected<Query> query = ParseQuery(typed);
//   if (!query) return Problem{query.problem()};                 // the caller's problem too
//   for (const Match& match : Search(*query)) ...
//
// A problem is a text for people: lower case, no full stop, with what was expected. Whoever has to
// decide by the kind of a failure needs an enum of his own.
//
// What is wrong with a file of the user goes into `Diagnostics`, with its place and all at once.
// Exceptions are for constructors, for errors of the programmer, and for code of the user that the
// engine calls. A remark beside a success is no problem: it is a part of the value. A status that
// is looked at later ("why it is paused") is a text, and std::optional says "there is none" where
// no reason is needed.
#ifndef COPPICE_BT_CORE_BASE_OUTCOME_H_
#define COPPICE_BT_CORE_BASE_OUTCOME_H_

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace coppice {

/// Why something could not be done; becomes an Outcome or any Expected.
struct Problem {
  std::string text;
};

/// Done, or a problem. Success allocates nothing.
class [[nodiscard]] Outcome {
 public:
  Outcome() = default;  ///< done: `return {};`
  Outcome(Problem problem) : problem_(std::move(problem.text)), is_ok_(false) {}

  bool ok() const { return is_ok_; }
  explicit operator bool() const { return is_ok_; }

  /// Empty if it was done.
  const std::string& problem() const& { return problem_; }
  std::string problem() && { return std::move(problem_); }

 private:
  std::string problem_;
  bool is_ok_ = true;
};

/// A value, or the problem for which there is none. A part of std::expected<T, Problem> (C++23).
template <typename T>
class [[nodiscard]] Expected {
 public:
  template <typename U = T, typename = std::enable_if_t<std::is_convertible_v<U&&, T>>>
  Expected(U&& value) : value_(std::forward<U>(value)) {}
  Expected(Problem problem) : problem_(std::move(problem.text)) {}

  bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// Throws std::bad_optional_access if there is none. The operators do not look.
  T& value() & { return value_.value(); }
  const T& value() const& { return value_.value(); }
  T&& value() && { return std::move(value_).value(); }
  T& operator*() & { return *value_; }
  const T& operator*() const& { return *value_; }
  T&& operator*() && { return *std::move(value_); }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

  /// Empty if there is a value.
  const std::string& problem() const& { return problem_; }
  std::string problem() && { return std::move(problem_); }

 private:
  std::optional<T> value_;
  std::string problem_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_OUTCOME_H_
