// Utterances to text, on a thread of its own: by a service where there is one that answers, else by
// pocketsphinx with a grammar of what the robot knows now. The grammar is made at the start or when
// the first utterance comes, and anew after an import of the knowledge. While somebody pauses,
// what he has said until then is recognized already: if he is done, the text is there at once. What
// is a whole request and sure (complete_request.h) is told before that is certain.
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
#include <vector>

#include "robot_app/knowledge/store/database.h"
#include "robot_app/knowledge/understanding/told_meaning.h"
#include "robot_app/speech/ear/complete_request.h"
#include "robot_app/speech/ear/recognizer.h"
#include "robot_app/speech/ear/voice_activity.h"
#include "robot_app/speech/endpoint/service_pause.h"

namespace coppice::robot::speech {

struct ListenerSettings {
  std::string knowledge;              ///< the database
  std::string language_folder;        ///< of intents.yaml
  std::string model = kEnglishModel;  ///< of pocketsphinx
  SpeechService service;
  SpeechService understanding;  ///< of what is surely said; no url: the robot itself understands
  bool ends_early = true;  ///< tells a whole request in a pause; not if the service understands
  double least_sure = knowledge::kSureEnough;  ///< that a request is meant, to be told then
  bool prepares =
      false;  ///< makes the grammar at the start, so that the first does not wait for it
};

struct HeardUtterance {
  std::vector<knowledge::Alternative> alternatives;  ///< none: nothing was recognized
  knowledge::Language language = knowledge::Language::kEnglish;
  std::string who;
  std::optional<knowledge::ToldMeaning> told;  ///< by the service for understanding
  std::chrono::nanoseconds took{};             ///< since Listen
  std::optional<int> pause;  ///< he has only paused: of no account if he has gone on (Ear::End)
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
  /// `expected`: the names of which one is expected, or yes or no, as the robot has asked back.
  /// An utterance that only pauses is told if it is a whole request, and again when it has ended.
  void Listen(Utterance utterance, knowledge::Language language, std::string who,
              std::vector<std::string> expected = {});

 private:
  using Instant = std::chrono::steady_clock::time_point;
  struct Task {
    Utterance utterance;
    HeardUtterance heard;
    std::vector<std::string> expected;
    Instant begin;
  };

  void Run();
  void Tell(HeardUtterance heard, Instant begin) const;
  std::vector<knowledge::Alternative> Recognize(const Task& task);
  std::vector<knowledge::Alternative> RecognizeOffline(const Task& task);
  void Foresee(Task task);
  bool IsAllSaid(const Task& task) const;
  bool IsForeseen(const Task& task) const;
  bool MayAskService() const;
  std::optional<knowledge::ToldMeaning> AskWhatIsMeant(const HeardUtterance& heard, Instant begin);
  bool Prepare();
  Outcome Refresh();
  Outcome LoadLanguage();

  const ListenerSettings settings_;
  const OnHeard on_heard_;
  const OnProblem on_problem_;
  ServicePause pause_, understanding_pause_;
  std::optional<knowledge::Database> database_;
  std::int64_t version_ = 0;  // of the names in the recognizer
  std::optional<knowledge::IntentTable> intents_;
  std::optional<knowledge::LanguageWords> words_;  // English
  std::vector<knowledge::Name> names_;
  std::unique_ptr<Recognizer> recognizer_;
  std::unique_ptr<CompleteRequest> complete_;
  std::optional<Task> foreseen_;  // recognized while he paused

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_LISTENER_H_
