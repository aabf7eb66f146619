// What a page asks for: one JSON object, checked.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_COMMAND_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_COMMAND_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::assistance {

struct PageCommand {
  enum class Kind : std::uint8_t {
    kCameras,  ///< {"do": "cameras", "names": ["front"]}: which pictures to send
    kTake,     ///< {"do": "take", "over": false}: the wheel
    kLeave,    ///< {"do": "leave"}
    kDrive,    ///< {"do": "drive", "linear": 0.2, "angular": 0, "beat": 1000}; m/s, rad/s, ms
    kSetPose,  ///< {"do": "set_pose", "x": 1, "y": 2, "yaw": 0}; in the map, m and rad
    kAnswer,   ///< {"do": "answer", "request": 7, "fixed": true}
    kRestart,  ///< {"do": "restart", "name": "navigation"}
  };
  Kind kind = Kind::kCameras;
  std::vector<std::string> names;
  bool take_over = false;
  Velocity2D velocity;
  Time beat{};  ///< when the robot sent the newest beat that the page has got
  Pose2D pose;
  std::uint32_t request = 0;
  bool fixed = false;
  std::string name;
};

/// Any bytes may be handed in. Nothing if it is no command: a field is missing or of another type,
/// a number is not finite or absurdly large.
std::optional<PageCommand> ReadPageCommand(std::string_view text);

/// Whether somebody who only watches may ask for it.
inline bool IsForViewers(PageCommand::Kind kind) { return kind == PageCommand::Kind::kCameras; }

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_COMMAND_H_
