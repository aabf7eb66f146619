#include "robot_app/knowledge/answers/dialogue.h"

#include <gmock/gmock.h>

#include "robot_app/knowledge/store/notes.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class DialogueTest : public testing::Test {
 protected:
  DialogueTest() {
    Diagnostics diagnostics;
    dialogue_ = Dialogue::Open(sample_.path(), LanguageFolder(), diagnostics);
    if (!dialogue_) throw std::runtime_error(diagnostics.ToString());
  }
  std::string Ask(const std::string& text) { return Hear(text).text; }
  std::string AskInGerman(const std::string& text) {
    dialogue_->set_language(Language::kGerman);
    return Ask(text);
  }
  Answer Hear(const std::string& text) { return dialogue_->Hear(text, now_); }
  HeardAnswer HearOneOf(const std::vector<Alternative>& heard) {
    return dialogue_->Hear(heard, now_);
  }

  SampleDatabase sample_;
  WallTime now_ = sample_.At("2026-11-25", 12);
  std::unique_ptr<Dialogue> dialogue_;
};

TEST_F(DialogueTest, APlaceOnTheMapIsDescribedAndShown) {
  const Answer answer = Hear("where is room 103");
  EXPECT_EQ(answer.text,
            "Office 103: on the ground floor of the institute building. I can take you there.");
  EXPECT_EQ(answer.place, "office_103");
  EXPECT_FALSE(answer.guides);
}

TEST_F(DialogueTest, APlaceElsewhereIsToldInWords) {
  EXPECT_EQ(AskInGerman("wo ist Büro 203"),
            "Büro 203: erster Stock, Institutsgebäude. Nehmen Sie in der Eingangshalle den Aufzug "
            "oder die Treppe in den ersten Stock.");
  EXPECT_THAT(Ask("wo ist die Mensa"), StartsWith("Die Mensa: Mensagebäude. Verlassen Sie"));
}

TEST_F(DialogueTest, AQuestionBackIsAnsweredByNameNumberOrYes) {
  EXPECT_EQ(Ask("office of Weber"), "Did you mean Prof. Dr. Anna Weber or Dr. Paul Weber?");
  EXPECT_THAT(Ask("Paul"), StartsWith("Dr. Paul Weber is in office 203"));
  Ask("office of Weber");
  EXPECT_THAT(Ask("the first one"), StartsWith("Prof. Dr. Anna Weber is in office 101"));
  EXPECT_EQ(Hear("office of Weber").mood, AnswerMood::kAsking);
  EXPECT_EQ(Ask("no thanks"), "All right.");
  EXPECT_EQ(Ask("yes"), "I have not asked anything.");
}

TEST_F(DialogueTest, WhatWasHeardUncertainlyIsAskedBack) {
  const HeardAnswer asked = HearOneOf(
      {{"where is the library", 4}, {"when does the library open", 4}, {"the moon was blue", 2}});
  EXPECT_EQ(asked.answer.text, "Did you ask where the library is, or when the library is open?");
  EXPECT_EQ(asked.answer.mood, AnswerMood::kAsking);
  ASSERT_THAT(asked.answer.choices, SizeIs(2));
  EXPECT_EQ(asked.answer.choices[1].label, "When the library is open");
  EXPECT_EQ(Ask("the second one"), "The library is open today from 08:00 to 22:00.");
}

TEST_F(DialogueTest, PlacesThatSoundAlikeAreAskedBackByName) {
  const std::vector<Alternative> heard = {{"where is hall A", 5}, {"where is hall B", 5}};
  EXPECT_EQ(HearOneOf(heard).answer.text, "Did you mean lecture hall A or lecture hall B?");
  EXPECT_EQ(Hear("lecture hall B").place, "hall_b");
  dialogue_->set_language(Language::kGerman);
  EXPECT_EQ(HearOneOf({{"wo ist Hörsaal A", 5}, {"wo ist Hörsaal B", 5}}).answer.text,
            "Meinen Sie Hörsaal A oder Hörsaal B?");
}

