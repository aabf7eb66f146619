// The models of node types that a scenario of a recorded run needs beside its tree: those of
// decorators that only the robot's program has. What they do is not known to who plays the
// scenario, but that they are there is (bt_core/testing/stand_in.h).
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_MODELS_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_MODELS_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/frames/tree_description.h"
#include "bt_core/model/project.h"

namespace coppice {

/// Types of decorators in the project that are neither built in nor described by it, rising.
std::vector<std::string> DecoratorsWithoutModel(const Project& project);

/// Models of the node types that the recorded tree uses and that are not built in, as the text of a
/// file; those that the record does not describe are not in it.
std::string ModelsOfRecord(const TreeDescription& tree);

/// The file that a scenario of that tree has to name as its `models`; empty if it needs none. The
/// one that the scenario's file names already stays; else it is the first of `known` that describes
/// all that is needed; else one that is written beside the scenario, with `models`:
/// patrol.models.xml of patrol.test.json. What cannot be written, or is described nowhere, goes to
/// `diagnostics`.
std::string ModelsForScenario(const std::string& scenario_file, const std::string& tree_file,
                              const std::vector<std::string>& known, const std::string& models,
                              Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_MODELS_H_
