#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "robot_app/speech/mouth/sound_output.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::robot::speech {

ClockedOutput::ClockedOutput(Clock& clock, std::string folder)
    : clock_(clock), folder_(std::move(folder)) {}

Outcome ClockedOutput::Start(const Sound& sound) {
  Stop();
  sound_ = sound;
  begin_ = clock_.Now();
  is_playing_ = true;
  if (folder_.empty()) return {};
  std::error_code problem;
  std::filesystem::create_directories(folder_, problem);
  return problem ? Problem{folder_ + ": " + problem.message()} : Outcome{};
}

void ClockedOutput::Stop() {
  if (!is_playing_) return;
  const double played = Played();
  is_playing_ = false;
  if (folder_.empty()) return;
  sound_.samples.resize(std::min(
      sound_.samples.size(), static_cast<std::size_t>(played * static_cast<double>(sound_.rate))));
  char name[32];
  std::snprintf(name, sizeof name, "/%04d.wav", ++number_);
  // A full disk is no reason to be silent.
  static_cast<void>(WriteWav(folder_ + name, sound_));
}

double ClockedOutput::Played() {
  if (!is_playing_) return 0;
  const std::chrono::duration<double> since = clock_.Now() - begin_;
  return std::min(since.count(), sound_.seconds());
}

}  // namespace coppice::robot::speech
