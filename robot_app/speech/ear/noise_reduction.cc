#include "robot_app/speech/ear/noise_reduction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kWindow = 512, kStep = kWindow / 4;  // samples: 32 ms, 8 ms
constexpr std::size_t kBands = kWindow / 2 + 1;
constexpr std::size_t kLowest = 4;   // band, 125 Hz; below is no speech
constexpr double kQuietest = 0.25;   // of the frames are noise alone
constexpr double kMemory = 0.95;     // of the estimate of the frame before
constexpr double kLeastGain = 0.15;  // what is left of noise covers the tones that it leaves

using Spectrum = std::vector<std::complex<double>>;
using Bands = std::array<double, kBands>;

// Applied before and behind, the frames add up to twice the sound.
std::vector<double> Window() {
  std::vector<double> window(kWindow);
  for (std::size_t i = 0; i < kWindow; ++i) {
    window[i] = std::sqrt(0.5 - 0.5 * std::cos(2 * M_PI * static_cast<double>(i) / kWindow));
  }
  return window;
}

double LoudnessOf(const Spectrum& frame) {
  return std::accumulate(
      frame.begin() + kLowest, frame.begin() + kBands, 0.0,
      [](double sum, const std::complex<double>& value) { return sum + std::norm(value); });
}

// The mean power of the quietest frames.
Bands NoiseOf(const std::vector<Spectrum>& frames) {
  std::vector<std::pair<double, const Spectrum*>> order;
  for (const Spectrum& frame : frames) order.emplace_back(LoudnessOf(frame), &frame);
  std::sort(order.begin(), order.end());
  order.resize(1 + static_cast<std::size_t>(kQuietest * static_cast<double>(order.size())));
  Bands noise;
  noise.fill(1e-3);
  for (const auto& [loudness, frame] : order) {
    for (std::size_t band = 0; band < kBands; ++band) {
      noise[band] += std::norm((*frame)[band]) / static_cast<double>(order.size());
    }
  }
  return noise;
}

// `before`: the power of speech beside that of the noise, in the frame before.
void Filter(const Bands& noise, Bands& before, Spectrum& frame) {
  for (std::size_t band = 0; band < kBands; ++band) {
    const double power = std::norm(frame[band]) / noise[band];
    const double speech = kMemory * before[band] + (1 - kMemory) * std::max(power - 1, 0.0);
    const double gain = std::max(kLeastGain, speech / (1 + speech));
    before[band] = gain * gain * power;
    frame[band] *= gain;
    if (band > 0 && band + 1 < kBands) frame[kWindow - band] = std::conj(frame[band]);
  }
}

}  // namespace

Sound WithoutNoise(const Sound& sound) {
  const std::size_t count = sound.samples.size();
  if (count < 4 * kWindow) return sound;
  const std::vector<double> window = Window();
  Eigen::FFT<double> transform;
  std::vector<Spectrum> frames;
  std::vector<double> part(kWindow);
  for (std::size_t at = 0; at + kWindow <= count; at += kStep) {
    for (std::size_t i = 0; i < kWindow; ++i) part[i] = window[i] * sound.samples[at + i];
    transform.fwd(frames.emplace_back(), part);
  }
  const Bands noise = NoiseOf(frames);
  Bands before{};
  std::vector<double> filtered(count);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    Filter(noise, before, frames[frame]);
    transform.inv(part, frames[frame]);
    for (std::size_t i = 0; i < kWindow; ++i) {
      filtered[frame * kStep + i] += window[i] * part[i] / 2;
    }
  }
  Sound result{sound.rate, std::vector<std::int16_t>(count)};
  std::transform(filtered.begin(), filtered.end(), result.samples.begin(), [](double value) {
    return static_cast<std::int16_t>(std::clamp(value, -32767.0, 32767.0));
  });
  return result;
}

}  // namespace coppice::robot::speech
