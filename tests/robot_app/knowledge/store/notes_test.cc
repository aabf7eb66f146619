#include "robot_app/knowledge/store/notes.h"

#include <gmock/gmock.h>

#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const Day kToday{20782};

class Notes : public testing::Test {
 protected:
  bool HasName(const std::string& text) {
    for (const Name& name : Names(*sample_)) {
      if (name.text == text) return true;
    }
    return false;
  }
  const Name pool_{Kind::kPlace, "gym", Language::kEnglish, "swimming pool", false};
  SampleDatabase sample_;
};

TEST_F(Notes, WhatIsAskedOftenComesFirst) {
  NoteUnknown(*sample_, "where is the moon", Language::kEnglish, kToday);
  NoteUnknown(*sample_, "wo ist der Mond", Language::kGerman, kToday);
  NoteUnknown(*sample_, "wo ist der Mond", Language::kGerman, kToday + 1);
  const auto requests = UnknownRequests(*sample_);
  ASSERT_THAT(requests, SizeIs(2));
  EXPECT_EQ(requests[0].text, "wo ist der Mond");
  EXPECT_EQ(requests[0].count, 2);
  EXPECT_EQ(requests[0].last, "2026-11-26");
  ASSERT_TRUE(ClearUnknown(*sample_));
  EXPECT_THAT(UnknownRequests(*sample_), IsEmpty());
}

TEST_F(Notes, ALongTextIsCutBetweenCharacters) {
  std::string text = "x";
  for (int i = 0; i < 300; ++i) text += "ä";
  NoteUnknown(*sample_, text, Language::kGerman, kToday);
  EXPECT_EQ(UnknownRequests(*sample_)[0].text.size(), 199U);
}

TEST_F(Notes, TheOldestAreForgotten) {
  for (int i = 0; i < kMostUnknown + 5; ++i) {
    NoteUnknown(*sample_, "question " + std::to_string(i), Language::kEnglish, kToday + i);
  }
  const auto requests = UnknownRequests(*sample_);
  EXPECT_THAT(requests, SizeIs(kMostUnknown));
  for (const UnknownRequest& request : requests) EXPECT_NE(request.text, "question 0");
}

TEST_F(Notes, ASynonymOutlivesAnImport) {
  ASSERT_TRUE(AddSynonym(*sample_, pool_));
  ASSERT_TRUE(WriteCampus(*sample_, SampleCampus()));
  EXPECT_TRUE(HasName("swimming pool"));
  EXPECT_TRUE(RemoveSynonym(*sample_, pool_));
  EXPECT_FALSE(HasName("swimming pool"));
  EXPECT_FALSE(RemoveSynonym(*sample_, pool_).ok());
}

TEST_F(Notes, ASynonymOfNobodyIsAProblemWithTheNearestRightName) {
  EXPECT_EQ(
      AddSynonym(*sample_, {Kind::kPlace, "libary", Language::kEnglish, "books", false}).problem(),
      "there is no place \"libary\" (did you mean \"library\"?)");
}

TEST_F(Notes, ASynonymWhoseSubjectIsGoneIsTold) {
  ASSERT_TRUE(AddSynonym(*sample_, {Kind::kPerson, "li_wang", Language::kEnglish, "Lee", false}));
  EXPECT_THAT(StraySynonyms(*sample_), IsEmpty());
  Campus campus = SampleCampus();
  campus.names.erase(std::remove_if(campus.names.begin(), campus.names.end(),
                                    [](const Name& name) { return name.subject == "li_wang"; }),
                     campus.names.end());
  ASSERT_TRUE(WriteCampus(*sample_, campus));
  EXPECT_THAT(StraySynonyms(*sample_), SizeIs(1));
}

}  // namespace
}  // namespace coppice::robot::knowledge