TEST_F(DialogueTest, ASingleCandidateIsAgreedToOrNot) {
  const std::vector<Alternative> heard = {
      {"where is the library", 5}, {"the moon was blue", 3}, {"goodbye", 2}};
  const HeardAnswer asked = HearOneOf(heard);
  EXPECT_EQ(asked.answer.text, "Did you ask where the library is?");
  ASSERT_THAT(asked.answer.choices, SizeIs(2));
  EXPECT_EQ(asked.answer.choices[0].label, "Yes");
  EXPECT_EQ(Hear("yes").place, "library");
  HearOneOf(heard);
  EXPECT_EQ(Ask("no"), "All right.");
  dialogue_->set_language(Language::kGerman);
  EXPECT_EQ(HearOneOf({{"wann öffnet die Bibliothek", 5}, {"der Mond war blau", 4}, {"danke", 1}})
                .answer.text,
            "Haben Sie gefragt, wann die Bibliothek geöffnet hat?");
  EXPECT_EQ(dialogue_->Press({Intent::kYes, {}}, now_).text,
            "Die Bibliothek ist heute von 08:00 bis 22:00 geöffnet.");
}

TEST_F(DialogueTest, WhatWasHardlyHeardIsNeitherActedOnNorNoted) {
  const HeardAnswer refused =
      HearOneOf({{"the moon was blue", 6}, {"take me to the library", 3}, {"goodbye", 1}});
  EXPECT_EQ(refused.answer.text, "I am sorry, I did not understand that. Please say it again.");
  EXPECT_EQ(refused.answer.mood, AnswerMood::kUnknown);
  EXPECT_EQ(refused.text, "");
  EXPECT_THAT(UnknownRequests(*sample_), IsEmpty());
  EXPECT_EQ(HearOneOf({}).answer.text, refused.answer.text);
}

TEST_F(DialogueTest, WhatAServiceHasUnderstoodGoesBeforeIfItFits) {
  const std::vector<Alternative> said = {{"i would love to read a book", 1}};
  const ToldMeaning library{Intent::kFindPlace, {{Kind::kPlace, "library"}}};
  EXPECT_EQ(dialogue_->Hear(said, now_, library).answer.place, "library");
  const ToldMeaning moon{Intent::kFindPlace, {{Kind::kPlace, "the moon"}}};
  EXPECT_EQ(dialogue_->Hear({{"where is the copy shop", 1}}, now_, moon).answer.place, "copy_shop")
      << "else the own understanding does";
}

TEST_F(DialogueTest, AYesToTwoIsAskedAgain) {
  const std::string question = Ask("office of Weber");
  EXPECT_EQ(Ask("yes"), question);
  EXPECT_THAT(Ask("the second one"), StartsWith("Dr. Paul Weber is in office 203"));
}

TEST_F(DialogueTest, AQuestionIsOpenForAWhileOnly) {
  Ask("office of Weber");
  EXPECT_THAT(dialogue_->ExpectedNames(now_), Contains("Paul Weber"));
  now_ += OpenQuestion::kPatience + std::chrono::seconds(1);
  EXPECT_THAT(dialogue_->ExpectedNames(now_), IsEmpty());
  EXPECT_EQ(Ask("yes"), "I have not asked anything.");
}

TEST_F(DialogueTest, AQuestionIsOpenLongerIfItTookLongToMakeOutTheAnswer) {
  const std::chrono::seconds took(30);
  Ask("office of Weber");
  now_ += std::chrono::seconds(10) + took;
  dialogue_->Wait(took);
  EXPECT_THAT(Ask("the second one"), StartsWith("Dr. Paul Weber is in office 203"));
}

TEST_F(DialogueTest, ANewQuestionEndsAnOpenOne) {
  Ask("office of Weber");
  EXPECT_THAT(Ask("where is the library"), StartsWith("The library"));
  EXPECT_EQ(Ask("yes"), "I have not asked anything.");
}

TEST_F(DialogueTest, WhatIsMissingIsAskedFor) {
  EXPECT_EQ(Ask("guide me"), "Which place do you mean?");
  const Answer answer = Hear("to the reception");
  EXPECT_EQ(answer.text, "Please follow me to the reception.");
  EXPECT_TRUE(answer.guides);
  EXPECT_EQ(answer.place, "reception");
}

