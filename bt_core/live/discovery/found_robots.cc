#include "bt_core/live/discovery/found_robots.h"

#include <algorithm>

namespace coppice {
namespace {

std::string EndpointOf(const Ipv4& address, std::uint16_t port) {
  std::string text;
  for (const std::uint8_t byte : address) text += (text.empty() ? "" : ".") + std::to_string(byte);
  return text + ":" + std::to_string(port);
}

bool ShowTheSame(const RobotNotice& a, const RobotNotice& b) {
  return a.host == b.host && a.tree == b.tree && a.needs_token == b.needs_token;
}

}  // namespace

bool FoundRobots::Hear(const Ipv4& address, const RobotNotice& notice) {
  for (Entry& robot : robots_) {
    if (robot.address != address || robot.notice.port != notice.port) continue;
    const bool is_news = !ShowTheSame(robot.notice, notice);
    robot = {address, notice};
    return is_news;
  }
  if (!HasRoom(address)) return false;
  robots_.push_back({address, notice});
  return true;
}

bool FoundRobots::HasRoom(const Ipv4& address) const {
  const auto count = std::count_if(robots_.begin(), robots_.end(),
                                   [&](const Entry& robot) { return robot.address == address; });
  return robots_.size() < kMost && static_cast<std::size_t>(count) < kMostOfAddress;
}

bool FoundRobots::Ask() {
  const auto gone = std::remove_if(robots_.begin(), robots_.end(),
                                   [](Entry& robot) { return ++robot.unanswered > kPatience; });
  const bool is_news = gone != robots_.end();
  robots_.erase(gone, robots_.end());
  return is_news;
}

std::vector<FoundRobot> FoundRobots::List() const {
  std::vector<FoundRobot> list;
  for (const Entry& robot : robots_) {
    const RobotNotice& notice = robot.notice;
    list.push_back(
        {EndpointOf(robot.address, notice.port), notice.host, notice.tree, notice.needs_token});
  }
  return list;
}

}  // namespace coppice
