// A trigram model of sentences, as the text that recognizers read (ARPA format).
//
//   NgramCounts counts;
//   counts.Add({"where", "is", "room", "101"}, 1.0);
//   WriteFile(path, counts.Arpa());
//
// Probabilities of each order are mixed with those of the order below (linear interpolation, F.
// Jelinek and R. Mercer, 1980) with fixed weights: sentences that are made from templates tell
// nothing of how often something new follows.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_NGRAM_COUNTS_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_NGRAM_COUNTS_H_

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace coppice::robot::speech {

class NgramCounts {
 public:
  NgramCounts();

  void Add(const std::vector<std::string>& sentence, double weight);
  /// These before and behind any of the sentences that were added until now, as if so many of them
  /// were said with one more: "excuse me", "please". None of them is empty.
  void AddBefore(const std::vector<std::vector<std::string>>& greetings, double share);
  void AddBehind(const std::vector<std::vector<std::string>>& courtesies, double share);
  /// A word that may come anywhere; all of these together have `anywhere` of the probability.
  void AddAnywhere(const std::string& word, double weight) { anywhere_[NumberOf(word)] += weight; }

  std::vector<std::string> Words() const;
  std::string Arpa() const;

  double lower = 0.2;     ///< of the probability goes to the order below
  double anywhere = 0.4;  ///< of the unigrams' probability

 private:
  static constexpr std::size_t kOrder = 3;
  using Word = std::uint32_t;              // its place in words_
  using Ngram = std::array<Word, kOrder>;  // a shorter one ends with zeros
  using Counts = std::map<Ngram, double>;  // those that begin alike are neighbours
  using Counted = std::pair<Ngram, double>;

  Word NumberOf(const std::string& word);
  std::vector<Word> NumbersOf(const std::vector<std::string>& words);
  void Count(const std::vector<Word>& words, double weight);
  bool GoesOn(const Ngram& words, std::size_t length) const;
  std::vector<double> UnigramProbabilities() const;
  std::string Line(double probability, const Ngram& words, std::size_t length) const;

  std::vector<std::string> words_;
  std::map<std::string, Word> numbers_;
  std::array<Counts, kOrder> counts_;  // of one word, of two and of three
  std::map<Word, double> anywhere_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_NGRAM_COUNTS_H_
