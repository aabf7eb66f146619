#include "robot_app/common/places/site_places.h"

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "bt_core/model/write_file.h"

namespace coppice::robot {
namespace {

TopologicalMap Load(const std::string& path) {
  Diagnostics diagnostics;
  std::optional<TopologicalMap> map = TopologicalMap::Load(path, diagnostics);
  if (!map) throw std::runtime_error("cannot use the places:\n" + diagnostics.ToString());
  if (map->FirstOf("patrol") < 0) {
    throw std::runtime_error(path + ": no place has the category \"patrol\"");
  }
  return *std::move(map);
}

}  // namespace

SitePlaces::SitePlaces(const std::string& path, unsigned seed, const Clock& clock,
                       std::string memory)
    : guide_(Load(path)), random_(seed), clock_(clock), memory_(std::move(memory)) {
  if (memory_.empty()) return;
  Diagnostics diagnostics;
  guide_.memory().Read(memory_, clock_.Now(), diagnostics);
  std::cerr << diagnostics.ToString();
}

SitePlaces::~SitePlaces() {
  writer_.reset();  // an older text must not come after this one
  if (!memory_.empty()) Write(guide_.memory().ToText());
}

const Place& SitePlaces::At(int index) const {
  return guide_.map().places()[static_cast<std::size_t>(index)];
}

Expected<int> SitePlaces::Index(const std::string& place) const {
  const int index = guide_.map().Find(place);
  if (index >= 0) return index;
  const std::string hint = DidYouMean(place, guide_.map().Names());
  return Problem{"there is no place \"" + place + "\"" + (hint.empty() ? "" : "; " + hint)};
}

leaves::Waypoint SitePlaces::ChooseForPatrol() {
  const std::lock_guard<std::mutex> lock(mutex_);
  last_ = guide_.map().ChooseNext(random_, last_);
  return {At(last_).name, *At(last_).pose};
}

bool SitePlaces::Find(const std::string& name, leaves::Waypoint& waypoint) const {
  const int index = guide_.map().Find(name);
  if (index < 0 || !At(index).pose) return false;
  waypoint = {name, *At(index).pose};
  return true;
}

Expected<std::optional<leaves::RouteLeg>> SitePlaces::NextLeg(const Pose2D& robot,
                                                              const std::string& place,
                                                              const std::string& language) {
  const auto index = Index(place);
  if (!index) return Problem{index.problem()};
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto next = guide_.Next(robot, *index, clock_.Now());
  if (!next) return Problem{next.problem()};
  if (!*next) return std::optional<leaves::RouteLeg>();
  const Leg& leg = **next;
  if (leg.name != leg_) since_ = clock_.Now();
  leg_ = leg.name;
  return std::optional(
      leaves::RouteLeg{leg.name, ToString(leg.kind), leg.goal, At(leg.to).Spoken(language)});
}

bool SitePlaces::IsAt(const Pose2D& robot, const std::string& place) {
  const auto index = Index(place);
  if (!index) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto next = guide_.Next(robot, *index, clock_.Now());
  return next && !*next;
}

void SitePlaces::Ended(const std::string& leg, bool travelled, const Pose2D& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Time now = clock_.Now();
  const double seconds = std::chrono::duration<double>(now - since_).count();
  // A leg that somebody else remembered tells nothing of times.
  if (leg == leg_ || !travelled) guide_.Ended(leg, travelled, robot, seconds, now);
  leg_.clear();
  if (show_) show_(guide_);
  Save();
}

void SitePlaces::ShowWays(std::function<void(const RouteGuide&)> show) {
  const std::lock_guard<std::mutex> lock(mutex_);
  show_ = std::move(show);
  show_(guide_);
}

Expected<std::string> SitePlaces::Nearest(const Pose2D& robot, const std::string& category) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto place = guide_.Nearest(robot, category, clock_.Now());
  if (!place) return Problem{place.problem()};
  return At(*place).name;
}

Expected<leaves::Routes::Description> SitePlaces::Describe(const Pose2D& robot,
                                                           const std::string& place,
                                                           const std::string& language) {
  const auto index = Index(place);
  if (!index) return Problem{index.problem()};
  const std::lock_guard<std::mutex> lock(mutex_);
  return Description{At(*index).Spoken(language),
                     guide_.Words(robot, *index, language, clock_.Now())};
}

void SitePlaces::Save() {
  if (memory_.empty()) return;
  writer_->RunFinished();
  // When the disk is so slow that writers wait, a later one has all that this one has.
  writer_->Add([this, text = guide_.memory().ToText()]() -> ServiceCaller::Finish {
    Write(text);
    return [] {};
  });
}

void SitePlaces::Write(const std::string& text) const {
  Diagnostics diagnostics;
  if (!WriteFile(memory_, text, diagnostics)) std::cerr << diagnostics.ToString();
}

}  // namespace coppice::robot
