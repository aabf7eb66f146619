// Robots that the editor has been connected to, the last one first: offered again, and kept in a
// file. No token is among what is kept.
//
//   MeetRobot(state.recent.robots, {"robot:1667", "Patrol", date});
//   for (const KnownRobot& robot : state.recent.robots) Offer(robot.endpoint, NoteOf(robot, date));
#ifndef COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_
#define COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

/// A robot as a line of text without its end, and back; nothing if the line is none.
std::string LineOf(const KnownRobot& robot);
std::optional<KnownRobot> RobotOfLine(const std::string& line);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_KNOWN_ROBOTS_H_
