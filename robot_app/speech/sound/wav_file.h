// Sound in WAV files, by libsndfile.
#ifndef COPPICE_ROBOT_APP_SPEECH_SOUND_WAV_FILE_H_
#define COPPICE_ROBOT_APP_SPEECH_SOUND_WAV_FILE_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

/// Nobody says more to a robot at once, and a file may claim anything [s].
inline constexpr double kLongestSound = 120;

/// Of several channels the first. A problem if it is no WAV file, its rate is below 4 or above
/// 192 kHz, or it is longer than kLongestSound. Takes any bytes.
Expected<Sound> ReadWav(const std::string& path);
Expected<Sound> ParseWav(const std::string& bytes);

/// The bytes of a WAV file of 16 bit samples.
std::string WavOf(const Sound& sound);
/// Replaces the file, or leaves it as it was.
Outcome WriteWav(const std::string& path, const Sound& sound);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_SOUND_WAV_FILE_H_
