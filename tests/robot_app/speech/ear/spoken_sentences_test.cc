#include "robot_app/speech/ear/spoken_sentences.h"

#include <gmock/gmock.h>

#include <map>

#include "robot_app/knowledge/store/queries.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Language;
using testing::Contains;
using testing::Key;
using testing::Not;

const std::map<std::string, double>& Sentences() {
  static const std::map<std::string, double> all = [] {
    std::map<std::string, double> sentences;
    knowledge::SampleDatabase sample;
    const auto& files = knowledge::ShippedLanguageFiles();
    const auto names = knowledge::Names(*sample);
    ForEachSentence({files.intents, In(Language::kEnglish, files.words), names},
                    [&](const Sentence& sentence, double weight) {
                      std::string text;
                      for (const std::string& word : sentence) text += " " + word;
                      sentences[text.substr(1)] += weight;
                    });
    return sentences;
  }();
  return all;
}

TEST(SpokenSentences, AnExampleStandsWithEveryName) {
  EXPECT_THAT(Sentences(), Contains(Key("where is the copy shop")));
  EXPECT_THAT(Sentences(), Contains(Key("where is the office of marie lefevre")));
  EXPECT_THAT(Sentences(), Contains(Key("the next bus to erlensee")));
}

TEST(SpokenSentences, APhraseStandsWithEveryName) {
  EXPECT_THAT(Sentences(), Contains(Key("directions to the library")));
}

TEST(SpokenSentences, WhoIsLedIsLedToAPlace) {
  EXPECT_THAT(Sentences(), Contains(Key("lead me to the library")));
  EXPECT_THAT(Sentences(), Not(Contains(Key("lead me the library"))));
}

TEST(SpokenSentences, ANameAloneIsOneWhereItMeansSomething) {
  EXPECT_THAT(Sentences(), Contains(Key("library")));
  EXPECT_THAT(Sentences(), Contains(Key("thank you")));
}

TEST(SpokenSentences, NamesOfAnotherLanguageAreLeftOut) {
  EXPECT_THAT(Sentences(), Not(Contains(Key("where is bibliothek"))));
}

TEST(SpokenSentences, TheWeightsOfARowAddUpToAboutOne) {
  double sum = 0;
  for (const auto& [sentence, weight] : Sentences()) sum += weight;
  EXPECT_NEAR(sum, knowledge::kIntents, 2);
}

}  // namespace
}  // namespace coppice::robot::speech
