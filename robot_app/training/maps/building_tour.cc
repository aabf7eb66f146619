#include "robot_app/training/maps/building_tour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <utility>

#include "robot_app/slam/graph/floor_pose.h"
#include "robot_app/slam/graph/planar_fit.h"

namespace coppice::robot::training {
namespace {

using slam::Pose3;

// Corridors are the edges between crossings.
constexpr double kWide = 60, kDeep = 40;  // m
constexpr int kColumns = 4, kRows = 3;    // crossings
constexpr double kAside = 0.3;            // m, of the middle of a corridor
constexpr double kSeen = 1.2;             // m: a place is known if a key frame lies so near
constexpr double kSeenTurn = 0.6;         // rad
constexpr std::uint32_t kRecent = 12;
// Noise, and what the mapper says of it.
constexpr double kSlip = 0.006, kTwist = 0.0025;
constexpr double kStepPlace = 0.0115, kStepTurn = 0.005;
constexpr double kPlace = 0.03, kTurn = 0.008;
constexpr double kClosurePlace = 0.05, kClosureTurn = 0.012;

struct Crossing {
  int column = 0, row = 0;
  bool operator==(const Crossing& other) const {
    return column == other.column && row == other.row;
  }
};

class Tour {
 public:
  explicit Tour(const BuildingTourSettings& settings)
      : settings_(settings), random_(settings.seed) {}

  std::vector<TourStep> Run() {
    for (int session = 0; session < settings_.sessions; ++session) Drive();
    return std::move(steps_);
  }

 private:
  Eigen::Vector2d At(const Crossing& crossing) {
    return {crossing.column * kWide / (kColumns - 1) + kAside * Normal(),
            crossing.row * kDeep / (kRows - 1) + kAside * Normal()};
  }

  // Any neighbour but the one that the robot comes from.
  Crossing Next(const Crossing& from, const Crossing& before) {
    std::vector<Crossing> next;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const Crossing to{from.column + x, from.row + y};
      if (to.column < 0 || to.row < 0 || to.column >= kColumns || to.row >= kRows) continue;
      if (!(to == before)) next.push_back(to);
    }
    return next[random_() % next.size()];
  }

  void Drive() {
    Crossing before{-1, -1};
    Crossing at{static_cast<int>(random_() % kColumns), static_cast<int>(random_() % kRows)};
    Eigen::Vector2d place = At(at);
    begins_ = true;
    for (int done = 0; done < settings_.key_frames;) {
      const Crossing next = Next(at, before);
      const Eigen::Vector2d goal = At(next), way = goal - place;
      const double yaw = std::atan2(way.y(), way.x());
      const int steps = static_cast<int>(way.norm() / settings_.step);
      for (int i = 0; i < steps && done < settings_.key_frames; ++i, ++done) {
        Add(place + way * i / steps, yaw);
      }
      place = goal;
      before = at;
      at = next;
    }
  }

  void Add(const Eigen::Vector2d& place, double yaw) {
    TourStep step;
    step.begins = std::exchange(begins_, false);
    step.truth = slam::ToPose3({place.x(), place.y(), yaw});
    step.information = slam::InformationOf(kStepPlace, kStepTurn);
    if (!step.begins) {
      step.moved =
          steps_.back().truth.inverse() * step.truth * Noise(kSlip, kTwist) * Turn(settings_.twist);
    }
    steps_.push_back(step);
    Close();
  }

  // With any of the key frames that show the place.
  void Close() {
    if (Uniform() > settings_.recognized) return;
    const auto newest = static_cast<std::uint32_t>(steps_.size() - 1);
    const Pose3& truth = steps_[newest].truth;
    std::vector<std::uint32_t> known;
    for (std::uint32_t i = 0; i + kRecent < newest; ++i) {
      const Pose3& other = steps_[i].truth;
      if ((other.translation() - truth.translation()).squaredNorm() > kSeen * kSeen) continue;
      const Eigen::Matrix3d turned = other.linear().transpose() * truth.linear();
      if (Eigen::AngleAxisd(turned).angle() <= kSeenTurn) known.push_back(i);
    }
    if (known.empty()) return;
    const std::uint32_t from = known[random_() % known.size()];
    steps_[newest].closures.push_back(
        {from, newest, steps_[from].truth.inverse() * truth * Noise(kPlace, kTurn),
         slam::InformationOf(kClosurePlace, kClosureTurn), slam::LinkKind::kPicture});
  }

