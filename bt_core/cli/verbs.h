// The verbs of `coppice`. Each takes the arguments behind the verb and returns the exit status: 0
// fine, 1 the answer is no (a tree failed, a file has errors), 2 wrong usage or unreadable input.
// What is not a verb here runs the program coppice-VERB that lies beside this one.
#ifndef COPPICE_BT_CORE_CLI_VERBS_H_
#define COPPICE_BT_CORE_CLI_VERBS_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice {

using Arguments = std::vector<std::string>;

struct Verb {
  const Command& (*command)();
  int (*run)(const Arguments&);
  std::string name() const;  ///< "check"
};

/// All of them, by name.
const std::vector<Verb>& Verbs();

/// `coppice cat FILE [--set PATH@ATTRIBUTE=VALUE ...]`: prints a file byte for byte, with
/// attributes set.
const Command& CatCommand();
int RunCat(const Arguments& arguments);

/// `coppice check FILE...`: loads, resolves and type-checks; prints all problems.
const Command& CheckCommand();
int RunCheck(const Arguments& arguments);

/// `coppice run FILE`: runs a tree that consists of built-in nodes.
const Command& RunCommand();
int RunTree(const Arguments& arguments);

/// `coppice test FILE...`: plays scenarios with whole trees.
const Command& TestCommand();
int RunTest(const Arguments& arguments);

/// `coppice trace FILE --leaves SCRIPT.json --ticks N`: runs a tree with scripted leaves, one JSON
/// line per tick.
const Command& TraceCommand();
int RunTrace(const Arguments& arguments);

/// `coppice live HOST:PORT`: shows what a robot does, in the terminal or as JSON, and debugs it.
const Command& LiveVerbCommand();
int RunLive(const Arguments& arguments);

/// `coppice record HOST:PORT -o FILE`: records a robot from elsewhere.
const Command& RecordCommand();
int RunRecord(const Arguments& arguments);

/// `coppice nodes`: the node types of the engine with their ports, as text or as XML models.
const Command& NodesCommand();
int RunNodes(const Arguments& arguments);

/// `coppice migrate DIR`: what becomes of code that is written for BehaviorTree.CPP.
const Command& MigrateCommand();
int RunMigrate(const Arguments& arguments);

/// `coppice upgrade FILE... [-i | -o OUTPUT]`: makes trees of format 3 trees of format 4.
const Command& UpgradeCommand();
int RunUpgrade(const Arguments& arguments);

/// `coppice completion bash`: what makes the shell complete verbs, options and their choices. For
/// programs of their own (coppice-edit) it asks their --help.
const Command& CompletionCommand();
int RunCompletion(const Arguments& arguments);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_VERBS_H_
