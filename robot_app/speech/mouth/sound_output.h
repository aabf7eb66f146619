// Where sound goes. One sound at a time; for one thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_MOUTH_SOUND_OUTPUT_H_
#define COPPICE_ROBOT_APP_SPEECH_MOUTH_SOUND_OUTPUT_H_

#include <string>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"
#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

class SoundOutput {
 public:
  virtual ~SoundOutput() = default;

  /// Begins to play; what is still playing is stopped.
  virtual Outcome Start(const Sound& sound) = 0;
  /// Nothing of the sound is heard 100 ms later.
  virtual void Stop() = 0;
  /// How much of it has been heard [s]; all of it once it has ended.
  virtual double Played() = 0;
};

/// Where there is no card: a sound lasts as long on a clock. With a folder, each is left there as
/// 0001.wav and so on, as far as it was played.
class ClockedOutput : public SoundOutput {
 public:
  explicit ClockedOutput(Clock& clock, std::string folder = {});
  ~ClockedOutput() override { Stop(); }

  Outcome Start(const Sound& sound) override;
  void Stop() override;
  double Played() override;

 private:
  Clock& clock_;
  std::string folder_;
  int number_ = 0;  // of the file
  Sound sound_;
  bool is_playing_ = false;
  Time begin_{};
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_MOUTH_SOUND_OUTPUT_H_
