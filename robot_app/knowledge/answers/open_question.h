// What the robot has asked back, until it is answered or too old: which of a few requests was
// meant, or what is missing of one.
//
//   OpenQuestion question({{"Anna Weber", office_of_anna}, {"Paul Weber", office_of_paul}}, now);
//   question.AnsweredBy("the second one", understander, words)   // office_of_paul
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_OPEN_QUESTION_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_OPEN_QUESTION_H_

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot_app/knowledge/answers/answer.h"
#include "robot_app/knowledge/understanding/likely_meanings.h"

namespace coppice::robot::knowledge {

/// An answer that was heard uncertainly.
struct LikelyReply {
  Request request;
  std::string text;  ///< the likeliest of those that say it
  double share = 0;  ///< its chance, 0..1
};

class OpenQuestion {
 public:
  /// From when it was asked; who answers later is not answering it. The robot says it meanwhile.
  static constexpr std::chrono::seconds kPatience{20};

  /// One or a few.
  OpenQuestion(std::vector<Choice> choices, WallTime now)
      : choices_(std::move(choices)), until_(now + kPatience) {}
  /// A slot of one of these kinds is missing.
  OpenQuestion(Request request, std::vector<Kind> kinds, WallTime now)
      : request_(std::move(request)), kinds_(std::move(kinds)), until_(now + kPatience) {}

  /// Who answered was not slow, but whoever made out what was said.
  void Wait(std::chrono::nanoseconds longer) {
    until_ += std::chrono::duration_cast<WallTime::duration>(longer);
  }
  bool is_open(WallTime now) const { return now <= until_; }
  const std::vector<Choice>& choices() const { return choices_; }

  /// The request that the answer chooses, by yes, number, name or by what is wanted; kCancel if it
  /// is none. Nothing if the text is no answer, but something new.
  std::optional<Request> AnsweredBy(std::string_view text, const Understander& understander,
                                    const LanguageWords& words) const;
  /// Likewise of an answer that was heard uncertainly: nothing, too, if it is not sure enough.
  std::optional<LikelyReply> AnsweredBy(const std::vector<Alternative>& alternatives,
                                        const Understander& understander,
                                        const LanguageWords& words) const;

 private:
  std::optional<Request> Completed(std::string_view text, const Understander& understander) const;
  std::optional<Request> ByNumber(std::string_view text, const LanguageWords& words) const;
  std::optional<Request> ByName(std::string_view text, const Understander& understander) const;
  std::optional<Request> ByIntent(Intent intent) const;

  std::vector<Choice> choices_;  // empty: a slot is missing
  Request request_;
  std::vector<Kind> kinds_;
  WallTime until_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_OPEN_QUESTION_H_
