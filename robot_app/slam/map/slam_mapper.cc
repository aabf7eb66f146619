#include "robot_app/slam/map/slam_mapper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

// Odometry between two key frames: standard deviations at rest, and more for each metre and radian.
// Wheels slip along their floor, not out of it.
constexpr double kSlip = 0.004;  // m
constexpr double kSlipPerMetre = 0.015;
constexpr double kLift = 0.002;  // m
constexpr double kLiftPerMetre = 0.003;
constexpr double kTwist = 0.003;  // rad
constexpr double kTwistPerMetre = 0.004;
constexpr double kTwistPerRadian = 0.01;
// What closures measure.
constexpr double kPicturePlace = 0.05;  // m
constexpr double kPictureTurn = 0.012;  // rad
constexpr double kCloudPlace = 0.04;
constexpr double kCloudTurn = 0.01;

constexpr float kKeptEdge = 0.1F;         // m: a point in each such cube is kept
constexpr float kKeptRange = 40;          // m
constexpr double kNear = 4;               // m: what is of use there is in the working memory,
constexpr std::size_t kEnough = 16;       // if there are not so many already,
constexpr std::size_t kRetrieved = 1;     // at once
constexpr double kPlace = 1;              // m: key frames in such a square,
constexpr double kPlaceTurn = M_PI_2;     // rad: and so turned were taken at one place
constexpr double kLeastDoubt = 1.5;       // m: clouds are asked for places so near to the robot
constexpr double kMostDoubt = 6;          // m
constexpr double kLeastTurnDoubt = 0.06;  // rad: and turned as it is, but for so much
constexpr double kMostTurnDoubt = 0.4;
constexpr double kBetweenClouds = 1;  // m of way between two closures by clouds

double AngleOf(const Pose3& pose) { return Eigen::AngleAxisd(pose.linear()).angle(); }

Matrix6 OfStep(const Pose3& moved) {
  const double way = moved.translation().norm();
  Matrix6 information =
      InformationOf(kSlip + kSlipPerMetre * way,
                    kTwist + kTwistPerMetre * way + kTwistPerRadian * AngleOf(moved));
  const double lift = kLift + kLiftPerMetre * way;
  information(2, 2) = 1 / (lift * lift);
  return information;
}

}  // namespace

SlamMapper::SlamMapper(const Vocabulary& vocabulary, const PlaceClassifier& classifier,
                       MapperSettings settings, std::unique_ptr<MapStore> store)
    : settings_(std::move(settings)),
      store_(std::move(store)),
      graph_(settings_.graph),
      pictures_(vocabulary, settings_.pictures),
      clouds_(classifier, settings_.clouds),
      memory_(settings_.working),
      environment_(settings_.environment) {}

Outcome SlamMapper::Resume(SlamMap map) {
  graph_ = SessionGraph(settings_.graph, std::move(map.graph), std::move(map.sessions));
  key_frames_ = std::move(map.key_frames);
  names_ = std::move(map.names);
  if (store_ != nullptr && store_->key_frames() < key_frames_.size()) {
    const Outcome kept = store_->Keep(names_, graph_, key_frames_);
    if (!kept) return kept;
  }
  for (std::uint32_t i = 0; i < key_frames_.size(); ++i) memory_.Add();
  Use({});
  for (std::uint32_t i = 0; i < key_frames_.size(); ++i) {
    if (!memory_.IsWorking(i)) {
      if (store_ != nullptr) key_frames_[i].reset();
      continue;
    }
    auto read = key_frame(i);
    if (!read) return Problem{read.problem()};
    key_frames_[i] = *std::move(read);
    RememberAgain(i);
  }
  return {};
}

Expected<std::shared_ptr<const KeyFrame>> SlamMapper::key_frame(std::uint32_t pose) const {
  if (key_frames_[pose] != nullptr) return key_frames_[pose];
  return store_->Read(pose);
}

void SlamMapper::BeginSession(const std::string& name) {
  graph_.BeginSession();
  names_.push_back({name, 0});
  is_first_ = true;
  session_begin_ = static_cast<std::uint32_t>(key_frames_.size());
  way_ = closed_at_ = 0;
}

bool SlamMapper::IsDue(const Pose3& odometry) const {
  if (is_first_) return true;
  const Pose3 moved = at_key_frame_.inverse() * odometry;
  return moved.translation().norm() >= settings_.step || AngleOf(moved) >= settings_.turn;
}

