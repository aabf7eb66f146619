// Utterances to text, on a thread of its own: by a service where there is one that answers, else by
// pocketsphinx with a grammar of what the robot knows now. The grammar is made at the start or when
// the first utterance comes, and anew after an import of the knowledge. Of all that pocketsphinx
// may have heard the text with the likeliest meaning is taken.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_LISTENER_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_LISTENER_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "robot_app/knowledge/store/database.h"
#include "robot_app/speech/ear/recognizer.h"
#include "robot_app/speech/endpoint/service_pause.h"

namespace coppice::robot::speech {

struct ListenerSettings {
  std::string knowledge;              ///< the database
  std::string language_folder;        ///< of intents.yaml
  std::string model = kEnglishModel;  ///< of pocketsphinx
  SpeechService service;
  bool prepares =
      false;  ///< makes the grammar at the start, so that the first does not wait for it
};

struct Recognition {
  std::string text;       ///< empty: nothing was recognized
  double confidence = 0;  ///< 0..1: that it means what was meant
};

/// A confidence below which it is better to ask again: half of what is wrong is below it, and
/// hardly anything that is right (./dev bench speech).
inline constexpr double kSureEnough = 0.6;

struct HeardUtterance {
  Recognition recognition;
  knowledge::Language language = knowledge::Language::kEnglish;
  std::string who;
};

class Listener {
 public:
  using OnHeard = std::function<void(const HeardUtterance&)>;
  using OnProblem = std::function<void(const std::string&)>;

  /// Both are called on the listener's thread.
  Listener(ListenerSettings settings, OnHeard on_heard, OnProblem on_problem);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Any thread; returns at once. More than three that wait are too many: the oldest is dropped.
  void Listen(Sound sound, knowledge::Language language, std::string who);

 private:
  struct Task {
    Sound sound;
    HeardUtterance heard;
  };

  void Run();
  Recognition Recognize(const Sound& sound, knowledge::Language language);
  Recognition RecognizeOffline(const Sound& sound);
  bool Prepare();
  Outcome Refresh();
  Outcome LoadLanguage();

  const ListenerSettings settings_;
  const OnHeard on_heard_;
  const OnProblem on_problem_;
  ServicePause pause_;
  std::optional<knowledge::Database> database_;
  std::int64_t version_ = 0;  // of the names in the recognizer
  std::optional<knowledge::IntentTable> intents_;
  std::optional<knowledge::LanguageWords> words_;  // English
  std::unique_ptr<Recognizer> recognizer_;
  std::unique_ptr<knowledge::Understander> understander_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_LISTENER_H_
