// The topological map: the places of a site, what people call them, and how one gets from one to
// the next (Stuede et al., ECMR 2021, section II-C2: nodes are relevant locations or waypoints,
// edges are driven directly or by a planner of their own). One file per site:
//
//   site: institute
//   places:
//     - name: hall                      # what trees call it
//       x: 46                           # in the map frame [m, rad]
//       y: 0
//       yaw: 0
//       tolerance: 0.3                  # near enough to count as being there [m]
//       categories: [hall, patrol]
//       called: {en: [entrance hall, lobby], de: [Eingangshalle]}   # the first is what is said
//     - name: charging_station
//       x: -2.4
//       y: 0
//       yaw: 3.1416
//       categories: [station]
//     - name: office_301                # no position: elsewhere, people can only be told
//       categories: [office]
//   edges:
//     - {from: hall, to: charging_station, by: dock}
//     - {from: hall, to: office_301, by: elsewhere, words: {en: Take the stairs.}}
//
// `patrol` and `station` are categories that mean something to the robot: where a patrol goes, and
// base_link on the charging station. All others are for who asks for "the nearest restroom".
// Immutable once loaded; any thread.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_TOPOLOGICAL_MAP_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_TOPOLOGICAL_MAP_H_

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

/// A text in one language: an ISO 639-1 code ("en", "de") and the words.
struct Wording {
  std::string language;
  std::string text;
};

struct Place {
  std::string name;
  std::optional<Pose2D> pose;  ///< in the map frame; none: not on this map
  double tolerance = 0.3;      ///< near enough to count as being there [m]
  std::vector<std::string> categories;
  std::vector<Wording> called;  ///< of each language what is said comes first, then synonyms

  bool Is(const std::string& category) const;
  /// What the robot calls it: in that language, else in any, else its name with blanks for "_".
  std::string Spoken(const std::string& language) const;
};

/// How an edge is travelled. A door is waited for and asked to be opened; elsewhere is not
/// travelled but told.
enum class EdgeKind : std::uint8_t { kDrive, kDoor, kDock, kUndock, kElsewhere };

/// "drive", "door", "dock", "undock", "elsewhere", as in the file.
const char* ToString(EdgeKind kind);

struct Edge {
  int from = 0;  ///< indices of places
  int to = 0;
  EdgeKind kind = EdgeKind::kDrive;
  std::vector<Wording> words;  ///< what people are told; of kElsewhere
};

class TopologicalMap {
 public:
  /// Reads a file. Every problem is added to `diagnostics` with file and line; nothing is returned
  /// if there was an error.
  static std::optional<TopologicalMap> Load(const std::string& path, Diagnostics& diagnostics);

  /// Of the building or the campus; may be empty.
  const std::string& site() const { return site_; }
  const std::vector<Place>& places() const { return places_; }
  const std::vector<Edge>& edges() const { return edges_; }
  std::vector<std::string> Names() const;

  /// Index of the place of that name, or -1.
  int Find(const std::string& name) const;
  /// Index of the first place of the category, or -1.
  int FirstOf(const std::string& category) const;
  /// Index of the edge, or -1.
  int FindEdge(int from, int to) const;
  /// "hall -> hall_north".
  std::string NameOf(const Edge& edge) const;

  /// Index of the place on this map that is nearest to the pose as the crow flies; -1: there is
  /// none.
  int Nearest(const Pose2D& pose) const;

  /// A random place of the category on this map, all with the same chance, but not `last` unless it
  /// is the only one. -1 if there is none. The same generator state gives the same choice
  /// everywhere.
  int ChooseNext(std::mt19937& random, int last, const std::string& category = "patrol") const;

 private:
  std::string site_;
  std::vector<Place> places_;
  std::vector<Edge> edges_;
};

/// In that language, else in any; empty if there is none.
std::string WordsIn(const std::vector<Wording>& words, const std::string& language);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_TOPOLOGICAL_MAP_H_
