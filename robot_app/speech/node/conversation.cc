#include "robot_app/speech/node/conversation.h"

#include <ros/console.h>

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

std::vector<std::string> TextsOf(const std::vector<knowledge::Slot>& slots) {
  std::vector<std::string> texts;
  for (const knowledge::Slot& slot : slots) {
    texts.push_back(std::string(Word(slot.kind)) + "=" + slot.subject);
  }
  return texts;
}

}  // namespace

Expected<std::unique_ptr<Conversation>> Conversation::Open(const std::string& database,
                                                           const std::string& site,
                                                           const std::string& language_folder) {
  auto opened = knowledge::OpenFilled(database, site);
  if (!opened) return Problem{opened.problem()};
  if (opened->is_copy()) ROS_WARN("%s cannot be written; it is read as it is", database.c_str());
  Diagnostics diagnostics;
  auto dialogue = knowledge::Dialogue::Make(*std::move(opened), language_folder, diagnostics);
  if (!dialogue) return Problem{diagnostics.ToString()};
  return std::unique_ptr<Conversation>(new Conversation(std::move(dialogue)));
}

knowledge::Language Conversation::language(WallTime now) const {
  return now - last_ > kSilence ? home_language_ : dialogue_->language();
}

void Conversation::set_language(knowledge::Language language, WallTime now) {
  if (now - last_ > kSilence) dialogue_->Forget();
  last_ = now;
  dialogue_->set_language(language);
}

coppice_msgs::Answer Conversation::Answer(const coppice_msgs::Heard& heard,
                                          const std::vector<knowledge::Alternative>& alternatives,
                                          WallTime now,
                                          const std::optional<knowledge::ToldMeaning>& told,
                                          std::chrono::nanoseconds took) {
  const WallTime said = now - std::chrono::duration_cast<WallTime::duration>(took);
  dialogue_->set_language(language(said));
  if (heard.who != who_ || said - last_ > kSilence) dialogue_->Forget();
  dialogue_->Wait(took);
  who_ = heard.who;
  last_ = now;
  if (const auto language = knowledge::LanguageOf(heard.language)) {
    dialogue_->set_language(*language);
  }
  const auto [answer, text, share] = dialogue_->Hear(alternatives, now, told);
  coppice_msgs::Answer message;
  message.heard = heard;
  message.heard.text = text;
  message.heard.confidence = static_cast<float>(share);
  message.mood = MoodOf(answer.mood);
  message.text = answer.text;
  message.language = Code(dialogue_->language());
  message.place = answer.place;
  message.guides = answer.guides;
  for (const knowledge::Choice& choice : answer.choices) {
    coppice_msgs::Choice& told = message.choices.emplace_back();
    told.label = choice.label;
    told.intent = Word(choice.request.intent);
    told.slots = TextsOf(choice.request.slots);
  }
  if (!answer.request) return message;
  message.intent = Word(answer.request->intent);
  message.slots = TextsOf(answer.request->slots);
  return message;
}

}  // namespace coppice::robot::speech
