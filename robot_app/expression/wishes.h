// Who wants the robot to look how, and what is shown of it: the most important of what is wanted.
// Times are those of the caller [s] and never go back. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_EXPRESSION_WISHES_H_
#define COPPICE_ROBOT_APP_EXPRESSION_WISHES_H_

#include <map>
#include <string>

#include "bt_nodes/interaction/expression.h"

namespace coppice::robot::expression {

using leaves::Expression;

/// Whose silence is an error: then the robot does nothing any more.
inline constexpr char kTrees[] = "trees";

class Wishes {
 public:
  /// In place of what the owner wanted before. It holds for `seconds`, or until it is said anew.
  void Want(const std::string& owner, Expression expression, double now, double seconds);
  void Withdraw(const std::string& owner) { wishes_.erase(owner); }

  /// NEUTRAL if nobody wants anything; ERROR while the trees, which have told something before,
  /// are silent.
  Expression Shown(double now);

 private:
  struct Wish {
    Expression expression = Expression::NEUTRAL;
    double until = 0;
  };
  std::map<std::string, Wish> wishes_;
  bool has_heard_trees_ = false;
};

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_WISHES_H_
