#include "editor/keys/known_robots.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "bt_core/model/utf8.h"
#include "editor/keys/age_text.h"

namespace coppice::editor {
void MeetRobot(std::vector<KnownRobot>& robots, KnownRobot robot) {
  robot.endpoint = PlainText(robot.endpoint, kLongestRobotText);
  robot.tree = PlainText(robot.tree, kLongestRobotText);
  if (robot.endpoint.empty()) return;
  ForgetRobot(robots, robot.endpoint);
  robots.insert(robots.begin(), std::move(robot));
  if (robots.size() > kMostKnownRobots) robots.resize(kMostKnownRobots);
}

void SeeRobot(std::vector<KnownRobot>& robots, const std::string& endpoint, std::int64_t date) {
  for (KnownRobot& robot : robots) {
    if (robot.endpoint == endpoint) robot.seen = date;
  }
}

void ForgetRobot(std::vector<KnownRobot>& robots, const std::string& endpoint) {
  const auto is_it = [&](const KnownRobot& robot) { return robot.endpoint == endpoint; };
  robots.erase(std::remove_if(robots.begin(), robots.end(), is_it), robots.end());
}

std::string NoteOf(const KnownRobot& robot, std::int64_t date) {
  const std::string age = robot.seen > 0 ? AgeText(date - robot.seen) : "";
  return robot.tree + (robot.tree.empty() || age.empty() ? "" : ", ") + age;
}

std::string NoteOf(const FoundRobot& robot) {
  std::string note = robot.tree;
  if (!robot.host.empty()) note += (note.empty() ? "on " : " on ") + robot.host;
  if (robot.needs_token) note += (note.empty() ? "" : ", ") + std::string("asks for a token");
  return note;
}

std::string LineOf(const KnownRobot& robot) {
  return std::to_string(robot.seen) + "\t" + robot.endpoint + "\t" + robot.tree;
}

std::optional<KnownRobot> RobotOfLine(const std::string& line) {
  KnownRobot robot;
  const std::size_t endpoint = line.find('\t');
  const std::size_t tree = endpoint == line.npos ? line.npos : line.find('\t', endpoint + 1);
  if (tree == line.npos) return std::nullopt;
  const auto read = std::from_chars(line.data(), line.data() + endpoint, robot.seen);
  if (read.ec != std::errc() || read.ptr != line.data() + endpoint) return std::nullopt;
  robot.endpoint = PlainText(line.substr(endpoint + 1, tree - endpoint - 1), kLongestRobotText);
  robot.tree = PlainText(line.substr(tree + 1), kLongestRobotText);
  if (robot.endpoint.empty()) return std::nullopt;
  return robot;
}

std::vector<OfferedRobot> OfferRobots(const std::vector<KnownRobot>& known,
                                      const std::vector<FoundRobot>& found, std::int64_t date) {
  const auto is_at = [](const std::string& endpoint) {
    return [&endpoint](const auto& robot) { return robot.endpoint == endpoint; };
  };
  std::vector<OfferedRobot> offered;
  for (const KnownRobot& robot : known) {
    const bool is_here = std::any_of(found.begin(), found.end(), is_at(robot.endpoint));
    const std::string note =
        is_here ? robot.tree + (robot.tree.empty() ? "" : ", ") + "here now" : NoteOf(robot, date);
    offered.push_back({robot.endpoint, note, true});
  }
  for (const FoundRobot& robot : found) {
    if (std::any_of(known.begin(), known.end(), is_at(robot.endpoint))) continue;
    offered.push_back({robot.endpoint, NoteOf(robot), false});
  }
  return offered;
}

}  // namespace coppice::editor
