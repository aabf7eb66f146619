#include "robot_app/questionnaire/answers_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"

namespace coppice::robot::questionnaire {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AnswersFile : public testing::Test {
 protected:
  AnswersFile() {
    questions_.scales = {{"mood", {}, {Item{}, Item{}}, std::nullopt, {}},
                         {"look", {}, {Item{}}, std::nullopt, {}}};
  }
  std::vector<Marks> Read(const std::string& text) {
    std::ofstream(path_) << text;
    return ReadAnswers(path_, questions_, diagnostics_);
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.Path("answers.csv");
  Questionnaire questions_;
  Diagnostics diagnostics_;
};

TEST_F(AnswersFile, WhatWasAddedIsRead) {
  ASSERT_TRUE(AddAnswers(path_, questions_, {1, 0, 5}));
  ASSERT_TRUE(AddAnswers(path_, questions_, {2, 3, 4}));
  std::ifstream file(path_);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}),
            "mood_1,mood_2,look_1\n1,,5\n2,3,4\n");
  EXPECT_THAT(ReadAnswers(path_, questions_, diagnostics_),
              ElementsAre(Marks{1, 0, 5}, Marks{2, 3, 4}));
}

TEST_F(AnswersFile, TellsWhatIsWrongAndInWhichLine) {
  EXPECT_THAT(Read("mood_1,mood_2,look_1\n1,2,3\n1,2\n1,9,x\n"), IsEmpty());
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("answers.csv:3:1: error: expected 3 fields"));
  EXPECT_THAT(diagnostics_.ToString(),
              HasSubstr(":4:1: error: mood_2: \"9\" is no mark from 1 to 5"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("look_1: \"x\""));
}

TEST_F(AnswersFile, AnswersToOtherQuestionsAreRefused) {
  EXPECT_THAT(Read("a,b\n1,2\n"), IsEmpty());
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("expected the columns mood_1,mood_2,look_1"));
}

TEST_F(AnswersFile, OnlyWholeSetsOfMarksAreTakenFromThePage) {
  EXPECT_EQ(MarksOf(R"({"marks":[1,0,5]})", questions_).value(), (Marks{1, 0, 5}));
  for (const char* const json :
       {"", "{}", "[]", R"({"marks":[1,2]})", R"({"marks":[1,2,6]})", R"({"marks":[1,2,-1]})",
        R"({"marks":[0,0,0]})", R"({"marks":["1",2,3]})", R"({"marks":[1,2,3,4]})",
        R"({"marks":[1.5,2,3]})", R"({"marks":[true,2,3]})", R"({"marks":[4294967297,2,3]})",
        R"({"marks":[18446744073709551615,2,3]})", R"({"marks":{"a":1,"b":2,"c":3}})"}) {
    EXPECT_FALSE(MarksOf(json, questions_)) << json;
  }
}

TEST_F(AnswersFile, AnswersThatCannotBeReadAreLeftAsTheyAre) {
  const auto keeps = [&](const std::string& text) {
    std::ofstream(path_) << text;
    const bool is_added = AddAnswers(path_, questions_, {1, 0, 5}).ok();
    std::ifstream file(path_);
    return !is_added && std::string(std::istreambuf_iterator<char>(file), {}) == text;
  };
  EXPECT_TRUE(keeps("other,questions\n1,2\n"));
  EXPECT_TRUE(keeps("mood_1,mood_2,look_1\n" + std::string(std::size_t{5} << 20, '\n')));
}

TEST_F(AnswersFile, ARowBeginsInALineOfItsOwn) {
  std::ofstream(path_) << "mood_1,mood_2,look_1\n1,2,3";
  ASSERT_TRUE(AddAnswers(path_, questions_, {4, 4, 4}));
  EXPECT_THAT(ReadAnswers(path_, questions_, diagnostics_),
              ElementsAre(Marks{1, 2, 3}, Marks{4, 4, 4}));
}

TEST_F(AnswersFile, ADiskThatCannotBeWrittenIsAProblem) {
  EXPECT_FALSE(AddAnswers(folder_.Path("none/answers.csv"), questions_, {1, 2, 3}));
}

}  // namespace
}  // namespace coppice::robot::questionnaire
