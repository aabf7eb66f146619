#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

#include "robot_app/perception/people/cloud_decoder.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

using robot::perception::LidarPoint;

// Takes numbers from the front of the bytes; zeros behind their end.
class Front {
 public:
  explicit Front(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  Number Take() {
    Number number{};
    const std::size_t size = std::min(sizeof(number), bytes_.size());
    std::memcpy(&number, bytes_.data(), size);
    bytes_.remove_prefix(size);
    return number;
  }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

std::string NameOf(char letter) {
  switch (letter) {
    case 'r':
      return "ring";
    case 'i':
      return "intensity";
    default:
      return std::string(1, letter);
  }
}

sensor_msgs::PointCloud2 MessageOf(std::string_view bytes) {
  Front front(bytes);
  sensor_msgs::PointCloud2 message;
  message.width = front.Take<std::uint32_t>();
  message.height = front.Take<std::uint32_t>();
  message.point_step = front.Take<std::uint32_t>();
  message.row_step = front.Take<std::uint32_t>();
  message.is_bigendian = front.Take<std::uint8_t>();
  message.fields.resize(front.Take<std::uint8_t>() % 8);
  for (sensor_msgs::PointField& field : message.fields) {
    field.name = NameOf(front.Take<char>());
    field.offset = front.Take<std::uint32_t>();
    field.datatype = front.Take<std::uint8_t>();
    field.count = front.Take<std::uint32_t>();
  }
  message.data.assign(front.rest().begin(), front.rest().end());
  return message;
}

}  // namespace

int FuzzCloud(std::string_view bytes) {
  const sensor_msgs::PointCloud2 message = MessageOf(bytes);
  std::vector<LidarPoint> points(1);
  if (!robot::perception::Decode(message, points)) {
    if (!points.empty()) std::abort();
    return 0;
  }
  if (points.size() > message.data.size()) std::abort();
  robot::perception::RangeImage image;
  const std::size_t kept = robot::perception::FillRangeImage(points, {}, image);
  if (kept > points.size() || kept > image.size()) std::abort();
  return kept > 0 ? 2 : 1;
}

}  // namespace coppice::fuzz
