// Answers in a CSV file (RFC 4180, with a header): a column for each item, a row for each person,
// an empty field where no mark was made. Nothing tells who it was, nor when.
#ifndef COPPICE_ROBOT_APP_QUESTIONNAIRE_ANSWERS_FILE_H_
#define COPPICE_ROBOT_APP_QUESTIONNAIRE_ANSWERS_FILE_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/outcome.h"
#include "robot_app/questionnaire/questionnaire.h"

namespace coppice::robot::questionnaire {

/// All problems with line and what was expected; then nothing is returned.
std::vector<Marks> ReadAnswers(const std::string& path, const Questionnaire& questionnaire,
                               Diagnostics& diagnostics);

/// Adds a row; with the header, if the file is new. It is on the disk when this returns.
Outcome AddAnswers(const std::string& path, const Questionnaire& questionnaire, const Marks& marks);

/// What the page sends: {"marks": [1, 5, 0, ...]}. A problem if that is not one mark for each item.
Expected<Marks> MarksOf(const std::string& json, const Questionnaire& questionnaire);

}  // namespace coppice::robot::questionnaire

#endif  // COPPICE_ROBOT_APP_QUESTIONNAIRE_ANSWERS_FILE_H_
