// Who has answered a search, and who does not any more. No sockets, no threads.
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_FOUND_ROBOTS_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_FOUND_ROBOTS_H_

#include <string>
#include <vector>

#include "bt_core/live/discovery/robot_messages.h"
#include "bt_core/live/discovery/robot_search.h"

namespace coppice {

class FoundRobots {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kMostOfAddress = 8;
  static constexpr int kPatience = 3;  ///< questions that a robot may leave unanswered

  /// It said so from that address. True if that is news. Beyond the limits who came first stays.
  bool Hear(const Ipv4& address, const RobotNotice& notice);

  /// All are asked again. True if somebody is taken for gone.
  bool Ask();

  /// The one that was heard first is the first: who comes does not move what somebody is about to
  /// click on.
  std::vector<FoundRobot> List() const;

 private:
  struct Entry {
    Ipv4 address{};
    RobotNotice notice;
    int unanswered = 0;
  };

  bool HasRoom(const Ipv4& address) const;

  std::vector<Entry> robots_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_FOUND_ROBOTS_H_
