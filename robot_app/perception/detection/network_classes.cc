#include "robot_app/perception/detection/network_classes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <utility>

namespace coppice::robot::perception {
namespace {

constexpr int kCoco = 80;

constexpr std::array<std::pair<const char*, SightingKind>, 10> kNames = {
    {{"person", SightingKind::kPerson},
     {"people", SightingKind::kPerson},
     {"pedestrian", SightingKind::kPerson},
     {"face", SightingKind::kFace},
     {"mask", SightingKind::kFaceWithMask},
     {"with mask", SightingKind::kFaceWithMask},
     {"face mask", SightingKind::kFaceWithMask},
     {"no mask", SightingKind::kFaceWithoutMask},
     {"without mask", SightingKind::kFaceWithoutMask},
     {"face no mask", SightingKind::kFaceWithoutMask}}};

std::string Plain(std::string line) {
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) {
    line.pop_back();
  }
  for (char& c : line) {
    c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return line;
}

std::optional<SightingKind> KindOf(const std::string& name) {
  const auto* const found = std::find_if(kNames.begin(), kNames.end(),
                                         [&](const auto& known) { return known.first == name; });
  if (found == kNames.end()) return std::nullopt;
  return found->second;
}

}  // namespace

Expected<NetworkClasses> ParseClasses(const std::string& text) {
  NetworkClasses classes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!Plain(line).empty()) classes.push_back(KindOf(Plain(line)));
  }
  if (std::any_of(classes.begin(), classes.end(), [](const auto& kind) { return kind; })) {
    return classes;
  }
  std::string known;
  for (const auto& [name, kind] : kNames) known += std::string(known.empty() ? "" : ", ") + name;
  return Problem{"none of the " + std::to_string(classes.size()) +
                 " classes is of use; expected one a line, some of them " + known};
}

Expected<NetworkClasses> UsualClasses(int count) {
  if (count != 1 && count != kCoco) {
    return Problem{"the network has " + std::to_string(count) +
                   " classes, expected a file with their names"};
  }
  NetworkClasses classes(static_cast<std::size_t>(count));
  classes[0] = SightingKind::kPerson;
  return classes;
}

}  // namespace coppice::robot::perception
