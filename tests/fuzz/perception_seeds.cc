#include "tests/fuzz/perception_seeds.h"

#include <sensor_msgs/PointField.h>

#include <cstdint>

#include "robot_app/common/compressed_picture.h"

namespace coppice::fuzz {
namespace {

using sensor_msgs::PointField;

constexpr std::uint32_t kStep = 18;  // bytes of a point
constexpr std::uint32_t kPoints = 40;

template <class Number>
void Append(Number number, std::string& out) {
  out.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void AppendField(char name, std::uint32_t offset, std::uint8_t type, std::string& out) {
  Append(name, out);
  Append(offset, out);
  Append(type, out);
  Append(std::uint32_t{1}, out);
}

}  // namespace

std::string SomeCloud() {
  std::string bytes;
  for (const std::uint32_t number : {kPoints, 1U, kStep, kPoints * kStep}) Append(number, bytes);
  Append(std::uint8_t{0}, bytes);
  Append(std::uint8_t{5}, bytes);
  AppendField('x', 0, PointField::FLOAT32, bytes);
  AppendField('y', 4, PointField::FLOAT32, bytes);
  AppendField('z', 8, PointField::FLOAT32, bytes);
  AppendField('i', 12, PointField::FLOAT32, bytes);
  AppendField('r', 16, PointField::UINT16, bytes);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    for (const float number : {3.0F, 0.1F * static_cast<float>(i), 0.5F, 40.0F}) {
      Append(number, bytes);
    }
    Append(static_cast<std::uint16_t>(i % 16), bytes);
  }
  return bytes;
}

std::string SomeColourPicture() {
  robot::Picture picture(24, 16);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = i % 251;
  const auto jpeg = robot::EncodeJpeg(picture);
  return "J" + std::string(jpeg.begin(), jpeg.end());
}

std::string SomeDepthPicture() {
  robot::DepthPicture picture(24, 16);
  for (std::size_t i = 0; i < picture.millimetres.size(); ++i) picture.millimetres[i] = 900 + 7 * i;
  const auto png = robot::EncodeDepth(picture);
  return "D" + std::string(png.begin(), png.end());
}

}  // namespace coppice::fuzz
