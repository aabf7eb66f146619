#include "robot_app/localization/localizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot_app/localization/scan_matcher.h"

namespace coppice::robot::localization {
namespace {

constexpr double kSpacing = 0.12;        // of the beams' ends [m]
constexpr int kMostBeams = 180;          // of a scan
constexpr int kFewestAgreeing = 15;      // beams; fewer prove nothing
constexpr double kTogether = 0.8;        // share of the particles in the heaviest group
constexpr double kStep = 0.05;           // the filter weighs again after this motion [m], [rad]
constexpr double kRest = 0.5;            // or, while not confirmed, after this time [s]
constexpr double kMatchedWithin = 0.25;  // a match farther from the particles is none [m]
constexpr double kMatchedTurn = 0.15;    // rad
constexpr double kHeld = 0.05;           // so well do the particles hold what a scan does not [m]
constexpr double kJumpDeviation = 0.2;   // when the odometry was restarted [m], [rad]
constexpr double kStillLook = 3;         // s; long enough for who has not moved to be sure
constexpr double kExpectedWithin = 2;    // m
constexpr double kExpectedTurn = 0.8;    // rad
constexpr std::size_t kMostPlaces = 8;
constexpr double kSudden = 0.07;      // share of a scan that changes at once: no person does that
constexpr double kBeyondDoors = 0.1;  // more than doors make out that stand otherwise
constexpr double kClearlyBetter = 0.04;  // share of the beams
constexpr int kSeenThroughWalls = 3;     // beams, more than at the better place
constexpr int kTwice = 2;                // searches in a row that find nothing better: it holds
constexpr double kSoon = 0.5;            // the next search, when in doubt [s]
constexpr double kFreshAtLeast = 0.3;
constexpr double kSetBack = 1;       // time itself was set back, not a scan overtaken [s]
constexpr double kHintWithin = 0.5;  // m
constexpr double kHintTurn = 0.2;    // rad
constexpr double kOtherView = 0.3;   // m, rad: between two hints that do not depend on each other
constexpr double kLookAroundAfter = 1;  // not confirmed for so long [s]

}  // namespace

struct Localizer::Map {
  explicit Map(const OccupancyGrid& grid) : field(grid), search(field) {}
  LikelihoodField field;
  PlaceSearch search;
};

Localizer::Localizer(LocalizerSettings settings)
    : settings_(settings), filter_(settings.filter, settings.seed) {}
Localizer::~Localizer() = default;

void Localizer::SetMap(const OccupancyGrid& map) {
  map_ = std::make_unique<Map>(map);
  Relocalize();
}

void Localizer::Relocalize() {
  filter_ = ParticleFilter(settings_.filter, settings_.seed);
  belief_ = {};
  view_.Clear();
  begun_ = proven_ = fits_ = lost_ = false;
  doubted_ = false;
  contested_ = 0;
  rivals_ = 0;
  hint_.reset();
  elsewhere_.reset();
}

void Localizer::SetPose(const Pose2D& pose, double deviation, double yaw_deviation) {
  filter_.Set(pose, deviation, yaw_deviation);
  expected_.clear();
  PutAt(pose, true);
}

// The particles have just been put there.
void Localizer::PutAt(const Pose2D& pose, bool proven) {
  belief_ = filter_.belief();
  pose_ = pose;
  filter_lag_ = {};
  weighed_ = -std::numeric_limits<double>::infinity();
  proven_ = proven;
  jumped_ = !proven;
  doubted_ = false;
  contested_ = 0;
  rivals_ = 0;
  if (proven) elsewhere_.reset();
  view_.Clear();
}

void Localizer::AddHint(double stamp, const Pose2D& pose) {
  const auto odometry = history_.At(stamp);
  if (!odometry || !begun_ || stamp <= doubted_at_) return;
  hint_ = Hint{Compose(pose, RelativeTo(*odometry, Pose2D{})), *odometry, history_.frame()};
}

std::optional<Pose2D> Localizer::pose() const {
  if (filter_.empty()) return std::nullopt;
  return pose_;
}

void Localizer::AddOdometry(double stamp, const Pose2D& pose) {
  history_.Add(stamp, pose);
  if (waiting_) AddScan(std::move(*waiting_));
}

void Localizer::AddScan(LaserScan scan) {
  waiting_.reset();
  if (!std::isfinite(scan.stamp)) return;
  if (!history_.empty() && scan.stamp <= history_.newest()) {
    const auto odometry = history_.At(scan.stamp);
    const bool overtaken = begun_ && scan.stamp <= stamp_ && scan.stamp >= stamp_ - kSetBack;
    if (odometry && map_ && !overtaken) Process(scan, *odometry);
  } else {
    waiting_ = std::move(scan);
  }
}

void Localizer::Process(const LaserScan& scan, const Pose2D& odometry) {
  const std::vector<Beam> beams = BeamsOf(scan, kSpacing, kMostBeams);
  if (begun_ && scan.stamp < stamp_ - kSetBack) {
    Relocalize();
    expected_ = starts_;
  }
  if (!begun_) Begin(scan.stamp);
  stamp_ = scan.stamp;
  Advance(odometry);
  if (change_.Add(scan, odometry) >= kSudden) Doubt();
  if (filter_.empty() && stamp_ >= next_search_) Start(beams);
  if (!filter_.empty()) {
    Follow(beams);
    Judge(beams);
  }
  if (TakeHint(beams)) return;
  // Though another place fits better, nothing speaks against this one yet but that.
  const bool holds = fits_ && proven_ && !doubted_;
  if (stamp_ - confirmed_ > kLookAroundAfter && !holds) {
    if (!looking_) view_.Clear();  // perhaps the robot was carried away since
    looking_ = true;
    LookAround(beams);
  } else {
    looking_ = false;
    view_.Add(odometry_, beams);
    LookForBetter(beams);
  }
}

// Not confirmed yet, but nobody needs to worry before the usual time is over.
void Localizer::Begin(double stamp) {
  begun_ = true;
  confirmed_ = stamp - settings_.uncertain_after;
  frame_ = history_.frame();
  odometry_ = *history_.At(stamp);
  next_search_ = weighed_ = stamp;
}

// Perhaps the robot was carried away: what was seen before proves nothing.
void Localizer::Doubt() {
  doubted_ = true;
  doubted_at_ = stamp_;
  hint_.reset();
  elsewhere_.reset();
  view_.Clear();
  next_search_ = stamp_;
}

void Localizer::Advance(const Pose2D& odometry) {
  if (history_.frame() == frame_) {
    const Pose2D motion = RelativeTo(odometry_, odometry);
    pose_ = Compose(pose_, motion);
    filter_lag_ = Compose(filter_lag_, motion);
  } else {
    frame_ = history_.frame();
    filter_.Spread(kJumpDeviation, kJumpDeviation);
    view_.Clear();
    change_.Clear();
  }
  odometry_ = odometry;
}

void Localizer::Start(const std::vector<Beam>& beams) {
  const std::vector<FittingPlace> places = map_->search.Find(beams, kMostPlaces);
  const double best = places.empty() ? 0 : places.front().agreement.share();
  for (const Pose2D& expected : expected_) {
    const Pose2D matched = MatchScan(map_->field, beams, expected);
    // First the place itself: along a corridor others may fit as well.
    std::vector<FittingPlace> candidates = {{matched, Agree(map_->field, beams, matched)}};
    candidates.insert(candidates.end(), places.begin(), places.end());
    const auto is_it = [&](const FittingPlace& place) {
      return place.agreement.score() >= settings_.agree &&
             place.agreement.share() > best - settings_.margin / 2 &&
             Distance(place.pose, expected) < kExpectedWithin &&
             std::abs(NormalizeAngle(place.pose.yaw - expected.yaw)) < kExpectedTurn;
    };
    const auto found = std::find_if(candidates.begin(), candidates.end(), is_it);
    if (found == candidates.end()) continue;
    expected_.clear();
    filter_.Set(found->pose, 0.1, 0.05);
    return PutAt(found->pose, true);
  }
  expected_.clear();
  if (places.empty() || places.front().agreement.score() < settings_.agree) return;
  filter_.Inject(places, 1);
  PutAt(places.front().pose, false);
}

void Localizer::Follow(const std::vector<Beam>& beams) {
  const bool moved =
      std::hypot(filter_lag_.x, filter_lag_.y) > kStep || std::abs(filter_lag_.yaw) > kStep;
  if (moved || (stamp_ - confirmed_ > 1 && stamp_ - weighed_ > kRest)) {
    filter_.Move(filter_lag_);
    filter_.Weigh(map_->field, beams);
    filter_lag_ = {};
    weighed_ = stamp_;
    belief_ = filter_.belief();
  }
  const Pose2D believed = Compose(belief_.pose, filter_lag_);
  if (!IsSamePlace(believed, pose_)) {
    pose_ = believed;
    jumped_ = true;
    proven_ = false;
  }
  // The scan says it more precisely than the particles, as long as both mean the same place. Along
  // a corridor it says next to nothing, and the walls of a map that is not quite straight would
  // draw it along: there the particles hold it.
  MatchSettings held;
  held.trust = kHeld;
  const Pose2D matched = MatchScan(map_->field, beams, believed, held);
  const double limit = std::max(kMatchedWithin, 2 * belief_.deviation());
  if (Distance(matched, believed) < limit &&
      std::abs(NormalizeAngle(matched.yaw - believed.yaw)) < kMatchedTurn) {
    pose_ = matched;
  } else {
    pose_ = believed;
  }
}

void Localizer::Judge(const std::vector<Beam>& beams) {
  agreement_ = Agree(map_->field, beams, pose_);
  fits_ = agreement_.agree >= kFewestAgreeing && agreement_.score() >= settings_.agree &&
          belief_.share >= kTogether && belief_.deviation() <= settings_.largest_deviation;
  if (fits_ && proven_ && contested_ == 0) {
    confirmed_ = stamp_;
    lost_ = false;
  }
  if (!lost_ && stamp_ - confirmed_ > settings_.lost_after) {
    lost_ = true;
    proven_ = false;
  }
}

void Localizer::LookForBetter(const std::vector<Beam>& beams) {
  if (stamp_ < next_search_) return;
  if (IsBetterElsewhere(beams)) {
    ++contested_;
    uncontested_ = 0;
  } else if (++uncontested_ >= kTwice) {
    contested_ = 0;
  }
  next_search_ = stamp_ + (doubted_ || contested_ > 0 ? kSoon : settings_.check_period);
}

bool Localizer::IsBetterElsewhere(const std::vector<Beam>& beams) {
  // That things stand where the map has none is no reason to doubt: the corridor may be blocked.
  // But nobody sees through walls, nor does a robot that moves see such things everywhere.
  const double clearly = doubted_ ? kClearlyBetter : kBeyondDoors;
  if (FitsBetterElsewhere(beams, doubted_ ? 0 : kSeenThroughWalls, clearly)) return true;
  if (!view_.complete()) return false;
  if (FitsBetterElsewhere(view_.From(odometry_), 0, clearly)) return true;
  doubted_ = false;
  return false;
}

// `through`: so many beams more must pass through walls here than there; `clearly`: such a larger
// share of them must agree there.
bool Localizer::FitsBetterElsewhere(const std::vector<Beam>& beams, int through,
                                    double clearly) const {
  const std::vector<FittingPlace> places = map_->search.Find(beams, 2);
  if (places.empty() || IsSamePlace(places.front().pose, pose_)) return false;
  const Agreement here = Agree(map_->field, beams, pose_);
  const Agreement there = places.front().agreement;
  return there.share() > here.share() + clearly && there.through + through <= here.through;
}

// True: it is believed, and the robot stands where it says.
bool Localizer::TakeHint(const std::vector<Beam>& beams) {
  if (!hint_) return false;
  const Hint hint = *hint_;
  hint_.reset();
  if (hint.frame != frame_) return false;
  const Pose2D expected = Compose(hint.odom_in_map, odometry_);
  const Pose2D matched = MatchScan(map_->field, beams, expected);
  const Agreement there = Agree(map_->field, beams, matched);
  if (Distance(matched, expected) > kHintWithin ||
      std::abs(NormalizeAngle(matched.yaw - expected.yaw)) > kHintTurn ||
      there.agree < kFewestAgreeing || there.score() < settings_.agree ||
      !FitsAsWellAsAnywhere(beams, matched)) {
    return false;
  }
  // The same picture twice says nothing new, however often it comes.
  const bool is_known = elsewhere_ && IsOfSamePlace(hint);
  if (is_known && !IsOfOtherView(hint)) return false;
  const bool is_here = !filter_.empty() && IsSamePlace(matched, pose_);
  if (is_here && fits_) {
    proven_ = true;
    doubted_ = jumped_ = false;
    contested_ = 0;
    rivals_ = 0;
    elsewhere_.reset();
  } else if (is_here || is_known || (!elsewhere_ && (!fits_ || !proven_))) {
    filter_.Set(matched, 0.1, 0.05);
    PutAt(matched, true);
  } else {
    if (proven_) Doubt();
    proven_ = false;
    elsewhere_ = hint;
    return false;
  }
  recognized_ = stamp_;
  return true;
}

bool Localizer::FitsAsWellAsAnywhere(const std::vector<Beam>& beams, const Pose2D& pose) const {
  std::vector<Beam> all = view_.From(odometry_);
  all.insert(all.end(), beams.begin(), beams.end());
  const std::vector<FittingPlace> places = map_->search.Find(all, 1);
  return places.empty() || Agree(map_->field, all, pose).share() + settings_.margin >
                               places.front().agreement.share();
}

// Than the one before.
bool Localizer::IsOfOtherView(const Hint& hint) const {
  return Distance(elsewhere_->odometry, hint.odometry) > kOtherView ||
         std::abs(NormalizeAngle(elsewhere_->odometry.yaw - hint.odometry.yaw)) > kOtherView;
}

bool Localizer::IsOfSamePlace(const Hint& hint) const {
  return elsewhere_->frame == hint.frame && IsSamePlace(Compose(elsewhere_->odom_in_map, odometry_),
                                                        Compose(hint.odom_in_map, odometry_));
}

void Localizer::LookAround(const std::vector<Beam>& beams) {
  if (view_.empty()) view_since_ = stamp_;
  const bool grown = view_.Add(odometry_, beams);
  if (!grown && stamp_ < next_search_) return;
  next_search_ = stamp_ + settings_.search_period;
  std::vector<Beam> all = view_.From(odometry_);
  all.insert(all.end(), beams.begin(), beams.end());
  Consider(map_->search.Find(all, kMostPlaces));
}

void Localizer::Consider(const std::vector<FittingPlace>& places) {
  rivals_ = 0;
  if (places.empty() || places.front().agreement.score() < settings_.agree) {
    // What has been put together is not of this map: perhaps the robot was carried in between.
    if (view_.complete()) view_.Clear();
    return;
  }
  std::vector<FittingPlace> fitting;
  for (const FittingPlace& place : places) {
    const double worse = places.front().agreement.share() - place.agreement.share();
    if (worse < settings_.margin) fitting.push_back(place);
  }
  rivals_ = fitting.size() - 1;
  const Pose2D& best = places.front().pose;
  const bool is_here = IsSamePlace(best, pose_) && !filter_.empty();
  const bool has_waited = !jumped_ && is_here && stamp_ - view_since_ > kStillLook;
  if (rivals_ == 0 && (view_.complete() || has_waited)) {
    if (!is_here) {
      filter_.Set(best, 0.1, 0.05);
      PutAt(best, true);
    }
    proven_ = true;
    jumped_ = false;
    contested_ = 0;
    elsewhere_.reset();
  } else {
    filter_.Inject(fitting, std::max(kFreshAtLeast, filter_.FreshShare()));
  }
}

LocalizationReport Localizer::Report(double now) const {
  LocalizationReport report;
  if (!begun_) {
    report.deviation = report.seconds_since_recognized = std::numeric_limits<double>::infinity();
    report.message = map_ ? "waits for the first scan with odometry" : "waits for the map";
    return report;
  }
  report.seconds_since_recognized = std::max(0.0, now - recognized_);
  report.seconds_since_confirmed = std::max(0.0, now - confirmed_);
  report.score = filter_.empty() ? 0 : agreement_.score();
  report.deviation =
      filter_.empty() ? std::numeric_limits<double>::infinity() : belief_.deviation();
  const bool ambiguous = view_.complete() && rivals_ > 0;
  if (report.seconds_since_confirmed < settings_.uncertain_after) {
    report.phase = LocalizationPhase::kOk;
    report.message = "the scan agrees with the map";
  } else if (ambiguous) {
    report.message = std::to_string(rivals_ + 1) + " places on the map fit what the robot sees";
  } else if (report.seconds_since_confirmed < settings_.lost_after) {
    report.message = fits_ ? "not proven yet" : "the scan does not agree with the map";
  } else if (now - stamp_ > 1) {
    report.message = "no scan with odometry";  // without eyes, but not lost
  } else {
    report.phase = LocalizationPhase::kLost;
    report.message = fits_ ? "a place fits; a full turn on the spot would prove it"
                           : "no place is known that fits; a full turn on the spot would help";
  }
  return report;
}

}  // namespace coppice::robot::localization
