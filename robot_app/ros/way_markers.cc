#include "robot_app/ros/way_markers.h"

#include <cmath>
#include <cstdio>

namespace coppice::robot::adapters {
namespace {

constexpr double kAside = 0.15;  // of a line from that between the places [m]
constexpr double kWords = 0.3;   // height of the words [m], and as far beside the line
constexpr double kSlow = 1.3;    // times what was expected

struct Colour {
  float red, green, blue;
};
constexpr Colour kUnknown{0.6F, 0.6F, 0.6F}, kUsual{0.2F, 0.75F, 0.3F}, kLate{0.95F, 0.6F, 0.1F},
    kBlocked{0.9F, 0.2F, 0.15F};

std_msgs::ColorRGBA ToMessage(const Colour& colour) {
  std_msgs::ColorRGBA message;
  message.r = colour.red;
  message.g = colour.green;
  message.b = colour.blue;
  message.a = 1;
  return message;
}

double HoursBlocked(const EdgeRecord& record, Time now) {
  return std::chrono::duration<double>(record.blocked_until - now).count() / 3600;
}

Colour ColourOf(const EdgeRecord& record, double expected, Time now) {
  if (HoursBlocked(record, now) > 0) return kBlocked;
  if (record.trips == 0) return kUnknown;
  return record.seconds > kSlow * expected ? kLate : kUsual;
}

// "21 s (expected 18), travelled 12 times, 1 failed, blocked for 23.5 h"
std::string WordsOf(const EdgeRecord& record, double expected, Time now) {
  char text[120];
  std::snprintf(text, sizeof text, "%.0f s (expected %.0f), travelled %d times",
                record.trips > 0 ? record.seconds : expected, expected, record.trips);
  std::string words = text;
  if (record.failures > 0) words += ", " + std::to_string(record.failures) + " failed";
  const double blocked = HoursBlocked(record, now);
  if (blocked <= 0) return words;
  std::snprintf(text, sizeof text, ", blocked for %.1f h", blocked);
  return words + text;
}

geometry_msgs::Point PointAt(const Pose2D& place, double aside, double yaw) {
  geometry_msgs::Point point;
  point.x = place.x + aside * std::sin(yaw);
  point.y = place.y - aside * std::cos(yaw);
  return point;
}

visualization_msgs::Marker Begin(const std::string& frame, int id, int type) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;  // stamp 0: the newest transform
  marker.ns = "ways";
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray MarkersOf(const TopologicalMap& map, const EdgeMemory& memory,
                                          Time now, const std::string& frame) {
  using visualization_msgs::Marker;
  visualization_msgs::MarkerArray message;
  message.markers.push_back(Begin(frame, 0, Marker::LINE_LIST));
  message.markers[0].scale.x = 0.06;
  message.markers[0].color = ToMessage(kUnknown);
  for (std::size_t i = 0; i < map.edges().size(); ++i) {
    const Edge& edge = map.edges()[i];
    const auto& from = map.places()[static_cast<std::size_t>(edge.from)].pose;
    const auto& to = map.places()[static_cast<std::size_t>(edge.to)].pose;
    if (edge.kind == EdgeKind::kElsewhere || !from || !to) continue;
    const EdgeRecord& record = memory.records()[i];
    const double yaw = std::atan2(to->y - from->y, to->x - from->x);
    const auto colour = ToMessage(ColourOf(record, memory.expected()[i], now));
    for (const Pose2D& end : {*from, *to}) {
      message.markers[0].points.push_back(PointAt(end, kAside, yaw));
      message.markers[0].colors.push_back(colour);
    }
    Marker words = Begin(frame, static_cast<int>(i) + 1, Marker::TEXT_VIEW_FACING);
    // One that was forgotten by a program that began anew is taken away.
    if (record.trips == 0 && record.failures == 0 && HoursBlocked(record, now) <= 0) {
      words.action = Marker::DELETE;
    }
    const Pose2D middle{(from->x + to->x) / 2, (from->y + to->y) / 2, 0};
    words.pose.position = PointAt(middle, kAside + kWords, yaw);
    words.scale.z = kWords;
    words.color = colour;
    words.text = WordsOf(record, memory.expected()[i], now);
    message.markers.push_back(words);
  }
  return message;
}

}  // namespace coppice::robot::adapters
