// The words that people use most, from the language model of Debian's pocketsphinx-en-us.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_COMMON_WORDS_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_COMMON_WORDS_H_

#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot::speech {

/// Folded, with their probabilities, the most frequent ones first.
Expected<std::vector<std::pair<std::string, double>>> CommonWords(const std::string& path,
                                                                  std::size_t most);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_COMMON_WORDS_H_
