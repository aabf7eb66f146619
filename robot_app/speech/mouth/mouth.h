// What the robot says, one thing after the other: the most urgent first, of equals the oldest. What
// is more urgent cuts what is being said. For one thread, which calls Update every 20 to 50 ms.
//
//   Mouth mouth(synthesize, output);
//   mouth.Add({1, "Follow me.", "en", 100});
//   for (const MouthEvent& event : mouth.Update()) ...          // kWord, kWord, kPlayed
#ifndef COPPICE_ROBOT_APP_SPEECH_MOUTH_MOUTH_H_
#define COPPICE_ROBOT_APP_SPEECH_MOUTH_MOUTH_H_

#include <cstdint>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "robot_app/speech/mouth/sound_output.h"
#include "robot_app/speech/mouth/synthesizer.h"

namespace coppice::robot::speech {

struct Saying {
  std::int64_t id = 0;  ///< of the caller, unique
  std::string text;
  std::string language;
  int priority = 0;
};

struct MouthEvent {
  enum class Kind : std::uint8_t { kWord, kPlayed, kCancelled, kCut, kFailed };
  std::int64_t id = 0;
  Kind kind = Kind::kPlayed;
  SpokenWord word;      ///< of kWord
  std::string message;  ///< of kFailed
};

/// Called on a thread of its own; may take its time.
using Synthesize =
    std::function<Expected<Speech>(const std::string& text, const std::string& language)>;

class Mouth {
 public:
  /// At most so many wait; of one more, the least urgent has failed.
  static constexpr std::size_t kMostWaiting = 16;
  /// So many sounds that nobody waits for any more may still be made: a thread each.
  static constexpr std::size_t kMostAbandoned = 4;

  /// `output` must outlive this.
  Mouth(Synthesize synthesize, SoundOutput& output)
      : synthesize_(std::move(synthesize)), output_(output) {}

  void Add(Saying saying);
  /// Silent within 100 ms. No matter if there is none of this id any more.
  void Cancel(std::int64_t id);
  /// What has happened since the last call; the last event of an id is none of kWord.
  std::vector<MouthEvent> Update();

  bool speaks() const { return !sayings_.empty(); }
  /// What is being said; empty if nothing is.
  std::string text() const { return is_playing_ ? sayings_.front().text : std::string(); }

 private:
  void Begin();
  void Stop();
  void Drop(std::size_t index, MouthEvent::Kind kind, std::string message = {});
  void Synthesized();
  void Follow();

  Synthesize synthesize_;
  SoundOutput& output_;
  std::vector<Saying> sayings_;  // the first is being made or played, the others wait in order
  std::future<Expected<Speech>> making_;
  std::vector<std::future<Expected<Speech>>> abandoned_;  // nobody waits for them any more
  bool is_playing_ = false;
  Speech speech_;
  std::size_t next_word_ = 0;
  std::vector<MouthEvent> events_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_MOUTH_MOUTH_H_