TEST_F(DialogueTest, ThereIsThePlaceOfWhichTheRobotHasJustSpoken) {
  Ask("where is room 103");
  EXPECT_EQ(Ask("take me there"), "Please follow me to office 103.");
  dialogue_->Forget();
  EXPECT_EQ(Ask("take me there"), "Which place do you mean?");
}

TEST_F(DialogueTest, WhereTheRobotCannotDriveItDoesNotGuide) {
  const Answer answer = Hear("take me to office 203");
  EXPECT_FALSE(answer.guides);
  EXPECT_THAT(answer.text, StartsWith("I cannot drive there: office 203"));
}

TEST_F(DialogueTest, TheNearestDependsOnWhereTheRobotIs) {
  EXPECT_EQ(Hear("where is the toilet").place, "restroom_ground");
  dialogue_->set_way(
      [] { return [](const Place& place) { return place.id == "restroom_first" ? 1 : 2; }; });
  EXPECT_EQ(Hear("where is the toilet").place, "restroom_first");
}

TEST_F(DialogueTest, TheMenuIsThatOfTheDayAndTheDiet) {
  EXPECT_EQ(Ask("what's for lunch"),
            "Today in the canteen: Fried fish with potato salad, Cheese dumplings with spinach and "
            "Pumpkin soup.");
  EXPECT_EQ(Ask("is there something vegan tomorrow"),
            "Vegan tomorrow in the canteen: Lentil bolognese.");
  EXPECT_EQ(AskInGerman("was gibt es am Samstag in der Mensa"),
            "Die Mensa ist am Samstag geschlossen.");
  now_ = sample_.At("2027-05-03", 12);
  EXPECT_EQ(Ask("was gibt es heute zu essen"), "Ich kenne heute keinen Speiseplan.");
}

TEST_F(DialogueTest, DeparturesAreThoseOfNow) {
  EXPECT_THAT(Ask("when does line 4 to Hauptbahnhof leave"),
              StartsWith("Line 4 to Hauptbahnhof at 12:06 from the stop Erlenhof Campus. Line 4"));
  EXPECT_THAT(AskInGerman("wann fährt der Nachtbus N4"),
              StartsWith("Linie N4 nach Erlensee am Samstag um 00:43"));
}

TEST_F(DialogueTest, OpeningHoursKnowWeekdaysAndHolidays) {
  EXPECT_EQ(Ask("when does the library open"), "The library is open today from 08:00 to 22:00.");
  EXPECT_EQ(Ask("is the library open on Sunday"), "The library is closed on Sunday.");
  EXPECT_EQ(Ask("is the reading room open"), "The reading room is open today all day.");
  now_ = sample_.At("2026-12-25", 12);
  EXPECT_EQ(Ask("is the gym open today"), "The sports hall is closed today.");
  EXPECT_EQ(Ask("when is the robotics lab open"),
            "I do not know when the robotics laboratory is open.");
}

TEST_F(DialogueTest, PeopleCanBeReached) {
  EXPECT_EQ(Ask("phone number of Li Wang"),
            "Dr. Li Wang: telephone +49 555 0205, email li.wang@erlenhof.example.");
  EXPECT_EQ(Ask("who works in room 101"), "In office 101: Prof. Dr. Anna Weber.");
  EXPECT_EQ(Ask("who works in room 107"), "In office 107: Elena Kowalski.");
}

TEST_F(DialogueTest, SmallTalkKnowsTheTime) {
  EXPECT_EQ(Ask("what time is it"), "It is 12:00.");
  EXPECT_EQ(AskInGerman("welcher Tag ist heute"), "Heute ist Mittwoch, 25. November.");
}

TEST_F(DialogueTest, TheLanguageIsChangedOnRequest) {
  EXPECT_EQ(Ask("speak German"), "Ich spreche jetzt Deutsch.");
  EXPECT_EQ(dialogue_->language(), Language::kGerman);
  EXPECT_THAT(Ask("wo ist die Mensa"), StartsWith("Die Mensa"));
}

