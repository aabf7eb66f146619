#include "robot_app/training/slam_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <utility>

#include "robot_app/simulation/floor_scene.h"
#include "robot_app/slam/graph/floor_pose.h"
#include "robot_app/slam/graph/planar_fit.h"
#include "robot_app/slam/map/map_voxels.h"

namespace coppice::robot::training {
namespace {

using simulation::Pose2;
using simulation::Vec2;
using slam::Pose3;

constexpr double kRight = 0.5;         // m
constexpr double kRightTurn = 0.0873;  // rad
constexpr double kMovedDoors = 1.0 / 3;
constexpr double kAside = 0.2;  // m

Pose3 ToPose3(const Pose2& pose) { return slam::ToPose3({pose.x, pose.y, pose.yaw}); }

bool IsFalse(const slam::Link& link, const std::vector<Stop>& stops) {
  const Pose3 truth = ToPose3(stops[link.from].truth).inverse() * ToPose3(stops[link.to].truth);
  const Pose3 off = truth.inverse() * link.relative;
  return off.translation().norm() > kRight || Eigen::AngleAxisd(off.linear()).angle() > kRightTurn;
}

// The way of a session, begun at another point of the round each time.
std::vector<Vec2> Begun(std::vector<Vec2> way, std::size_t session) {
  if (session == 0) return way;
  way.pop_back();  // where it began
  const std::size_t first = (session * 5) % way.size();
  std::rotate(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(first), way.end());
  way.push_back(way.front());
  return way;
}

class Study {
 public:
  Study(const SlamStudy& study, const std::function<void(double)>& say)
      : study_(study),
        say_(say),
        mapper_(study.vocabulary, study.classifier, study.mapper,
                study.on_disk ? *slam::MapStore::Open("") : nullptr) {}

  SlamResult Run() {
    for (std::size_t session = 0; session < study_.lights.size(); ++session) Drive(session);
    figures_.key_frames = static_cast<int>(stops_.size());
    figures_.mean_update = seconds_ / std::max<double>(static_cast<double>(stops_.size()), 1);
    SlamResult result{figures_, mapper_.Map(), stops_};
    for (std::uint32_t i = 0; i < stops_.size(); ++i) {
      result.map.key_frames[i] = *mapper_.key_frame(i);
    }
    CompareGrid(CompareWays(result), result);
    return result;
  }

 private:
  void Drive(std::size_t session) {
    TourSettings tour;
    tour.seed = study_.seed * 1000 + session;
    tour.light = study_.lights[session];
    tour.moved_doors = session == 0 ? 0 : kMovedDoors;
    tour.aside = session == 0 ? 0 : kAside;
    TourEyes eyes(study_.floor, study_.sensors, tour);
    const std::vector<Stop> stops = training::Drive(Begun(study_.way, session), tour);
    mapper_.BeginSession("session " + std::to_string(session + 1));
    for (std::size_t i = 0; i < stops.size(); ++i) {
      Look(stops[i], eyes, static_cast<double>(i));
      say_((static_cast<double>(session) +
            static_cast<double>(i) / static_cast<double>(stops.size())) /
           static_cast<double>(study_.lights.size()));
    }
    figures_.way += stops.back().way;
    if (session > 0 && mapper_.IsJoined()) ++figures_.joined;
  }

  void Look(const Stop& stop, TourEyes& eyes, double stamp) {
    slam::Sight sight;
    sight.stamp = stamp;
    sight.odometry = ToPose3(stop.odometry);
    if (!mapper_.IsDue(sight.odometry)) return;
    // So the grid of the map that is kept can be navigated on. The mapper itself does not use it.
    if (mapper_.graph().session_count() <= 1) {
      sight.place = Pose2D{stop.truth.x, stop.truth.y, stop.truth.yaw};
    }
    std::vector<simulation::RgbdPicture> pictures;
    for (std::size_t camera = 0; camera < 2; ++camera) {
      pictures.push_back(eyes.TakePicture(stop, camera));
    }
    sight.cloud = eyes.TakeCloud(stop);
    stops_.push_back(stop);
    const std::clock_t begin = std::clock();
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const simulation::RgbdPicture& seen = pictures[camera];
      const slam::CameraMount& mount = study_.sensors.cameras[camera];
      sight.pictures.push_back(slam::SeePicture(seen.colour, seen.depth, mount));
      sight.brightness = slam::BrightnessOf(seen.colour);
    }
    const slam::MapperReport report = mapper_.Add(sight);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    seconds_ += seconds;
    figures_.worst_update = std::max(figures_.worst_update, seconds);
    Count(report.by_picture, report.of_picture, figures_.by_picture);
    Count(report.by_cloud, report.of_cloud, figures_.by_cloud);
    figures_.most_working = std::max(figures_.most_working, mapper_.memory().working());
    was_away_.resize(stops_.size());
    for (std::uint32_t i = 0; i < stops_.size(); ++i) {
      if (!mapper_.memory().IsWorking(i)) was_away_[i] = true;
    }
  }

