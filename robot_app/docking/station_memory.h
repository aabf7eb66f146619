// Where the station stands on the map: where it was seen when the robot docked last, kept in a
// file, or else where the map of places says. Whoever has moved the station by more than a step
// says so there, and is believed. Not for several threads, but for Save.
#ifndef COPPICE_ROBOT_APP_DOCKING_STATION_MEMORY_H_
#define COPPICE_ROBOT_APP_DOCKING_STATION_MEMORY_H_

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::docking {

class StationMemory {
 public:
  /// `prior`: base_link when docked, in the map frame, as in the map of places. `file`: one line "x
  /// y yaw"; "none": what is learnt is forgotten with the program. One that is missing or broken,
  /// or lies farther than 1.5 m from the prior, does not count.
  StationMemory(const std::optional<Pose2D>& prior, std::string file);

  /// base_link when docked, in the map frame.
  const std::optional<Pose2D>& station() const { return station_; }

  /// The robot has docked, and has seen it there. True if the file is to say so, too: if the
  /// station has moved by a centimetre or half a degree since that was written.
  bool Learn(const Pose2D& station);

  /// Replaces the file as a whole. Waits for the disk; any thread. A problem if it cannot.
  Outcome Save(const Pose2D& station) const;

  /// So the file says now.
  void HasSaved(const Pose2D& station) { kept_ = station; }

 private:
  std::optional<Pose2D> station_;
  std::optional<Pose2D> kept_;  // in the file
  const std::string file_;
};

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_STATION_MEMORY_H_
