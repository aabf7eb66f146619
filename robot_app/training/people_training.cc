#include "robot_app/training/people_training.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace coppice::robot::training {
namespace {

using perception::CandidateFinder;
using perception::Clusters;
using perception::PeopleFinder;
using perception::PersonClassifier;
using perception::RangeImage;

constexpr float kBody = 0.36F;          // points so near to a person's axis are the person's [m]
constexpr double kMostlyPerson = 0.75;  // so much of a cluster: it is one
constexpr double kLeastCover = 0.5;     // so much of the person's points: a whole one
constexpr double kHardlyPerson = 0.4;   // less of a cluster: it is none
constexpr double kHardlyCover = 0.3;    // less of the person's points: an arm, a leg
constexpr double kTwoPeople = 0.2;  // more of a cluster is somebody else's: it is not one person

// The points of each person, and whose each cell is.
struct Owners {
  std::vector<std::uint8_t> of_cell;  // 1 + the person's index; 0: nobody
  std::vector<int> points;            // of each person
};

Owners FindOwners(const RangeImage& image, const std::vector<perception::Surface>& surfaces,
                  const LabelledScan& scan) {
  Owners owners{std::vector<std::uint8_t>(image.size(), 0),
                std::vector<int>(scan.people.size(), 0)};
  for (std::size_t cell = 0; cell < image.size(); ++cell) {
    if (surfaces[cell] != perception::Surface::kStanding) continue;
    float nearest = kBody;
    for (std::size_t i = 0; i < scan.people.size(); ++i) {
      const Eigen::Vector2f axis =
          Eigen::Vector2d(scan.people[i].position.x, scan.people[i].position.y).cast<float>();
      const float distance = (image.points[cell].head<2>() - axis).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      owners.of_cell[cell] = static_cast<std::uint8_t>(1 + i);
    }
    if (owners.of_cell[cell] > 0) ++owners.points[owners.of_cell[cell] - 1];
  }
  return owners;
}

enum class Label { kPerson, kOther, kUnclear };

Label LabelOf(Clusters::Cells cells, const Owners& owners) {
  std::vector<int> counts(owners.points.size() + 1, 0);
  for (const std::uint32_t cell : cells) ++counts[owners.of_cell[cell]];
  const auto most = std::max_element(counts.begin() + 1, counts.end());
  if (most == counts.end()) return Label::kOther;
  const int points = owners.points[most - counts.begin() - 1];
  const double share = static_cast<double>(*most) / static_cast<double>(cells.size());
  const double cover = static_cast<double>(*most) / std::max(1, points);
  const double others =
      static_cast<double>(cells.size() - *most - counts[0]) / static_cast<double>(cells.size());
  if (share < kHardlyPerson || cover < kHardlyCover || others > kTwoPeople) return Label::kOther;
  return share >= kMostlyPerson && cover >= kLeastCover ? Label::kPerson : Label::kUnclear;
}

std::vector<PersonClassifier::Example> ExamplesIn(const CandidateFinder& finder,
                                                  const LabelledScan& scan) {
  const Owners owners = FindOwners(finder.image(), finder.surfaces(), scan);
  std::vector<PersonClassifier::Example> examples;
  for (std::size_t i = 0; i < finder.candidates().size(); ++i) {
    const Clusters::Cells cells = finder.candidates()[i];
    const Label label = LabelOf(cells, owners);
    if (label == Label::kUnclear) continue;
    examples.push_back({Describe(finder.image(), cells), label == Label::kPerson});
  }
  return examples;
}

}  // namespace

Expected<PersonClassifier> TrainPeople(const LearningRounds& learning, const Progress& say) {
  CandidateFinder finder({});
  const auto examples_in = [&](std::mt19937_64& random) {
    const LabelledScan scan = MakeLabelledScan(MakeRandomHall(random), {}, random);
    finder.Find(scan.points);
    return ExamplesIn(finder, scan);
  };
  return LearnInRounds<perception::PersonKind>(learning, examples_in, say);
}

PeopleFigures MeasurePeople(perception::PeopleFinder& finder, const Site& site, int scans,
                            std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PeopleCount count;
  for (int i = 0; i < scans; ++i) {
    const LabelledScan scan = MakeLabelledScan(site, {}, random);
    const auto begin = std::chrono::steady_clock::now();
    const auto& people = finder.Find(scan.points);
    count.AddTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::vector<simulation::Vec2> seen;
    for (const auto& person : people) seen.push_back({person.position.x(), person.position.y()});
    count.Add(seen, scan.people);
  }
  return count.figures();
}

}  // namespace coppice::robot::training
