#include "robot_app/perception/people/people_in_record.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdio>
#include <utility>

#include "robot_app/common/transforms/message_time.h"
#include "robot_app/common/transforms/transform_memory.h"

namespace coppice::robot::perception {
namespace {

constexpr double kStep = 0.1;  // between two points of a trail [m]

const std::vector<std::string> kTopics = {"/tf", "/tf_static", "/velodyne_points",
                                          "/people/sightings", "/scan"};

class Reader {
 public:
  Reader(const FollowerOptions& options, Classifiers classifiers, const OnLook& on_look)
      : follower_(options, std::move(classifiers),
                  [this](const std::string& parent, const std::string& child,
                         const ros::Time& time) { return transforms_.Find(parent, child, time); }),
        on_look_(on_look) {}

  RecordFigures Read(rosbag::View& view) {
    const double begin = view.getBeginTime().toSec();
    for (const rosbag::MessageInstance& message : view) {
      figures_.seconds = message.getTime().toSec() - begin;
      Take(message);
    }
    return std::move(figures_);
  }

 private:
  void Take(const rosbag::MessageInstance& message) {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      transforms_.Store(*transforms, message.getTopic() == "/tf_static", message.getTime());
    } else if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) {
      const Outcome checked = CheckStamp(cloud->header.stamp, message.getTime());
      Count(checked ? follower_.OnCloud(*cloud) : checked, figures_.clouds);
    } else if (const auto sightings = message.instantiate<coppice_msgs::Sightings>()) {
      TakeSightings(*sightings, message.getTime());
    } else if (const auto scan = message.instantiate<sensor_msgs::LaserScan>()) {
      TakeScan(*scan, message.getTime());
    }
  }

  void TakeSightings(const coppice_msgs::Sightings& sightings, const ros::Time& now) {
    const Outcome checked = CheckStamp(sightings.header.stamp, now);
    if (!checked) return Count(checked, figures_.pictures);
    const auto late = follower_.OnSightings(sightings);
    Count(late ? Outcome() : Problem{late.problem()}, figures_.pictures);
  }

  void TakeScan(const sensor_msgs::LaserScan& scan, const ros::Time& now) {
    const Outcome checked = CheckStamp(scan.header.stamp, now);
    if (!checked) return Count(checked, figures_.scans);
    const auto looked = follower_.OnScan(scan);
    if (!looked) Count(Problem{looked.problem()}, figures_.scans);
    if (looked && *looked) Count({}, figures_.scans);
  }

  void Count(const Outcome& done, int& counter) {
    if (!done) {
      if (figures_.refused++ == 0) figures_.problem = done.problem();
      return;
    }
    ++counter;
    for (const Track& track : follower_.tracker().tracks()) {
      if (track.is_confirmed) Remember(track);
    }
    if (on_look_) on_look_(figures_.seconds, follower_, figures_);
  }

  void Remember(const Track& track) {
    const double ago = follower_.tracker().time() - track.first_seen;
    const auto [known, is_new] = figures_.people.try_emplace(track.id);
    PersonInRecord& person = known->second;
    if (is_new) person.first_seen = std::max(figures_.seconds - ago, 0.0);
    person.last_seen =
        std::max(figures_.seconds - (follower_.tracker().time() - track.last_seen), 0.0);
    person.has_mask = track.has_mask;
    if (person.trail.empty() || (person.trail.back() - track.position()).norm() > kStep) {
      person.trail.push_back(track.position());
    }
  }

  TransformMemory transforms_;
  PeopleFollower follower_;
  const OnLook& on_look_;
  RecordFigures figures_;
};

double LengthOf(const std::vector<Eigen::Vector2d>& trail) {
  double length = 0;
  for (std::size_t i = 1; i < trail.size(); ++i) length += (trail[i] - trail[i - 1]).norm();
  return length;
}

std::string LineOf(std::uint32_t id, const PersonInRecord& person) {
  const char* const mask = !person.has_mask ? "not seen" : *person.has_mask ? "yes" : "no";
  char text[128];
  std::snprintf(text, sizeof(text), "%6u %9.1f %9.1f %9.1f  %s\n", id, person.first_seen,
                person.last_seen, LengthOf(person.trail), mask);
  return text;
}

}  // namespace

Expected<RecordFigures> FollowInRecord(const std::string& file, const FollowerOptions& options,
                                       Classifiers classifiers, const OnLook& on_look) {
  try {
    const rosbag::Bag bag(file, rosbag::bagmode::Read);
    rosbag::View view(bag, rosbag::TopicQuery(kTopics));
    if (view.size() == 0) {
      return Problem{file + ": nothing of /velodyne_points, /people/sightings or /tf was recorded"};
    }
    return Reader(options, std::move(classifiers), on_look).Read(view);
  } catch (const std::exception& problem) {  // of rosbag, or of a message that is no message
    return Problem{file + ": " + problem.what()};
  }
}

std::string Table(const RecordFigures& figures) {
  char text[160];
  std::snprintf(text, sizeof(text), "%d clouds, %d pictures, %d scans in %.1f s; %zu people\n",
                figures.clouds, figures.pictures, figures.scans, figures.seconds,
                figures.people.size());
  std::string table = text;
  if (figures.refused > 0) {
    table +=
        std::to_string(figures.refused) + " messages refused; the first: " + figures.problem + "\n";
  }
  table += "number  from [s]    to [s]   way [m]  mask\n";
  for (const auto& [id, person] : figures.people) table += LineOf(id, person);
  return table;
}

}  // namespace coppice::robot::perception
