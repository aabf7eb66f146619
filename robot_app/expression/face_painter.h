// Paints the frames of expressions for the LED matrix. Pure; any thread.
#ifndef COPPICE_ROBOT_APP_EXPRESSION_FACE_PAINTER_H_
#define COPPICE_ROBOT_APP_EXPRESSION_FACE_PAINTER_H_

#include "robot_app/common/picture.h"
#include "robot_app/expression/expression_table.h"

namespace coppice::robot::expression {

/// kFaceWidth x kFaceHeight pixels; what lies outside is cut off.
Picture PaintFace(const FaceFrame& frame);

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_FACE_PAINTER_H_
