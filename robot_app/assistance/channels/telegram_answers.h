// Answers by Telegram: long polling of a bot (https://core.telegram.org/bots/api#getupdates), so
// the robot needs no address that Telegram could reach.
//
//   TelegramAnswers answers(config);
//   for (const ChatAnswer& answer : answers.TakeAnswers()) ...;
//
// An answer is the button "Fixed" or "Not fixed" below a question, or the text "fixed" or
// "not fixed", with the number of the request if there are several. One program alone may poll a
// bot.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_TELEGRAM_ANSWERS_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_TELEGRAM_ANSWERS_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot_app/assistance/assistance_config.h"
#include "robot_app/assistance/channels/chat_answer.h"

namespace coppice::robot::assistance {

/// What the button for an answer to a request says to us when it is pressed.
std::string TelegramButton(std::uint32_t request, bool fixed);

struct TelegramUpdates {
  std::vector<ChatAnswer> answers;
  std::int64_t next = 0;  ///< what has an id below that has been seen
};

/// Reads the reply of getUpdates; what is no answer is passed over. Nothing if it is no such reply.
std::optional<TelegramUpdates> ReadTelegramUpdates(const std::string& body);

class TelegramAnswers : public ChatListener {
 public:
  struct Patience {
    std::chrono::seconds poll{25};           ///< Telegram keeps a request so long
    std::chrono::milliseconds pause{10000};  ///< after one that failed
  };

  /// Polls from now on, in a thread of its own.
  explicit TelegramAnswers(const ChannelConfig& config) : TelegramAnswers(config, Patience()) {}
  TelegramAnswers(const ChannelConfig& config, Patience patience);
  /// Breaks off a request within a second.
  ~TelegramAnswers() override;
  TelegramAnswers(const TelegramAnswers&) = delete;
  TelegramAnswers& operator=(const TelegramAnswers&) = delete;

  std::vector<ChatAnswer> TakeAnswers() override;
  std::vector<std::string> TakeProblems() override;

 private:
  void Work();
  bool Poll();
  void EndWaitOfButton(const ChatAnswer& answer);
  std::string Url(const char* method) const;

  const ChannelConfig config_;
  const Patience patience_;
  std::atomic<bool> stop_{false};
  std::int64_t next_ = 0;  // the thread's
  std::mutex mutex_;       // for the rest
  std::condition_variable stopped_;
  std::vector<ChatAnswer> answers_;
  std::vector<std::string> problems_;
  std::thread thread_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_TELEGRAM_ANSWERS_H_
