#include "editor/keys/recent.h"

#include <algorithm>
#include <sstream>

#include "editor/keys/fuzzy.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMost = 8;  // a bonus must not outweigh what fits better

struct KeptList {
  const char* prefix;
  std::vector<std::string> Recent::*list;
};
constexpr KeptList kKept[] = {
    {"type\t", &Recent::types}, {"choice\t", &Recent::choices}, {"", &Recent::files}};
constexpr char kRobot[] = "robot\t";

}  // namespace

void UseAgain(std::vector<std::string>& list, const std::string& what) {
  list.erase(std::remove(list.begin(), list.end(), what), list.end());
  list.insert(list.begin(), what);
  if (list.size() > kMost) list.resize(kMost);
}

int BonusOf(const std::vector<std::string>& list, const std::string& what) {
  return static_cast<int>(list.end() - std::find(list.begin(), list.end(), what)) * kSameFit;
}

Recent ReadRecent(const std::string& text) {
  Recent recent;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(kRobot, 0) == 0) {
      const auto robot = RobotOfLine(line.substr(std::string(kRobot).size()));
      if (robot && recent.robots.size() < kMostKnownRobots) recent.robots.push_back(*robot);
      continue;
    }
    for (const KeptList& kept : kKept) {
      if (line.empty() || line.rfind(kept.prefix, 0) != 0) continue;
      auto& list = recent.*kept.list;
      if (list.size() < kMost) list.push_back(line.substr(std::string(kept.prefix).size()));
      break;
    }
  }
  return recent;
}

std::string WriteRecent(const Recent& recent) {
  std::string text;
  for (const KnownRobot& robot : recent.robots) text += kRobot + LineOf(robot) + "\n";
  for (const KeptList& kept : kKept) {
    for (const std::string& one : recent.*kept.list) text += kept.prefix + one + "\n";
  }
  return text;
}

}  // namespace coppice::editor
