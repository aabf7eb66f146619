#include "robot_app/ros/duty_feed.h"

#include <utility>

namespace coppice::robot::adapters {
namespace {

constexpr double kPeriod = 10;  // s, wall

}  // namespace

knowledge::LocalTime LocalTimeAt(std::time_t moment) {
  std::tm local{};
  localtime_r(&moment, &local);
  const auto day = knowledge::DayOf({local.tm_year + 1900, local.tm_mon + 1, local.tm_mday});
  const std::chrono::seconds time(3600 * local.tm_hour + 60 * local.tm_min + local.tm_sec);
  return {day.value_or(knowledge::Day()), time};
}

DutyFeed::DutyFeed(ros::NodeHandle& node, knowledge::OpeningHours hours,
                   std::vector<Sender<double>> trees)
    : hours_(std::move(hours)),
      trees_(std::move(trees)),
      timer_(node.createWallTimer(ros::WallDuration(kPeriod), [this](const auto&) { Send(); })) {
  Send();
}

void DutyFeed::Send() {
  const std::chrono::duration<double> left = hours_.OpenFor(LocalTimeAt(std::time(nullptr)));
  for (const Sender<double>& tree : trees_) tree.Send(left.count());
}

}  // namespace coppice::robot::adapters
