// Random numbers that are the same with every standard library, whose distributions are not.
#ifndef COPPICE_ROBOT_APP_TRAINING_DRAW_H_
#define COPPICE_ROBOT_APP_TRAINING_DRAW_H_

#include <random>

namespace coppice::robot::training {

/// Evenly from `low` up to `high`.
inline double Draw(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_DRAW_H_
