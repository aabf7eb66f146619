#include "robot_app/knowledge/understanding/word_similarity.h"

#include <gtest/gtest.h>

namespace coppice::robot::knowledge {
namespace {

double Similar(const char* heard, const char* known) {
  return Similarity(Sounding(heard), Sounding(known));
}

TEST(WordSimilarity, LettersAreInsertedRemovedReplacedAndSwapped) {
  EXPECT_EQ(EditDistance("libary", "library"), 1);
  EXPECT_EQ(EditDistance("toliet", "toilet"), 1);
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("same", "same"), 0);
}

TEST(WordSimilarity, MisspeltAndMisheardWordsAreAlike) {
  EXPECT_GT(Similar("libary", "library"), 0.8);
  EXPECT_GT(Similar("maier", "meyer"), 0.8);
  EXPECT_GT(Similar("kovalsky", "kowalski"), 0.7);
  EXPECT_EQ(Similar("kowal", "kowalski"), 0.8);
}

TEST(WordSimilarity, NumbersAndShortWordsAreTheSameOrNotAlike) {
  EXPECT_EQ(Similar("103", "104"), 0);
  EXPECT_EQ(Similar("103", "103"), 1);
  EXPECT_EQ(Similar("gum", "gym"), 0);
  EXPECT_EQ(Similar("pool", "paul"), 0);
}

TEST(WordSimilarity, OtherWordsAreNotAlike) {
  EXPECT_EQ(Similar("wetter", "weber"), 0);
  EXPECT_EQ(Similar("cinema", "canteen"), 0);
}

}  // namespace
}  // namespace coppice::robot::knowledge
