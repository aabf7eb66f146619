#include "robot_app/knowledge/understanding/name_index.h"

#include <gmock/gmock.h>

#include "tests/robot_app/knowledge/language_files.h"

namespace coppice::robot::knowledge {
namespace {

class NameIndexTest : public testing::Test {
 protected:
  NameIndexTest() {
    for (const char* number : {"101", "102", "103"}) {
      Add(Kind::kPlace, number, std::string("room ") + number);
    }
    Add(Kind::kPlace, "hall_a", "lecture hall A");
    Add(Kind::kCategory, "lecture_hall", "lecture hall");
    Add(Kind::kPerson, "anna_weber", "Anna Weber");
    Add(Kind::kPerson, "paul_weber", "Paul Weber");
    Add(Kind::kPerson, "li_wang", "Li Wang");
    Add(Kind::kLine, "4", "4");
  }
  void Add(Kind kind, const std::string& subject, const std::string& text) {
    names_.push_back({kind, subject, Language::kEnglish, text, true});
  }
  std::vector<Candidate> Find(const std::string& text) const {
    const LanguageWords& words = In(Language::kEnglish, ShippedLanguageFiles().words);
    return NameIndex(names_, words, Language::kEnglish).Find(TakeApart(text, words));
  }
  std::string Best(const std::string& text) const {
    const auto found = Find(text);
    return found.empty() ? "" : found[0].subject;
  }

  std::vector<Name> names_;
};

TEST_F(NameIndexTest, ANameIsFoundAsItIsWritten) {
  EXPECT_EQ(Best("where is room 102 please"), "102");
  EXPECT_EQ(Find("room 102")[0].fit, 1);
}

TEST_F(NameIndexTest, WhatFewSubjectsShareCounts) {
  EXPECT_EQ(Best("102"), "102");
  EXPECT_TRUE(Find("room").empty());
  EXPECT_TRUE(Find("room 999").empty());
}

TEST_F(NameIndexTest, TheNameThatExplainsMoreIsBetter) {
  EXPECT_EQ(Best("the lecture hall a"), "hall_a");
  EXPECT_EQ(Best("a lecture hall"), "lecture_hall");
}

TEST_F(NameIndexTest, MisspeltNamesAreFound) {
  EXPECT_EQ(Best("lectur hall"), "lecture_hall");
  EXPECT_EQ(Best("lecturehall"), "lecture_hall");
  EXPECT_EQ(Best("anna webber"), "anna_weber");
}

TEST_F(NameIndexTest, HalfANameFitsAllWhoHaveIt) {
  const auto found = Find("Anna");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(found[0].fit, 1);
}

TEST_F(NameIndexTest, ALineIsFoundAsPeopleSayIt) {
  for (const char* text : {"line 4", "the 4", "tram four", "bus number 4"}) {
    EXPECT_EQ(Best(text), "4") << text;
  }
}

TEST_F(NameIndexTest, AWordThatIsKnownIsNoMisspeltName) { EXPECT_TRUE(Find("want").empty()); }

TEST_F(NameIndexTest, AnEmptyTextNamesNobody) { EXPECT_TRUE(Find("").empty()); }

}  // namespace
}  // namespace coppice::robot::knowledge
