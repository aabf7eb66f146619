#include "robot_app/speech/sound/sound.h"

#include <samplerate.h>

#include <stdexcept>

namespace coppice::robot::speech {

Sound Resampled(const Sound& sound, int rate) {
  if (sound.rate == rate || sound.samples.empty()) return {rate, sound.samples};
  std::vector<float> in(sound.samples.size());
  src_short_to_float_array(sound.samples.data(), in.data(), static_cast<int>(in.size()));
  const double ratio = static_cast<double>(rate) / sound.rate;
  std::vector<float> out(static_cast<std::size_t>(static_cast<double>(in.size()) * ratio) + 16);
  SRC_DATA data{};
  data.data_in = in.data();
  data.data_out = out.data();
  data.input_frames = static_cast<long>(in.size());
  data.output_frames = static_cast<long>(out.size());
  data.src_ratio = ratio;
  if (const int error = src_simple(&data, SRC_SINC_MEDIUM_QUALITY, 1)) {
    throw std::runtime_error(src_strerror(error));
  }
  Sound result{rate, std::vector<std::int16_t>(static_cast<std::size_t>(data.output_frames_gen))};
  src_float_to_short_array(out.data(), result.samples.data(),
                           static_cast<int>(result.samples.size()));
  return result;
}

}  // namespace coppice::robot::speech
