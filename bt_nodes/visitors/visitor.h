// What visitors want of the robot: a value on the blackboard, fed from what they say and touch. The
// understanding lies elsewhere (robot_app/knowledge); trees see only what they act on.
#ifndef COPPICE_BT_NODES_VISITORS_VISITOR_H_
#define COPPICE_BT_NODES_VISITORS_VISITOR_H_

#include <string>
#include <string_view>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"

namespace coppice::leaves {

struct Visitor {
  Time heard{};       ///< of the tree's clock: last said, touched or answered; zero: never
  int touches = 0;    ///< how often somebody began to use the display
  int request = 0;    ///< number of the wish to be guided; 0: there is none
  Time asked{};       ///< when that was said, of the tree's clock
  std::string place;  ///< where to: its name on the map of places
  std::string language = "en";  ///< that visitors speak: en, de
};

/// What trees tell of visitors' wishes. Called on the ticking thread; returns at once.
class Visitors {
 public:
  virtual ~Visitors() = default;
  /// The wish has been dealt with, and no tree sees it any more. `outcome`, for people and records:
  /// "arrived", "lost", "blocked" ... Nothing happens if it is not the wish of now.
  virtual void Settle(int request, const std::string& outcome) = 0;
};

}  // namespace coppice::leaves

/// Text form: JSON, {"heard":NS,"touches":0,"request":3,"asked":NS,"place":"...","language":"en"}.
template <>
struct coppice::ValueTraits<coppice::leaves::Visitor> {
  static constexpr const char* kName = "Visitor";
  static bool Parse(std::string_view text, leaves::Visitor& out);
  static std::string Print(const leaves::Visitor& value);
};

#endif  // COPPICE_BT_NODES_VISITORS_VISITOR_H_
