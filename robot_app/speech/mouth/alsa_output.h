// Sound to a card, by ALSA. A thread of its own feeds the card 20 ms at a time, so that Stop is
// heard at once.
#ifndef COPPICE_ROBOT_APP_SPEECH_MOUTH_ALSA_OUTPUT_H_
#define COPPICE_ROBOT_APP_SPEECH_MOUTH_ALSA_OUTPUT_H_

#include <atomic>
#include <string>
#include <thread>

#include "robot_app/speech/mouth/sound_output.h"

namespace coppice::robot::speech {

class AlsaOutput : public SoundOutput {
 public:
  /// `device` as aplay takes it: "default", "plughw:1,0". It is opened for each sound, so a card
  /// that is unplugged and back again is used again.
  explicit AlsaOutput(std::string device) : device_(std::move(device)) {}
  ~AlsaOutput() override { Stop(); }

  Outcome Start(const Sound& sound) override;
  void Stop() override;
  double Played() override { return played_; }

 private:
  const std::string device_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  std::atomic<double> played_{0};
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_MOUTH_ALSA_OUTPUT_H_
