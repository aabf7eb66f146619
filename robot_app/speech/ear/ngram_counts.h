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

#include <map>
#include <string>
#include <vector>

namespace coppice::robot::speech {

class NgramCounts {
 public:
  void Add(const std::vector<std::string>& sentence, double weight);
  /// These before and behind any of the sentences that were added until now, as if so many of them
  /// were said with one more: "excuse me", "please". None of them is empty.
  void AddBefore(const std::vector<std::vector<std::string>>& greetings, double share);
  void AddBehind(const std::vector<std::vector<std::string>>& courtesies, double share);
  /// A word that may come anywhere; all of these together have kAnywhere of the probability.
  void AddAnywhere(const std::string& word, double weight) { anywhere_[word] += weight; }

  std::vector<std::string> Words() const;
  std::string Arpa() const;

  double lower = 0.2;     ///< of the probability goes to the order below
  double anywhere = 0.4;  ///< of the unigrams' probability

 private:
  using History = std::vector<std::string>;  // the words before, the last one last
  using Followers = std::map<std::string, double>;
  void AddNgrams(const std::vector<std::string>& words, double weight);
  Followers FollowersOf(const History& history) const;

  std::map<History, Followers> counts_;
  std::map<std::string, double> anywhere_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_NGRAM_COUNTS_H_
