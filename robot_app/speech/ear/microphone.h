// A microphone by ALSA: a thread of its own reads it and hands on 20 ms at a time.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_MICROPHONE_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_MICROPHONE_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace coppice::robot::speech {

class Microphone {
 public:
  using OnSamples = std::function<void(const std::vector<std::int16_t>& samples)>;
  using OnProblem = std::function<void(const std::string& problem)>;

  /// `device` as arecord takes it: "default", "plughw:1,0". Both are called on the thread of the
  /// microphone; `on_problem` when it cannot be opened or has gone, and then it is tried again
  /// every 5 s.
  Microphone(std::string device, OnSamples on_samples, OnProblem on_problem);
  ~Microphone();
  Microphone(const Microphone&) = delete;
  Microphone& operator=(const Microphone&) = delete;

 private:
  void Run();
  std::string Record();

  const std::string device_;
  const OnSamples on_samples_;
  const OnProblem on_problem_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_MICROPHONE_H_
