#include "robot_app/speech/ear/spoken_sentences.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "robot_app/knowledge/store/folded_text.h"
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

TEST(SpokenSentences, WhatIsContractedStandsBothWays) {
  EXPECT_THAT(Sentences(), Contains(Key("wheres the copy shop")));
}

TEST(SpokenSentences, AFamilyNameStandsWithTitles) {
  EXPECT_THAT(Sentences(), Contains(Key("where is mrs brandt")));
  EXPECT_THAT(Sentences(), Contains(Key("where is doctor paul weber")));
  EXPECT_THAT(Sentences(), Not(Contains(Key("where is mrs janitor"))));
}

TEST(SpokenSentences, ASecondSlotIsFilled) {
  EXPECT_THAT(Sentences(), Contains(Key("is the library open tomorrow")));
  EXPECT_THAT(Sentences(), Contains(Key("when does line 4 to marktplatz leave")));
}

TEST(SpokenSentences, EveryOpeningStandsBeforeSomeName) {
  const auto& table = knowledge::ShippedLanguageFiles().intents;
  const auto& example = In(Language::kEnglish, table.front().examples).at(9);
  ASSERT_EQ(example.text, " where {place} is");
  for (const std::string& opening : example.openings) {
    const bool is_there = std::any_of(Sentences().begin(), Sentences().end(), [&](const auto& one) {
      return one.first.rfind(knowledge::Folded(opening) + " where the ", 0) == 0;
    });
    EXPECT_TRUE(is_there) << opening;
  }
}

TEST(SpokenSentences, ANameTakesAnArticleOrAnEndingAsItIsSaid) {
  EXPECT_THAT(Sentences(), Contains(Key("where can i find an elevator")));
  EXPECT_THAT(Sentences(), Not(Contains(Key("where can i find a elevator"))));
  EXPECT_THAT(Sentences(), Contains(Key("where is anna webers office")));
}

TEST(SpokenSentences, AReplyIsYesNoANumberOrAName) {
  std::set<std::string> replies;
  const auto add = [&replies](const Sentence& sentence, double) {
    std::string text;
    for (const std::string& word : sentence) text += (text.empty() ? "" : " ") + word;
    replies.insert(text);
  };
  const auto& files = knowledge::ShippedLanguageFiles();
  ForEachReply({files.intents, In(Language::kEnglish, files.words), {}}, add);
  ForEachNamed({"the library"}, add);
  EXPECT_THAT(replies, testing::IsSupersetOf({"yes", "no thanks", "the second one", "library"}));
  EXPECT_THAT(replies, Not(Contains("the third one")));
}

// Of a university all: with all of them in each frame there were millions of sentences.
TEST(SpokenSentences, ThousandsOfNamesStandInSomeSentenceEach) {
  std::vector<knowledge::Name> names;
  for (int i = 0; i < 5000; ++i) {
    std::string person = "p";  // of letters: numbers would be words of their own
    for (int rest = i; rest > 0; rest /= 16) person += static_cast<char>('a' + rest % 16);
    names.push_back({knowledge::Kind::kPerson, person, Language::kEnglish, person, true});
  }
  const auto& files = knowledge::ShippedLanguageFiles();
  std::size_t sentences = 0;
  std::set<std::string> words;
  ForEachSentence({files.intents, In(Language::kEnglish, files.words), names},
                  [&](const Sentence& sentence, double) {
                    ++sentences;
                    words.insert(sentence.begin(), sentence.end());
                  });
  EXPECT_LT(sentences, 400'000u);
  for (const knowledge::Name& name : names) EXPECT_EQ(words.count(name.text), 1u) << name.text;
}

TEST(SpokenSentences, TheWeightsOfARowAddUpToAboutOne) {
  double sum = 0;
  for (const auto& [sentence, weight] : Sentences()) sum += weight;
  EXPECT_NEAR(sum, knowledge::kIntents, 2);
}

}  // namespace
}  // namespace coppice::robot::speech
