#include "robot_app/deployment/figures/journal.h"

#include <array>

namespace coppice::robot::deployment {

const char* ToString(Activity activity) {
  constexpr std::array<const char*, kActivities> kNames = {
      "full", "charging", "no current", "moving", "recovering", "asking", "off"};
  return kNames[static_cast<std::size_t>(activity)];
}

bool IsUndocked(Activity activity) {
  return activity == Activity::kMoving || activity == Activity::kRecovering ||
         activity == Activity::kAsking;
}

}  // namespace coppice::robot::deployment
