#include "robot_app/training/detection_figures.h"

#include <algorithm>

namespace coppice::robot::training {

using perception::Sighting;

namespace {

bool IsSurer(const Sighting& a, const Sighting& b) { return a.confidence > b.confidence; }

// The free one that has most in common with a box; the end: none has enough.
std::size_t BestFor(const Sighting& sighting, const std::vector<Sighting>& truth,
                    const std::vector<bool>& is_taken) {
  std::size_t best = truth.size();
  double most = kSameThing;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double overlap = perception::Overlap(truth[i].box, sighting.box);
    if (is_taken[i] || overlap < most) continue;
    most = overlap;
    best = i;
  }
  return best;
}

}  // namespace

void DetectionFigures::Add(const std::vector<Sighting>& truth, std::vector<Sighting> seen) {
  std::stable_sort(seen.begin(), seen.end(), IsSurer);
  std::vector<bool> is_taken(truth.size(), false);
  for (const Sighting& real : truth) there_ += real.confidence > 0 ? 1 : 0;
  for (const Sighting& sighting : seen) {
    const std::size_t best = BestFor(sighting, truth, is_taken);
    const bool is_right = best < truth.size();
    const bool counts = !is_right || truth[best].confidence > 0;
    if (is_right && counts) is_taken[best] = true;
    if (counts) seen_.emplace_back(sighting.confidence, is_right);
  }
}

int DetectionFigures::found(double least_confidence) const {
  return static_cast<int>(std::count_if(seen_.begin(), seen_.end(), [&](const auto& seen) {
    return seen.second && seen.first >= least_confidence;
  }));
}

int DetectionFigures::invented(double least_confidence) const {
  return static_cast<int>(std::count_if(seen_.begin(), seen_.end(), [&](const auto& seen) {
    return !seen.second && seen.first >= least_confidence;
  }));
}

double DetectionFigures::precision(double least_confidence) const {
  const int right = found(least_confidence);
  const int all = right + invented(least_confidence);
  return all > 0 ? static_cast<double>(right) / all : 0;
}

double DetectionFigures::recall(double least_confidence) const {
  return there_ > 0 ? static_cast<double>(found(least_confidence)) / there_ : 0;
}

double DetectionFigures::average_precision() const {
  auto seen = seen_;
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> precisions;  // whenever one more is found
  int right = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].second) continue;
    ++right;
    precisions.push_back(right / static_cast<double>(i + 1));
  }
  double area = 0, best = 0;
  for (auto i = precisions.rbegin(); i != precisions.rend(); ++i) {
    best = std::max(best, *i);
    area += best;
  }
  return there_ > 0 ? area / there_ : 0;
}

}  // namespace coppice::robot::training
