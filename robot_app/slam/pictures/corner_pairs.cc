#include "robot_app/slam/pictures/corner_pairs.h"

#include <limits>

// Processors that count bits in one instruction do so; Debian's compiler asks for less. Which it
// is, is found out by a function that runs before ThreadSanitizer is there, which watches it:
// under that there is only the one for all.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define COPPICE_COUNTS_BITS __attribute__((target_clones("popcnt", "default")))
#else
#define COPPICE_COUNTS_BITS
#endif

namespace coppice::robot::slam {
namespace {

constexpr int kMostDifference = 64;  // bits: more is something else
constexpr float kClearly = 0.85F;    // the second best must differ so much more,
constexpr int kRivals = 75;          // bits: more is beaten by all that may be a pair
static_assert(static_cast<float>(kMostDifference) <= kClearly * (kRivals + 1), "the second best");
constexpr int kNone = std::numeric_limits<int>::max();

struct Best {
  std::size_t corner = 0;
  int difference = kNone;
  int second = kNone;
};

struct Bests {
  std::vector<Best> of_old, of_new;
};

COPPICE_COUNTS_BITS
void Compare(const std::vector<Descriptor>& olds, const std::vector<Descriptor>& news,
             Bests& bests) {
  for (std::size_t i = 0; i < olds.size(); ++i) {
    Best& of_old = bests.of_old[i];
    for (std::size_t k = 0; k < news.size(); ++k) {
      const int difference = Difference(olds[i], news[k]);
      if (difference > kRivals) continue;
      if (difference < of_old.difference) {
        of_old = {k, difference, of_old.difference};
      } else if (difference < of_old.second) {
        of_old.second = difference;
      }
      Best& of_new = bests.of_new[k];
      if (difference < of_new.difference) of_new = {i, difference, of_new.difference};
    }
  }
}

}  // namespace

std::vector<CornerPair> PairsOf(const PictureFeatures& old_picture,
                                const PictureFeatures& new_picture) {
  std::vector<CornerPair> pairs;
  if (old_picture.size() < 2 || new_picture.size() < 2) return pairs;
  Bests bests{std::vector<Best>(old_picture.size()), std::vector<Best>(new_picture.size())};
  Compare(old_picture.descriptors, new_picture.descriptors, bests);
  for (std::size_t i = 0; i < old_picture.size(); ++i) {
    const Best& best = bests.of_old[i];
    const bool is_clear =
        static_cast<float>(best.difference) <= kClearly * static_cast<float>(best.second);
    if (best.difference <= kMostDifference && is_clear && bests.of_new[best.corner].corner == i &&
        old_picture.points[i].allFinite()) {
      pairs.push_back({i, best.corner});
    }
  }
  return pairs;
}

}  // namespace coppice::robot::slam
