// Takes the steady noise of a place out of an utterance: of each frequency as much as it lies in
// noise (a Wiener filter with the decision-directed estimate of Y. Ephraim and D. Malah, 1984). How
// loud the noise is, is told by the moments in which the utterance is quietest.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_NOISE_REDUCTION_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_NOISE_REDUCTION_H_

#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

/// As long as the sound, which is at kHearingRate; of less than 0.13 s the sound itself. Any
/// thread.
Sound WithoutNoise(const Sound& sound);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_NOISE_REDUCTION_H_
