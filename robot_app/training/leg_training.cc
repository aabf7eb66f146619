#include "robot_app/training/leg_training.h"

#include <chrono>
#include <vector>

namespace coppice::robot::training {
namespace {

using perception::LegCandidate;
using perception::LegClassifier;
using perception::SegmentedScan;

constexpr double kMostly = 0.75;  // so many of a segment's points are the person's: it is one's

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

std::vector<LegClassifier::Example> ExamplesIn(const LabelledSweep& sweep) {
  SegmentedScan scan;
  SegmentByJumps(sweep.scan, perception::LegFinderOptions{}.farthest, scan);
  std::vector<LegClassifier::Example> examples;
  for (const LegCandidate& candidate : LegCandidatesIn(scan)) {
    examples.push_back({Describe(scan, candidate), IsPerson(scan, candidate, sweep)});
  }
  return examples;
}

}  // namespace

Expected<LegClassifier> TrainLegs(const LegTrainingOptions& options, const Progress& say) {
  SweepOptions sweeping;
  sweeping.most_four_legged = options.most_four_legged;
  const auto examples_in = [&](std::mt19937_64& random) {
    return ExamplesIn(MakeLabelledSweep(MakeRandomHall(random), sweeping, random));
  };
  return LearnInRounds<perception::LegKind>(options.learning, examples_in, say);
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
