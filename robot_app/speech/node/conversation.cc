#include "robot_app/speech/node/conversation.h"

#include "robot_app/knowledge/import/fill_database.h"

namespace coppice::robot::speech {
namespace {

constexpr std::chrono::seconds kSilence{60};  // then the next one is somebody else

std::uint8_t MoodOf(knowledge::AnswerMood mood) {
  switch (mood) {
    case knowledge::AnswerMood::kAnswered:
      return coppice_msgs::Answer::ANSWERED;
    case knowledge::AnswerMood::kAsking:
      return coppice_msgs::Answer::ASKING;
    case knowledge::AnswerMood::kUnknown:
      break;
  }
  return coppice_msgs::Answer::UNKNOWN;
}

}  // namespace

Expected<std::unique_ptr<Conversation>> Conversation::Open(const std::string& database,
                                                           const std::string& site,
                                                           const std::string& language_folder) {
  const Outcome imported = knowledge::FillIfEmpty(database, site);
  if (!imported) return Problem{imported.problem()};
  Diagnostics diagnostics;
  auto dialogue = knowledge::Dialogue::Open(database, language_folder, diagnostics);
  if (!dialogue) return Problem{diagnostics.ToString()};
  return std::unique_ptr<Conversation>(new Conversation(std::move(dialogue)));
}

coppice_msgs::Answer Conversation::Answer(const coppice_msgs::Heard& heard, WallTime now) {
  if (heard.who != who_ || now - last_ > kSilence) dialogue_->Forget();
  who_ = heard.who;
  last_ = now;
  if (const auto language = knowledge::LanguageOf(heard.language)) {
    dialogue_->set_language(*language);
  }
  const knowledge::Answer answer = dialogue_->Hear(heard.text, now);
  coppice_msgs::Answer message;
  message.heard = heard;
  message.mood = MoodOf(answer.mood);
  message.text = answer.text;
  message.language = Code(dialogue_->language());
  message.place = answer.place;
  message.guides = answer.guides;
  if (!answer.request) return message;
  message.intent = Word(answer.request->intent);
  for (const knowledge::Slot& slot : answer.request->slots) {
    message.slots.push_back(std::string(Word(slot.kind)) + "=" + slot.subject);
  }
  return message;
}

}  // namespace coppice::robot::speech
