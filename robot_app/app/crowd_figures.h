// How crowded and how lively the surroundings of a robot are, from what perception told in a run:
// the measure of the paper (row S111).
#ifndef COPPICE_ROBOT_APP_APP_CROWD_FIGURES_H_
#define COPPICE_ROBOT_APP_APP_CROWD_FIGURES_H_

#include <coppice_msgs/People.h>

#include <cstdint>
#include <map>
#include <string>

namespace coppice::robot {

struct CrowdFigures {
  int looks = 0;            ///< messages of /people
  int most = 0;             ///< people seen at once
  std::int64_t seen = 0;    ///< people, of all looks together
  std::int64_t moving = 0;  ///< of them faster than 0.3 m/s
  /// Everybody who was followed so far, by number: coppice_msgs/Person::mask, as it was known last.
  std::map<std::uint32_t, std::uint8_t> masks;

  /// Who is only remembered, unseen for half a second, counts as followed, but not as seen.
  void Add(const coppice_msgs::People& people);

  double crowd() const;       ///< people seen at once, in the mean
  double liveliness() const;  ///< share of them that moves, 0..1
};

/// A line for people: who was followed, faces with and without mask, how crowded and how lively.
std::string ToText(const CrowdFigures& figures);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_CROWD_FIGURES_H_
