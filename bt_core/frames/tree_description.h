// What one must know of a tree to understand its events without the program that ran it: its XML,
// its nodes and slots in the order of their numbers, and the node types of the application.
#ifndef COPPICE_BT_CORE_FRAMES_TREE_DESCRIPTION_H_
#define COPPICE_BT_CORE_FRAMES_TREE_DESCRIPTION_H_

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/model/document.h"
#include "bt_core/model/manifest.h"

namespace coppice {

class Program;

using RunId = std::array<std::uint8_t, 16>;

/// From the computer's source of random numbers.
RunId MakeRunId();
/// As 32 hexadecimal digits.
std::string ToString(const RunId& id);

using Metadata = std::vector<std::pair<std::string, std::string>>;

/// What the application says about a run.
struct RunInfo {
  RunId run{};          ///< the same in everything that one run of a program leaves behind
  std::string clock;    ///< which clock the times are of: "wall", "simulated", "ros", ...
  Metadata metadata;    ///< whatever it wants to be known
  Time start{};         ///< of the events
  WallTime wall_start;  ///< the same moment, since 1970

  WallTime WallAt(Time time) const { return wall_start + (time - start); }
};

/// In the metadata of a run of which only changes of status were told, as by the Groot2 protocol
/// and the logs of BehaviorTree.CPP: a node of which nothing is told may have been ticked all the
/// same.
inline constexpr std::pair<const char*, const char*> kChangesOnly = {"told", "changes of status"};
bool TellsChangesOnly(const RunInfo& info);

/// A new run that begins now, with a random number. The clock is "wall", "simulated" or "own".
RunInfo BeginRun(const Clock& clock);

struct DescribedDocument {
  std::string file;
  std::string text;  ///< complete
};

/// A port of a node and the slot that it is bound to.
struct DescribedPort {
  std::string name;
  SlotIndex slot{0};
};

struct DescribedNode {
  std::string path;  ///< as Program::Path
  std::string id;    ///< registration ID; for a SubTree the ID of its tree
  NodeCategory category = NodeCategory::kAction;
  bool runs_one_child = false;  ///< see NodeShape
  NodeIndex parent{0};          ///< itself for the root
  std::uint32_t document = 0;   ///< of TreeDescription::documents
  ElementIndex element{0};      ///< in that document
  std::vector<DescribedPort> ports;
};

struct DescribedSlot {
  std::string scope;  ///< path of the tree that first named it; the main tree's is its ID
  std::string name;   ///< the key; a mailbox or literal has none but "PATH OF THE NODE.PORT"
  std::string type;
  bool has_key = false;
};

struct TreeDescription {
  std::string writer;  ///< program and compiler
  RunInfo info;
  std::string main_tree;
  std::vector<DescribedDocument> documents;
  std::string models;  ///< XML document with the <TreeNodesModel> of all node types
  std::vector<DescribedNode> nodes;
  std::vector<DescribedSlot> slots;
};

TreeDescription DescribeTree(const Program& program, RunInfo info);

TreeShape ShapeOf(const TreeDescription& tree);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_TREE_DESCRIPTION_H_
