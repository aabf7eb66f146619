#include "robot_app/slam/pictures/place_index.h"

#include <algorithm>

namespace coppice::robot::slam {

void PlaceIndex::Add(std::uint32_t picture, const BagOfWords& bag) {
  for (const WeighedWord& word : bag) entries_[word.word].push_back({picture, word.weight});
  if (picture >= scores_.size()) scores_.resize(picture + 1, 0);
}

void PlaceIndex::Remove(std::uint32_t picture, const BagOfWords& bag) {
  for (const WeighedWord& word : bag) {
    auto& entries = entries_[word.word];
    entries.erase(
        std::remove_if(entries.begin(), entries.end(),
                       [picture](const Entry& entry) { return entry.picture == picture; }),
        entries.end());
  }
}

std::vector<PlaceCandidate> PlaceIndex::Find(const BagOfWords& bag, std::size_t most,
                                             const std::function<bool(std::uint32_t)>& is_asked) {
  std::vector<std::uint32_t> met;
  for (const WeighedWord& word : bag) {
    for (const Entry& entry : entries_[word.word]) {
      if (scores_[entry.picture] == 0) met.push_back(entry.picture);
      scores_[entry.picture] += std::min(entry.weight, word.weight);
    }
  }
  std::vector<PlaceCandidate> candidates;
  for (const std::uint32_t picture : met) {
    const float score = scores_[picture];
    scores_[picture] = 0;
    if (is_asked(picture)) candidates.push_back({picture, score});
  }
  const auto is_before = [](const PlaceCandidate& a, const PlaceCandidate& b) {
    return a.score != b.score ? a.score > b.score : a.picture < b.picture;
  };
  const auto end =
      candidates.begin() + static_cast<std::ptrdiff_t>(std::min(most, candidates.size()));
  std::partial_sort(candidates.begin(), end, candidates.end(), is_before);
  candidates.erase(end, candidates.end());
  return candidates;
}

}  // namespace coppice::robot::slam