MapperReport SlamMapper::Add(const Sight& sight) {
  const Pose3 moved = is_first_ ? Pose3::Identity() : at_key_frame_.inverse() * sight.odometry;
  if (is_first_) names_.back().begin = sight.stamp;
  is_first_ = false;
  at_key_frame_ = sight.odometry;
  way_ += moved.translation().norm();
  MapperReport report;
  report.key_frame = graph_.AddPose(moved, OfStep(moved));

  auto key_frame = std::make_shared<KeyFrame>();
  key_frame->stamp = sight.stamp;
  key_frame->descriptor = Describe(sight.cloud);
  environment_.Add(sight.stamp, Read(key_frame->descriptor, sight.brightness));
  const SlamConfiguration configuration = ConfigurationFor(environment_.surroundings());
  key_frame->range = configuration.range;
  key_frame->place = sight.place;
  key_frame->points = Thinned(sight.cloud, kKeptEdge, kKeptRange);
  for (const SightPicture& picture : sight.pictures) {
    key_frame->pictures.push_back(std::make_shared<PictureFeatures>(picture.features));
    if (configuration.has_cameras) key_frame->camera_clouds.push_back(picture.cloud);
  }
  key_frames_.push_back(key_frame);
  memory_.Add();
  if (!environment_.is_dark()) LookAtPictures(sight, report);
  KnownCloud cloud{key_frame->descriptor, ThinOut(key_frame->points)};
  LookAtCloud(cloud, report);
  graph_.Refine();
  report.work = graph_.TakeWork();
  Remember(report.key_frame, std::move(cloud));
  if (store_ != nullptr) report.problem = store_->Keep(names_, graph_, key_frames_).problem();
  const Outcome applied = Apply(Use(Near(kNear)));
  if (!applied) report.problem = applied.problem();
  return report;
}

Outcome SlamMapper::PlaceNewest(const Pose2D& place) {
  auto placed = std::make_shared<KeyFrame>(*key_frames_.back());
  placed->place = place;
  key_frames_.back() = placed;
  if (store_ == nullptr) return {};
  return store_->Replace(static_cast<std::uint32_t>(key_frames_.size() - 1), *placed);
}

MemoryChange SlamMapper::Use(const std::vector<std::uint32_t>& near) {
  return memory_.Use(near, kEnough, kRetrieved,
                     [this](std::uint32_t key_frame) { return PlaceOf(key_frame); });
}

std::uint64_t SlamMapper::PlaceOf(std::uint32_t key_frame) const {
  const Pose3& pose = graph_.poses()[key_frame];
  const Eigen::Vector3d ahead = pose.linear().col(0);
  const auto square = [](double metres) {
    return static_cast<std::uint64_t>(std::lround(metres / kPlace)) & 0xFFFF;
  };
  const auto turn =
      static_cast<std::uint64_t>(std::lround(std::atan2(ahead.y(), ahead.x()) / kPlaceTurn + 4));
  const std::uint64_t map = graph_.map_of(graph_.sessions()[key_frame]);
  return map << 48 | square(pose.translation().x()) << 32 | square(pose.translation().y()) << 16 |
         (square(pose.translation().z()) & 0xFFF) << 4 | (turn & 3);
}

void SlamMapper::Remember(std::uint32_t key_frame, KnownCloud cloud) {
  for (const auto& picture : key_frames_[key_frame]->pictures) pictures_.Add(key_frame, picture);
  clouds_.Add(key_frame, std::move(cloud));
}

void SlamMapper::RememberAgain(std::uint32_t key_frame) {
  const KeyFrame& kept = *key_frames_[key_frame];
  Remember(key_frame, {kept.descriptor, ThinOut(kept.points)});
}

Outcome SlamMapper::Apply(const MemoryChange& change) {
  Outcome all;
  for (const std::uint32_t key_frame : change.retrieved) {
    auto read = this->key_frame(key_frame);
    if (!read) {
      memory_.PutBack(key_frame);
      all = Problem{read.problem()};
      continue;
    }
    key_frames_[key_frame] = *std::move(read);
    RememberAgain(key_frame);
  }
  for (const std::uint32_t key_frame : change.forgotten) {
    pictures_.Remove(key_frame);
    clouds_.Remove(key_frame);
    // What is not on the disk stays in memory.
    if (store_ != nullptr && key_frame < store_->key_frames()) key_frames_[key_frame].reset();
  }
  return all;
}

