#include "robot_app/training/leg_training.h"

#include <chrono>
#include <optional>
#include <utility>

namespace coppice::robot::training {
namespace {

using perception::LegCandidate;
using perception::LegClassifier;
using perception::SegmentedScan;

constexpr double kMostly = 0.75;     // so many of a segment's points are the person's: it is one's
constexpr float kSuspicious = 0.1F;  // later rounds learn from what looks like legs
constexpr int kEverydayShare = 8;    // and from each eighth of what is clear

// Whose most of the segment's points are, or kNobody.
int OwnerOf(const SegmentedScan& scan, std::uint32_t index, const LabelledSweep& sweep) {
  const perception::ScanSegment& segment = scan.segments[index];
  std::vector<int> counts(sweep.people.size(), 0);
  for (std::uint32_t i = segment.begin; i < segment.end; ++i) {
    const int owner = sweep.owner[scan.points[i].beam];
    if (owner == LabelledSweep::kNobody) continue;
    if (++counts[owner] >= kMostly * segment.size()) return owner;
  }
  return LabelledSweep::kNobody;
}

bool IsPerson(const SegmentedScan& scan, const LegCandidate& candidate,
              const LabelledSweep& sweep) {
  const int owner = OwnerOf(scan, candidate.first, sweep);
  return owner != LabelledSweep::kNobody &&
         (!candidate.second || OwnerOf(scan, *candidate.second, sweep) == owner);
}

// What the classifier is not sure about, or wrong.
bool IsInstructive(const LegClassifier& classifier, const LegClassifier::Example& example) {
  const float probability = classifier.Probability(example.features);
  return example.is_person ? probability < 1 - kSuspicious : probability > kSuspicious;
}

void AddExamples(const LabelledSweep& sweep, const LegClassifier* classifier,
                 std::vector<LegClassifier::Example>& examples, std::mt19937_64& random) {
  SegmentedScan scan;
  SegmentByJumps(sweep.scan, perception::LegFinderOptions{}.farthest, scan);
  for (const LegCandidate& candidate : LegCandidatesIn(scan)) {
    const LegClassifier::Example example{Describe(scan, candidate),
                                         IsPerson(scan, candidate, sweep)};
    const bool is_everyday =
        classifier == nullptr ? !example.is_person : !IsInstructive(*classifier, example);
    if (!is_everyday || random() % kEverydayShare == 0) examples.push_back(example);
  }
}

}  // namespace

Expected<LegClassifier> TrainLegs(const LegTrainingOptions& options,
                                  const std::function<void(double)>& say) {
  std::mt19937_64 random(options.seed);
  SweepOptions sweeping;
  sweeping.most_four_legged = options.most_four_legged;
  std::vector<LegClassifier::Example> examples;
  std::optional<LegClassifier> classifier;
  for (int round = 0; round < options.rounds; ++round) {
    for (int i = 0; i < options.scans; ++i) {
      const LabelledSweep sweep = MakeLabelledSweep(MakeRandomHall(random), sweeping, random);
      AddExamples(sweep, classifier ? &*classifier : nullptr, examples, random);
      say((round + static_cast<double>(i) / options.scans) / options.rounds);
    }
    auto learnt = LegClassifier::Train(examples, options.trees);
    if (!learnt) return Problem{learnt.problem()};
    classifier.emplace(std::move(*learnt));
  }
  return std::move(*classifier);
}

PeopleFigures MeasureLegs(perception::LegFinder& finder, const Site& site, int scans,
                          int most_four_legged, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  SweepOptions sweeping;
  sweeping.most_four_legged = most_four_legged;
  PeopleCount count;
  for (int i = 0; i < scans; ++i) {
    LabelledSweep sweep = MakeLabelledSweep(site, sweeping, random);
    const auto begin = std::chrono::steady_clock::now();
    const auto& people = finder.Find(sweep.scan);
    count.AddTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::vector<simulation::Vec2> seen;
    for (const auto& person : people) seen.push_back({person.position.x(), person.position.y()});
    for (PersonTruth& person : sweep.people) {
      if (simulation::Length(person.position) > finder.options().farthest) person.visible = 0;
    }
    count.Add(seen, sweep.people);
  }
  return count.figures();
}

}  // namespace coppice::robot::training
