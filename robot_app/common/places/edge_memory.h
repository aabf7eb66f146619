// What a robot has learnt of the edges of its map by travelling them: how long each takes, and
// which could not be passed lately. Kept in a file, so that it outlives the program.
//
// A blocked edge is not forgotten as a way: for a day it costs an hour more, so that it is taken
// only where there is no other. Who gets through unblocks it.
//
// The idea of learning times per edge from long runs: N. Hawes et al., The STRANDS Project, IEEE
// Robotics & Automation Magazine 24 (2017). Not for several threads.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_EDGE_MEMORY_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_EDGE_MEMORY_H_

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"
#include "robot_app/common/places/topological_map.h"

namespace coppice::robot {

/// Of one edge, in its direction.
struct EdgeRecord {
  int trips = 0;         ///< that ended well
  int failures = 0;      ///< that did not
  double seconds = 0;    ///< what a trip takes: the mean of about the last 20; 0: no trip yet
  Time blocked_until{};  ///< Time{}: not blocked
};

class EdgeMemory {
 public:
  explicit EdgeMemory(const TopologicalMap& map);

  /// The edges, one behind the other, were travelled within so many seconds. What each took is
  /// estimated by what was expected of it. With `whole` false only a part of the first was
  /// travelled: nothing is learnt of times, but the edges are open.
  void Travelled(const std::vector<int>& edges, double seconds, bool whole = true);
  /// The edge could not be passed: blocked for a day, in both directions.
  void Failed(int edge, Time now);

  /// What the robot goes out of its way rather than to try the edge [s]; 0: it is not blocked.
  double Detour(int edge, Time now) const;
  /// What each edge costs now, with that [s].
  std::vector<double> Costs(Time now) const;
  const std::vector<EdgeRecord>& records() const { return records_; }
  /// What a trip takes as long as nobody has made one [s].
  const std::vector<double>& expected() const { return expected_; }

  /// As a file of YAML, an edge a line, and back. Edges that the map no longer has are forgotten. A
  /// file that is missing is no problem, one that is broken is told, and what is good of it used.
  /// `now`: blocks that reach farther than a day ahead are of another clock and count no more.
  std::string ToText() const;
  void Read(const std::string& path, Time now, Diagnostics& diagnostics);

 private:
  std::vector<std::string> names_;  // of the edges
  std::vector<int> opposite_;       // edge the other way; -1: none
  std::vector<double> expected_;    // [s]
  std::vector<EdgeRecord> records_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_EDGE_MEMORY_H_
