#include "robot_app/interaction/assistance.h"

#include <utility>

#include "robot_app/interaction/assistance_store.h"

namespace coppice::robot {
namespace {

struct KindText {
  const char* name;
  const char* headline;
};

KindText TextOf(Letter::Kind kind) {
  switch (kind) {
    case Letter::Kind::kQuestion:
      return {"question", " needs help: "};
    case Letter::Kind::kReminder:
      return {"reminder", " still needs help: "};
    case Letter::Kind::kAllClear:
      return {"all-clear", " needs no more help: "};
    case Letter::Kind::kNotice:
      break;
  }
  return {"notice", " tells: "};
}

}  // namespace

Channels MakeChannels(const AssistanceConfig& config) {
  Channels channels;
  for (const ChannelConfig& channel : config.channels) {
    channels[channel.name] = MakeChannel(channel);
  }
  return channels;
}

// Seconds as the first id: grows from run to run, even without a file.
Assistance::Assistance(const AssistanceConfig& config, Channels channels,
                       const std::string& state_file, Time now)
    : config_(config),
      state_file_(state_file),
      desk_(
          config.supervisors,
          [this](const std::string& subject) { return config_.RulesOf(subject); },
          static_cast<std::uint32_t>(
              std::chrono::duration_cast<std::chrono::seconds>(now).count())),
      access_(config.page.operator_token, config.page.viewer_token),
      courier_(std::move(channels)) {
  if (state_file_.empty()) return;
  Diagnostics diagnostics;  // a file that cannot be read is written anew; Save says what is wrong
  AssistanceState state = LoadState(state_file_, diagnostics);
  for (const HelpRequest& request : state.requests) with_links_.insert(request.id);
  desk_.Restore(std::move(state.requests));
  access_.Restore(std::move(state.passes));
}

std::vector<std::string> Assistance::Step(Time now) {
  std::vector<std::string> problems;
  for (const Delivery& delivery : courier_.TakeDeliveries()) {
    desk_.Delivered(delivery.letter, delivery.error.empty(), now);
    if (delivery.error.empty()) continue;
    problems.push_back("channel " + delivery.channel + ": " + delivery.error);
  }
  desk_.Step(now);
  EndLinksOfClosed();
  SendLetters(now);
  Save(problems);
  return problems;
}

void Assistance::SendLetters(Time now) {
  for (const Letter& letter : desk_.TakeLetters(now)) {
    const Way& way = desk_.supervisors()[letter.supervisor].ways[letter.way];
    courier_.Send(letter.number, way.channel, Compose(letter, now));
  }
}

OutgoingMessage Assistance::Compose(const Letter& letter, Time now) {
  const HumanSupervisor& supervisor = desk_.supervisors()[letter.supervisor];
  const KindText kind = TextOf(letter.kind);
  OutgoingMessage message;
  message.to = supervisor.ways[letter.way].to;
  message.name = supervisor.name;
  message.headline = config_.robot + kind.headline + letter.subject;
  message.text = letter.text;
  message.kind = kind.name;
  message.subject = letter.subject;
  message.request = letter.request;
  message.id = "coppice-" + std::to_string(now.count()) + "-" + std::to_string(++messages_so_far_);
  const bool asks =
      letter.kind == Letter::Kind::kQuestion || letter.kind == Letter::Kind::kReminder;
  if (asks && !page_url_.empty()) {
    // Behind "#": browsers keep it to themselves, so neither logs nor previews of links use it up.
    message.link = page_url_ + "/#" + access_.MakeLinkToken(supervisor.name, letter.request, now);
    with_links_.insert(letter.request);
  }
  return message;
}

void Assistance::EndLinksOfClosed() {
  for (auto it = with_links_.begin(); it != with_links_.end();) {
    const HelpRequest* const request = desk_.Find(*it);
    if (request && request->state == HelpState::kOpen) {
      ++it;
      continue;
    }
    access_.EndLinks(*it);
    it = with_links_.erase(it);
  }
}

void Assistance::Save(std::vector<std::string>& problems) {
  if (state_file_.empty()) return;
  if (saved_desk_ == desk_.version() && saved_access_ == access_.version()) return;
  saved_desk_ = desk_.version();
  saved_access_ = access_.version();
  const AssistanceState state = {{desk_.requests().begin(), desk_.requests().end()},
                                 access_.state()};
  Diagnostics diagnostics;
  if (!SaveState(state_file_, state, diagnostics)) {
    problems.push_back(diagnostics.ToString());
  }
}

}  // namespace coppice::robot
