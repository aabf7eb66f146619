// A vocabulary of what corners look like: a tree in which each description finds its word by a few
// comparisons, so that a picture becomes a short list of words with weights.
//
// D. Galvez-Lopez, J. D. Tardos: Bags of Binary Words for Fast Place Recognition in Image
// Sequences, IEEE T-RO 28 (2012): k-medians of binary descriptors, weights by how rare a word is.
// It is learnt by `coppice-train vocabulary`.
//
// Immutable once it is made; any thread.
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_VOCABULARY_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_VOCABULARY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::slam {

struct WeighedWord {
  std::uint32_t word = 0;
  float weight = 0;
};

/// The words of a picture, ascending; the weights sum up to 1.
using BagOfWords = std::vector<WeighedWord>;

class Vocabulary {
 public:
  struct Training {
    int branches = 10;
    int depth = 3;
    std::uint64_t seed = 1;
  };
  /// Learns from the descriptions of many pictures; the same ones give the same vocabulary.
  static Expected<Vocabulary> Train(const std::vector<std::vector<Descriptor>>& pictures,
                                    const Training& training);

  /// Reads what Save has written. A file that is missing or damaged is a problem, with its line.
  static Expected<Vocabulary> Load(const std::string& file);
  Outcome Save(const std::string& file) const;

  /// Of the words.
  std::size_t size() const { return words_; }

  std::uint32_t WordOf(const Descriptor& descriptor) const;
  BagOfWords BagOf(const std::vector<Descriptor>& descriptors) const;

 private:
  // A leaf has no children and is a word.
  struct Node {
    Descriptor center{};
    std::uint32_t first_child = 0;
    std::uint32_t children = 0;
    std::uint32_t word = 0;
    float weight = 0;  // of the word
  };
  const Node& LeafOf(const Descriptor& descriptor) const;
  void Weigh(const std::vector<std::vector<Descriptor>>& pictures);

  std::vector<Node> nodes_;  // children behind their parents, side by side; the first is the root
  std::uint32_t words_ = 0;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_VOCABULARY_H_