// Key frames of the map around the newest one, the nearest first.
std::vector<std::uint32_t> SlamMapper::Near(double radius) const {
  std::vector<std::pair<double, std::uint32_t>> near;
  const auto newest = static_cast<std::uint32_t>(graph_.poses().size() - 1);
  for (std::uint32_t i = 0; i < newest; ++i) {
    if (!graph_.InOneMap(i, newest)) continue;
    const Pose3& pose = graph_.poses()[i];
    const double way = (pose.translation() - graph_.poses()[newest].translation()).norm();
    if (way <= radius) near.push_back({way, i});
  }
  std::sort(near.begin(), near.end());
  std::vector<std::uint32_t> key_frames;
  for (const auto& [way, key_frame] : near) key_frames.push_back(key_frame);
  return key_frames;
}

bool SlamMapper::IsOld(std::uint32_t key_frame) const {
  return key_frame < session_begin_ || key_frame + settings_.recent < graph_.poses().size();
}

std::optional<KnownPlace> SlamMapper::Recognize(const std::vector<SightPicture>& pictures) {
  std::optional<PicturePlace> best;
  for (const SightPicture& picture : pictures) {
    const auto found = pictures_.Find(picture.features, picture.camera,
                                      [this](std::uint32_t k) { return IsOld(k); });
    if (!found || !IsSure(found->match, settings_.pictures.match)) continue;
    if (!best || found->match.inliers > best->match.inliers) best = found;
    if (IsClear(best->match, settings_.pictures.match)) break;
  }
  if (!best) return std::nullopt;
  return KnownPlace{best->key_frame, best->match.relative};
}

void SlamMapper::LookAtPictures(const Sight& sight, MapperReport& report) {
  const auto best = Recognize(sight.pictures);
  if (!best) return;
  report.by_picture = Link{best->key_frame, report.key_frame, best->relative,
                           InformationOf(kPicturePlace, kPictureTurn), LinkKind::kPicture};
  report.of_picture = Close(*report.by_picture);
}

void SlamMapper::LookAtCloud(const KnownCloud& cloud, MapperReport& report) {
  if (closed_at_ > 0 && way_ - closed_at_ < kBetweenClouds) return;
  const double way = way_ - closed_at_;
  const double doubt = std::min(kLeastDoubt + settings_.drift * way, kMostDoubt);
  const double turn_doubt = std::min(kLeastTurnDoubt + settings_.twist * way, kMostTurnDoubt);
  const Pose3& here = graph_.poses()[report.key_frame];
  const auto found = clouds_.Find(cloud, [&](std::uint32_t k) -> std::optional<TurnGuess> {
    if (!IsOld(k) || !graph_.InOneMap(k, report.key_frame)) return std::nullopt;
    const Pose3 relative = graph_.poses()[k].inverse() * here;
    if (relative.translation().norm() > doubt) return std::nullopt;
    return TurnGuess{ToPose2D(relative).yaw, turn_doubt};
  });
  if (!found || !IsSure(found->registration, settings_.clouds.registration)) return;
  report.by_cloud = Link{found->key_frame, report.key_frame, found->registration.relative,
                         InformationOf(kCloudPlace, kCloudTurn), LinkKind::kCloud};
  report.of_cloud = Close(*report.by_cloud);
}

Verdict SlamMapper::Close(const Link& link) {
  const Verdict verdict = graph_.AddClosure(link);
  if (verdict == Verdict::kBelieved) closed_at_ = way_;
  return verdict;
}

Pose3 SlamMapper::PoseOf(const Pose3& odometry) const {
  if (is_first_) return Pose3::Identity();
  return graph_.poses().back() * at_key_frame_.inverse() * odometry;
}

bool SlamMapper::IsJoined() const {
  if (is_first_) return key_frames_.empty();
  const std::uint32_t last = graph_.session_count();
  return last <= 1 || graph_.map_of(last - 1) != last - 1;
}

SlamMap SlamMapper::Map() const { return {key_frames_, graph_.graph(), graph_.sessions(), names_}; }

}  // namespace coppice::robot::slam
