// Understanding by a service of others: a language model behind the interface of OpenAI. It may
// only choose among the intents of the table and quote the names that it has heard; what it answers
// is checked (knowledge/understanding/told_meaning.h).
#ifndef COPPICE_ROBOT_APP_SPEECH_ENDPOINT_UNDERSTANDING_SERVICE_H_
#define COPPICE_ROBOT_APP_SPEECH_ENDPOINT_UNDERSTANDING_SERVICE_H_

#include <string>

#include "robot_app/knowledge/understanding/told_meaning.h"
#include "robot_app/speech/endpoint/speech_service.h"

namespace coppice::robot::speech {

/// POST /v1/chat/completions: what a text means. A problem if the answer is none of those that were
/// allowed. As Transcribe in all else.
Expected<knowledge::ToldMeaning> AskMeaning(const SpeechService& service, const std::string& text,
                                            knowledge::Language language,
                                            const knowledge::IntentTable& table);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_ENDPOINT_UNDERSTANDING_SERVICE_H_
