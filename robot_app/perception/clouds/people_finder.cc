#include "robot_app/perception/clouds/people_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::robot::perception {
namespace {

constexpr float kApart = 0.45F;     // two people's axes are no nearer [m]
constexpr float kShared = 0.4F;     // of the points of the smaller one: it is the same person
constexpr float kSure = 0.9F;       // surer makes no difference
constexpr float kHalfBody = 0.09F;  // the axis lies so far behind the middle of what is seen [m]

float SharedShare(Clusters::Cells a, Clusters::Cells b) {
  std::size_t shared = 0;
  const std::uint32_t* in_b = b.begin();
  for (const std::uint32_t cell : a) {
    while (in_b != b.end() && *in_b < cell) ++in_b;
    if (in_b != b.end() && *in_b == cell) ++shared;
  }
  return static_cast<float>(shared) / static_cast<float>(std::min(a.size(), b.size()));
}

// Where the person stands: the median of the points, which a hand or a bag hardly moves, and half a
// body farther.
SeenPerson Locate(const RangeImage& image, Clusters::Cells cells, const Features& features) {
  SeenPerson person;
  std::vector<float> x, y;
  for (const std::uint32_t cell : cells) {
    x.push_back(image.points[cell].x());
    y.push_back(image.points[cell].y());
    person.top = std::max(person.top, image.points[cell].z());
  }
  const auto median = [](std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  const Eigen::Vector2f front(median(x), median(y));
  const float distance = std::max(front.norm(), 0.01F);
  person.position = front * (1 + kHalfBody / distance);
  person.turn = static_cast<float>(ColumnOf(front, image.geometry)) /
                static_cast<float>(image.geometry.columns);
  // Steps, and what hides a part, move it more than the sensor's noise does.
  const float deviation = 0.06F + 0.01F * distance + 0.3F * features[kHiddenSides];
  person.covariance = Eigen::Matrix2f::Identity() * deviation * deviation;
  return person;
}

}  // namespace

PeopleFinder::PeopleFinder(const FinderOptions& options, PersonClassifier classifier)
    : options_(options), classifier_(std::move(classifier)), candidates_(options.candidates) {}

const std::vector<SeenPerson>& PeopleFinder::Find(const std::vector<LidarPoint>& points) {
  const Clusters& candidates = candidates_.Find(points);
  const RangeImage& image = candidates_.image();
  sure_.clear();
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const Features features = Describe(image, candidates[i]);
    SeenPerson person = Locate(image, candidates[i], features);
    if (person.position.norm() > options_.farthest) continue;
    person.probability = classifier_.Probability(features);
    person.cluster = i;
    if (person.probability >= options_.least_probability) sure_.push_back(person);
  }
  // Of those that are sure enough the whole person goes before its parts.
  const auto rank = [&](const SeenPerson& person) {
    return std::make_pair(std::min(person.probability, kSure), candidates[person.cluster].size());
  };
  std::stable_sort(sure_.begin(), sure_.end(),
                   [&](const SeenPerson& a, const SeenPerson& b) { return rank(a) > rank(b); });
  people_.clear();
  for (const SeenPerson& person : sure_) {
    const bool is_known = std::any_of(people_.begin(), people_.end(), [&](const SeenPerson& other) {
      return (other.position - person.position).norm() < kApart ||
             SharedShare(candidates[other.cluster], candidates[person.cluster]) > kShared;
    });
    if (!is_known) people_.push_back(person);
  }
  return people_;
}

}  // namespace coppice::robot::perception
