// What a file of scenarios says of running its tree by chance, for people to read.
//
//   OriginOf(play);     // "patrol.test.json:8"
//   LinesOf(play);      // "stops: 1, 2 or 3"   "<*Fault>: 20% SUCCESS 80% FAILURE"   "for 600 s"
#ifndef COPPICE_EDITOR_SIMULATION_CHANCE_TEXT_H_
#define COPPICE_EDITOR_SIMULATION_CHANCE_TEXT_H_

#include <string>
#include <vector>

#include "bt_core/testing/scenario.h"

namespace coppice::editor {

/// The file, without its folder, and the line; empty if no file says anything.
std::string OriginOf(const RandomPlay& play);

/// Keys with their values, nodes with what they do, the time.
std::vector<std::string> LinesOf(const RandomPlay& play);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_CHANCE_TEXT_H_
