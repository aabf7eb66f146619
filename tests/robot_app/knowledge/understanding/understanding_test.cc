#include "robot_app/knowledge/understanding/understanding.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/knowledge/understanding_figures.h"

namespace coppice::robot::knowledge {
namespace {

class UnderstandingTest : public testing::Test {
 protected:
  static std::string Heard(const std::string& text, Language language = Language::kEnglish) {
    return TextOf(Of(language).Understand(text));
  }
  static const Understander& Of(Language language) {
    static const SampleNames sample;
    return In(language, sample.understanders);
  }

 private:
  struct SampleNames {
    SampleDatabase database;
    ByLanguage<Understander> understanders{Make(Language::kEnglish), Make(Language::kGerman)};
    Understander Make(Language language) {
      const LanguageFiles& files = ShippedLanguageFiles();
      return Understander(files.intents, In(language, files.words), Names(*database), language);
    }
  };
};

TEST_F(UnderstandingTest, ANumberThatNobodyHasIsUnknown) {
  EXPECT_EQ(Heard("where is room 103"), "find_place place=office_103");
  EXPECT_EQ(Heard("where is room 999"), "unknown [999]");
}

TEST_F(UnderstandingTest, AWordThatBelongsToTheNameMakesItAnotherThing) {
  EXPECT_EQ(Heard("where is the post office"), "unknown [post]");
  EXPECT_EQ(Heard("where is the office of the president"), "unknown [president]");
}

TEST_F(UnderstandingTest, SeveralOfOneNameAreAskedBack) {
  EXPECT_EQ(Heard("where is Weber"), "find_person person=anna_weber? person=paul_weber?");
  EXPECT_EQ(Heard("take me to the office of Weber"), "guide person=anna_weber? person=paul_weber?");
}

TEST_F(UnderstandingTest, WhatIsMissingIsKnownToBeMissing) {
  EXPECT_EQ(Heard("guide me"), "guide which?");
  EXPECT_EQ(Heard("bring mich", Language::kGerman), "guide which?");
}

TEST_F(UnderstandingTest, APlaceToGetInIsToldFromOneToGoTo) {
  EXPECT_EQ(Heard("next bus from Technologiepark to Flughafen"),
            "departures place=stop_park stop=Flughafen");
  EXPECT_EQ(Heard("next bus to Technologiepark"), "departures stop=Technologiepark");
}

TEST_F(UnderstandingTest, NothingAndNonsenseAreUnknown) {
  EXPECT_EQ(Heard(""), "unknown []");
  EXPECT_EQ(Heard("?!"), "unknown []");
  EXPECT_EQ(Heard(std::string(100000, 'x')), "unknown [" + std::string(100000, 'x') + "]");
}

TEST_F(UnderstandingTest, NoBytesMakeItFail) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 80, ' ');
    for (char& c : text) c = static_cast<char>(random());
    Of(Language::kGerman).Understand(text);
  }
}

std::string WithNames(std::string text, Language language) {
  static const std::map<std::string, ByLanguage<std::string>> kNames = {
      {"{place}", {"room 103", "Raum 103"}},     {"{category}", {"printer", "Drucker"}},
      {"{person}", {"Li Wang", "Li Wang"}},      {"{day}", {"tomorrow", "morgen"}},
      {"{diet}", {"vegetarian", "vegetarisch"}}, {"{line}", {"line 4", "Linie 4"}},
      {"{stop}", {"Flughafen", "Flughafen"}}};
  for (const auto& [slot, words] : kNames) {
    const std::size_t at = text.find(slot);
    if (at != std::string::npos) text.replace(at, slot.size(), In(language, words));
  }
  return text;
}

// With names for its slots, and wholly.
TEST_F(UnderstandingTest, EveryExampleOfTheTableIsUnderstoodWithEveryOpening) {
  for (const IntentRow& row : ShippedLanguageFiles().intents) {
    for (const Language language : kLanguages) {
      for (const Example& example : In(language, row.examples)) {
        std::vector<std::string> openings = example.openings;
        openings.emplace_back();
        for (const std::string& opening : openings) {
          const std::string text = opening + " " + WithNames(example.text, language);
          const Understanding heard = Of(language).Understand(text);
          EXPECT_EQ(heard.verdict, Verdict::kUnderstood) << text;
          EXPECT_STREQ(Word(heard.request.intent), Word(row.intent)) << text;
          EXPECT_EQ(heard.unknown, "") << text;  // else it would be asked back
        }
      }
    }
  }
}

TEST_F(UnderstandingTest, CourtesiesChangeNothing) {
  for (const Language language : kLanguages) {
    const LanguageWords& words = In(language, ShippedLanguageFiles().words);
    const std::string asked =
        language == Language::kEnglish ? "where is room 103" : "wo ist Raum 103";
    std::vector<std::string> texts;
    for (const std::string& greeting : words.greetings) texts.push_back(greeting + " " + asked);
    for (const std::string& courtesy : words.courtesies) texts.push_back(asked + " " + courtesy);
    for (const std::string& text : texts) {
      EXPECT_EQ(Heard(text, language), "find_place place=office_103") << text;
      EXPECT_EQ(Of(language).Understand(text).unknown, "") << text;
    }
  }
}

class Figures : public UnderstandingTest, public testing::WithParamInterface<Language> {
 protected:
  HearingCounts Count(bool only_held_out) const {
    HearingCounts counts;
    for (const SpokenExample& example : LoadExamples(UtterancesFile(GetParam()))) {
      if (only_held_out && !example.is_held_out) continue;
      counts.Add(example, HearingOf(Of(GetParam()).Understand(example.text), example));
    }
    return counts;
  }
};

TEST_P(Figures, EnoughIsUnderstoodAndLittleIsDoneWrong) {
  const HearingCounts all = Count(false);
  EXPECT_GE(all.answerable, 300);
  EXPECT_GE(all.right_share(), 0.95);
  EXPECT_GE(all.refused_share(), 0.9);
  EXPECT_LE(all.wrong_share(), 0.03);
}

TEST_P(Figures, TheSameHoldsForWhatWasNeverLookedAt) {
  const HearingCounts held_out = Count(true);
  EXPECT_GE(held_out.answerable, 100);
  EXPECT_GE(held_out.right_share(), 0.95);
  EXPECT_GE(held_out.refused_share(), 0.9);
  EXPECT_LE(held_out.wrong_share(), 0.03);
}

INSTANTIATE_TEST_SUITE_P(Languages, Figures,
                         testing::Values(Language::kEnglish, Language::kGerman));

}  // namespace
}  // namespace coppice::robot::knowledge
