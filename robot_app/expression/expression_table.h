// What each expression looks like: the LED matrix of the face (64 x 32 pixels), the strips in arms
// and ears, and where ears and arms stand. Data of a file; the shipped one is expressions.yaml,
// which explains the form.
//
//   Diagnostics diagnostics;
//   const ExpressionTable table = ReadExpressions("expressions.yaml", diagnostics);
//   if (!diagnostics.has_errors()) PaintFace(table[Expression::SAD].face[0]);
#ifndef COPPICE_ROBOT_APP_EXPRESSION_EXPRESSION_TABLE_H_
#define COPPICE_ROBOT_APP_EXPRESSION_EXPRESSION_TABLE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_nodes/interaction/expression.h"
#include "robot_app/common/picture.h"

namespace coppice::robot::expression {

using leaves::Expression;

inline constexpr int kFaceWidth = 64;   ///< pixels
inline constexpr int kFaceHeight = 32;  ///< pixels

enum class ShapeKind : std::uint8_t { kRing, kDisc, kArc, kLine };

/// In pixels. Of an eye: from its middle, x away from the nose, y down. Else from the upper left
/// corner of the face.
struct Shape {
  ShapeKind kind = ShapeKind::kRing;
  /// ring: x y rx ry width; disc: x y radius; arc: x y radius width from to [deg, from x towards
  /// y]; line: x1 y1 x2 y2 width.
  std::array<double, 6> numbers{};
  Colour colour{};
};

struct FaceFrame {
  double seconds = 1;
  std::array<double, 2> look{};  ///< both eyes are moved by that [pixels]: x to the right, y down
  std::vector<Shape> eyes;       ///< drawn for both, the left one mirrored
  std::vector<Shape> also;
};

/// The colours fade into those of the next step.
struct LightStep {
  double seconds = 1;
  Colour arms{};
  Colour ears{};
};

/// Joints of the robot, in this order.
inline constexpr std::array<const char*, 4> kLimbs{"left_ear_joint", "right_ear_joint",
                                                   "left_arm_joint", "right_arm_joint"};
using LimbAngles = std::array<double, kLimbs.size()>;  ///< [rad]

struct LimbStep {
  double seconds = 1;
  LimbAngles angles{};
};

/// Each of the three begins anew when its last step is over; none is empty.
struct Appearance {
  std::vector<FaceFrame> face;
  std::vector<LightStep> lights;
  std::vector<LimbStep> limbs;
};

class ExpressionTable {
 public:
  Appearance& operator[](Expression expression) {
    return rows_[static_cast<std::size_t>(expression)];
  }
  const Appearance& operator[](Expression expression) const {
    return rows_[static_cast<std::size_t>(expression)];
  }

 private:
  std::array<Appearance, leaves::kExpressionCount> rows_;
};

/// All problems of the file at once; an expression that it does not have is one.
ExpressionTable ReadExpressions(const std::string& path, Diagnostics& diagnostics);

/// What is shown at a time since the expression began [s].
const FaceFrame& FaceAt(const Appearance& appearance, double seconds);
LightStep LightsAt(const Appearance& appearance, double seconds);
const LimbAngles& LimbsAt(const Appearance& appearance, double seconds);

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_EXPRESSION_TABLE_H_