  static Pose3 Turn(double angle) { return slam::ToPose3({0, 0, angle}); }

  // Of a robot on its floor.
  Pose3 Noise(double place, double turn) {
    Pose3 pose = Turn(turn * Normal());
    pose.translation() << place * Normal(), place * Normal(), 0;
    return pose;
  }

  double Uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double Normal() {
    return std::sqrt(-2 * std::log(1 - Uniform())) * std::cos(2 * M_PI * Uniform());
  }

  const BuildingTourSettings& settings_;
  std::mt19937_64 random_;
  std::vector<TourStep> steps_;
  bool begins_ = true;
};

// How far the poses are from the truth after one shift and turn, root of mean square [m]; of those
// that lie in the map of the first session.
double ErrorOf(const slam::SessionGraph& graph, const std::vector<TourStep>& tour) {
  std::vector<Eigen::Vector3d> mapped, truth;
  for (std::uint32_t i = 0; i < graph.poses().size(); ++i) {
    if (!graph.InOneMap(0, i)) continue;
    mapped.push_back(graph.poses()[i].translation());
    truth.push_back(tour[i].truth.translation());
  }
  const Pose3 fit = slam::PlanarFit(truth, mapped);
  double squares = 0;
  for (std::size_t i = 0; i < mapped.size(); ++i)
    squares += (fit * mapped[i] - truth[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(mapped.size()));
}

}  // namespace

std::vector<TourStep> TourOfABuilding(const BuildingTourSettings& settings) {
  return Tour(settings).Run();
}

GraphFigures MeasureGraph(const std::vector<TourStep>& tour, slam::SessionGraphSettings settings) {
  slam::SessionGraph graph(settings);
  GraphFigures figures;
  std::vector<double> seconds;
  for (const TourStep& step : tour) {
    const std::clock_t begin = std::clock();
    if (step.begins) graph.BeginSession();
    graph.AddPose(step.moved, step.information);
    for (const slam::Link& closure : step.closures) {
      const slam::Verdict verdict = graph.AddClosure(closure);
      figures.believed += verdict == slam::Verdict::kBelieved ? 1 : 0;
      figures.refused += verdict == slam::Verdict::kRefused ? 1 : 0;
      figures.waited += verdict == slam::Verdict::kWaits ? 1 : 0;
    }
    graph.Refine();
    seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    const slam::SolverWork work = graph.TakeWork();
    figures.most_poses = std::max(figures.most_poses, work.poses);
    figures.most_links = std::max(figures.most_links, work.links);
  }
  figures.key_frames = graph.poses().size();
  figures.links = graph.graph().links.size();
  seconds.erase(seconds.begin(), seconds.end() - static_cast<std::ptrdiff_t>(seconds.size() / 4));
  std::sort(seconds.begin(), seconds.end());
  figures.median = seconds[seconds.size() / 2];
  figures.worst = seconds.back();
  figures.error = ErrorOf(graph, tour);
  slam::PoseGraph whole = graph.graph();
  slam::Optimize({0}, {50}, whole);
  figures.error_at_once = ErrorOf({settings, std::move(whole), graph.sessions()}, tour);
  return figures;
}

std::string Table(const std::vector<GraphFigures>& figures) {
  std::string text =
      "| key frames | links | closures believed | refused | poses solved at most | links | median | "
      "worst | error | at once |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const GraphFigures& one : figures) {
    char line[200];
    std::snprintf(line, sizeof(line),
                  "| %zu | %zu | %d | %d | %zu | %zu | %.1f ms | %.1f ms | %.3f m | %.3f m |\n",
                  one.key_frames, one.links, one.believed, one.refused, one.most_poses,
                  one.most_links, 1e3 * one.median, 1e3 * one.worst, one.error, one.error_at_once);
    text += line;
  }
  return text;
}

}  // namespace coppice::robot::training
