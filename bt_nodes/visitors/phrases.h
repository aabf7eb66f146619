// What trees say to visitors, in the language that they speak. Trees name a phrase; a wrong name is
// refused when they are loaded, and a phrase that the site's file lacks when the robot starts.
#ifndef COPPICE_BT_NODES_VISITORS_PHRASES_H_
#define COPPICE_BT_NODES_VISITORS_PHRASES_H_

#include <cstdint>
#include <string>

#include "bt_core/data/enum.h"

namespace coppice::leaves {

enum class Phrase : std::uint8_t {
  GREETING,       ///< by the time of day
  LEAD_ON,        ///< the robot drives ahead
  ARE_YOU_THERE,  ///< nobody follows any more
  THERE_YOU_ARE,  ///< somebody does again
  LOST_YOU,       ///< gives up, as nobody follows
  NO_WAY,         ///< gives up, as no way leads there
  MUST_CHARGE,    ///< cannot guide, as it must charge
  ARRIVED,        ///< at the place
  FAREWELL,
};

/// Called on the ticking thread; returns at once.
class Phrases {
 public:
  virtual ~Phrases() = default;
  /// With `about` where the phrase has {about}. In the first language if it has no such one.
  virtual std::string Text(Phrase phrase, const std::string& language,
                           const std::string& about) = 0;
};

}  // namespace coppice::leaves

template <>
struct coppice::ValueTraits<coppice::leaves::Phrase>
    : coppice::EnumTraits<coppice::leaves::Phrase> {
  static constexpr const char* kName = "Phrase";
  static constexpr coppice::Enumerator kEnumerators[] = {
      {"GREETING", 0},      {"LEAD_ON", 1},  {"ARE_YOU_THERE", 2},
      {"THERE_YOU_ARE", 3}, {"LOST_YOU", 4}, {"NO_WAY", 5},
      {"MUST_CHARGE", 6},   {"ARRIVED", 7},  {"FAREWELL", 8}};
};

#endif  // COPPICE_BT_NODES_VISITORS_PHRASES_H_
