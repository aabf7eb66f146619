#include "robot_app/monitoring/tf_monitor.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

bool IsSame(const TransformWatch& a, const TransformWatch& b) {
  return a.parent == b.parent && a.child == b.child && a.node == b.node && a.age == b.age &&
         a.jump == b.jump && a.speed == b.speed;
}

double Distance(const TransformSample& a, const TransformSample& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

}  // namespace

void TfMonitor::Watch(const std::vector<TransformWatch>& pairs) {
  std::vector<Pair> watched;
  for (const TransformWatch& watch : pairs) {
    Pair pair{watch, Judge(watch.age, "s"), Judge(watch.jump, "m"), {}, {}, {}, {}, "", ""};
    for (const Pair& known : pairs_) {
      if (IsSame(known.watch, watch)) pair = known;
    }
    watched.push_back(std::move(pair));
  }
  pairs_ = std::move(watched);
}

std::vector<std::pair<std::string, std::string>> TfMonitor::Pairs() const {
  std::vector<std::pair<std::string, std::string>> names;
  for (const Pair& pair : pairs_) names.emplace_back(pair.watch.parent, pair.watch.child);
  return names;
}

void TfMonitor::OnSamples(const std::vector<Expected<TransformSample>>& samples, const Times& now) {
  for (std::size_t i = 0; i < std::min(samples.size(), pairs_.size()); ++i) {
    OnSample(pairs_[i], samples[i], now);
  }
}

void TfMonitor::OnSample(Pair& pair, const Expected<TransformSample>& look, const Times& now) {
  pair.problem = look.problem();
  if (!look) return;
  const TransformSample& sample = *look;
  pair.age.OnValue(InSeconds(AgeOf(pair, sample, now)), now.ros);
  CompareWithLast(pair, sample, now.ros);
  if (pair.first_parent.empty()) pair.first_parent = sample.hangs_on;
  pair.last = sample;
}

Duration TfMonitor::AgeOf(Pair& pair, const TransformSample& sample, const Times& now) {
  if (sample.stamp == Time{}) return Duration::zero();  // static
  const Duration age = now.ros - sample.stamp;
  if (!pair.last || pair.last->stamp != sample.stamp) {
    pair.renewed = now;
    pair.age_then = age;
  }
  return std::min(age, pair.age_then + (now.wall - pair.renewed.wall));
}

// When time was set back nothing can be compared.
void TfMonitor::CompareWithLast(Pair& pair, const TransformSample& sample, Time now) {
  if (!pair.last || sample.stamp < pair.last->stamp) return;
  const double driven = pair.watch.speed * InSeconds(sample.stamp - pair.last->stamp);
  pair.jump.OnValue(std::max(0.0, Distance(*pair.last, sample) - driven), now);
}

Finding TfMonitor::About(const Pair& pair, const std::string& what, Time now) {
  return {"tf", pair.watch.parent + " -> " + pair.watch.child + " " + what,
          "",   HealthLevel::kOk,
          0,    "",
          "",   now,
          ""};
}

void TfMonitor::Report(Pair& pair, const ProcessTable& processes, const Times& now,
                       std::vector<Finding>& findings) const {
  if (!pair.watch.node.empty() && processes.IsStarting(pair.watch.node)) {
    pair.age.Reset();
    pair.jump.Reset();
    pair.last.reset();
  }
  const auto judge = [&now](Judge& judge, Finding& finding) {
    const Assessment assessment = judge.Assess(now.ros);
    finding.level = assessment.level;
    finding.message = assessment.message;
    finding.value = judge.value().value_or(std::nan(""));
  };
  Finding age = About(pair, "age", now.ros);
  age.node = pair.watch.node;
  age.unit = "s";
  judge(pair.age, age);
  if (age.level != HealthLevel::kOk && !pair.problem.empty()) age.message += ": " + pair.problem;
  pair.patience.Apply(age, now.wall, patience_);
  ApplyGrace(processes, pair.watch.node, age);
  findings.push_back(std::move(age));

  Finding jump = About(pair, "jump", now.ros);
  jump.unit = "m";
  judge(pair.jump, jump);
  findings.push_back(std::move(jump));

  Finding parent = About(pair, "parent", now.ros);
  if (pair.last && pair.last->hangs_on != pair.first_parent) {
    parent.level = HealthLevel::kError;
    parent.message =
        pair.watch.child + " hung on " + pair.first_parent + ", now on " + pair.last->hangs_on;
  }
  findings.push_back(std::move(parent));
}

std::vector<Finding> TfMonitor::Report(const ProcessTable& processes, const Times& now) {
  std::vector<Finding> findings;
  for (Pair& pair : pairs_) Report(pair, processes, now, findings);
  return findings;
}

}  // namespace coppice::robot::monitoring
