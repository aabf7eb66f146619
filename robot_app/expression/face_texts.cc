#include "robot_app/expression/face_texts.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "robot_app/expression/face_painter.h"

namespace coppice::robot::expression {
namespace {

constexpr int kShown = 3;       // frames of each expression
constexpr int kScale = 4;       // pixels of the picture for one of the matrix
constexpr int kGap = 12;        // pixels
constexpr int kTitle = 180;     // pixels, left of the frames
constexpr int kStrip = 8;       // pixels, height of the strips
constexpr double kLeast = 0.2;  // a frame that is shorter is left out, if another is not [s]
const cv::Scalar kInk(225, 225, 225), kPaper(24, 24, 28);

std::string Ansi(int layer, const Colour& colour) {
  char text[32];
  std::snprintf(text, sizeof(text), "\x1b[%d;2;%d;%d;%dm", layer, colour[0], colour[1], colour[2]);
  return text;
}

// When the first frames of an expression are half over [s].
std::vector<double> ShownTimes(const Appearance& appearance) {
  const std::vector<FaceFrame>& face = appearance.face;
  const auto is_long = [](const FaceFrame& frame) { return frame.seconds >= kLeast; };
  const bool shows_all =
      face.size() > 2 * kShown || std::none_of(face.begin(), face.end(), is_long);
  std::vector<double> times;
  double begin = 0;
  for (const FaceFrame& frame : face) {
    const bool is_shown = shows_all || is_long(frame);
    if (is_shown && times.size() < kShown) times.push_back(begin + frame.seconds / 2);
    begin += frame.seconds;
  }
  return times;
}

class Sheet {
 public:
  explicit Sheet(int rows)
      : canvas_(rows * kRow + kGap, kTitle + kShown * (kFaceWidth * kScale + kGap), CV_8UC3,
                kPaper) {}

  void Draw(int row, const std::string& name, const Appearance& appearance) {
    const int top = kGap + row * kRow;
    Write(name, top + 40, 0.5);
    const std::vector<double> times = ShownTimes(appearance);
    char limbs[64];
    const LimbAngles& angles = LimbsAt(appearance, times[0]);
    std::snprintf(limbs, sizeof(limbs), "ears %.1f %.1f", angles[0], angles[1]);
    Write(limbs, top + 64, 0.4);
    std::snprintf(limbs, sizeof(limbs), "arms %.1f %.1f", angles[2], angles[3]);
    Write(limbs, top + 82, 0.4);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const int left = kTitle + static_cast<int>(i) * (kFaceWidth * kScale + kGap);
      DrawFace(PaintFace(FaceAt(appearance, times[i])), left, top);
      const LightStep lights = LightsAt(appearance, times[i]);
      const int half = kFaceWidth * kScale / 2;
      const int below = top + kFaceHeight * kScale + 3;
      Fill({left, below, half - 2, kStrip}, lights.ears);
      Fill({left + half + 2, below, half - 2, kStrip}, lights.arms);
    }
  }

  Picture picture() const {
    Picture picture(canvas_.cols, canvas_.rows);
    std::copy(canvas_.datastart, canvas_.dataend, picture.rgb.begin());
    return picture;
  }

 private:
  static constexpr int kRow = kFaceHeight * kScale + kStrip + kGap + 6;

  void Write(const std::string& text, int y, double size) {
    cv::putText(canvas_, text, {kGap, y}, cv::FONT_HERSHEY_SIMPLEX, size, kInk, 1, cv::LINE_AA);
  }
  void Fill(const cv::Rect& area, const Colour& colour) {
    cv::rectangle(canvas_, area, cv::Scalar(colour[0], colour[1], colour[2]), cv::FILLED);
  }
  // With gaps between the pixels, as LEDs have them.
  void DrawFace(const Picture& face, int left, int top) {
    Fill({left, top, kFaceWidth * kScale, kFaceHeight * kScale}, {0, 0, 0});
    for (int y = 0; y < face.height; ++y) {
      for (int x = 0; x < face.width; ++x) {
        Fill({left + x * kScale, top + y * kScale, kScale - 1, kScale - 1}, face.at(x, y));
      }
    }
  }

  cv::Mat canvas_;
};

}  // namespace

std::string TerminalText(const Picture& face) {
  std::string text;
  for (int row = 0; row + 1 < face.height; row += 2) {
    for (int column = 0; column < face.width; ++column) {
      text += Ansi(38, face.at(column, row)) + Ansi(48, face.at(column, row + 1)) + "▀";
    }
    text += "\x1b[0m\n";
  }
  return text;
}

Picture Overview(const ExpressionTable& table) {
  Sheet sheet(leaves::kExpressionCount);
  int row = 0;
  for (const Enumerator& one : ValueTraits<Expression>::kEnumerators) {
    sheet.Draw(row++, std::string(one.name), table[static_cast<Expression>(one.value)]);
  }
  return sheet.picture();
}

std::vector<std::uint8_t> EncodePng(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> bytes(size);
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr)) {
    return {};
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace coppice::robot::expression
