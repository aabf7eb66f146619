#include "robot_app/perception/people/cloud_decoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace coppice::robot::perception {
namespace {

constexpr std::uint64_t kMostPoints = 1'000'000;  // four times those of the largest lidars

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

std::size_t SizeOf(std::uint8_t type) {
  switch (type) {
    case PointField::UINT8:
      return 1;
    case PointField::UINT16:
      return 2;
    case PointField::UINT32:
    case PointField::FLOAT32:
      return 4;
    default:
      return 0;  // not for us
  }
}

// A field of a point: where its bytes are.
struct Field {
  std::size_t offset = 0;
  std::uint8_t type = 0;

  double Read(const std::uint8_t* point) const {
    const std::uint8_t* at = point + offset;
    switch (type) {
      case PointField::UINT8:
        return *at;
      case PointField::UINT16:
        return Copy<std::uint16_t>(at);
      case PointField::UINT32:
        return Copy<std::uint32_t>(at);
      default:
        return Copy<float>(at);
    }
  }

 private:
  template <typename Number>
  static Number Copy(const std::uint8_t* at) {
    Number number;
    std::memcpy(&number, at, sizeof(number));
    return number;
  }
};

using Types = std::vector<std::uint8_t>;

Expected<Field> FindField(const PointCloud2& message, const std::string& name,
                          const Types& allowed) {
  const auto found = std::find_if(message.fields.begin(), message.fields.end(),
                                  [&](const PointField& field) { return field.name == name; });
  if (found == message.fields.end()) return Problem{"the cloud has no field \"" + name + "\""};
  if (std::find(allowed.begin(), allowed.end(), found->datatype) == allowed.end()) {
    return Problem{"the field \"" + name + "\" of the cloud has the type " +
                   std::to_string(found->datatype) + ", expected " + std::to_string(allowed[0])};
  }
  if (std::uint64_t{found->offset} + SizeOf(found->datatype) > message.point_step) {
    return Problem{"the field \"" + name + "\" of the cloud lies outside its points"};
  }
  return Field{found->offset, found->datatype};
}

Outcome CheckSizes(const PointCloud2& message) {
  if (message.is_bigendian != 0) return Problem{"the cloud has the bytes in the other order"};
  const std::uint64_t row = std::uint64_t{message.width} * message.point_step;
  // Two numbers of 32 bits: their product fits.
  if (message.row_step < row ||
      message.data.size() < std::uint64_t{message.row_step} * message.height) {
    return Problem{"the cloud says " + std::to_string(message.width) + " x " +
                   std::to_string(message.height) + " points of " +
                   std::to_string(message.point_step) + " bytes and has " +
                   std::to_string(message.data.size()) + " bytes"};
  }
  if (std::uint64_t{message.width} * message.height > kMostPoints) {
    return Problem{"the cloud has more than " + std::to_string(kMostPoints) + " points"};
  }
  return {};
}

float FiniteOrZero(float number) { return std::isfinite(number) ? number : 0; }

}  // namespace

Outcome Decode(const PointCloud2& message, std::vector<LidarPoint>& points) {
  points.clear();
  if (const Outcome sizes = CheckSizes(message); !sizes) return sizes;
  if (message.width == 0 || message.height == 0) return {};
  const Types number{PointField::FLOAT32};
  const auto x = FindField(message, "x", number);
  const auto y = FindField(message, "y", number);
  const auto z = FindField(message, "z", number);
  const auto ring =
      FindField(message, "ring", {PointField::UINT16, PointField::UINT8, PointField::UINT32});
  for (const auto* field : {&x, &y, &z, &ring}) {
    if (!*field) return Problem{field->problem()};
  }
  const auto intensity = FindField(message, "intensity", {PointField::FLOAT32, PointField::UINT8});
  const auto time = FindField(message, "time", number);

  points.reserve(std::size_t{message.width} * message.height);
  for (std::size_t row = 0; row < message.height; ++row) {
    const std::uint8_t* point = message.data.data() + row * message.row_step;
    for (std::size_t i = 0; i < message.width; ++i, point += message.point_step) {
      points.push_back({static_cast<float>(x->Read(point)), static_cast<float>(y->Read(point)),
                        static_cast<float>(z->Read(point)),
                        intensity ? static_cast<float>(intensity->Read(point)) : 0,
                        static_cast<std::uint16_t>(std::min(ring->Read(point), 65535.0)),
                        time ? FiniteOrZero(static_cast<float>(time->Read(point))) : 0});
    }
  }
  return {};
}

}  // namespace coppice::robot::perception
