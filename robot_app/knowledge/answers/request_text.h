// What somebody may have asked for, as the end of a question back: "where the library is".
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REQUEST_TEXT_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REQUEST_TEXT_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/answers/answer_texts.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/understanding/likely_meanings.h"

namespace coppice::robot::knowledge {

/// Of a request that CanBeAsked: "where the library is", "for departures: line 4". For the places
/// {first}, {second} ... of "asked_1" and "asked_2".
std::string RequestText(const Database& database, const AnswerTexts& texts, const Request& request,
                        Language language, Day today);

/// Whether the requests want the same of different subjects: then their names tell them apart.
bool DifferByName(const std::vector<Request>& requests);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REQUEST_TEXT_H_
