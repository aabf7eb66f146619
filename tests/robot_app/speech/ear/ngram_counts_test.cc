#include "robot_app/speech/ear/ngram_counts.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>

namespace coppice::robot::speech {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

struct Entry {
  double probability = 0, back_off = 1;
};

std::map<std::string, Entry> EntriesOf(const std::string& arpa) {
  std::map<std::string, Entry> entries;
  std::istringstream stream(arpa);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find('\t');
    if (first == std::string::npos) continue;
    const std::size_t second = line.find('\t', first + 1);
    Entry entry{std::pow(10, std::stod(line)), 1};
    if (second != std::string::npos) entry.back_off = std::pow(10, std::stod(line.substr(second)));
    entries[line.substr(first + 1, second - first - 1)] = entry;
  }
  return entries;
}

NgramCounts TwoSentences() {
  NgramCounts counts;
  counts.lower = 0.2;
  counts.anywhere = 0.5;
  counts.Add({"where", "is", "it"}, 3);
  counts.Add({"where", "are", "you"}, 1);
  counts.AddAnywhere("please", 1);
  return counts;
}

TEST(NgramCounts, KnowsAllWords) {
  EXPECT_THAT(TwoSentences().Words(),
              ElementsAre("</s>", "are", "is", "it", "please", "where", "you"));
}

TEST(NgramCounts, AWordIsAsLikelyAsItWasSeenAfterTheOnesBefore) {
  const auto entries = EntriesOf(TwoSentences().Arpa());
  const double is = 0.5 * 3 / 16;  // half is for words that come anywhere
  EXPECT_THAT(entries.at("is").probability, DoubleNear(is, 1e-4));
  EXPECT_THAT(entries.at("please").probability, DoubleNear(0.5, 1e-4));
  const double where_is = 0.8 * 3 / 4 + 0.2 * is;
  EXPECT_THAT(entries.at("where is").probability, DoubleNear(where_is, 1e-3));
  EXPECT_THAT(entries.at("<s> where is").probability,
              DoubleNear(0.8 * 3 / 4 + 0.2 * where_is, 1e-3));
}

// As if "please where is it" had been added, but for how common "where", "is" and "it" are alone.
TEST(NgramCounts, GreetingsStandBeforeEverySentence) {
  NgramCounts told = TwoSentences(), added = TwoSentences();
  told.AddBefore({{"please"}, {"excuse", "me"}}, 0.5);
  for (const auto& [greeting, weight] : std::vector<std::pair<std::vector<std::string>, double>>{
           {{"please"}, 0.25}, {{"excuse", "me"}, 0.25}}) {
    for (const auto& [rest, times] : std::vector<std::pair<std::vector<std::string>, double>>{
             {{"where", "is", "it"}, 3}, {{"where", "are", "you"}, 1}}) {
      std::vector<std::string> sentence = greeting;
      sentence.insert(sentence.end(), rest.begin(), rest.end());
      added.Add(sentence, weight * times);
    }
  }
  const auto have = EntriesOf(told.Arpa()), want = EntriesOf(added.Arpa());
  ASSERT_EQ(have.size(), want.size());
  for (const auto& [words, entry] : want) {
    if (words.find(' ') == std::string::npos)
      continue;  // words behind the greeting count once more
    EXPECT_NEAR(have.at(words).probability, entry.probability, 0.05) << words;
    EXPECT_EQ(have.at(words).back_off, entry.back_off) << words;
  }
  EXPECT_NEAR(have.at("<s> excuse me").probability, 1, 0.25);
  EXPECT_NEAR(have.at("excuse me where").probability, 1, 0.25);
}

TEST(NgramCounts, CourtesiesStandBehindEverySentence) {
  NgramCounts counts = TwoSentences();
  counts.lower = 0.01;
  counts.AddBehind({{"thank", "you"}, {"now"}}, 0.5);
  const auto entries = EntriesOf(counts.Arpa());
  EXPECT_NEAR(entries.at("is it </s>").probability, 1 / 1.5, 0.01);
  EXPECT_NEAR(entries.at("is it thank").probability, 0.25 / 1.5, 0.01);
  EXPECT_NEAR(entries.at("it thank you").probability, 1, 0.02);
  EXPECT_NEAR(entries.at("are you now").probability, 0.25 / 1.5, 0.01);
  EXPECT_NEAR(entries.at("you now </s>").probability, 1, 0.02);
}

// What follows a word adds up to one: what was seen, and the rest by the order below.
TEST(NgramCounts, ProbabilitiesAddUpToOne) {
  const NgramCounts counts = TwoSentences();
  const auto entries = EntriesOf(counts.Arpa());
  double sum = 0;
  for (const std::string& word : counts.Words()) {
    const auto seen = entries.find("where " + word);
    sum += seen != entries.end() ? seen->second.probability
                                 : entries.at("where").back_off * entries.at(word).probability;
  }
  EXPECT_NEAR(sum, 1, 0.01);
}

}  // namespace
}  // namespace coppice::robot::speech
