// `coppice test --random RUNS FILE`: trees with leaves that do by chance what leaves may do.
#ifndef COPPICE_BT_CORE_CLI_TEST_RANDOM_TEST_H_
#define COPPICE_BT_CORE_CLI_TEST_RANDOM_TEST_H_

#include "bt_core/base/command_line.h"

namespace coppice {

/// Each file is a tree, or scenarios, of which the tree is taken and what they say of chance: their
/// "random", or without it the scripts of all leaves. Of a tree the "random" of NAME.test.json
/// beside it is taken (of a tree that is not the main one: NAME.TREE.test.json), if it is about it.
/// Exit status: 0, 1 if something was found, 2 if something cannot be run.
int RunRandomTest(const Options& options);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_TEST_RANDOM_TEST_H_
