// `coppice-train vocabulary`: the words of pictures, learnt from what the robot's camera sees in
// halls that nobody built.
#ifndef COPPICE_ROBOT_APP_TRAINING_VOCABULARY_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_VOCABULARY_TRAINING_H_

#include <cstdint>
#include <functional>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/pictures/vocabulary.h"

namespace coppice::robot::training {

struct VocabularyTrainingOptions {
  std::uint64_t seed = 1;
  int pictures = 400;  ///< each in a hall of its own, from dim to bright
};

/// `say` hears how far it is, 0..1. The same options give the same vocabulary, bit for bit.
Expected<slam::Vocabulary> TrainVocabulary(const VocabularyTrainingOptions& options,
                                           const std::function<void(double)>& say);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_VOCABULARY_TRAINING_H_
