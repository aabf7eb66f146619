// How well people are found in scans: who was missed, who was invented, by distance and by how much
// of them is hidden.
//
//   PeopleCount count;
//   for (...) count.Add(where_somebody_was_seen, truth);
//   std::fputs(Table(count.figures()).c_str(), stdout);
#ifndef COPPICE_ROBOT_APP_TRAINING_PEOPLE_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_PEOPLE_FIGURES_H_

#include <array>
#include <string>
#include <vector>

#include "robot_app/training/labelled_scan.h"

namespace coppice::robot::training {

/// How many people were there, and how many of them were not found.
struct Misses {
  int people = 0;
  int missed = 0;
  double share() const { return people > 0 ? static_cast<double>(missed) / people : 0; }
};

enum class Distance { kNear, kMiddle, kFar };         ///< up to 5 m, 10 m, 20 m
enum class Occlusion { kFree, kHalfHidden, kGroup };  ///< in full view; 30-70 %; groups of three

struct PeopleFigures {
  int scans = 0;
  std::array<std::array<Misses, 3>, 3> misses;  ///< by Distance, then Occlusion
  std::array<int, 3> false_people{};            ///< by Distance
  double position_error = 0;                    ///< root of mean square within 5 m [m]
  double seconds = 0;                           ///< to find people, all scans

  const Misses& of(Distance distance, Occlusion occlusion) const {
    return misses[static_cast<std::size_t>(distance)][static_cast<std::size_t>(occlusion)];
  }
  double false_per_scan() const;
};

class PeopleCount {
 public:
  /// A scan more: where somebody was seen in it, surest first, and who was there. Each is who is
  /// nearest within half a metre. Who is hidden by more than 70 % counts neither as missed nor as
  /// false.
  void Add(const std::vector<simulation::Vec2>& seen, const std::vector<PersonTruth>& people);
  /// What it took to look [s].
  void AddTime(double seconds) { figures_.seconds += seconds; }

  PeopleFigures figures() const;

 private:
  void AddSeen(simulation::Vec2 at, const std::vector<PersonTruth>& people,
               std::vector<bool>& found);

  PeopleFigures figures_;
  double squares_ = 0;  // of the positions' errors
  int near_ = 0;
};

/// A table for people, Markdown.
std::string Table(const PeopleFigures& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PEOPLE_FIGURES_H_
