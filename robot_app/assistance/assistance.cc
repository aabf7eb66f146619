#include "robot_app/assistance/assistance.h"

#include <utility>

#include "robot_app/assistance/channels/telegram_answers.h"

namespace coppice::robot::assistance {
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

const HumanSupervisor* FindByAddress(const std::vector<HumanSupervisor>& supervisors,
                                     const std::string& channel, const std::string& address) {
  for (const HumanSupervisor& supervisor : supervisors) {
    for (const Way& way : supervisor.ways) {
      if (way.channel == channel && way.to == address) return &supervisor;
    }
  }
  return nullptr;
}

// An answer that does not say to what was meant for a question that was open when it was written;
// other people's clocks count whole seconds. 0: there was none.
std::uint32_t OldestOpenAt(const std::deque<HelpRequest>& requests, Time written) {
  for (const HelpRequest& request : requests) {
    const bool is_older = request.opened <= written + std::chrono::seconds(2);
    if (request.state == HelpState::kOpen && is_older) return request.id;
  }
  return 0;
}

}  // namespace

Channels MakeChannels(const AssistanceConfig& config) {
  Channels channels;
  for (const ChannelConfig& channel : config.channels) {
    channels[channel.name] = MakeChannel(channel);
  }
  return channels;
}

ChatListeners MakeListeners(const AssistanceConfig& config) {
  ChatListeners listeners;
  for (const ChannelConfig& channel : config.channels) {
    if (channel.kind != ChannelConfig::Kind::kTelegram || !channel.answers) continue;
    listeners[channel.name] = std::make_unique<TelegramAnswers>(channel);
  }
  return listeners;
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
              std::chrono::duration_cast<std::chrono::seconds>(now.time_since_epoch()).count())),
      access_(config.page.operator_token, config.page.viewer_token),
      sender_(std::move(channels)) {
  if (state_file_.empty()) return;
  Diagnostics diagnostics;  // a file that cannot be read is written anew; Save says what is wrong
  AssistanceState state = LoadState(state_file_, diagnostics);
  for (const HelpRequest& request : state.requests) with_links_.insert(request.id);
  desk_.Restore(std::move(state.requests));
  access_.Restore(std::move(state.passes));
}

std::vector<std::string> Assistance::Step(Time now) {
  std::vector<std::string> problems;
  for (const Delivery& delivery : sender_.TakeDeliveries()) {
    desk_.Delivered(delivery.letter, delivery.outcome.ok(), now);
    if (delivery.outcome) continue;
    problems.push_back("channel " + delivery.channel + ": " + delivery.outcome.problem());
  }
  TakeAnswers(now, problems);
  desk_.Step(now);
  EndLinksOfClosed();
  SendLetters(now);
  Save(problems);
  return problems;
}

void Assistance::TakeAnswers(Time now, std::vector<std::string>& problems) {
  for (const auto& [channel, listener] : listeners_) {
    for (const ChatAnswer& answer : listener->TakeAnswers()) TakeAnswer(channel, answer, now);
    for (std::string& problem : listener->TakeProblems()) problems.push_back(std::move(problem));
  }
}

void Assistance::TakeAnswer(const std::string& channel, const ChatAnswer& answer, Time now) {
  const HumanSupervisor* const by = FindByAddress(desk_.supervisors(), channel, answer.from);
  if (!by) return;
  std::uint32_t id = answer.request;
  if (id == 0) id = OldestOpenAt(desk_.requests(), answer.written);
  OutgoingMessage reply;
  reply.to = answer.from;
  reply.name = by->name;
  reply.headline = config_.robot;
  if (id == 0) {
    reply.text = "Nothing is open.";
  } else {
    const Expected<std::string> told = desk_.Answer(id, by->name, answer.fixed, now);
    reply.text = told ? *told : told.problem();
  }
  reply.kind = "notice";
  reply.id = MessageId(now);
  sender_.Send(0, channel, std::move(reply));  // no letter of the desk: not tried again
}

std::string Assistance::MessageId(Time now) {
  return "coppice-" + std::to_string(ToNanoseconds(now)) + "-" + std::to_string(++messages_so_far_);
}

void Assistance::SendLetters(Time now) {
  for (const Letter& letter : desk_.TakeLetters(now)) {
    const Way& way = desk_.supervisors()[letter.supervisor].ways[letter.way];
    sender_.Send(letter.number, way.channel, Compose(letter, now));
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
  message.id = MessageId(now);
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

// On a thread of its own: people are asked, and drive, though the disk is slow.
void Assistance::Save(std::vector<std::string>& problems) {
  if (state_file_.empty()) return;
  writer_->RunFinished();
  if (!save_problem_.empty()) problems.push_back(std::exchange(save_problem_, ""));
  if (is_saving_) return;
  if (saved_desk_ == desk_.version() && saved_access_ == access_.version()) return;
  saved_desk_ = desk_.version();
  saved_access_ = access_.version();
  is_saving_ = writer_->Add([this, state = CurrentState()]() -> ServiceCaller::Finish {
    Diagnostics diagnostics;
    const bool is_saved = SaveState(state_file_, state, diagnostics);
    return [this, problem = is_saved ? "" : diagnostics.ToString()] {
      is_saving_ = false;
      save_problem_ = problem;
    };
  });
}

AssistanceState Assistance::CurrentState() const {
  return {{desk_.requests().begin(), desk_.requests().end()}, access_.state()};
}

// The writer may not have begun with the last one.
Assistance::~Assistance() {
  const bool is_left =
      is_saving_ || saved_desk_ != desk_.version() || saved_access_ != access_.version();
  writer_.reset();
  Diagnostics ignored;
  if (is_left && !state_file_.empty()) SaveState(state_file_, CurrentState(), ignored);
}

}  // namespace coppice::robot::assistance
