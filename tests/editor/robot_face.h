// What a robot of the tests shows to people: ring eyes on an LED matrix, and strips of light.
#ifndef COPPICE_TESTS_EDITOR_ROBOT_FACE_H_
#define COPPICE_TESTS_EDITOR_ROBOT_FACE_H_

#include <algorithm>
#include <cmath>
#include <string>

#include "bt_core/live/pictures/picture_set.h"

namespace coppice::editor {

/// 64 x 32 pixels.
inline LivePicture RingEyes(const std::string& text) {
  LivePicture face{"face", text, 64, 32, {}};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double to_eye = std::hypot((x % 32) - 15.5, y - 15.5);
      const double lit = std::clamp(2.25 - std::abs(to_eye - 10), 0.0, 1.0);
      for (const int full : {0x48, 0xc8, 0xff}) {
        face.rgb.push_back(static_cast<std::uint8_t>(lit * full));
      }
    }
  }
  return face;
}

inline LivePicture Strip(const std::string& name, const std::string& text) {
  return {name, text, 1, 1, {0x20, 0xe0, 0x40}};
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_ROBOT_FACE_H_
