// Answers of why.h for people and for scripts.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_WHY_TEXT_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_WHY_TEXT_H_

#include <string>

#include "bt_core/analysis/why/why.h"

namespace coppice {

/// Why a step ended as it did, in a few words: "because DoorOpen is FAILURE", "battery = 12".
std::string ReasonOf(const RecordedTree& tree, const WhyStep& step);

/// What kept the node from being ticked, as one sentence.
std::string SentenceOf(const RecordedTree& tree, const WhyNot& why_not);

/// What went another way than in the tick before, as one sentence.
std::string SentenceOf(const RecordedTree& tree, const WhyChange& change);

/// Several lines. Times are shown in seconds since `start`.
std::string PrintWhy(const RecordedTree& tree, const Why& why, Time start);

/// One JSON object in one line.
std::string WhyToJson(const RecordedTree& tree, const Why& why, Time start);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_WHY_TEXT_H_
