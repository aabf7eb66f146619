#include "robot_app/tablet/tablet_desk.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/support/folders.h"

namespace coppice::robot::tablet {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class Links : public TabletLinks {
 public:
  void Touched() override { calls.emplace_back("touched"); }
  void Talk(bool on) override { calls.emplace_back(on ? "talk" : "silent"); }
  void Answered(const knowledge::Answer& answer, const std::string& language) override {
    calls.push_back(std::string(answer.guides ? "guide " : "answer ") + language + " " +
                    answer.place);
  }
  void StopGuiding() override { calls.emplace_back("stop"); }
  std::vector<std::string> calls;
};

class TabletDeskTest : public testing::Test {
 protected:
  TabletDeskTest() {
    Diagnostics diagnostics;
    auto dialogue =
        knowledge::Dialogue::Open(sample_.path(), knowledge::LanguageFolder(), diagnostics);
    auto map = TopologicalMap::Load(SourceFolder() + "/robot_app/knowledge/sample/places.yaml",
                                    diagnostics);
    if (!dialogue || !map) throw std::runtime_error(diagnostics.ToString());
    desk_ = std::make_unique<TabletDesk>(std::move(dialogue), *std::move(map), links_,
                                         [this] { return sample_.At("2026-11-25", 12, minute_); });
  }
  json Call(const json& call) { return json::parse(desk_->Reply(call.dump())); }
  void StandAt(double x, double y) {
    desk_->ChangeView([&](TabletView& view) { view.pose = Pose2D{x, y, 0}; });
  }
  std::vector<std::string> LabelsAt(const std::vector<std::string>& path) {
    std::vector<std::string> labels;
    const json screen = Call({{"do", "screen"}, {"path", path}});
    for (const json& button : screen["buttons"]) {
      labels.push_back(button["label"]);
    }
    return labels;
  }

