// Which nodes of a tree are played by a script, and what the script does.
//
// A pattern names nodes in one of three ways; `*` stands for any characters:
//
//   "wait_*"            nodes by their name (without a name: by their ID)
//   "patrol/*/drive"    nodes by their path, which is recognised by the slash; "/drive" is the node
//                       `drive` of the main tree itself
//   "<DriveTo>"         nodes by their type; a SubTree node by the ID of its tree
//
// Where several rules fit one node, the most specific decides: a path before a name before a type,
// a pattern without `*` before one with it, then the one with more characters that are no `*`, then
// the one that comes first in the list.
#ifndef COPPICE_BT_CORE_TESTING_MOCK_RULES_H_
#define COPPICE_BT_CORE_TESTING_MOCK_RULES_H_

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/testing/chances.h"

namespace coppice {

/// What a node does instead of its own code.
struct MockScript {
  /// One result per tick; the last one repeats. Empty: SUCCESS.
  std::vector<Status> results;
  /// Start at the first result in every activation, instead of going on where the last one ended.
  bool restart = false;
  /// In every activation RUNNING until so much time has passed; only then come the results.
  Duration duration{0};
  /// Instead of results and duration: both by chance, anew in every activation.
  std::optional<Chances> chances;
  /// Values for output ports, by port, as text; written in every tick that completes the node.
  /// Where neither the port nor the key has a type, a number is a number.
  std::vector<std::pair<std::string, std::string>> outputs;
  /// The same with one of these values by chance, each time.
  std::vector<std::pair<std::string, std::vector<std::string>>> outputs_by_chance;
  /// The same in every tick in which it is RUNNING.
  std::vector<std::pair<std::string, std::string>> feedback;
  /// A message in every tick that completes the node.
  std::string says;
  /// The text of an exception that is thrown in place of a completing result.
  std::string throws;
};

struct MockRule {
  std::string pattern;
  MockScript script;
};

/// How a node is known.
struct NodeNames {
  std::string name;
  std::string path;
  std::string id;
};

bool Matches(std::string_view pattern, const NodeNames& node);

/// The rule that decides for a node, as its number in the list, or nothing.
std::optional<std::size_t> ChooseRule(const std::vector<MockRule>& rules, const NodeNames& node);

/// True if the text fits the pattern, in which `*` stands for any characters, also none.
bool FitsWildcards(std::string_view pattern, std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_MOCK_RULES_H_
