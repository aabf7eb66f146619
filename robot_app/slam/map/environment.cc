#include "robot_app/slam/map/environment.h"

#include <algorithm>
#include <vector>

#include "bt_core/model/utf8.h"

namespace coppice::robot::slam {
namespace {

constexpr std::array<const char*, 3> kNames = {"indoor", "hall", "outdoor"};
constexpr std::size_t kLongestTold = 60;  // bytes of what somebody asks for

}  // namespace

const char* NameOf(Surroundings surroundings) {
  return kNames[static_cast<std::size_t>(surroundings)];
}

Expected<std::optional<Surroundings>> AskedSurroundings(const std::string& text) {
  if (text == "auto") return std::optional<Surroundings>();
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (text == kNames[i]) return std::optional(static_cast<Surroundings>(i));
  }
  return Problem{"surroundings: expected auto, indoor, hall or outdoor, not \"" +
                 PlainText(text, kLongestTold) + "\""};
}

SlamConfiguration ConfigurationFor(Surroundings surroundings) {
  switch (surroundings) {
    case Surroundings::kIndoor:
      return {surroundings, 8, true};
    case Surroundings::kHall:
      return {surroundings, 15, false};
    case Surroundings::kOutdoor:
      return {surroundings, 40, false};
  }
  return {};
}

EnvironmentReading Read(const CloudDescriptor& cloud, double brightness) {
  std::vector<float> walls;
  for (const float range : cloud.contour) {
    if (range > 0) walls.push_back(range);
  }
  EnvironmentReading reading;
  reading.brightness = brightness;
  reading.open = 1 - static_cast<double>(walls.size()) / kSectors;
  if (walls.empty()) return reading;
  const auto middle = walls.begin() + static_cast<std::ptrdiff_t>(walls.size() / 2);
  std::nth_element(walls.begin(), middle, walls.end());
  reading.walls = *middle;
  return reading;
}

// What it was until now decides between the limits.
Surroundings Environment::Judge(const EnvironmentReading& reading) const {
  const bool was_outdoor = judged_ == Surroundings::kOutdoor;
  const bool was_hall = judged_ == Surroundings::kHall;
  if (!is_dark() && reading.open > (was_outdoor ? settings_.closed : settings_.open)) {
    return Surroundings::kOutdoor;
  }
  return reading.walls > (was_hall ? settings_.indoor : settings_.hall) ? Surroundings::kHall
                                                                        : Surroundings::kIndoor;
}

void Environment::Add(double stamp, const EnvironmentReading& reading) {
  reading_ = reading;
  const Surroundings now = Judge(reading);
  if (!judged_ || now == *judged_) {
    judged_ = now;
    other_ = now;
    return;
  }
  if (now != other_ || stamp < since_) {  // or time was set back
    other_ = now;
    since_ = stamp;
  }
  if (stamp - since_ >= settings_.patience) judged_ = now;
}

}  // namespace coppice::robot::slam