  void Count(const std::optional<slam::Link>& link, slam::Verdict verdict, int& believed) {
    if (!link) return;
    if (verdict == slam::Verdict::kRefused) ++figures_.refused;
    if (verdict != slam::Verdict::kBelieved) return;
    ++believed;
    if (was_away_[link->from]) ++figures_.from_disk;
  }

  // Closures that were believed, one of those that waited among them, and the poses of all sessions
  // that lie in the map of the first one.
  // Returns the shift and turn that lay the map upon the floor.
  Pose3 CompareWays(SlamResult& result) const {
    const slam::SessionGraph& graph = mapper_.graph();
    for (const slam::Link& link : graph.graph().links) {
      if (link.is_closure() && IsFalse(link, stops_)) ++result.figures.false_closures;
    }
    std::vector<Eigen::Vector3d> mapped, truth;
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      if (graph.map_of(graph.sessions()[i]) != 0) continue;
      mapped.push_back(graph.poses()[i].translation());
      truth.emplace_back(stops_[i].truth.x, stops_[i].truth.y, 0);
    }
    const Pose3 fit = slam::PlanarFit(truth, mapped);
    double squares = 0;
    for (std::size_t i = 0; i < mapped.size(); ++i) {
      const double off = (fit * mapped[i] - truth[i]).norm();
      squares += off * off;
      result.figures.worst = std::max(result.figures.worst, off);
    }
    result.figures.error = std::sqrt(squares / static_cast<double>(mapped.size()));
    return fit;
  }

  // An occupied cell is right if something stands within two cells, a free one if nothing is in it.
  void CompareGrid(const Pose3& to_floor, SlamResult& result) const {
    const OccupancyGrid grid =
        slam::VoxelsOf(result.map, 0, study_.mapper.lidar, study_.mapper.resolution).Project();
    const simulation::StillScene still = simulation::MakeStillScene(study_.floor);
    std::size_t known = 0, right = 0;
    for (int i = 0; i < grid.frame.size(); ++i) {
      const std::int8_t cell = grid.cells[static_cast<std::size_t>(i)];
      if (cell < 0) continue;
      const Point2D center = grid.frame.Center(grid.frame.CellOf(i));
      const Eigen::Vector3d at = to_floor * Eigen::Vector3d(center.x, center.y, 0);
      const double distance = FromEdges(still, {at.x(), at.y()});
      const bool is_occupied = cell >= OccupancyGrid::kOccupied;
      ++known;
      const bool is_right = is_occupied ? distance <= 2 * grid.frame.resolution
                                        : distance >= grid.frame.resolution / 2;
      right += is_right ? 1 : 0;
    }
    result.figures.right_cells =
        static_cast<double>(right) / std::max<double>(static_cast<double>(known), 1);
  }

  static double FromEdges(const simulation::StillScene& still, Vec2 point) {
    double nearest = 1e9;
    for (const simulation::Panel& panel : still.panels) {
      nearest = std::min(nearest, simulation::Distance(point, panel.edge));
    }
    return nearest;
  }

  const SlamStudy& study_;
  const std::function<void(double)>& say_;
  slam::SlamMapper mapper_;
  SlamFigures figures_;
  std::vector<Stop> stops_;
  std::vector<bool> was_away_;  // of each key frame, at any time
  double seconds_ = 0;
};

}  // namespace

SlamResult MeasureSlam(const SlamStudy& study, const std::function<void(double)>& say) {
  return Study(study, say).Run();
}

std::string Table(const std::vector<SlamFigures>& figures) {
  std::string text =
      "| way | key frames | closures by picture | by cloud | refused | false | sessions joined | "
      "error | worst | cells right | update | worst |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const SlamFigures& one : figures) {
    char line[240];
    std::snprintf(
        line, sizeof(line),
        "| %.0f m | %d | %d | %d | %d | %d | %d | %.3f m | %.2f m | %.1f %% | %.0f ms | %.0f ms |\n",
        one.way, one.key_frames, one.by_picture, one.by_cloud, one.refused, one.false_closures,
        one.joined, one.error, one.worst, 100 * one.right_cells, 1e3 * one.mean_update,
        1e3 * one.worst_update);
    text += line;
  }
  return text;
}

}  // namespace coppice::robot::training
