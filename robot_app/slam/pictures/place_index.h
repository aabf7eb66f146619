// Which of many pictures show the same as a new one: an inverted index from words to the pictures
// that have them, so that a question looks only at pictures with words in common.
//
// J. Sivic, A. Zisserman: Video Google, ICCV 2003. D. Nister, H. Stewenius: Scalable Recognition
// with a Vocabulary Tree, CVPR 2006 (the score).
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_PLACE_INDEX_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_PLACE_INDEX_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "robot_app/slam/pictures/vocabulary.h"

namespace coppice::robot::slam {

struct PlaceCandidate {
  std::uint32_t picture = 0;
  float score = 0;  ///< how much of the words' weights is common to both, 0..1
};

/// Not thread-safe.
class PlaceIndex {
 public:
  explicit PlaceIndex(std::size_t words) : entries_(words) {}

  /// Adds a picture under a number of the caller's.
  void Add(std::uint32_t picture, const BagOfWords& bag);

  /// Takes a picture out that was added with this bag. What is asked costs no more for it then.
  void Remove(std::uint32_t picture, const BagOfWords& bag);

  /// At most `most` pictures of those that `is_asked` holds for, the likest first.
  std::vector<PlaceCandidate> Find(const BagOfWords& bag, std::size_t most,
                                   const std::function<bool(std::uint32_t)>& is_asked);

 private:
  struct Entry {
    std::uint32_t picture = 0;
    float weight = 0;
  };
  std::vector<std::vector<Entry>> entries_;  // of each word
  // Of each picture, while a question is answered; 0 between.
  std::vector<float> scores_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_PLACE_INDEX_H_
