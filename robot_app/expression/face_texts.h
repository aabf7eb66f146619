// Expressions for people: in a terminal, and all of them on one picture. Pure; any thread.
#ifndef COPPICE_ROBOT_APP_EXPRESSION_FACE_TEXTS_H_
#define COPPICE_ROBOT_APP_EXPRESSION_FACE_TEXTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/expression/expression_table.h"

namespace coppice::robot::expression {

/// Two rows of pixels are one line of half blocks in 24-bit colours (ECMA-48).
std::string TerminalText(const Picture& face);

/// A row for each expression: its first frames as the LED matrix shows them, with the strips at the
/// time below, and where ears and arms are told to be.
Picture Overview(const ExpressionTable& table);

/// Empty for a picture without pixels.
std::vector<std::uint8_t> EncodePng(const Picture& picture);

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_FACE_TEXTS_H_
