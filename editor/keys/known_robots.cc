#include "editor/keys/known_robots.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "editor/keys/age_text.h"

namespace coppice::editor {
namespace {

// No character is cut into pieces.
std::string Cleaned(std::string text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  text.erase(std::remove_if(text.begin(), text.end(), is_control), text.end());
  std::size_t end = std::min(text.size(), kLongestRobotText);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  text.resize(end);
  return text;
}

}  // namespace

void MeetRobot(std::vector<KnownRobot>& robots, KnownRobot robot) {
  robot.endpoint = Cleaned(std::move(robot.endpoint));
  robot.tree = Cleaned(std::move(robot.tree));
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
  robot.endpoint = Cleaned(line.substr(endpoint + 1, tree - endpoint - 1));
  robot.tree = Cleaned(line.substr(tree + 1));
  if (robot.endpoint.empty()) return std::nullopt;
  return robot;
}

}  // namespace coppice::editor
