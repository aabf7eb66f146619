#include "robot_app/training/maps/update_figures.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <random>
#include <utility>

#include "robot_app/slam/graph/floor_pose.h"
#include "robot_app/training/draw.h"

namespace coppice::robot::training {
namespace {

using slam::Pose3;

constexpr double kTwist = 0.001;  // rad: odometry turns so much too far at a step, at most
constexpr double kSlip = 0.004;   // m

struct Seen {
  slam::Sight sight;
  double seconds = 0;  // to find its corners
};

double Seconds(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

std::vector<Seen> Round(const SlamStudy& study, std::size_t session) {
  TourSettings tour;
  tour.seed = study.seed * 1000 + session;
  tour.light = study.lights[session];
  tour.aside = 0.2;
  tour.step = study.mapper.step;
  tour.turn = study.mapper.turn;
  TourEyes eyes(study.floor, study.sensors, tour);
  std::vector<Seen> round;
  for (const Stop& stop : Drive(study.way, tour)) {
    Seen seen;
    slam::Sight& sight = seen.sight;
    sight.odometry = slam::ToPose3({stop.odometry.x, stop.odometry.y, stop.odometry.yaw});
    sight.cloud = eyes.TakeCloud(stop);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const simulation::RgbdPicture picture = eyes.TakePicture(stop, camera);
      const slam::CameraMount& mount = study.sensors.cameras[camera];
      const std::clock_t begin = std::clock();
      sight.pictures.push_back(slam::SeePicture(picture.colour, picture.depth, mount));
      sight.brightness = slam::BrightnessOf(picture.colour);
      seen.seconds += Seconds(begin);
    }
    round.push_back(std::move(seen));
  }
  return round;
}

// The memory that the program has now [MB].
double MemoryNow() {
  std::ifstream stream("/proc/self/statm");
  double all = 0, resident = 0;
  stream >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

class Study {
 public:
  Study(const SlamStudy& study, std::size_t every)
      : every_(every),
        random_(study.seed),
        mapper_(study.vocabulary, study.classifier, study.mapper, *slam::MapStore::Open("")) {}

  void Drive(const std::vector<Seen>& round, std::size_t most) {
    mapper_.BeginSession("again");
    const double twist = Draw(random_, -kTwist, kTwist);
    Pose3 before = round.front().sight.odometry, odometry = Pose3::Identity();
    for (const Seen& seen : round) {
      if (mapper_.graph().poses().size() >= most) return;
      slam::Sight sight = seen.sight;
      sight.stamp = stamp_ += 1;
      const Pose3 slipped =
          slam::ToPose3({Draw(random_, -kSlip, kSlip), Draw(random_, -kSlip, kSlip), twist});
      odometry = odometry * (before.inverse() * sight.odometry) * slipped;
      before = std::exchange(sight.odometry, odometry);
      const std::clock_t begin = std::clock();
      const slam::MapperReport report = mapper_.Add(sight);
      Count(report, Seconds(begin) + seen.seconds);
    }
  }

  std::size_t key_frames() const { return mapper_.graph().poses().size(); }
  std::vector<UpdateFigures> figures() { return std::move(all_); }

 private:
  void Count(const slam::MapperReport& report, double seconds) {
    seconds_.push_back(seconds);
    now_.most_poses = std::max(now_.most_poses, report.work.poses);
    now_.closures += report.of_picture == slam::Verdict::kBelieved ? 1 : 0;
    now_.closures += report.of_cloud == slam::Verdict::kBelieved ? 1 : 0;
    if (seconds_.size() < every_) return;
    std::sort(seconds_.begin(), seconds_.end());
    now_.key_frames = key_frames();
    now_.working = mapper_.memory().working();
    now_.median = seconds_[seconds_.size() / 2];
    now_.late = seconds_[seconds_.size() * 99 / 100];
    now_.worst = seconds_.back();
    now_.memory = MemoryNow();
    all_.push_back(std::exchange(now_, {}));
    seconds_.clear();
  }

  const std::size_t every_;
  std::mt19937_64 random_;
  slam::SlamMapper mapper_;
  double stamp_ = 0;
  std::vector<double> seconds_;
  UpdateFigures now_;
  std::vector<UpdateFigures> all_;
};

}  // namespace

std::vector<UpdateFigures> MeasureUpdates(const SlamStudy& study, std::size_t key_frames,
                                          std::size_t every,
                                          const std::function<void(double)>& say) {
  std::vector<std::vector<Seen>> rounds;
  for (std::size_t i = 0; i < study.lights.size(); ++i) rounds.push_back(Round(study, i));
  Study updates(study, every);
  for (std::size_t i = 0; updates.key_frames() < key_frames; ++i) {
    updates.Drive(rounds[i % rounds.size()], key_frames);
    say(static_cast<double>(updates.key_frames()) / static_cast<double>(key_frames));
  }
  return updates.figures();
}

std::string Table(const std::vector<UpdateFigures>& figures) {
  std::string text =
      "| key frames | in memory | closures | poses solved at most | median | but 1 % | worst | "
      "program |\n|---|---|---|---|---|---|---|---|\n";
  for (const UpdateFigures& one : figures) {
    char line[200];
    std::snprintf(line, sizeof(line),
                  "| %zu | %zu | %d | %zu | %.0f ms | %.0f ms | %.0f ms | %.0f MB |\n",
                  one.key_frames, one.working, one.closures, one.most_poses, 1e3 * one.median,
                  1e3 * one.late, 1e3 * one.worst, one.memory);
    text += line;
  }
  return text;
}

}  // namespace coppice::robot::training
