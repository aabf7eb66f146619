// A Journal as a file: JSON with a version, written at once or not at all, so that a seed that has
// its file is done.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_FILE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_FILE_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/deployment/figures/journal.h"

namespace coppice::robot::deployment {

std::string ToText(const Journal& journal);
/// Of a text that ToText has made; another one is a problem.
Expected<Journal> JournalFromText(const std::string& text);

Outcome SaveJournal(const Journal& journal, const std::string& path);
Expected<Journal> LoadJournal(const std::string& path);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_FILE_H_
