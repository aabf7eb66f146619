// What is said to the robot becomes what it answers, as messages. One conversation at a time: with
// another person, or after a silence, nothing of it is left.
#ifndef COPPICE_ROBOT_APP_SPEECH_NODE_CONVERSATION_H_
#define COPPICE_ROBOT_APP_SPEECH_NODE_CONVERSATION_H_

#include <coppice_msgs/Answer.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/answers/dialogue.h"

namespace coppice::robot::speech {

class Conversation {
 public:
  /// Fills the database from the files of `site` if it is empty (fill_database.h).
  static Expected<std::unique_ptr<Conversation>> Open(const std::string& database,
                                                      const std::string& site,
                                                      const std::string& language_folder);

  /// Answers one of the texts that somebody may have said. In `heard` of the answer is what it
  /// answers and how sure that is; no text if it was not understood. `heard.language` may be empty:
  /// the one that is spoken now. `took`: to make out what was said; that long ago it was said.
  coppice_msgs::Answer Answer(const coppice_msgs::Heard& heard,
                              const std::vector<knowledge::Alternative>& alternatives, WallTime now,
                              const std::optional<knowledge::ToldMeaning>& told = std::nullopt,
                              std::chrono::nanoseconds took = {});

  /// That is spoken with who has said nothing yet.
  void set_home_language(knowledge::Language language) { home_language_ = language; }
  /// That somebody speaks, by whatever else he has told so.
  void set_language(knowledge::Language language, WallTime now);

  /// What may be answered to the question that the robot has asked back; nothing if it has not.
  std::vector<std::string> ExpectedNames(WallTime now) { return dialogue_->ExpectedNames(now); }
  /// Whoever else has answered.
  void CloseQuestion() { dialogue_->CloseQuestion(); }
  void set_least_sure(double share) { dialogue_->set_least_sure(share); }

  /// Without it as the crow flies from the robot's home.
  void set_way(knowledge::WayFromHere way) { dialogue_->set_way(std::move(way)); }

  /// The one that is spoken now: of the last one who spoke, for a minute, then that of the place.
  knowledge::Language language(WallTime now) const;

 private:
  explicit Conversation(std::unique_ptr<knowledge::Dialogue> dialogue)
      : dialogue_(std::move(dialogue)) {}

  std::unique_ptr<knowledge::Dialogue> dialogue_;
  knowledge::Language home_language_ = knowledge::Language::kEnglish;
  std::string who_;
  WallTime last_{};
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_NODE_CONVERSATION_H_
