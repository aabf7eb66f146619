// Whether somebody who pauses has said all that he wants, so that he need not be waited for as long
// as usual: what he means is sure, and no sentence that is known here (spoken_sentences.h) goes on
// after these words. "What is for lunch" may be followed by "tomorrow", "take me to the office" by
// "of Anna Weber"; "where is the library" is all.
//
//   const CompleteRequest complete({table, words, Names(database)});
//   complete.IsSaid(recognizer.Recognize(until_the_pause), kSureEnough)
//
// Greetings, small talk and what answers questions are often followed by a question: they are never
// complete. Immutable; any thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_COMPLETE_REQUEST_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_COMPLETE_REQUEST_H_

#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "robot_app/knowledge/understanding/likely_meanings.h"
#include "robot_app/speech/ear/spoken_sentences.h"

namespace coppice::robot::speech {

class CompleteRequest {
 public:
  /// The table and the words of `spoken` must outlive this.
  explicit CompleteRequest(const SpokenLanguage& spoken);

  /// `least_sure`: the chance that it is meant with which it is acted on.
  bool IsSaid(const std::vector<knowledge::Alternative>& alternatives, double least_sure) const;

 private:
  std::string EndOf(const Sentence& words) const;
  Sentence WithoutOpenings(Sentence words) const;
  bool GoesOn(const Sentence& words) const;
  bool TakesMore(const knowledge::Request& request) const;

  const knowledge::IntentTable& table_;
  const std::set<std::string>& fillers_;
  knowledge::Language language_;
  knowledge::Understander understander_;
  std::set<Sentence> openings_;                // "can you tell me", "excuse me"
  std::unordered_set<std::string> sentences_;  // beginnings of them, without openings
  std::unordered_set<std::string> ends_;       // their last words
  std::unordered_set<std::string> names_, names_that_go_on_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_COMPLETE_REQUEST_H_
