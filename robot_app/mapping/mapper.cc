#include "robot_app/mapping/mapper.h"

#include <algorithm>
#include <cmath>

#include "robot_app/localization/scan_matcher.h"
#include "robot_app/mapping/loop_closure.h"

namespace coppice::robot::mapping {
namespace {

using localization::LikelihoodField;

constexpr double kSpacing = 0.1;  // of the beams that are matched [m]
constexpr int kMostBeams = 250;
constexpr double kBeamNoise = 0.05;  // m; the walls that were just drawn are exact
// Odometry between two key frames: standard deviations at rest, and more for each metre and radian.
constexpr double kSlip = 0.003;  // m
constexpr double kSlipPerMetre = 0.015;
constexpr double kTwist = 0.003;  // rad
constexpr double kTwistPerMetre = 0.005;
constexpr double kTwistPerRadian = 0.02;
constexpr double kAfterJump = 0.3;     // m and rad: odometry has told nothing
constexpr std::size_t kFew = 3;        // key frames that may be missing from what was seen lately
constexpr std::size_t kLookEvery = 4;  // key frames, for the end of a loop
constexpr double kLeastDoubt = 0.4;    // m
constexpr double kMostDoubt = 6;       // m
constexpr double kYawDoubt = 0.3;      // rad, and more with the way
constexpr double kMostYawDoubt = 0.8;
constexpr double kDrawnWell = 0.5;  // cells by which a pose may be off in the drawn map

}  // namespace

Mapper::Mapper(MappingSettings settings, const Pose2D& start)
    : settings_(settings), start_(start), grid_(settings.resolution) {}

void Mapper::AddOdometry(double stamp, const Pose2D& pose) {
  history_.Add(stamp, pose);
  UseWaiting();
}

void Mapper::AddScan(LaserScan scan) {
  waiting_ = std::move(scan);
  UseWaiting();
}

void Mapper::UseWaiting() {
  if (!waiting_) return;
  const auto odometry = history_.At(waiting_->stamp);
  if (!odometry) return;
  const LaserScan scan = *std::move(waiting_);
  waiting_.reset();
  if (started() && history_.frame() != odometry_frame_) {
    // Another odometry frame: the newest key frame is put where the robot was last seen in it.
    at_frame_ = Compose(*odometry, RelativeTo(odometry_, at_frame_));
    jumped_ = true;
  }
  odometry_frame_ = history_.frame();
  odometry_ = *odometry;
  stamp_ = scan.stamp;
  if (!started() || jumped_ || IsFarEnough()) AddKeyFrame(scan);
}

bool Mapper::IsFarEnough() const {
  return Distance(at_frame_, odometry_) >= settings_.step ||
         std::abs(NormalizeAngle(odometry_.yaw - at_frame_.yaw)) >= settings_.turn;
}

void Mapper::AddKeyFrame(const LaserScan& scan) {
  if (frames_.size() >= settings_.most_frames) {
    too_large_ = true;
    return;
  }
  if (!started()) {
    frames_.poses.push_back(start_);
  } else {
    const PoseConstraint step = MatchWithLast(scan, RelativeTo(at_frame_, odometry_));
    way_ += std::hypot(step.relative.x, step.relative.y);
    frames_.poses.push_back(Compose(frames_.poses.back(), step.relative));
    constraints_.push_back(step);
  }
  frames_.scans.push_back(scan);
  at_frame_ = odometry_;
  jumped_ = false;
  if (frames_.size() % kLookEvery == 0) LookForLoop();
  Draw();
}

const LikelihoodField& Mapper::SeenLately() {
  const std::size_t end = frames_.size();
  if (!lately_ || end <= kFew || end - lately_end_ >= kFew) {
    const std::size_t first = end - std::min(end, settings_.window);
    lately_ = std::make_unique<LikelihoodField>(MapOf(frames_, first, end, settings_));
    lately_end_ = end;
  }
  return *lately_;
}

PoseConstraint Mapper::MatchWithLast(const LaserScan& scan, const Pose2D& moved) {
  const std::size_t last = frames_.size() - 1;
  const double metres = std::hypot(moved.x, moved.y);
  localization::MatchSettings match;
  match.beam_noise = kBeamNoise;
  match.trust = jumped_ ? kAfterJump : kSlip + kSlipPerMetre * metres;
  match.yaw_trust = jumped_ ? kAfterJump
                            : kTwist + kTwistPerMetre * metres +
                                  kTwistPerRadian * std::abs(NormalizeAngle(moved.yaw));
  const Pose2D guess = Compose(frames_.poses[last], moved);
  const LikelihoodField& field = SeenLately();
  const std::vector<localization::Beam> beams =
      BeamsWithin(scan, settings_.range, kSpacing, kMostBeams);
  const Pose2D matched = localization::MatchScan(field, beams, guess, match);
  score_ = localization::Agree(field, beams, matched).score();

  const double position = 1 / (match.trust * match.trust);
  const double yaw = 1 / (match.yaw_trust * match.yaw_trust);
  PoseConstraint step;
  step.from = last;
  step.to = last + 1;
  step.information = Eigen::Vector3d(position, position, yaw).asDiagonal();
  const bool fits = score_ >= settings_.agree;
  step.relative = fits ? RelativeTo(frames_.poses[last], matched) : moved;
  if (fits) {
    step.information +=
        AlongAxesOf(matched, localization::MatchInformation(field, beams, matched, match));
  }
  return step;
}

void Mapper::LookForLoop() {
  const double unbound = settings_.drift * (way_ - closed_at_);
  const PoseDoubt doubt{std::min(kMostDoubt, kLeastDoubt + unbound),
                        std::min(kMostYawDoubt, kYawDoubt + unbound / 10)};
  const auto closure = FindLoopClosure(frames_, doubt, settings_);
  if (!closure) return;
  constraints_.push_back(*closure);
  OptimizePoses(constraints_, frames_.poses);
  lately_.reset();
  closed_at_ = way_;
  ++loops_;
}

// A key frame is entered as it comes; when the poses have moved all are entered anew.
void Mapper::Draw() {
  const double most = kDrawnWell * settings_.resolution;
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const double turned = std::abs(NormalizeAngle(frames_.poses[i].yaw - drawn_[i].yaw));
    if (Distance(frames_.poses[i], drawn_[i]) <= most && turned * settings_.range <= 2 * most) {
      continue;
    }
    grid_ = LogOddsGrid(settings_.resolution);
    drawn_.clear();
    break;
  }
  for (std::size_t i = drawn_.size(); i < frames_.size(); ++i) {
    too_large_ = !grid_.Add(frames_.scans[i], frames_.poses[i], settings_.range) || too_large_;
    drawn_.push_back(frames_.poses[i]);
  }
  ++revision_;
}

MappingReport Mapper::Report() const {
  MappingReport report;
  report.key_frames = frames_.size();
  report.loops = loops_;
  report.way = way_;
  report.score = score_;
  report.fits = score_ >= settings_.agree;
  report.message = !started()    ? "waits for the laser and odometry"
                   : too_large_  ? "the map is as large as it can be; save it"
                   : report.fits ? "maps"
                                 : "what is seen does not fit the map; drive back a little, slowly";
  return report;
}

}  // namespace coppice::robot::mapping
