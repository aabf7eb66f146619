// Runs made by hand for tests of figures.
#ifndef COPPICE_TESTS_ROBOT_APP_DEPLOYMENT_MADE_JOURNAL_H_
#define COPPICE_TESTS_ROBOT_APP_DEPLOYMENT_MADE_JOURNAL_H_

#include <string>

#include "robot_app/deployment/figures/journal.h"

namespace coppice::robot::deployment {

inline Time At(const std::string& moment) { return ParseMoment(moment).value(); }

/// The published deployment: its span and its four interventions.
inline Journal PublishedJournal() {
  Journal journal;
  journal.controller = "paper";
  journal.span = {At("2021-03-02 13:00"), At("2021-03-18 08:30:59")};
  journal.duties = Calendar::Make(journal.span, "Mo-Fr 09:00-17:00").value().duties();
  journal.stops = {{At("2021-03-04 13:55"), "docking", ""},
                   {At("2021-03-09 13:28"), "charge_signal", ""},
                   {At("2021-03-11 09:11"), "crash_loop", ""},
                   {At("2021-03-12 13:55"), "no_current", ""}};
  return journal;
}

}  // namespace coppice::robot::deployment

#endif  // COPPICE_TESTS_ROBOT_APP_DEPLOYMENT_MADE_JOURNAL_H_
