// What a leaf does, in a few words, as the user types and reads it:
//
//   "SUCCESS"             that in every tick
//   "2s FAILURE"          RUNNING for two seconds, then FAILURE
//   "RUNNING x3 SUCCESS"  one result per tick; the last one repeats
//   "each FAILURE SUCCESS"  every activation begins at the first result
//   "80% SUCCESS 20% FAILURE 0s..2s"  by chance, after a time within these; with "holds 0s..5s" it
//                         does the same again for a time within those
#ifndef COPPICE_EDITOR_SIMULATION_SCRIPT_TEXT_H_
#define COPPICE_EDITOR_SIMULATION_SCRIPT_TEXT_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "bt_core/testing/mock_rules.h"

namespace coppice::editor {

/// A problem if the text says nothing that a leaf can do. Statuses may be shortened to their first
/// letters.
Expected<MockScript> ParseScript(const std::string& text);

/// "2s", "300ms"
std::string PrintDuration(Duration duration);

/// Outputs and messages of a script are left out.
std::string PrintScript(const MockScript& script);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SCRIPT_TEXT_H_
