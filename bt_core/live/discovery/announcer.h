// Tells the network of a robot, so that editors offer it (multicast DNS), as long as it lives.
//
//   Announcer announcer("eth0", {"patrol", 1667, "sobi", "Patrol", true});
//   announcer.SetTree("Docking");
//
// It has no rights to give: who finds the robot needs its token as before. Any thread.
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_ANNOUNCER_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_ANNOUNCER_H_

#include <memory>
#include <string>

#include "bt_core/live/discovery/robot_messages.h"

namespace coppice {

class Announcer {
 public:
  /// In the networks of InterfacesOf(address), also those that come later. Throws
  /// std::runtime_error, with a text for people, if none of those that are there lets it.
  Announcer(const std::string& address, RobotNotice robot);
  /// Says that the robot goes.
  ~Announcer();
  Announcer(const Announcer&) = delete;
  Announcer& operator=(const Announcer&) = delete;

  void SetTree(const std::string& tree);

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

/// Of this computer. Its label is one that no other robot of the network has.
RobotNotice NoticeOfThisRobot(std::uint16_t port, bool needs_token);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_ANNOUNCER_H_
