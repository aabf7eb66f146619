// Sound as it is spoken, heard and kept: one channel of 16 bit samples.
#ifndef COPPICE_ROBOT_APP_SPEECH_SOUND_SOUND_H_
#define COPPICE_ROBOT_APP_SPEECH_SOUND_SOUND_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::robot::speech {

/// What the ear works at [Hz].
inline constexpr int kHearingRate = 16000;

struct Sound {
  int rate = kHearingRate;  ///< Hz
  std::vector<std::int16_t> samples;

  double seconds() const { return static_cast<double>(samples.size()) / rate; }
};

/// The same sound at another rate, band-limited.
Sound Resampled(const Sound& sound, int rate);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_SOUND_SOUND_H_
