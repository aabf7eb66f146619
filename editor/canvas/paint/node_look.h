// How a node is to be painted now: what the scene does not say.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_NODE_LOOK_H_
#define COPPICE_EDITOR_CANVAS_PAINT_NODE_LOOK_H_

#include <cstdint>
#include <string_view>

#include "editor/live/tree_snapshot.h"
#include "editor/live/values/port_values.h"
#include "editor/theme/geometry.h"

namespace coppice::editor {

enum class Badge : std::uint8_t { kNone, kWarning, kError };

/// What became of a node from one version of a tree to the next.
enum class Change : std::uint8_t { kNone, kAdded, kRemoved, kMoved, kChanged };

struct NodeLook {
  Box box;  ///< on the screen, with the note above and the chip below the node
  float zoom = 1;
  NodeState state;
  bool selected = false;
  bool hovered = false;
  bool collapsed = false;
  bool name_only = false;                ///< has no room for ports
  bool whole_values = false;             ///< LayoutStyle::whole_values
  bool offline = false;                  ///< the robot does not answer: statuses are the last known
  std::uint32_t hidden = 0;              ///< descendants of a collapsed node
  Status hidden_status = Status::kIdle;  ///< kRunning if one of them runs
  Badge badge = Badge::kNone;
  Badge hidden_badge = Badge::kNone;  ///< the worst of the hidden ones
  Change change = Change::kNone;
  bool has_heat = false;
  float heat = 0;                           ///< 0 to 1; negative: never ticked
  float strength = 1;                       ///< less: others are to be seen
  std::string_view lit_value;               ///< ports with that value are lit; empty: none
  const PortValues* port_values = nullptr;  ///< in the place of keys; null: none
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_NODE_LOOK_H_
