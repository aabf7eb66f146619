// Damaged classifiers: whoever reads them says so, or takes numbers that are none for none.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "robot_app/common/learning/boosted_trees.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

constexpr int kFeatures = 4;
constexpr BoostedTrees::Subject kSubject{"attacked", kFeatures, "nothing"};
constexpr int kDamages = 600;

class ClassifierAttack : public testing::Test {
 protected:
  ClassifierAttack() {
    std::vector<BoostedTrees::Example> examples;
    for (int i = 0; i < 200; ++i) {
      BoostedTrees::Example example;
      for (int k = 0; k < kFeatures; ++k) example.features.push_back(Random());
      example.is_one = example.features[1] + example.features[2] * example.features[0] > 0;
      examples.push_back(example);
    }
    const auto trees = BoostedTrees::Train(kSubject, examples, {20, 3});
    if (trees && trees->Save(file_)) good_ = TextOf(file_);
  }

  float Random() { return std::normal_distribution<float>()(random_); }
  std::size_t Below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  Expected<BoostedTrees> Load(const std::string& text) {
    std::ofstream(file_) << text;
    return BoostedTrees::Load(file_, kSubject);
  }

  // A few bytes, numbers or lines of the good one are others, or gone.
  std::string Damaged() {
    static const char* const kNumbers[] = {"-1", "99999999999", ".Nan", "4", "1e300", "[ ]"};
    std::string text = good_;
    for (std::size_t k = 1 + Below(3); k > 0; --k) {
      const std::size_t at = Below(text.size());
      const std::size_t digit = text.find_first_of("0123456789", at);
      const std::size_t line = text.find('\n', at);
      switch (Below(4)) {
        case 0:
          text[at] = static_cast<char>(1 + Below(126));
          break;
        case 1:
          if (digit != std::string::npos) text.replace(digit, 1, kNumbers[Below(6)]);
          break;
        case 2:
          if (line != std::string::npos) text.erase(line, Below(300));
          break;
        default:
          text.insert(at, text.substr(Below(text.size()), Below(300)));
      }
    }
    return text;
  }

  std::mt19937 random_{1};
  const std::string file_ = testing::TempDir() + "attacked.yaml";
  std::string good_;
};

TEST_F(ClassifierAttack, DamagedOnesAreRefusedOrGiveProbabilities) {
  ASSERT_TRUE(Load(good_));
  int refused = 0;
  for (int k = 0; k < kDamages; ++k) {
    const auto trees = Load(Damaged());
    refused += !trees;
    for (int row = 0; trees && row < 20; ++row) {
      float features[kFeatures];
      for (float& feature : features) feature = row % 5 == 0 ? NAN : Random();
      const float probability = trees->Probability(features);
      ASSERT_TRUE(probability >= 0 && probability <= 1) << TextOf(file_);
    }
  }
  EXPECT_GT(refused, kDamages / 4);
}

TEST_F(ClassifierAttack, OnesOfMoreLevelsThanThereAreStacksAreRefused) {
  const std::string begin = "%YAML:1.0\n---\nattacked: ";
  const auto often = [](const std::string& text) {
    std::string many;
    for (int k = 0; k < 300'000; ++k) many += text;
    return many;
  };
  for (const std::string level : {"[", "{a:", "- ", "a: ", "a:"}) {
    EXPECT_FALSE(Load(begin + often(level)));
  }
  EXPECT_FALSE(Load("<?xml version=\"1.0\"?><opencv_storage>" + often("<a>")));
  EXPECT_FALSE(Load(often("{\"a\":")));
}

}  // namespace
}  // namespace coppice::robot
