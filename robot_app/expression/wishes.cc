#include "robot_app/expression/wishes.h"

#include <algorithm>

namespace coppice::robot::expression {
namespace {

constexpr std::size_t kMostOwners = 100;  // who knows what is sent to a topic

}  // namespace

void Wishes::Want(const std::string& owner, Expression expression, double now, double seconds) {
  if (wishes_.size() >= kMostOwners && wishes_.count(owner) == 0) return;
  wishes_[owner] = {expression, now + seconds};
  has_heard_trees_ = has_heard_trees_ || owner == kTrees;
}

Expression Wishes::Shown(double now) {
  for (auto wish = wishes_.begin(); wish != wishes_.end();) {
    wish = wish->second.until > now ? std::next(wish) : wishes_.erase(wish);
  }
  if (has_heard_trees_ && wishes_.count(kTrees) == 0) return Expression::ERROR;
  Expression shown = Expression::NEUTRAL;
  for (const auto& [owner, wish] : wishes_) shown = std::max(shown, wish.expression);
  return shown;
}

}  // namespace coppice::robot::expression
