// How the robot looks: what its face, lights, ears and arms show together. Implemented on ROS
// topics in robot_app/ros, and on test doubles. What each expression looks like is said by the
// table of robot_app/expression; trees only name it, and a wrong name is refused when they are
// loaded.
#ifndef COPPICE_BT_NODES_INTERACTION_EXPRESSION_H_
#define COPPICE_BT_NODES_INTERACTION_EXPRESSION_H_

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "bt_core/data/enum.h"

namespace coppice::leaves {

/// In the order of their importance: of those that are wanted at the same time the last one is
/// shown. Short answers to a person come before what lasts. Most names are those of the published
/// software of Sobi (LEDExpression).
enum class Expression : std::uint8_t {
  NEUTRAL,          ///< blinking ring eyes: nothing special
  SLEEP,            ///< charging
  GUIDING,          ///< leads somebody: looks along the way
  GREETING,         ///< has just met somebody
  LAUGHING,         ///< is happy: wiggles its ears
  ASKING_FOR_HELP,  ///< waits for a person who frees it
  SAD,              ///< cannot answer: lowers its ears
  PROCESS,          ///< thinks of the answer
  LISTENING,        ///< hears somebody: green, ears forward, wide eyes
  ERROR,            ///< does not work
};

/// All functions are called on the ticking thread of any tree and return at once.
class Face {
 public:
  virtual ~Face() = default;
  /// Looks like that until told otherwise.
  virtual void SetExpression(Expression expression) = 0;
  /// Wants an expression until Release, as often as it was wanted.
  virtual void Hold(Expression expression) = 0;
  virtual void Release(Expression expression) = 0;
};

}  // namespace coppice::leaves

template <>
struct coppice::ValueTraits<coppice::leaves::Expression>
    : coppice::EnumTraits<coppice::leaves::Expression> {
  static constexpr const char* kName = "Expression";
  static constexpr coppice::Enumerator kEnumerators[] = {
      {"NEUTRAL", 0},         {"SLEEP", 1}, {"GUIDING", 2}, {"GREETING", 3},  {"LAUGHING", 4},
      {"ASKING_FOR_HELP", 5}, {"SAD", 6},   {"PROCESS", 7}, {"LISTENING", 8}, {"ERROR", 9}};
};

namespace coppice::leaves {
inline constexpr std::size_t kExpressionCount = std::size(ValueTraits<Expression>::kEnumerators);
}

#endif  // COPPICE_BT_NODES_INTERACTION_EXPRESSION_H_