TEST_F(DialogueTest, WhatWasSaidIsRepeated) {
  EXPECT_EQ(Ask("say that again"), "I have not said anything yet.");
  dialogue_->Forget();
  const std::string said = Ask("tell me a joke");
  EXPECT_EQ(Ask("pardon"), said);
  EXPECT_EQ(Ask("once more please"), said);
}

TEST_F(DialogueTest, AnUnknownPlaceIsRefusedAndNotedUntilTheOperatorNamesIt) {
  const Answer refused = Hear("where is the swimming pool");
  EXPECT_EQ(refused.mood, AnswerMood::kUnknown);
  EXPECT_EQ(refused.text, "I am sorry, I do not know “swimming pool”.");
  ASSERT_THAT(UnknownRequests(*sample_), SizeIs(1));
  EXPECT_EQ(UnknownRequests(*sample_)[0].text, "where is the swimming pool");
  ASSERT_TRUE(
      AddSynonym(*sample_, {Kind::kPlace, "gym", Language::kEnglish, "swimming pool", false}));
  EXPECT_EQ(Hear("where is the swimming pool").place, "gym");
}

TEST_F(DialogueTest, AnImportIsSeenByTheNextQuestion) {
  Campus campus = SampleCampus();
  campus.names.push_back({Kind::kPlace, "gym", Language::kEnglish, "climbing wall", false});
  EXPECT_EQ(Hear("where is the climbing wall").mood, AnswerMood::kUnknown);
  ASSERT_TRUE(WriteCampus(*sample_, campus));
  EXPECT_EQ(Hear("where is the climbing wall").place, "gym");
}

TEST_F(DialogueTest, ADatabaseWithoutKnowledgeHasNoAnswers) {
  TemporaryFolder folder;
  { const Database empty = Database::OpenOrCreate(folder.Path("empty.db")).value(); }
  Diagnostics diagnostics;
  const auto dialogue = Dialogue::Open(folder.Path("empty.db"), LanguageFolder(), diagnostics);
  ASSERT_TRUE(dialogue);
  EXPECT_EQ(dialogue->Hear("help", now_).text, "I am sorry, I cannot look that up at the moment.");
  EXPECT_FALSE(Dialogue::Open(folder.Path("missing.db"), LanguageFolder(), diagnostics));
}

// Presses the first button on and on, wherever that leads.
void PressAll(Dialogue& dialogue, WallTime now, const std::vector<std::string>& path,
              std::map<Intent, Answer>& answers) {
  const TouchScreen screen = dialogue.Screen(path);
  if (screen.request) answers.emplace(screen.request->intent, dialogue.Press(*screen.request, now));
  const std::size_t most = path.empty() ? screen.buttons.size() : 2;
  for (std::size_t i = 0; i < std::min(most, screen.buttons.size()); ++i) {
    EXPECT_NE(screen.buttons[i].label, "");
    std::vector<std::string> next = path;
    next.push_back(screen.buttons[i].step);
    PressAll(dialogue, now, next, answers);
  }
}

TEST_F(DialogueTest, EveryIntentIsReachedByTouchWithAllThatItNeeds) {
  std::map<Intent, Answer> answers;
  PressAll(*dialogue_, now_, {}, answers);
  EXPECT_THAT(answers, SizeIs(kIntents));
  for (const auto& [intent, answer] : answers) {
    EXPECT_NE(answer.text, "") << Word(intent);
    EXPECT_EQ(answer.mood, AnswerMood::kAnswered) << Word(intent);
    if (intent != Intent::kGuide) continue;
    EXPECT_TRUE(answer.guides);
  }
}

TEST_F(DialogueTest, APathThatNoButtonLeadsToIsEmpty) {
  const TouchScreen screen = dialogue_->Screen({"people", "nobody"});
  EXPECT_FALSE(screen.request);
  EXPECT_THAT(screen.buttons, IsEmpty());
}

TEST_F(DialogueTest, TouchAndSpeechGiveTheSameAnswer) {
  const TouchScreen screen = dialogue_->Screen({"nearby", "restroom"});
  ASSERT_TRUE(screen.request);
  EXPECT_EQ(dialogue_->Press(*screen.request, now_).text, Ask("where is the nearest restroom"));
}

}  // namespace
}  // namespace coppice::robot::knowledge
