// What was used last, newest first: kept in a file, so that it is there the next time.
//
//   UseAgain(state.recent.types, "Wait");
//   const Recent recent = ReadRecent(text);     // what WriteRecent wrote
#ifndef COPPICE_EDITOR_KEYS_RECENT_H_
#define COPPICE_EDITOR_KEYS_RECENT_H_

#include <string>
#include <vector>

#include "editor/keys/known_robots.h"

namespace coppice::editor {

/// What was used last, newest first.
struct Recent {
  std::vector<std::string> files;
  std::vector<std::string> types;    ///< of nodes that were added
  std::vector<std::string> choices;  ///< of the palette: "command Fit all"
  std::vector<KnownRobot> robots;
  std::string search;
};

/// Puts it in front; what has not been used for longest is forgotten.
void UseAgain(std::vector<std::string>& list, const std::string& what);

/// How much higher it ranks among what fits alike: 0 if it was not used, else in steps of
/// kSameFit (keys/fuzzy.h).
int BonusOf(const std::vector<std::string>& list, const std::string& what);

/// A line is a path; with the word "type", "choice" or "robot" and a tab before it, one of these.
Recent ReadRecent(const std::string& text);
std::string WriteRecent(const Recent& recent);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_RECENT_H_
