// From what is wanted to what is said: a sentence, and the place that goes with it.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/knowledge/answers/answer_texts.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

/// How the robot should look.
enum class AnswerMood : std::uint8_t {
  kAnswered,
  kAsking,   ///< waits for an answer
  kUnknown,  ///< sorry: ears down
};

/// "answered", "asking", "unknown".
const char* Word(AnswerMood mood);

/// Of a question that the robot has asked back: what is said of it, and what it means.
struct Choice {
  std::string label;  ///< "Dr. Paul Weber", "Where the library is", "Yes"
  Request request;
};

struct Answer {
  AnswerMood mood = AnswerMood::kAnswered;
  std::string text;                     ///< what is said and shown
  std::string place;                    ///< to be shown on the map; may be empty
  bool guides = false;                  ///< and to be driven to, with the person behind
  std::optional<Request> request = {};  ///< what was understood; nothing: it is asked or unknown
  std::vector<Choice> choices = {};     ///< of kAsking: for buttons; empty if anything may follow
};

/// What an answer depends on beside the knowledge.
struct AnswerContext {
  Language language = Language::kEnglish;
  WallTime now;
  WayFromHere way;  ///< empty, or where it returns that: as the crow flies from the robot's home
};

/// Answers a request whose slots are filled. Throws std::runtime_error if the database is damaged.
Answer AnswerTo(const Database& database, const AnswerTexts& texts, const Request& request,
                const AnswerContext& context);

/// The day that a slot means: "today", "tomorrow", "day_after_tomorrow", or the next day of that
/// name, which may be today.
Day DayMeant(const std::string& subject, Day today);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_H_
