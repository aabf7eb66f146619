#include <cstdlib>
#include <string>

#include "robot_app/speech/sound/wav_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {

int FuzzWav(std::string_view bytes) {
  const auto sound = robot::speech::ParseWav(std::string(bytes));
  if (!sound) return 0;
  if (sound->rate < 4000 || sound->rate > 192000) std::abort();
  if (sound->seconds() > robot::speech::kLongestSound) std::abort();
  return sound->samples.empty() ? 1 : 2;
}

}  // namespace coppice::fuzz
