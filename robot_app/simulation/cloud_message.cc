#include "robot_app/simulation/cloud_message.h"

#include <cstring>

namespace coppice::robot::simulation {
namespace {

using sensor_msgs::PointField;

constexpr std::uint32_t kRingOffset = 16;
constexpr std::uint32_t kTimeOffset = 18;
constexpr std::uint32_t kPointSize = 22;

PointField Field(const char* name, std::uint32_t offset, std::uint8_t type) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  return field;
}

}  // namespace

sensor_msgs::PointCloud2 ToMessage(const Cloud& cloud, int rings) {
  sensor_msgs::PointCloud2 message;
  message.height = static_cast<std::uint32_t>(rings);
  message.width = static_cast<std::uint32_t>(cloud.points.size()) / message.height;
  message.fields = {Field("x", 0, PointField::FLOAT32),
                    Field("y", 4, PointField::FLOAT32),
                    Field("z", 8, PointField::FLOAT32),
                    Field("intensity", 12, PointField::FLOAT32),
                    Field("ring", kRingOffset, PointField::UINT16),
                    Field("time", kTimeOffset, PointField::FLOAT32)};
  message.point_step = kPointSize;
  message.row_step = kPointSize * message.width;
  message.data.resize(std::size_t{message.row_step} * message.height);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const CloudPoint& point = cloud.points[i];
    const std::size_t column = i / message.height;
    std::uint8_t* const at = &message.data[(point.ring * message.width + column) * kPointSize];
    const float values[] = {point.x, point.y, point.z, point.intensity};
    std::memcpy(at, values, sizeof(values));
    std::memcpy(at + kRingOffset, &point.ring, sizeof(point.ring));
    std::memcpy(at + kTimeOffset, &point.time, sizeof(point.time));
  }
  return message;
}

}  // namespace coppice::robot::simulation