  knowledge::SampleDatabase sample_;
  Links links_;
  int minute_ = 0;
  std::unique_ptr<TabletDesk> desk_;
};

TEST_F(TabletDeskTest, PlacesAreFoundByTheirCategory) {
  EXPECT_THAT(LabelsAt({"places", "seminar_room"}), testing::Contains("Seminar room 104"));
}

TEST_F(TabletDeskTest, ButtonsSpeakTheVisitorsLanguage) {
  Call({{"do", "touched"}, {"language", "de"}});
  EXPECT_THAT(LabelsAt({"places", "seminar_room"}), testing::Contains("Seminarraum 104"));
}

TEST_F(TabletDeskTest, APressedPlaceIsToldWithTheWayFromHere) {
  StandAt(24, 0);
  const json told = Call({{"do", "press"}, {"path", {"places", "office", "office_103"}}});
  EXPECT_THAT(told["text"].get<std::string>(), HasSubstr("ffice 103"));
  EXPECT_EQ(told["place"], "office_103");
  const json& points = told["way"]["points"];
  EXPECT_EQ(points.front(), (json{24.0, 0.0}));
  EXPECT_EQ(points.back(), (json{24.0, 3.6}));
  EXPECT_TRUE(told["way"]["there"]);
}

TEST_F(TabletDeskTest, AnotherFloorIsToldInWordsAndTheWayEndsWhereTheRobotDoes) {
  StandAt(46, 0);  // in the hall
  const json told = Call({{"do", "ask"}, {"text", "where is room 203"}});
  EXPECT_FALSE(told["way"]["there"]);
  EXPECT_NE(told["way"]["words"], "");
}

TEST_F(TabletDeskTest, PeopleAreFoundHoweverTheyAreSpelt) {
  const json told = Call({{"do", "ask"}, {"text", "paul webber"}});
  EXPECT_THAT(told["text"].get<std::string>(), HasSubstr("Dr. Paul Weber"));
}

TEST_F(TabletDeskTest, MenusAndDeparturesAreButtons) {
  for (const char* const first : {"menu", "departures"}) {
    std::vector<std::string> path = {first};
    json screen = Call({{"do", "screen"}, {"path", path}});
    while (!screen["answers"] && !screen["buttons"].empty()) {
      path.push_back(screen["buttons"][0]["step"]);
      screen = Call({{"do", "screen"}, {"path", path}});
    }
    const json told = Call({{"do", "press"}, {"path", path}});
    EXPECT_EQ(told["mood"], "answered") << told;
  }
}

TEST_F(TabletDeskTest, TheNearestPlaceIsTheOneThatIsSoonestReached) {
  StandAt(40, 0);
  const std::string near = Call({{"do", "ask"}, {"text", "nearest restroom"}})["place"];
  EXPECT_EQ(near, "restroom_ground");
}

TEST_F(TabletDeskTest, AsksTheRobotToLeadAndToStop) {
  Call({{"do", "guide"}, {"place", "office_103"}, {"language", "de"}});
  Call({{"do", "stop"}});
  EXPECT_THAT(links_.calls, ElementsAre("guide de office_103", "stop"));
}

TEST_F(TabletDeskTest, LeadsNowhereThatIsNotOnTheMap) {
  EXPECT_TRUE(Call({{"do", "guide"}, {"place", "../etc"}}).contains("error"));
  EXPECT_THAT(links_.calls, testing::IsEmpty());
}

TEST_F(TabletDeskTest, HearsWhileTheButtonIsPressed) {
  Call({{"do", "talk"}, {"on", true}});
  Call({{"do", "talk"}, {"on", false}});
  EXPECT_THAT(links_.calls, ElementsAre("talk", "silent"));
}

TEST_F(TabletDeskTest, WhoClosesThePageWhileHeTalksIsHeardNoMore) {
  Call({{"do", "talk"}, {"on", true}});
  desk_->EndTalkUnlessHeld();
  EXPECT_THAT(links_.calls, ElementsAre("talk"));
  ++minute_;
  desk_->EndTalkUnlessHeld();
  desk_->EndTalkUnlessHeld();
  EXPECT_THAT(links_.calls, ElementsAre("talk", "silent"));
}

TEST_F(TabletDeskTest, ForgetsWhoHasGone) {
  Call({{"do", "ask"}, {"text", "office of Weber"}});
  Call({{"do", "leave"}});
  const json told = Call({{"do", "ask"}, {"text", "the first one"}});
  EXPECT_THAT(told["text"].get<std::string>(), testing::Not(HasSubstr("Weber")));
}

TEST_F(TabletDeskTest, TellsTheFaceOnlyWhenItHasChanged) {
  desk_->ChangeView([](TabletView& view) {
    view.face = {0, 255, 16};
    view.face_number = 4;
  });
  EXPECT_EQ(Call({{"do", "state"}, {"face", 3}})["face"], "00ff10");
  EXPECT_EQ(Call({{"do", "state"}, {"language", "de"}})["language"], "en") << "of who comes next";
  EXPECT_FALSE(Call({{"do", "state"}, {"face", 4}}).contains("face"));
}

TEST_F(TabletDeskTest, ShowsWhatWasAnsweredToSomebodyWhoSpoke) {
  StandAt(24, 0);
  desk_->ChangeView([](TabletView& view) {
    view.said.text = "Office 103 is there.";
    view.said.place = "office_103";
    view.said_number = 2;
  });
  const json state = Call({{"do", "state"}, {"said", 1}});
  EXPECT_EQ(state["said"]["text"], "Office 103 is there.");
  EXPECT_TRUE(state["said"]["way"]["there"]);
  EXPECT_FALSE(Call({{"do", "state"}, {"said", 2}}).contains("said"));
}

TEST_F(TabletDeskTest, AQuestionBackIsAnsweredByAButton) {
  const json asked = Call({{"do", "ask"}, {"text", "where is the office of Weber"}});
  EXPECT_EQ(asked["choices"], json::parse(R"(["Prof. Dr. Anna Weber", "Dr. Paul Weber"])"));
  const json answer = Call({{"do", "choose"}, {"number", 1}});
  EXPECT_THAT(answer["text"].get<std::string>(), HasSubstr("Dr. Paul Weber is in office 203"));
  EXPECT_TRUE(Call({{"do", "choose"}, {"number", 1}}).contains("error"));
}

TEST_F(TabletDeskTest, WhatWasAskedBackAloudIsAnsweredByAButton) {
  desk_->ChangeView([](TabletView& view) {
    view.said = {knowledge::AnswerMood::kAsking, "Did you ask where the library is?", {}, false};
    view.said.choices = {
        {"Yes", {knowledge::Intent::kFindPlace, {{knowledge::Kind::kPlace, "library"}}}},
        {"No", {knowledge::Intent::kCancel, {}}}};
    ++view.said_number;
  });
  EXPECT_EQ(Call({{"do", "state"}})["said"]["choices"][0], "Yes");
  EXPECT_EQ(Call({{"do", "choose"}, {"number", 0}})["place"], "library");
}

TEST_F(TabletDeskTest, ShowsTheRestWhenATopicSaysWhatIsNoText) {
  desk_->ChangeView([](TabletView& view) {
    view.outcome = "\xff\xfe";
    view.said = {knowledge::AnswerMood::kAnswered, "\xc3", "\x80", false};
    ++view.said_number;
  });
  const json state = Call({{"do", "state"}});
  EXPECT_FALSE(state.contains("error"));
  EXPECT_EQ(state["said"]["text"], "\uFFFD");
}

TEST_F(TabletDeskTest, TellsTheWalls) {
  OccupancyGrid grid;
  grid.frame.width = 3;
  grid.frame.height = 1;
  grid.cells = {0, 100, -1};
  desk_->SetGrid(grid);
  EXPECT_EQ(Call({{"do", "map"}})["cells"], ".# ");
}

TEST_F(TabletDeskTest, WhatIsNoCallIsRefusedAndLeadsToNothing) {
  for (const std::string call :
       {"", "{", "[]", "7", "{\"do\":7}", "{\"do\":\"restart\"}",
        "{\"do\":\"press\",\"path\":[\"nowhere\"]}", "{\"do\":\"press\"}",
        "{\"do\":\"talk\",\"on\":\"yes\"}", "{\"do\":\"screen\",\"path\":[1]}",
        "{\"do\":\"ask\",\"text\":\"\xff\xfe\"}", "{\"do\":\"guide\",\"place\":[]}",
        "{\"do\":\"choose\",\"number\":-1}"}) {
    EXPECT_TRUE(json::parse(desk_->Reply(call)).is_object()) << call;
  }
  const std::string deep(10000, '[');
  EXPECT_TRUE(json::parse(desk_->Reply(deep)).contains("error"));
  EXPECT_TRUE(Call({{"do", "ask"}, {"text", std::string(1000, 'a')}}).contains("error"));
}

}  // namespace
}  // namespace coppice::robot::tablet
