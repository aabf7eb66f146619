#include "robot_app/storage/topics/topic_reader.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "bt_core/model/utf8.h"

namespace coppice::robot::storage {
namespace {

constexpr int kMostFiles = 16;  // of one message; who sends it says how many arrays it has

bool IsMd5(const std::string& text) {
  return text.size() <= 32 && std::all_of(text.begin(), text.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0;
         });
}

// The remarks in a definition may be in any encoding, but no database takes them like that.
std::string Utf8Of(std::string text) {
  std::replace(text.begin(), text.end(), '\0', '?');
  for (std::size_t at; (at = FindInvalidUtf8(text)) < text.size();) text[at] = '?';
  return text;
}

}  // namespace

TopicReader::TopicReader(TopicConfig config, Intake& intake, FileStore& files)
    : config_(std::move(config)), intake_(intake), files_(files) {}

// On average no more than the rate, also of messages that come at other moments than they are due.
// A clock that was set back does not silence a topic.
bool TopicReader::IsDue(std::int64_t now) {
  if (config_.rate <= 0) return true;
  const auto period = static_cast<std::int64_t>(1e9 / config_.rate);
  if (now < due_ && due_ - now <= period) return false;
  const bool goes_on = now >= due_ && now - due_ < period;
  due_ = (goes_on ? due_ : now) + period;
  return true;
}

Outcome TopicReader::Learn(const HeardMessage& message) {
  if (!type_ || type_->md5 != message.md5 || type_->name != message.type) {
    const Outcome remembered = Remember(message);
    if (!remembered) return remembered;
  }
  return layout_ ? Outcome() : Problem{layout_.problem()};
}

Outcome TopicReader::Remember(const HeardMessage& message) {
  if (!IsTypeName(message.type) || !IsMd5(message.md5)) {
    return Problem{"expected the name of a type and its MD5 sum"};
  }
  if (message.definition.size() > kLongestDefinition) {
    return Problem{message.type + ": the definition is too long"};
  }
  if (types_ >= kMostTypes) return Problem{"the topic has had too many types"};
  ++types_;
  type_ = std::make_shared<const MessageType>(
      MessageType{message.type, message.md5, Utf8Of(message.definition)});
  layout_ = ParseDefinition(type_->name, type_->definition);
  return {};
}

JsonRules TopicReader::RulesAt(std::int64_t now) {
  JsonRules rules;
  rules.longest_array = config_.longest_array;
  if (config_.keeps_files) {
    rules.keep = [this, now, left = kMostFiles](std::string_view bytes) mutable {
      if (bytes.empty() || left == 0) return std::string();
      --left;
      return files_.Keep(bytes, now);
    };
  }
  return rules;
}

void TopicReader::OnMessage(const HeardMessage& message) {
  if (!IsDue(message.received)) return;
  const Outcome known = Learn(message);
  if (!known) return intake_.Lose(config_.topic, known.problem(), message.received);
  Expected<std::string> json = MessageToJson(*layout_, message.bytes, RulesAt(message.received));
  if (!json) return intake_.Lose(config_.topic, json.problem(), message.received);
  intake_.Put({0, config_.priority, message.received, message.stamp, config_.topic, type_,
               *std::move(json)});
}

}  // namespace coppice::robot::storage
