#include "robot_app/perception/people/people_messages.h"

#include <algorithm>

namespace coppice::robot::perception {
namespace {

using coppice_msgs::People;
using coppice_msgs::Person;
using visualization_msgs::Marker;

constexpr double kShown = 0.5;  // how long a marker stays [s]
constexpr double kHeight = 1.7;
constexpr double kWidth = 0.5;

Person ToMessage(const Track& track, double now) {
  Person person;
  person.id = track.id;
  person.position.x = track.state[0];
  person.position.y = track.state[1];
  person.velocity.x = track.state[2];
  person.velocity.y = track.state[3];
  for (int i = 0; i < 4; ++i) person.covariance[i] = track.covariance(i / 2, i % 2);
  person.seen_by = track.modalities;
  person.mask = !track.has_mask   ? Person::MASK_UNKNOWN
                : *track.has_mask ? Person::WITH_MASK
                                  : Person::WITHOUT_MASK;
  person.known_for = static_cast<float>(now - track.first_seen);
  person.unseen_for = static_cast<float>(now - track.last_seen);
  return person;
}

Marker MakeMarker(const People& people, const Person& person, const char* kind, int type) {
  Marker marker;
  marker.header = people.header;
  marker.ns = kind;
  marker.id = static_cast<std::int32_t>(person.id);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.lifetime = ros::Duration(kShown);
  marker.pose.position = person.position;
  marker.pose.orientation.w = 1;
  marker.color.r = 0.2F;
  marker.color.g = 0.6F;
  marker.color.b = 0.9F;
  marker.color.a = person.unseen_for > kShown ? 0.25F : 0.8F;
  return marker;
}

}  // namespace

People ToMessage(const Tracker& tracker, const std::string& frame) {
  People people;
  people.header.stamp = ros::Time(std::max(tracker.time(), 0.0));
  people.header.frame_id = frame;
  for (const Track& track : tracker.tracks()) {
    if (track.is_confirmed) people.people.push_back(ToMessage(track, tracker.time()));
  }
  return people;
}

visualization_msgs::MarkerArray ToMarkers(const People& people) {
  visualization_msgs::MarkerArray markers;
  for (const Person& person : people.people) {
    Marker body = MakeMarker(people, person, "people", Marker::CYLINDER);
    body.pose.position.z = kHeight / 2;
    body.scale.x = body.scale.y = kWidth;
    body.scale.z = kHeight;
    markers.markers.push_back(body);

    Marker number = MakeMarker(people, person, "numbers", Marker::TEXT_VIEW_FACING);
    number.pose.position.z = kHeight + 0.2;
    number.scale.z = 0.25;
    number.text = std::to_string(person.id);
    markers.markers.push_back(number);

    Marker way = MakeMarker(people, person, "velocities", Marker::ARROW);
    way.pose.position = geometry_msgs::Point();
    way.points.assign(2, person.position);
    way.points[1].x += person.velocity.x;
    way.points[1].y += person.velocity.y;
    way.scale.x = 0.05;
    way.scale.y = 0.1;
    markers.markers.push_back(way);
  }
  return markers;
}

}  // namespace coppice::robot::perception
