#include "robot_app/speech/ear/complete_request.h"

#include <gtest/gtest.h>

#include "robot_app/knowledge/store/queries.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Alternative;
using knowledge::Language;

bool IsSaid(const std::vector<Alternative>& alternatives) {
  static const CompleteRequest complete = [] {
    knowledge::SampleDatabase sample;
    const auto& files = knowledge::ShippedLanguageFiles();
    const auto names = knowledge::Names(*sample);
    return CompleteRequest({files.intents, In(Language::kEnglish, files.words), names});
  }();
  return complete.IsSaid(alternatives, knowledge::kSureEnough);
}
bool IsSaid(const std::string& text) { return IsSaid({{text, 1}}); }

TEST(CompleteRequest, WhatNothingFollowsIsSaid) {
  EXPECT_TRUE(IsSaid("where is the library"));
  EXPECT_TRUE(IsSaid("take me to the sports hall"));
  EXPECT_TRUE(IsSaid("what is the phone number of Anna Weber"));
  EXPECT_TRUE(IsSaid("when is the next tram to Erlensee"));
  EXPECT_TRUE(IsSaid("what is for lunch tomorrow"));
  EXPECT_TRUE(IsSaid("is the library open on sunday"));
}

TEST(CompleteRequest, WhatMayBeFollowedByADayOrAStopIsNot) {
  EXPECT_FALSE(IsSaid("what is for lunch"));
  EXPECT_FALSE(IsSaid("which vegetarian meals are there"));
  EXPECT_FALSE(IsSaid("is the library open"));
  EXPECT_FALSE(IsSaid("when does the next tram leave"));
}

TEST(CompleteRequest, OpeningsChangeNothing) {
  EXPECT_TRUE(IsSaid("could you please tell me where the copy shop is"));
  EXPECT_FALSE(IsSaid("could you please tell me where the copy shop"));
  EXPECT_TRUE(IsSaid("excuse me where is the library"));
  EXPECT_TRUE(IsSaid("hello can you take me to the sports hall"));
  EXPECT_FALSE(IsSaid("excuse me is the library open"));
}

TEST(CompleteRequest, WhereWordsOfAKnownSentenceFollowItIsNot) {
  EXPECT_FALSE(IsSaid("where is the office"));  // of Anna Weber
  EXPECT_FALSE(IsSaid("show me the menu"));     // for tomorrow
}

TEST(CompleteRequest, AHalfNameIsNot) {
  EXPECT_FALSE(IsSaid("take me to the lecture hall"));  // A
  EXPECT_FALSE(IsSaid("could you drive me to the office"));
  EXPECT_TRUE(IsSaid("take me to the dining hall"));  // although there is a hall A
}

TEST(CompleteRequest, NoneEndsWithAPreposition) {
  EXPECT_FALSE(IsSaid("guide me to the office of"));
  EXPECT_FALSE(IsSaid("where is the"));
}

TEST(CompleteRequest, WhatAQuestionOftenFollowsIsNot) {
  EXPECT_FALSE(IsSaid("hello"));
  EXPECT_FALSE(IsSaid("no"));
  EXPECT_FALSE(IsSaid("stop talking"));
}

TEST(CompleteRequest, WhatIsUnknownOrAmbiguousIsNot) {
  EXPECT_FALSE(IsSaid(""));
  EXPECT_FALSE(IsSaid("where is the swimming pool"));
  EXPECT_FALSE(IsSaid("where is the office of Weber"));
  EXPECT_FALSE(IsSaid(std::vector<Alternative>{}));
}

TEST(CompleteRequest, WhatIsUnsureIsNot) {
  EXPECT_FALSE(IsSaid({{"where is the library", 0.8}, {"where is the copy shop", 0.2}}));
  EXPECT_TRUE(IsSaid({{"where is the library", 0.5}, {"wheres the library", 0.5}}));
}

}  // namespace
}  // namespace coppice::robot::speech
