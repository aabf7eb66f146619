// Robots that the editor has been connected to, the last one first: offered again, and kept in a
// file. No token is among what is kept.
//
//   MeetRobot(state.recent.robots, {"robot:1667", "Patrol", date});
//   for (const OfferedRobot& robot : OfferRobots(state.recent.robots, found, date)) Show(robot);
#ifndef COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_
#define COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/live/discovery/robot_search.h"

namespace coppice::editor {

struct KnownRobot {
  std::string endpoint;   ///< "HOST:PORT" or "HOST:PORT/TREE"
  std::string tree;       ///< that it ran, as it says; empty: it said nothing
  std::int64_t seen = 0;  ///< when it answered last [seconds since 1970]; 0: not known
};

inline constexpr std::size_t kMostKnownRobots = 12;
inline constexpr std::size_t kLongestRobotText = 200;  ///< bytes of an endpoint, and of a name

/// Puts it in front; the one that was not met for longest is forgotten. What a robot says of itself
/// is cut to kLongestRobotText, and without control characters. One without an endpoint is none.
void MeetRobot(std::vector<KnownRobot>& robots, KnownRobot robot);

/// It still answers. The order stays, and one that was forgotten stays so.
void SeeRobot(std::vector<KnownRobot>& robots, const std::string& endpoint, std::int64_t date);

void ForgetRobot(std::vector<KnownRobot>& robots, const std::string& endpoint);

/// "Patrol, 3 minutes ago".
std::string NoteOf(const KnownRobot& robot, std::int64_t date);
/// "Patrol on sobi, asks for a token".
std::string NoteOf(const FoundRobot& robot);

/// A row for one that can be connected to.
struct OfferedRobot {
  std::string endpoint;
  std::string note;
  bool is_known = false;  ///< else the network says that it is there

  const char* word() const { return is_known ? "robot" : "found"; }
};

/// Those that were met before, then those of the network that were not.
std::vector<OfferedRobot> OfferRobots(const std::vector<KnownRobot>& known,
                                      const std::vector<FoundRobot>& found, std::int64_t date);

/// A robot as a line of text without its end, and back; nothing if the line is none.
std::string LineOf(const KnownRobot& robot);
std::optional<KnownRobot> RobotOfLine(const std::string& line);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_
