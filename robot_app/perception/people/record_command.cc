#include "robot_app/perception/people/record_command.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "bt_core/base/command_line.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/compressed_picture.h"
#include "robot_app/common/limits/run_apart.h"
#include "robot_app/perception/drawing/floor_picture.h"
#include "robot_app/perception/people/people_in_record.h"

namespace coppice::robot::perception {
namespace {

constexpr char kOffline[] = "--offline";
constexpr double kReach = 8;        // of a picture, around the lidar [m]
constexpr std::size_t kTrail = 40;  // points of 0.1 m
constexpr int kQuality = 85;

const Command kCommand{
    "coppice-people",
    "finds people in a record (rosbag) and follows them",
    {},
    "Reads /velodyne_points, /people/sightings, /scan, /tf and /tf_static as fast as it\n"
    "goes, without a ROS master, and prints who was there. With --pictures it also draws what\n"
    "the lidar saw from above, with people and their ways: 00000.jpg, 00001.jpg ...\n"
    "A film of them: ffmpeg -framerate 10 -i FOLDER/%05d.jpg people.mp4",
    {CommandOption::Text(kOffline, "FILE", "the record").Needed(),
     CommandOption::Text("--pictures", "FOLDER", "where to draw them; it is made"),
     CommandOption::Real("--every", "SECONDS", 0.05, 3600, "between two pictures; else 1"),
     CommandOption::Text("--frame", "NAME", "that does not move; else odom"),
     CommandOption::Text("--classifier", "FILE", "that coppice-train made"),
     CommandOption::Text("--leg-classifier", "FILE", "the same for scans of the laser"),
     CommandOption::Whole("--memory", "MIB", 16, 1 << 20, "that it may take; else 240")}};

int Fail(const std::string& problem) {
  std::fprintf(stderr, "coppice-people: %s\n", problem.c_str());
  return 1;
}

// Of a turn of the lidar in the frame, what stands on the floor.
std::vector<Eigen::Vector2d> Standing(const CandidateFinder& candidates, const Pose2D& lidar) {
  std::vector<Eigen::Vector2d> points;
  const Eigen::Rotation2Dd turn(lidar.yaw);
  const RangeImage& image = candidates.image();
  for (std::size_t cell = 0; cell < image.size(); ++cell) {
    if (candidates.surfaces()[cell] != Surface::kStanding) continue;
    points.push_back(turn * image.points[cell].head<2>().cast<double>() +
                     Eigen::Vector2d(lidar.x, lidar.y));
  }
  return points;
}

std::string LabelOf(const Track& track) {
  const char* const mask = !track.has_mask ? "" : *track.has_mask ? " mask" : " no mask";
  return std::to_string(track.id) + mask;
}

Picture Draw(double time, const PeopleFollower& follower, const RecordFigures& figures) {
  const Pose2D& lidar = follower.lidar();
  FloorPicture picture({lidar.x, lidar.y}, kReach);
  if (follower.finder()) {
    picture.DrawPoints(Standing(follower.finder()->candidates(), lidar), kGray);
  }
  picture.DrawRobot(lidar);
  for (const Track& track : follower.tracker().tracks()) {
    if (!track.is_confirmed) continue;
    std::vector<Eigen::Vector2d> trail = figures.people.at(track.id).trail;
    const auto length = std::min(trail.size(), kTrail);
    trail.erase(trail.begin(), trail.end() - static_cast<std::ptrdiff_t>(length));
    picture.DrawTrail(trail, ColourOf(track.id));
    picture.DrawPerson(track.position(), track.velocity(), LabelOf(track), ColourOf(track.id));
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f s", time);
  picture.Write(text);
  return picture.picture();
}

// Draws one in `every` seconds.
class Pictures {
 public:
  Pictures(std::filesystem::path folder, double every)
      : folder_(std::move(folder)), every_(every) {}

  Outcome Begin() const {
    if (folder_.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) return Problem{folder_.string() + ": " + error.message()};
    return {};
  }

  void Look(double time, const PeopleFollower& follower, const RecordFigures& figures) {
    if (folder_.empty() || time < due_ || !problem_.empty()) return;
    due_ = std::max(due_ + every_, time);
    const std::vector<std::uint8_t> bytes = EncodeJpeg(Draw(time, follower, figures), kQuality);
    char name[16];
    std::snprintf(name, sizeof(name), "%05d.jpg", count_++);
    Diagnostics diagnostics;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!WriteFile((folder_ / name).string(), text, diagnostics)) problem_ = diagnostics.ToString();
  }

  const std::string& problem() const { return problem_; }  ///< empty: all could be written

 private:
  std::filesystem::path folder_;
  double every_;
  double due_ = 0;
  int count_ = 0;
  std::string problem_;
};

// Nobody may ever write into a pipe, and rosbag waits for him.
bool IsNoFile(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

int Look(const Options& options, const std::string& clouds_file, const std::string& legs_file) {
  auto classifiers = Classifiers::Load(options.Get("--classifier", clouds_file),
                                       options.Get("--leg-classifier", legs_file));
  if (!classifiers) return Fail(classifiers.problem());
  Pictures pictures(options.Get("--pictures"), options.Real("--every", 1));
  if (Outcome begun = pictures.Begin(); !begun) return Fail(begun.problem());
  FollowerOptions following;
  following.frame = options.Get("--frame", following.frame);
  const auto figures =
      FollowInRecord(options.Get(kOffline), following, std::move(*classifiers),
                     [&](double time, const PeopleFollower& follower, const RecordFigures& so_far) {
                       pictures.Look(time, follower, so_far);
                     });
  if (!figures) return Fail(figures.problem());
  if (!pictures.problem().empty()) return Fail(pictures.problem());
  std::fputs(Table(*figures).c_str(), stdout);
  return FinishOutput(0);
}

}  // namespace

bool IsAboutRecord(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const std::string& argument) { return argument.rfind(kOffline, 0) == 0; });
}

int LookIntoRecord(const std::vector<std::string>& arguments, const std::string& clouds_file,
                   const std::string& legs_file) {
  const bool asks_for_help =
      std::find(arguments.begin(), arguments.end(), "--help") != arguments.end();
  const Options options =
      ParseOptions(kCommand, asks_for_help ? std::vector<std::string>{"--help"} : arguments);
  if (options.exit) return *options.exit;
  const std::string record = options.Get(kOffline);
  if (IsNoFile(record)) return Fail(record + ": is a folder, a device or a pipe, and no record");
  // rosbag believes what a record says of itself, and crashes at some that are damaged.
  const auto memory = static_cast<std::size_t>(options.Whole("--memory", 240)) << 20;
  const Expected<int> looked =
      RunApart([&] { return Look(options, clouds_file, legs_file); }, {memory, {}});
  if (looked) return *looked;
  return Fail(record + ": the record is damaged: who reads it " + looked.problem() +
              ", or it takes more memory than --memory says");
}

}  // namespace coppice::robot::perception
