// Which nodes of a scene the problems of a file are about.
#ifndef COPPICE_EDITOR_SCENE_PROBLEM_PLACES_H_
#define COPPICE_EDITOR_SCENE_PROBLEM_PLACES_H_

#include <cstdint>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

/// By node the worst problem: 0 none, 1 a warning, 2 an error. A problem belongs to the last
/// element that begins at or before its place. Empty if there are no problems.
std::vector<std::uint8_t> PlaceProblems(const Forest& forest, const Scene& scene,
                                        const std::vector<Diagnostic>& problems);

/// The first problem that lies within the attribute, or null.
const Diagnostic* ProblemOfAttribute(const Document& document, const Attribute& attribute,
                                     const std::vector<Diagnostic>& problems);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_PROBLEM_PLACES_H_
