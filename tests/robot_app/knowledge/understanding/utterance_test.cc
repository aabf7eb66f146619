#include "robot_app/knowledge/understanding/utterance.h"

#include <gtest/gtest.h>

#include "tests/robot_app/knowledge/language_files.h"

namespace coppice::robot::knowledge {
namespace {

std::string Taken(const std::string& text, Language language) {
  std::string words;
  for (const SoundingWord& word :
       TakeApart(text, In(language, ShippedLanguageFiles().words)).words) {
    words += (words.empty() ? "" : " ") + word.text;
  }
  return words;
}

TEST(Utterance, NumbersThatAreSpokenBecomeDigits) {
  EXPECT_EQ(Taken("Room one oh three", Language::kEnglish), "room 103");
  EXPECT_EQ(Taken("Linie vier", Language::kGerman), "linie 4");
  EXPECT_EQ(Taken("this one please", Language::kEnglish), "this one please");
}

TEST(Utterance, LettersAndDigitsAreWordsOfTheirOwn) {
  EXPECT_EQ(Taken("S3, room103", Language::kEnglish), "s 3 room 103");
}

TEST(Utterance, ContractionsAreWrittenOut) {
  EXPECT_EQ(Taken("What's for lunch?", Language::kEnglish), "what is for lunch");
  EXPECT_EQ(Taken("was gibt's", Language::kGerman), "was gibt es");
}

TEST(Utterance, FillersAreNoContent) {
  const Utterance utterance =
      TakeApart("please the library", In(Language::kEnglish, ShippedLanguageFiles().words));
  EXPECT_EQ(utterance.content.to_ulong(), 0b100U);
}

TEST(Utterance, OfALongOneTheBeginningIsTaken) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "word ";
  EXPECT_EQ(TakeApart(text, {}).words.size(), kMostWords);
  EXPECT_TRUE(TakeApart("", {}).words.empty());
}

}  // namespace
}  // namespace coppice::robot::knowledge
