#include "robot_app/training/place_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "robot_app/slam/pictures/picture_places.h"

namespace coppice::robot::training {
namespace {

using simulation::Pose2;

constexpr double kRight = 0.5;         // m
constexpr double kRightTurn = 0.0873;  // rad
constexpr double kAside = 0.25;        // m
constexpr double kMovedDoors = 1.0 / 3;

// What a way of recognizing places answers.
struct Answer {
  std::uint32_t stop = 0;  // of the first round
  slam::Pose3 relative = slam::Pose3::Identity();
  double score = 0;
  bool is_sure = false;
};

// What an answer says of where the robot is, beside the truth.
Pose2 Off(const Answer& answer, const Stop& old_stop, const Stop& stop) {
  const Eigen::Vector3d at = answer.relative.translation();
  const Eigen::Matrix3d turn = answer.relative.linear();
  const Pose2 relative{at.x(), at.y(), std::atan2(turn(1, 0), turn(0, 0))};
  return Compose(Inverse(stop.truth), Compose(old_stop.truth, relative));
}

class Count {
 public:
  explicit Count(double light) { figures_.light = light; }

  void Add(const std::optional<Answer>& answer, const std::vector<Stop>& known, const Stop& stop) {
    ++figures_.asked;
    if (!answer) return;
    const Pose2 off = Off(*answer, known[answer->stop], stop);
    const double metres = simulation::Length(off.position());
    const bool is_wrong = metres > kRight || std::abs(off.yaw) > kRightTurn;
    if (is_wrong) figures_.most_wrong = std::max(figures_.most_wrong, answer->score);
    if (!answer->is_sure) return;
    ++figures_.answered;
    figures_.farthest = std::max(figures_.farthest, metres);
    figures_.wrong += is_wrong ? 1 : 0;
    if (is_wrong) return;
    squares_ += metres * metres;
    least_ = std::min(least_, answer->score);
  }

  PlaceFigures Finish(double seconds) {
    figures_.seconds = seconds;
    figures_.error = std::sqrt(squares_ / std::max(figures_.answered - figures_.wrong, 1));
    figures_.least_right = figures_.answered > figures_.wrong ? least_ : 0;
    return figures_;
  }

 private:
  PlaceFigures figures_;
  double squares_ = 0;
  double least_ = 1e9;
};

// `remember(eyes, index, stop)` for each stop of the first round, `ask(eyes, stop)` -> answer and
// seconds for each of the others.
template <typename Remember, typename Ask>
std::vector<PlaceFigures> Measure(const PlaceStudy& study, Remember remember, Ask ask,
                                  const std::function<void(double)>& say) {
  TourSettings tour;
  tour.seed = study.seed;
  tour.step = 0.8;
  tour.turn = 0.6;
  const std::vector<Stop> known = Drive(study.way, tour);
  TourEyes first(study.floor, study.sensors, tour);
  for (std::uint32_t i = 0; i < known.size(); ++i) remember(first, i, known[i]);
  std::vector<PlaceFigures> all;
  for (const double light : study.lights) {
    say(static_cast<double>(all.size()) / static_cast<double>(study.lights.size()));
    tour.seed += 100;
    tour.light = light;
    tour.aside = kAside;
    tour.moved_doors = kMovedDoors;
    TourEyes eyes(study.floor, study.sensors, tour);
    Count count(light);
    double seconds = 0;
    for (const Stop& stop : Drive(study.way, tour)) {
      count.Add(ask(eyes, stop, known, seconds), known, stop);
    }
    all.push_back(count.Finish(seconds));
  }
  return all;
}

class Watch {
 public:
  explicit Watch(double& seconds) : seconds_(seconds) {}
  ~Watch() { seconds_ += static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

 private:
  double& seconds_;
  std::clock_t begin_ = std::clock();
};

}  // namespace

std::vector<PlaceFigures> MeasurePictures(const slam::Vocabulary& vocabulary,
                                          const PlaceStudy& study,
                                          const std::function<void(double)>& say) {
  slam::PicturePlaces places(vocabulary);
  const auto look = [&](TourEyes& eyes, const Stop& stop, std::size_t camera) {
    const auto seen = eyes.TakePicture(stop, camera);
    return slam::FindFeatures(seen.colour, seen.depth, study.sensors.cameras[camera]);
  };
  const auto remember = [&](TourEyes& eyes, std::uint32_t i, const Stop& stop) {
    for (std::size_t camera = 0; camera < 2; ++camera) {
      places.Add(i, std::make_shared<slam::PictureFeatures>(look(eyes, stop, camera)));
    }
  };
  const auto ask = [&](TourEyes& eyes, const Stop& stop, const std::vector<Stop>&,
                       double& seconds) {
    std::optional<Answer> best;
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const slam::PictureFeatures seen = look(eyes, stop, camera);
      const Watch watch(seconds);
      const auto found =
          places.Find(seen, study.sensors.cameras[camera], [](std::uint32_t) { return true; });
      if (!found || (best && found->match.inliers <= best->score)) continue;
      best =
          Answer{found->key_frame, found->match.relative, static_cast<double>(found->match.inliers),
                 IsSure(found->match, places.settings().match)};
    }
    return best;
  };
  return Measure(study, remember, ask, say);
}

std::vector<PlaceFigures> MeasureClouds(const slam::PlaceClassifier& classifier,
                                        const PlaceStudy& study,
                                        const std::function<void(double)>& say) {
  slam::CloudPlaces places(classifier);
  const auto remember = [&](TourEyes& eyes, std::uint32_t i, const Stop& stop) {
    places.Add(i, slam::Keep(eyes.TakeCloud(stop)));
  };
  const auto ask = [&](TourEyes& eyes, const Stop& stop, const std::vector<Stop>& known,
                       double& seconds) -> std::optional<Answer> {
    const slam::CloudPoints points = eyes.TakeCloud(stop);
    const Watch watch(seconds);
    const auto found =
        places.Find(slam::Keep(points), [&](std::uint32_t i) -> std::optional<slam::TurnGuess> {
          const Pose2 relative = Compose(Inverse(known[i].truth), stop.truth);
          if (simulation::Length(relative.position()) > study.doubt) return std::nullopt;
          const double off = (i % 2 == 0 ? 1 : -1) * study.turn_doubt / 4;
          return slam::TurnGuess{relative.yaw + off, study.turn_doubt};
        });
    if (!found) return std::nullopt;
    return Answer{found->key_frame, found->registration.relative, found->registration.overlap,
                  IsSure(found->registration, places.settings().registration)};
  };
  return Measure(study, remember, ask, say);
}

std::string Table(const std::vector<PlaceFigures>& figures) {
  std::string text =
      "| light | stops | recognized | of them wrong | position | farthest off | least sure right one | surest "
      "wrong one | a stop |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const PlaceFigures& one : figures) {
    char line[160];
    std::snprintf(line, sizeof(line),
                  "| %.3f | %d | %.1f %% | %d | %.3f m | %.2f m | %.2f | %.2f | %.0f ms |\n",
                  one.light, one.asked, 100 * one.recall(), one.wrong, one.error, one.farthest,
                  one.least_right, one.most_wrong, 1e3 * one.seconds / std::max(one.asked, 1));
    text += line;
  }
  return text;
}

}  // namespace coppice::robot::training
