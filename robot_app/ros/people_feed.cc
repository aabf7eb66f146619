#include "robot_app/ros/people_feed.h"

#include <algorithm>
#include <cmath>

#include "robot_app/common/ros_support.h"

namespace coppice::robot::adapters {
namespace {

using leaves::Mask;
using leaves::SeenPerson;

constexpr char kBase[] = "base_link";
constexpr std::size_t kMostPeople = 1000;  // more nobody can see at once

double Millimetres(double value) { return std::round(value * 1000) / 1000; }

// `frame` is where the frame of the message lies in base_link.
SeenPerson FromMessage(const coppice_msgs::Person& person, const Pose2D& frame) {
  const Point2D place = Compose(frame, Point2D{person.position.x, person.position.y});
  SeenPerson seen;
  seen.id = person.id;
  seen.x = Millimetres(place.x);
  seen.y = Millimetres(place.y);
  seen.speed = Millimetres(std::hypot(person.velocity.x, person.velocity.y));
  seen.known_for = Millimetres(person.known_for);
  seen.unseen_for = Millimetres(person.unseen_for);
  seen.mask = person.mask == coppice_msgs::Person::WITH_MASK      ? Mask::kWith
              : person.mask == coppice_msgs::Person::WITHOUT_MASK ? Mask::kWithout
                                                                  : Mask::kUnknown;
  return seen;
}

bool IsFinite(const SeenPerson& person) {
  return std::isfinite(person.x) && std::isfinite(person.y) && std::isfinite(person.speed) &&
         std::isfinite(person.known_for) && std::isfinite(person.unseen_for);
}

}  // namespace

PeopleFeed::PeopleFeed(ros::NodeHandle& node, std::vector<Sender<leaves::PeopleView>> trees,
                       const Clock& clock)
    : clock_(clock) {
  std::copy_if(trees.begin(), trees.end(), std::back_inserter(trees_),
               [](const auto& tree) { return static_cast<bool>(tree); });
  if (trees_.empty()) return;
  transforms_.emplace(node);
  subscriber_ = node.subscribe<coppice_msgs::People>(
      "/people", 1,
      boost::function<void(const coppice_msgs::People::ConstPtr&)>(
          [this](const coppice_msgs::People::ConstPtr& message) { OnPeople(*message); }));
}

void PeopleFeed::OnPeople(const coppice_msgs::People& message) const {
  const auto found = transforms_->Find(kBase, message.header.frame_id, ros::Time(0));
  if (!found) return;
  const geometry_msgs::Transform& transform = found->transform;
  const Pose2D frame{transform.translation.x, transform.translation.y, YawOf(transform.rotation)};
  leaves::PeopleView view;
  view.stamp = clock_.Now();
  for (const coppice_msgs::Person& person : message.people) {
    const SeenPerson seen = FromMessage(person, frame);
    if (IsFinite(seen)) view.people.push_back(seen);
    if (view.people.size() == kMostPeople) break;
  }
  for (const Sender<leaves::PeopleView>& tree : trees_) tree.Send(view);
}

}  // namespace coppice::robot::adapters
