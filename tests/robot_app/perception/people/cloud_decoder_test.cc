#include "robot_app/perception/people/cloud_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace coppice::robot::perception {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;
using testing::HasSubstr;

PointField Field(const char* name, std::uint32_t offset, std::uint8_t type) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  return field;
}

// As the driver of the Velodyne sends it, `points` in one row.
PointCloud2 Message(const std::vector<LidarPoint>& points) {
  PointCloud2 message;
  message.height = 1;
  message.width = static_cast<std::uint32_t>(points.size());
  message.point_step = 22;
  message.row_step = message.width * message.point_step;
  message.fields = {
      Field("x", 0, PointField::FLOAT32),    Field("y", 4, PointField::FLOAT32),
      Field("z", 8, PointField::FLOAT32),    Field("intensity", 12, PointField::FLOAT32),
      Field("ring", 16, PointField::UINT16), Field("time", 18, PointField::FLOAT32)};
  for (const LidarPoint& point : points) {
    std::uint8_t bytes[22] = {};
    const float numbers[] = {point.x, point.y, point.z, point.intensity};
    std::memcpy(bytes, numbers, sizeof(numbers));
    std::memcpy(bytes + 16, &point.ring, sizeof(point.ring));
    std::memcpy(bytes + 18, &point.time, sizeof(point.time));
    message.data.insert(message.data.end(), bytes, bytes + 22);
  }
  return message;
}

std::string ProblemOf(const PointCloud2& message) {
  std::vector<LidarPoint> points;
  return Decode(message, points).problem();
}

TEST(Decode, ReadsPlaceBrightnessAndRing) {
  std::vector<LidarPoint> points;
  ASSERT_TRUE(Decode(Message({{1, 2, 3, 40, 5}, {-1, -2, -3, 0, 15}}), points));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].y, 2);
  EXPECT_EQ(points[0].intensity, 40);
  EXPECT_EQ(points[1].z, -3);
  EXPECT_EQ(points[1].ring, 15);
}

TEST(Decode, ReadsWhenAPointWasMeasured) {
  PointCloud2 message = Message({{1, 2, 3, 40, 5, 0.05F}, {1, 2, 3, 40, 5, std::nanf("")}});
  std::vector<LidarPoint> points;
  ASSERT_TRUE(Decode(message, points));
  EXPECT_EQ(points[0].time, 0.05F);
  EXPECT_EQ(points[1].time, 0);
  message.fields.pop_back();
  ASSERT_TRUE(Decode(message, points));
  EXPECT_EQ(points[0].time, 0);
}

TEST(Decode, ACloudOfNoPointsIsNoProblem) {
  std::vector<LidarPoint> points{{}};
  EXPECT_TRUE(Decode(Message({}), points));
  EXPECT_TRUE(points.empty());
}

TEST(Decode, WithoutBrightnessItIsZero) {
  PointCloud2 message = Message({{1, 2, 3, 40, 5}});
  message.fields.erase(message.fields.begin() + 3);
  std::vector<LidarPoint> points;
  ASSERT_TRUE(Decode(message, points));
  EXPECT_EQ(points[0].intensity, 0);
}

TEST(Decode, NamesTheFieldThatIsMissingOrOfAnotherType) {
  PointCloud2 message = Message({{1, 2, 3, 40, 5}});
  message.fields[4].name = "Ring";
  EXPECT_THAT(ProblemOf(message), HasSubstr("no field \"ring\""));
  message = Message({{1, 2, 3, 40, 5}});
  message.fields[1].datatype = PointField::FLOAT64;
  EXPECT_THAT(ProblemOf(message), HasSubstr("\"y\" of the cloud has the type 8, expected 7"));
}

TEST(Decode, SizesThatDoNotAgreeAreAProblem) {
  PointCloud2 message = Message({{1, 2, 3, 40, 5}});
  message.width = 2;
  EXPECT_THAT(ProblemOf(message), HasSubstr("has 22 bytes"));
  message = Message({{1, 2, 3, 40, 5}});
  message.height = 0xFFFFFFFF;
  EXPECT_NE(ProblemOf(message), "");
  message = Message({{1, 2, 3, 40, 5}});
  message.point_step = 0;
  EXPECT_NE(ProblemOf(message), "");
}

TEST(Decode, MorePointsThanALidarMeasuresAreAProblem) {
  PointCloud2 message = Message({});
  message.width = 6'000'000;
  message.point_step = 4;  // all fields on one another: 24 MB become 144
  message.row_step = message.width * message.point_step;
  message.data.resize(message.row_step);
  for (PointField& field : message.fields) field.offset = 0;
  EXPECT_THAT(ProblemOf(message), HasSubstr("more than 1000000 points"));
}

TEST(Decode, AFieldOutsideItsPointIsAProblem) {
  PointCloud2 message = Message({{1, 2, 3, 40, 5}});
  message.fields[0].offset = 19;
  EXPECT_THAT(ProblemOf(message), HasSubstr("outside"));
  message.fields[0].offset = 0xFFFFFFFE;
  EXPECT_THAT(ProblemOf(message), HasSubstr("outside"));
}

TEST(Decode, AMessageWithAnythingInItIsReadInsideItsDataOrRefused) {
  std::mt19937 random(9);
  const PointCloud2 good = Message(std::vector<LidarPoint>(20, {1, 2, 3, 4, 5}));
  for (int round = 0; round < 20000; ++round) {
    PointCloud2 message = good;
    for (int change = 0; change < 2; ++change) {
      const std::uint32_t value = random() % 3 == 0 ? random() : random() % 64;
      PointField& field = message.fields[random() % message.fields.size()];
      switch (random() % 7) {
        case 0:
          message.width = value;
          break;
        case 1:
          message.height = value;
          break;
        case 2:
          message.point_step = value;
          break;
        case 3:
          message.row_step = value;
          break;
        case 4:
          field.offset = value;
          break;
        case 5:
          field.datatype = static_cast<std::uint8_t>(value);
          break;
        default:
          message.data.resize(value % 2000);
      }
    }
    std::vector<LidarPoint> points;
    const Outcome outcome = Decode(message, points);
    EXPECT_TRUE(outcome || points.empty());
    EXPECT_LE(points.size(), message.data.size());
  }
}

}  // namespace
}  // namespace coppice::robot::perception
