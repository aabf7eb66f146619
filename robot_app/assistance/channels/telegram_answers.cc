#include "robot_app/assistance/channels/telegram_answers.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "bt_core/base/json_library.h"
#include "robot_app/assistance/channels/http_request.h"

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kTransfer{10};  // in addition to the time that Telegram waits

// The words of "Not fixed 7.", "/not_fixed@robot_bot 7" and "not_fixed:7", without whom they are
// said to.
std::vector<std::string> WordsOf(const std::string& text) {
  std::string plain;
  bool is_name = false;
  for (const char c : text.substr(0, 100)) {
    const auto byte = static_cast<unsigned char>(c);
    is_name = c == '@' || (is_name && !std::isspace(byte));
    plain += std::isalnum(byte) && !is_name ? static_cast<char>(std::tolower(byte)) : ' ';
  }
  std::istringstream stream(plain);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<std::uint32_t> NumberOf(const std::string& word) {
  if (word.size() > 10 || word.find_first_not_of("0123456789") != std::string::npos) return {};
  const unsigned long long number = std::stoull(word);
  if (number > UINT32_MAX) return {};
  return static_cast<std::uint32_t>(number);
}

// "fixed", "not fixed", each maybe with a number behind it. Anything else is talk.
bool ReadWords(std::vector<std::string> words, ChatAnswer& answer) {
  answer.fixed = words.empty() || words[0] != "not";
  if (!answer.fixed) words.erase(words.begin());
  if (words.empty() || words[0] != "fixed" || words.size() > 2) return false;
  if (words.size() == 1) return true;
  const auto number = NumberOf(words[1]);
  answer.request = number.value_or(0);
  return number.has_value();
}

std::string ChatOf(const json& message) {
  return std::to_string(message.at("chat").at("id").get<std::int64_t>());
}

std::optional<ChatAnswer> ReadUpdate(const json& update) {
  ChatAnswer answer;
  if (const auto press = update.find("callback_query"); press != update.end()) {
    answer.from = ChatOf(press->at("message"));
    answer.pressed = press->at("id").get<std::string>();
    const bool is_ours = ReadWords(WordsOf(press->at("data").get<std::string>()), answer);
    if (!is_ours || answer.request == 0) return std::nullopt;
    return answer;
  }
  const json& message = update.at("message");
  answer.from = ChatOf(message);
  answer.written = Time(std::chrono::seconds(message.at("date").get<std::uint32_t>()));
  if (!ReadWords(WordsOf(message.at("text").get<std::string>()), answer)) return std::nullopt;
  return answer;
}

}  // namespace

std::string TelegramButton(std::uint32_t request, bool fixed) {
  return (fixed ? "fixed:" : "not_fixed:") + std::to_string(request);
}

std::optional<TelegramUpdates> ReadTelegramUpdates(const std::string& body) {
  TelegramUpdates updates;
  try {
    const json reply = ParseLimitedJson(body);
    for (const json& update : reply.at("result")) {
      updates.next = std::max(updates.next, update.at("update_id").get<std::int64_t>() + 1);
      try {
        if (auto answer = ReadUpdate(update)) updates.answers.push_back(*std::move(answer));
      } catch (const json::exception&) {  // a picture, or something newer than this program
      }
    }
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return updates;
}

TelegramAnswers::TelegramAnswers(const ChannelConfig& config, Patience patience)
    : config_(config), patience_(patience), thread_([this] { Work(); }) {}

TelegramAnswers::~TelegramAnswers() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  stopped_.notify_all();
  thread_.join();
}

std::vector<ChatAnswer> TelegramAnswers::TakeAnswers() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(answers_, {});
}

std::vector<std::string> TelegramAnswers::TakeProblems() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(problems_, {});
}

void TelegramAnswers::Work() {
  while (!stop_) {
    if (Poll()) continue;
    std::unique_lock<std::mutex> lock(mutex_);
    stopped_.wait_for(lock, patience_.pause, [this] { return stop_.load(); });
  }
}

bool TelegramAnswers::Poll() {
  HttpRequest request;
  request.url = Url("getUpdates");
  request.timeout = patience_.poll + kTransfer;
  request.body = json{{"offset", next_},
                      {"timeout", patience_.poll.count()},
                      {"allowed_updates", {"message", "callback_query"}}}
                     .dump();
  const Expected<std::string> reply = Exchange(request, stop_);
  if (stop_) return true;
  std::string problem = reply.problem();
  if (reply) {
    const auto updates = ReadTelegramUpdates(*reply);
    if (updates) {
      next_ = std::max(next_, updates->next);
      for (const ChatAnswer& answer : updates->answers) EndWaitOfButton(answer);
      const std::lock_guard<std::mutex> lock(mutex_);
      answers_.insert(answers_.end(), updates->answers.begin(), updates->answers.end());
      return true;
    }
    problem = "the reply cannot be read";
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  problems_.assign(1, "answers by " + config_.name + ": " + problem);
  return false;
}

// Or the telephone shows for a while that it waits.
void TelegramAnswers::EndWaitOfButton(const ChatAnswer& answer) {
  if (answer.pressed.empty()) return;
  HttpRequest request;
  request.url = Url("answerCallbackQuery");
  request.timeout = kTransfer;
  request.body = json{{"callback_query_id", answer.pressed}}.dump();
  static_cast<void>(Exchange(request, stop_));
}

std::string TelegramAnswers::Url(const char* method) const {
  return config_.url + "/bot" + UrlPart(config_.secret) + "/" + method;
}

}  // namespace coppice::robot::assistance
